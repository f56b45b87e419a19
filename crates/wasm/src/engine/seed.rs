//! Fresh seeds.

use wasm_bindgen::prelude::*;

use crate::objects::coded;
use riverseed::base::dice;

/// Makes a new seed: a random word that can be pronounced.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<String, JsValue> {
    getrandom::u64().map(dice::word).map_err(|error| coded("no-randomness", &error.to_string()))
}
