//! The committed digests: natively, in wasm and in every browser, the same recipes give the same rivers and pixels.
//!
//! `RIVERSEED_REFRESH=1 cargo test --test digest` writes them again, for a change that is meant to change pictures,
//! and then fails, so that nobody refreshes by accident.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use riverseed::digest::digest;
use riverseed::recipe::link;
#[cfg(not(target_arch = "wasm32"))]
use riverseed::recipe::{Choice, Style};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test_configure!(run_in_browser);

/// Lines of a digest and a link.
const DIGESTS: &str = include_str!("digest.txt");

fn now(link: &str) -> String {
    digest(&link::read(link).unwrap()).unwrap()
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
fn every_recipe_has_its_committed_digest() {
    let lines: Vec<(&str, &str)> = DIGESTS.lines().filter_map(|line| line.split_once(' ')).collect();
    assert!(lines.len() >= 50);
    #[cfg(not(target_arch = "wasm32"))]
    refresh(&lines);
    let changed: Vec<&str> =
        lines.iter().filter(|(digest, link)| *digest != now(link)).map(|(_, link)| *link).collect();
    assert!(changed.is_empty(), "these recipes have changed: {changed:#?}");
}

#[test]
#[cfg(not(target_arch = "wasm32"))]
fn every_style_has_a_digest() {
    for style in Style::WORDS.iter().map(|word| word.name) {
        let is_its = |line: &str| line.split(['&', ' ']).any(|part| part.strip_prefix("style=") == Some(style));
        assert!(DIGESTS.lines().any(is_its), "no recipe has style={style}");
    }
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
fn digest_tells_recipes_apart() {
    let links = ["seed=a", "seed=b", "seed=a&trim=125", "seed=a&style=skeleton", "seed=a&width=15"];
    let mut digests: Vec<String> = links.iter().map(|link| now(&format!("{link}&attractors=300"))).collect();
    digests.sort();
    digests.dedup();
    assert_eq!(digests.len(), links.len());
}

#[cfg(not(target_arch = "wasm32"))]
fn refresh(lines: &[(&str, &str)]) {
    if std::env::var_os("RIVERSEED_REFRESH").is_none() {
        return;
    }
    let text: String = lines.iter().map(|(_, link)| format!("{} {link}\n", now(link))).collect();
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/digest.txt"), text).unwrap();
    panic!("the digests are written again: look at what has changed, then run without RIVERSEED_REFRESH");
}
