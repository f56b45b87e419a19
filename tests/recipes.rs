//! Recipes come from strangers: reading any text ends, and its result is in range.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::property::{cases, large};
use crate::common::random_link;
use proptest::prelude::*;
use riverseed::recipe::reading::{ReadOptions, Reading, read, read_given};
use riverseed::recipe::{Key, Recipe, RecipeError, given, json, link, preset, table::TABLE};

fn assert_in_range(recipe: &Recipe) {
    for parameter in &TABLE {
        assert!(parameter.accepts(recipe.value(parameter.key)), "{}: {recipe:?}", parameter.name);
    }
}

/// Text that almost looks like a link.
fn mangled_link() -> impl Strategy<Value = String> {
    let names: Vec<&str> = TABLE.iter().map(|parameter| parameter.name).chain(["preset", "depth", ""]).collect();
    let presets = preset::PRESETS.iter().map(|preset| preset.name);
    let words = [
        "ink",
        "nesw",
        "random",
        "drawn",
        ".AAAAgAgA__AA",
        ".AAAAgAgA__AA..AAAA____",
        ".AAAA",
        "..AAAA____",
        "1",
        "-1",
        "0.5",
        "1e9",
        "NaN",
        "-inf",
        "%FF",
        "%00",
        "9999999999999999999999",
    ];
    let words: Vec<&str> = words.into_iter().chain(presets).collect();
    let value = prop_oneof![
        proptest::sample::select(words).prop_map(String::from),
        "[-+]?[0-9]{0,5}[.]?[0-9]{0,6}",
        "[.]{1,2}[A-Za_-]{0,16}",
        ".{0,12}",
    ];
    let pair = (proptest::sample::select(names), "[=&]?", value)
        .prop_map(|(name, sign, value)| format!("{name}{}{value}", if sign.is_empty() { "=" } else { &sign }));
    proptest::collection::vec(pair, 0..6).prop_map(|pairs| pairs.join("&"))
}

fn as_json(recipe: &Recipe) -> String {
    serde_json::to_string(&riverseed::export::json::recipe(recipe)).unwrap()
}

/// Checks that text becomes a recipe in range when read leniently, and strictly the same one or a refusal that lenient
/// reading reports.
fn check_link(text: &str) {
    let (recipe, notices) = link::read_leniently(text);
    assert_in_range(&recipe);
    match link::read(text) {
        Ok(strict) => {
            assert_eq!(strict, recipe);
            assert!(notices.is_empty(), "{:?}", notices);
        }
        Err(_) => assert!(!notices.is_empty(), "refused strictly, but nothing is said of {:?}", text),
    }
}

proptest! {
    #![proptest_config(large(100_000))]

    #[test]
    fn any_text_is_read_leniently_into_a_recipe_in_range(text in mangled_link()) {
        check_link(&text);
    }

    #[test]
    fn what_is_shared_of_any_text_opens_as_the_same(text in mangled_link(), widget: bool, dark: bool) {
        let options = ReadOptions { widget, dark };
        let reading = read(&text, options);
        assert_in_range(&reading.recipe);
        let again = read(&reading.shared_link(), options);
        prop_assert_eq!(&again.recipe, &reading.recipe);
        prop_assert_eq!(&again.notices, &vec![]);
        prop_assert_eq!(again.shared_link(), reading.shared_link());
    }
}

/// What may stand before a link, and behind it.
const BEFORE: &[&str] = &[
    "",
    "",
    "https://example.org/?",
    "a://b#c?",
    "?",
    "<",
    "[a](https://example.org/#",
    "x=y&",
    "\n> ",
    "amp;",
    "#38;",
];
const BEHIND: &[&str] = &[
    "",
    "",
    ")",
    ").",
    ",",
    "%20",
    "+",
    "\r\n",
    "&amp;land=valley",
    "#country=usual&seed=rimu",
    "\">a</a>",
    " and more",
    "://?country=usual&seed=a",
];

/// Text that almost looks like what people paste: a link in an address, encoded, or with signs around it.
fn pasted() -> impl Strategy<Value = String> {
    let link = prop_oneof![mangled_link(), random_link(1_000_000), ".{0,40}"];
    let (before, after) = (proptest::sample::select(BEFORE), proptest::sample::select(BEHIND));
    (before, link, after, 0..3).prop_map(|(before, link, after, codings)| {
        let encoded = |text: String| form_urlencoded::byte_serialize(text.as_bytes()).collect::<String>();
        (0..codings).fold(format!("{before}{link}{after}"), |text, _| encoded(text))
    })
}

/// Reads what was handed over to a page.
fn on_page(text: &str) -> Reading {
    read_given(text, "", ReadOptions::default())
}

/// A recipe with any seed.
fn random_recipe() -> impl Strategy<Value = Recipe> {
    let seed = prop_oneof!["[^\\p{C}\u{fffd}]{0,64}", "[ -~]{0,64}", "[?#&=%:/;.)a]{0,20}"];
    (random_link(1_000_000), seed).prop_map(|(text, seed)| {
        let mut recipe = link::read(&text).unwrap();
        recipe.set(Key::Seed, &seed).unwrap();
        recipe
    })
}

/// Writes names and values as a link.
fn written(pairs: &[(String, String)]) -> String {
    form_urlencoded::Serializer::new(String::new()).extend_pairs(pairs).finish()
}

