//! Every kind of land that recipes know, as link text: tests that go through these test a new kind, too.
#![allow(dead_code, reason = "each test file uses its own part")]

use riverseed::recipe::{Choice, LandKind};

/// A square, drawn.
const SQUARE: &str = ".MzMzzMMzzMzMMzzM";

/// Links of all kinds of land, each with all that it needs to differ from the plain rectangle.
pub fn every_land() -> Vec<String> {
    links(|_| true)
}

/// Links of all kinds of land that have a coast.
pub fn lands_with_a_coast() -> Vec<String> {
    links(|kind| kind != LandKind::Rectangle)
}

/// Links of all kinds of land whose share of sea the recipe says.
pub fn lands_with_a_share_of_sea() -> Vec<String> {
    links(|kind| !matches!(kind, LandKind::Rectangle | LandKind::Drawn))
}

/// The words of all kinds of land that have a coast.
pub fn words_of_lands_with_a_coast() -> Vec<&'static str> {
    kinds(|kind| kind != LandKind::Rectangle).map(|kind| kind.word().name).collect()
}

fn kinds(is_wanted: impl Fn(LandKind) -> bool) -> impl Iterator<Item = LandKind> {
    LandKind::ALL.iter().copied().filter(move |kind| is_wanted(*kind))
}

fn links(is_wanted: impl Fn(LandKind) -> bool) -> Vec<String> {
    let link = |kind: LandKind| match (kind, kind.word().name) {
        (LandKind::Drawn, word) => format!("land={word}&outline={SQUARE}"),
        (_, word) => format!("land={word}"),
    };
    kinds(is_wanted).map(link).collect()
}
