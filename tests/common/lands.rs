//! All kinds of land as link text. Tests that loop over these also test new kinds.
#![allow(dead_code, reason = "each test file uses its own part")]

use riverseed::recipe::{Choice, LandKind};

/// A square, drawn.
const SQUARE: &str = ".MzMzzMMzzMzMMzzM";

/// Links for all kinds of land, each with everything that makes it differ from the plain rectangle.
pub fn every_land() -> Vec<String> {
    links(|_| true)
}

/// Links for all kinds of land that have a coast.
pub fn lands_with_a_coast() -> Vec<String> {
    links(|kind| kind != LandKind::Rectangle)
}

/// Links for all kinds of land whose share of sea is a parameter.
pub fn lands_with_a_share_of_sea() -> Vec<String> {
    links(|kind| !matches!(kind, LandKind::Rectangle | LandKind::Drawn))
}

/// The words for all kinds of land that have a coast.
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
