use super::*;
use crate::recipe::Recipe;
use crate::recipe::reading::{ReadOptions, Reading, read_given};

/// The map that all the damaged links are of.
const MAP: &str = "seed=rimu&land=valley";

/// Texts from which that map was lost, and whether the text was damaged or only stood in an address.
const HANDED_OVER: [(&str, bool); 49] = include!("mangled.rs");

fn read_on_page(text: &str) -> Reading {
    read_given(text, "", ReadOptions::default())
}

fn pairs_of(link: &str) -> Vec<(String, String)> {
    link::pairs(link).unwrap()
}

/// Returns the recipe of what was handed over, as strict readers read it, without the marks of addresses.
fn recipe_of(text: &str) -> Recipe {
    link::apply(Recipe::default(), &pairs(text).unwrap().0).unwrap()
}

#[test]
fn forty_damaged_links_and_some_addresses_show_the_right_map() {
    let wanted = link::read(MAP).unwrap();
    assert!(HANDED_OVER.iter().filter(|(_, is_damaged)| *is_damaged).count() >= 40);
    for (text, is_damaged) in HANDED_OVER {
        assert_eq!(recipe_of(text), wanted, "{text:?}");
        let reading = read_on_page(text);
        assert_eq!(reading.recipe, wanted, "{text:?}");
        let is_told = reading.notices.iter().any(|notice| notice.key == MENDED);
        assert_eq!(is_told, is_damaged, "{text:?}");
    }
}

#[test]
fn words_stay_as_they_are_whatever_they_hold() {
    for word in [
        "Why?",
        "#1",
        "Anna & Tom",
        "100%",
        "a%3Db",
        "1+1=2",
        "E = mc²",
        "C#",
        "(x)",
        "kauri.",
        "http://",
        "a?b#c",
        "why? x=y",
        "https://example.org/",
        "?",
        "&&&",
        "=",
        "seed",
        "land",
        "we say seed=kauri",
        "長江",
    ] {
        assert_eq!(read(word).pairs, [("seed".into(), word.into())], "{word}");
        assert!(!read(word).is_mended && !is_address(word), "{word}");
    }
    for word in
        ["seed=kauri&land=valley", "seed=x://y?land=valley", "seed%3Dkauri", "land=valley)", "a&b=c#d=e", "&amp;"]
    {
        assert!(!is_address(word), "{word}");
    }
}

#[test]
fn seeds_in_links_stay_as_they_are_whatever_they_hold() {
    for seed in
        ["Mr.", "smile :)", "(a)", "x://y?land=valley", "a?land=valley", "a&land=valley", "%26", "a=b", "\"", "it's,"]
    {
        let mut recipe = link::read("land=valley").unwrap();
        recipe.set(Key::Seed, seed).unwrap();
        for link in [link::write(&recipe), link::write_for_file(&recipe)] {
            for (text, is_address) in [(link.clone(), false), (format!("https://example.org/a?{link}"), true)] {
                let given = read(&text);
                assert_eq!(
                    (given.pairs, given.is_address, given.is_mended),
                    (pairs_of(&link), is_address, false),
                    "{text}"
                );
            }
        }
    }
    // As people type them.
    for text in ["seed=Mr.", "seed=smile :)", "seed=a?land=b", "seed=x://y?z", "seed=\"a\""] {
        assert_eq!(read(text).pairs, pairs_of(text), "{text}");
    }
}

#[test]
fn what_is_wrong_in_a_link_stays_to_be_refused() {
    let long = &format!("seed={} more", "a".repeat(64))[..];
    for text in
        ["depth=3", "seed=a&depth=3", "curl=9", "curl=1,5", "land=vally", "names=zzz)", "edition=7", "curl=1e9", long]
    {
        let given = read(text);
        assert_eq!((given.pairs, given.is_mended), (pairs_of(text), false), "{text}");
    }
}

#[test]
fn strangers_in_an_address_are_left_out_and_told_and_in_a_link_they_stay() {
    let (found, notices) = pairs("https://example.org/?seed=a&utm_source=mail&view=six").unwrap();
    assert_eq!(found, pairs_of("seed=a"));
    assert_eq!(notices.iter().map(|notice| &notice.key[..]).collect::<Vec<_>>(), ["utm_source", "view"]);
    assert_eq!(pairs("seed=a&depth=3"), Ok((pairs_of("seed=a&depth=3"), vec![])));
}

#[test]
fn an_address_in_place_of_the_seed_is_the_map_and_other_values_take_precedence() {
    let link = |text: &str, values: &str| link::write(&read_given(text, values, ReadOptions::default()).recipe);
    let address = "seed=https%3A%2F%2Fexample.org%2F%3Fseed%3Drimu%26land%3Dvalley";
    assert_eq!(link("curl=1", address), "seed=rimu&edition=1&land=valley");
    assert_eq!(link("", &format!("curl=1&land=island&{address}")), link("seed=rimu&curl=1&land=island", ""));
    assert_eq!(link("seed=a&seed=b&curl=1", "seed=z"), link("seed=z&curl=1", ""));
    // In a link it is a seed, as any other text is.
    assert_eq!(read_on_page(address).recipe.seed(), "https://example.org/?seed=rimu&land=valley");
}
