//! The committed digests: natively, in wasm and in every browser, the same recipes give the same rivers and pixels.
//!
//! `RIVERSEED_REFRESH=1 cargo test --test digest` writes them again, for a change that is meant to change pictures,
//! and then fails, so that nobody refreshes by accident.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use riverseed::digest::{DigestError, digest};
use riverseed::recipe::link;
#[cfg(not(target_arch = "wasm32"))]
use riverseed::recipe::{Choice, Style};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test_configure!(run_in_browser);

/// Lines of a digest and a link: of maps without names and scenery, which any build draws.
const DIGESTS: &str = include_str!("digest.txt");
/// The same of maps with labels, a cartouche, woods or hills.
const ANNOTATED: &str = include_str!("digest-annotated.txt");

fn now(link: &str) -> String {
    digest(&link::read(link).unwrap()).unwrap()
}

#[test]
#[cfg(not(target_arch = "wasm32"))]
fn every_recipe_has_its_committed_digest() {
    refresh();
    expect_none(&lines().into_iter().filter_map(changed).collect::<Vec<_>>());
}

/// One recipe in so many is tried by `make test`, the others by `make test-all`.
#[cfg(target_arch = "wasm32")]
const STRIDE: usize = 3;

#[wasm_bindgen_test]
#[cfg(target_arch = "wasm32")]
async fn every_third_recipe_has_its_committed_digest() {
    expect_committed(lines().into_iter().step_by(STRIDE)).await;
}

#[wasm_bindgen_test]
#[ignore = "second tier"]
#[cfg(target_arch = "wasm32")]
async fn all_other_recipes_have_their_committed_digests() {
    let others = lines().into_iter().enumerate().filter(|(i, _)| i % STRIDE != 0);
    expect_committed(others.map(|(_, line)| line)).await;
}

#[cfg(target_arch = "wasm32")]
async fn expect_committed(lines: impl Iterator<Item = (&'static str, &'static str)>) {
    let mut all = Vec::new();
    for line in lines {
        all.extend(changed(line));
        give_way().await;
    }
    expect_none(&all);
}

/// Lets the browser answer whoever drives it, who gives up on a page that is silent for half a minute.
#[cfg(target_arch = "wasm32")]
async fn give_way() {
    let later = js_sys::eval("new Promise(done => setTimeout(done))").unwrap();
    js_sys::futures::JsFuture::from(js_sys::Promise::resolve(&later)).await.unwrap();
}

/// Those that this build has to give.
fn lines() -> Vec<(&'static str, &'static str)> {
    let annotations = if cfg!(feature = "names") { lines_of(ANNOTATED) } else { Vec::new() };
    [lines_of(DIGESTS), annotations].concat()
}

fn lines_of(text: &'static str) -> Vec<(&'static str, &'static str)> {
    let lines: Vec<_> = text.lines().filter_map(|line| line.split_once(' ')).collect();
    assert!(lines.len() >= 16);
    lines
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
fn map_with_names_or_scenery_has_no_digest_where_nothing_draws_these() {
    for option in ["labels=many", "labels=few", "cartouche=plain", "woods=0.5", "hills=0.5"] {
        let recipe = link::read(&format!("seed=kea&attractors=100&{option}")).unwrap();
        let refused = digest(&recipe).is_err_and(|error| error == DigestError::NoNames);
        assert_eq!(refused, cfg!(not(feature = "names")), "{option}");
    }
    assert!(digest(&link::read("seed=kea&attractors=100&labels=none").unwrap()).is_ok());
}

/// The link of a line, if its digest is another now.
fn changed<'a>((digest, link): (&str, &'a str)) -> Option<&'a str> {
    (digest != now(link)).then_some(link)
}

fn expect_none(changed: &[&str]) {
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
    let mut links = vec!["seed=a", "seed=b", "seed=a&trim=125", "seed=a&style=skeleton", "seed=a&width=15"];
    if cfg!(feature = "names") {
        links.extend(["seed=a&labels=many", "seed=a&labels=many&language=7", "seed=a&woods=0.5", "seed=a&hills=0.5"]);
        links.extend(["seed=a&cartouche=plain", "seed=a&cartouche=plain&names=t.Kea"]);
    }
    let mut digests: Vec<String> = links.iter().map(|link| now(&format!("{link}&attractors=300"))).collect();
    digests.sort();
    digests.dedup();
    assert_eq!(digests.len(), links.len());
}

#[cfg(not(target_arch = "wasm32"))]
fn refresh() {
    if std::env::var_os("RIVERSEED_REFRESH").is_none() {
        return;
    }
    for (file, lines) in [("digest.txt", lines_of(DIGESTS)), ("digest-annotated.txt", lines_of(ANNOTATED))] {
        let text: String = lines.iter().map(|(_, link)| format!("{} {link}\n", now(link))).collect();
        std::fs::write(format!("{}/tests/{file}", env!("CARGO_MANIFEST_DIR")), text).unwrap();
    }
    panic!("the digests are written again: look at what has changed, then run without RIVERSEED_REFRESH");
}