proptest! {
    #![proptest_config(large(20_000))]

    #[test]
    fn a_link_that_the_program_wrote_is_handed_over_unchanged(recipe in random_recipe()) {
        for text in [link::write(&recipe), link::write_for_file(&recipe)] {
            prop_assert_eq!(given::pairs(&text), Ok((link::pairs(&text).unwrap(), vec![])));
            prop_assert!(!given::is_address(&text));
            prop_assert_eq!(on_page(&text).recipe, recipe.clone());
        }
    }

    #[test]
    fn a_pasted_address_of_a_recipe_is_that_recipe(recipe in random_recipe(), host in "[a-z]{1,9}://[a-z./-]{1,20}[?#]|[?#]") {
        let address = format!("{host}{recipe}");
        prop_assert!(given::is_address(&address));
        let (pairs, notices) = given::pairs(&address).unwrap();
        prop_assert_eq!(link::apply(Recipe::default(), &pairs), Ok(recipe.clone()));
        prop_assert_eq!(notices, vec![]);
        let encoded = form_urlencoded::byte_serialize(address.as_bytes()).collect::<String>();
        // What stands around an address is known by its beginning.
        let around = ["<[]>", "([]),", "\"[]\"", "[a]([])", "<a href='[]'>a</a>"].map(|around| around.replace("[]", &address));
        let around = around.into_iter().filter(|_| host.contains("://"));
        for damaged in [encoded].into_iter().chain(around) {
            let reading = on_page(&damaged);
            prop_assert_eq!(&reading.recipe, &recipe);
            prop_assert_eq!(reading.notices.len(), 1);
        }
    }

    #[test]
    fn any_pasted_text_is_read_and_what_was_read_is_read_again_as_it_is(text in pasted()) {
        let reading = on_page(&text);
        assert_in_range(&reading.recipe);
        let (pairs, _) = given::pairs(&text).unwrap();
        prop_assert_eq!(given::pairs(&written(&pairs)), Ok((pairs, vec![])));
    }
}

/// Returns `true` if the error of a refused JSON recipe names one of its members, or the place where it is not JSON.
fn names_what_is_wrong(error: &RecipeError, text: &str) -> bool {
    let said = error.to_string();
    let is_named = |name: &str| {
        let names = said.starts_with(&format!("{name}: ")) || said.contains(&format!("'{name}'"));
        names && text.contains(&format!("\"{name}\":"))
    };
    let is_placed = said.starts_with("the recipe cannot be read: ") && said.contains(" at line 1 column ");
    let is_of_preset = said.starts_with("there is no preset '") && text.contains("\"preset\":");
    is_placed || is_of_preset || JSON_NAMES.into_iter().chain(TABLE.iter().map(|row| row.name)).any(is_named)
}

/// Names in JSON that are not those of parameters.
const JSON_NAMES: [&str; 4] = ["preset", "recipe", "nodes", "x"];

/// Text that almost looks like a JSON recipe.
fn mangled_json() -> impl Strategy<Value = String> {
    let names: Vec<&str> = TABLE.iter().map(|parameter| parameter.name).chain(JSON_NAMES).collect();
    let words = [
        r#""ink""#,
        r#""kauri""#,
        r#"".AAAAgAgA__AA""#,
        "1",
        "-1",
        "0.5",
        "1e400",
        "1e-9",
        "null",
        "true",
        "[]",
        "{}",
        r#"{"curl":1}"#,
        r#""\ud800""#,
        "",
    ];
    let member = (proptest::sample::select(names), proptest::sample::select(words.to_vec()));
    let members = proptest::collection::vec(member, 0..5).prop_map(|members| {
        members.iter().map(|(name, value)| format!("\"{name}\":{value}")).collect::<Vec<_>>().join(",")
    });
    (members, 0usize..3, 0usize..60).prop_map(|(members, nest, cut)| {
        let nested = (0..nest).fold(format!("{{{members}}}"), |json, _| format!("{{\"recipe\":{json}}}"));
        let kept = nested.len() - cut.saturating_sub(50).min(nested.len());
        nested.chars().take(kept).collect()
    })
}

proptest! {
    #![proptest_config(large(20_000))]

    #[test]
    fn any_json_is_refused_by_name_or_read_into_range(text in mangled_json()) {
        match json::read(&text) {
            Ok(recipe) => {
                assert_in_range(&recipe);
                prop_assert_eq!(json::read(&as_json(&recipe)), Ok(recipe));
            }
            Err(error) => prop_assert!(names_what_is_wrong(&error, &text), "{:?} of {:?}", error.to_string(), text),
        }
    }
}

proptest! {
    #![proptest_config(cases(5_000))]

    #[test]
    fn any_bytes_are_read(text in ".{0,300}") {
        assert_in_range(&link::read_leniently(&text).0);
        let _ = link::read(&text);
        let is_empty = text.trim() == "{}";
        prop_assert!(json::read(&text).is_err() || is_empty);
    }

    #[test]
    fn written_recipe_reads_back(text in random_link(1_000_000), seed in "[^\\p{C}\u{fffd}]{0,64}") {
        let mut recipe = link::read(&text).unwrap();
        recipe.set(riverseed::recipe::Key::Seed, &seed).unwrap();
        let written = link::write(&recipe);
        prop_assert_eq!(link::read(&written), Ok(recipe.clone()));
        prop_assert_eq!(link::read_leniently(&written), (recipe.clone(), vec![]));
        prop_assert_eq!(json::read(&as_json(&recipe)), Ok(recipe));
    }
}

#[test]
fn a_preset_named_twice_is_refused_or_said() {
    check_link("preset=original&preset=ink");
}

#[test]
fn presets_override_nothing_that_is_given() {
    for preset in preset::PRESETS {
        let recipe = link::read(&format!("trim=17&preset={}", preset.name)).unwrap();
        assert_eq!(recipe.number(riverseed::recipe::NumberKey::Trim), 17.0, "{}", preset.name);
    }
    assert!(matches!(link::read("preset=curl&preset=curl"), Err(RecipeError::Duplicate { .. })));
}
