//! The committed digests: the same recipes give the same rivers and pixels everywhere. Browsers compare them on the page `digest.html`.
//!
//! `RIVERSEED_REFRESH=1 cargo test --test all -- digest` writes them again, for a change that is meant to change pictures,
//! and then fails, so that nobody refreshes by accident.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use riverseed::digest::digest;
use riverseed::recipe::link;
use riverseed::recipe::{Choice, Style};

/// Lines of a digest and a link: of maps without names and scenery, which any build draws.
const DIGESTS: &str = include_str!("digest.txt");
/// The same of maps with labels, a cartouche, woods or hills.
const ANNOTATED: &str = include_str!("digest-annotated.txt");

fn now(link: &str) -> String {
    digest(&link::read(link).unwrap()).unwrap()
}

#[test]
fn every_recipe_has_its_committed_digest() {
    refresh();
    expect_none(&lines().into_iter().filter_map(changed).collect::<Vec<_>>());
}

fn lines() -> Vec<(&'static str, &'static str)> {
    [lines_of(DIGESTS), lines_of(ANNOTATED)].concat()
}

fn lines_of(text: &'static str) -> Vec<(&'static str, &'static str)> {
    let lines: Vec<_> = text.lines().filter_map(|line| line.split_once(' ')).collect();
    assert!(lines.len() >= 16);
    lines
}

/// The link of a line, if its digest is another now.
fn changed<'a>((digest, link): (&str, &'a str)) -> Option<&'a str> {
    (digest != now(link)).then_some(link)
}

fn expect_none(changed: &[&str]) {
    assert!(changed.is_empty(), "these recipes have changed: {changed:#?}");
}

#[test]
fn every_style_has_a_digest() {
    assert_eq!(links_of_new_styles(), [""; 0], "make goldens");
}

/// A link for each style that no line has.
fn links_of_new_styles() -> Vec<String> {
    let names = |line: &str, style: &str| line.split(['&', ' ']).any(|part| part.strip_prefix("style=") == Some(style));
    let styles = Style::WORDS.iter().map(|word| word.name);
    styles
        .filter(|style| !DIGESTS.lines().any(|line| names(line, style)))
        .map(|style| {
            format!("country=usual&seed=tui&growth=drainage&land=island&attractors=3000&aspect=1.5&style={style}&labels=none")
        })
        .collect()
}

#[test]
fn digest_tells_recipes_apart() {
    let links = [
        [
            "country=usual&seed=a",
            "country=usual&seed=b",
            "country=usual&seed=a&trim=125",
            "country=usual&seed=a&style=skeleton",
            "country=usual&seed=a&width=15",
        ]
        .as_slice(),
        &[
            "country=usual&seed=a&labels=many",
            "country=usual&seed=a&labels=many&language=7",
            "country=usual&seed=a&woods=0.5",
            "country=usual&seed=a&hills=0.5",
        ],
        &["country=usual&seed=a&cartouche=plain", "country=usual&seed=a&cartouche=plain&names=t.Kea"],
    ]
    .concat();
    let mut digests: Vec<String> = links.iter().map(|link| now(&format!("{link}&attractors=300"))).collect();
    digests.sort();
    digests.dedup();
    assert_eq!(digests.len(), links.len());
}

fn refresh() {
    if std::env::var_os("RIVERSEED_REFRESH").is_none() {
        return;
    }
    let new = links_of_new_styles();
    for (file, lines, new) in [("digest.txt", DIGESTS, &new[..]), ("digest-annotated.txt", ANNOTATED, &[])] {
        let links = lines_of(lines).into_iter().map(|(_, link)| link).chain(new.iter().map(String::as_str));
        let text: String = links.map(|link| format!("{} {link}\n", now(link))).collect();
        std::fs::write(format!("{}/../../tests/{file}", env!("CARGO_MANIFEST_DIR")), text).unwrap();
    }
    panic!("the digests are written again: look at what has changed, then run without RIVERSEED_REFRESH");
}
