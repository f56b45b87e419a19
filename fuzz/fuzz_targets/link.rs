//! Any link text is read leniently into a recipe in range. Read strictly, it gives the same recipe, or is refused and
//! the lenient reading has reported a correction.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riverseed::recipe::link;
use riverseed_fuzz::{check_message, check_recipe};

fuzz_target!(|text: &str| {
    let (recipe, notices) = link::read_leniently(text);
    check_recipe(&recipe);
    notices.iter().for_each(|notice| check_message(&notice.message));
    match link::read(text) {
        Ok(strict) => {
            assert_eq!(strict, recipe);
            assert!(notices.is_empty(), "{notices:?}");
        }
        Err(error) => {
            check_message(&error.to_string());
            assert!(!notices.is_empty(), "refused strictly, but nothing is said");
        }
    }
});
