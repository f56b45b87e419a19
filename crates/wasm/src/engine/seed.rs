//! Seeds, fresh and typed.

use wasm_bindgen::prelude::*;

use crate::objects::coded;
use riverseed::base::dice;
use riverseed::recipe::given;

/// Makes a new seed: a random word that can be pronounced.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<String, JsValue> {
    getrandom::u64().map(dice::word).map_err(|error| coded("no-randomness", &error.to_string()))
}

/// Returns true if what was typed as a seed is the address of a map.
#[wasm_bindgen(js_name = isAddress)]
pub fn is_address(word: &str) -> bool {
    given::is_address(word)
}
