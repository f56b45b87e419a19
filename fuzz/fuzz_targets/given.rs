//! Whatever is handed over in place of a link is read into a recipe in range, and what was read is read again as it is.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riverseed::recipe::given;
use riverseed::recipe::reading::{ReadOptions, read_given};
use riverseed_fuzz::{check_message, check_recipe};

fuzz_target!(|text: &str| {
    let reading = read_given(text, "", ReadOptions::default());
    check_recipe(&reading.recipe);
    reading.notices.iter().for_each(|notice| check_message(&notice.message));
    let (text, values) = text.split_once('\n').unwrap_or((text, ""));
    check_recipe(&read_given(text, values, ReadOptions::default()).recipe);
    let Ok((pairs, notices)) = given::pairs(text) else { return };
    notices.iter().for_each(|notice| check_message(&notice.message));
    let written = form_urlencoded::Serializer::new(String::new()).extend_pairs(&pairs).finish();
    if let Ok(again) = given::pairs(&written) {
        assert_eq!(again, (pairs, vec![]), "{written}");
    }
});
