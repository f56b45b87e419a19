//! Any JSON is refused with a reason or read into a recipe in range, whose own JSON reads back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riverseed::export::json as to_json;
use riverseed::recipe::json;
use riverseed_fuzz::{check_message, check_recipe};

fuzz_target!(|text: &str| {
    match json::read(text) {
        Ok(recipe) => {
            check_recipe(&recipe);
            let written = serde_json::to_string(&to_json::recipe(&recipe)).expect("a recipe is plain data");
            assert_eq!(json::read(&written), Ok(recipe), "{written}");
        }
        Err(error) => check_message(&error.to_string()),
    }
});
