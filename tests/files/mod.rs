//! What files say is what the session holds: every value of SVG, GeoJSON and JSON is worked out again, by its definition, from the
//! tree and the rivers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod definitions;
mod geojson;
mod json;
mod svg;

use std::sync::LazyLock;

use crate::common::plain::plain;
use definitions::lakes;
use riverseed::export::{geojson as to_geojson, json as to_json};
use riverseed::network::NONE;
use riverseed::recipe::link;
use riverseed::session::Session;
use serde_json::Value;

/// Maps of all kinds: wide and tall, with many lakes, with islands, of either growth, trimmed and not.
const LINKS: [&str; 6] = [
    "country=usual&seed=kauri&land=rectangle&aspect=1.5&attractors=1500&trim=39&great-rivers=16&meander-elsewhere=1&meander-rounds=200&meander-strength=1&flat-share=1&neck=4&oxbows=1&style=ink",
    "country=usual&seed=rimu&land=rectangle&aspect=3&attractors=1200&trim=44&sides=ew&mouths=5&meander=flow&great-rivers=16&meander-elsewhere=1&meander-rounds=200&flat-share=1&meander-strength=1&neck=4&oxbows=1&style=dark",
    "country=usual&seed=kea&land=archipelago&sea=0.2&aspect=0.6&attractors=2000&trim=28&mouths=4&meander-mix=0.8&curl=0.9&stretch=5&great-rivers=16&meander-rounds=200&flat-share=1&meander-elsewhere=1&meander-strength=1&neck=4&oxbows=1&style=atlas",
    "country=usual&seed=rata&land=valley&sea=0.55&aspect=1&growth=brownian&sensitivity=24&trim=50&great-rivers=16&meander-rounds=300&flat-share=1&meander-elsewhere=1&meander-strength=1&neck=4&oxbows=1&style=atlas",
    "country=usual&seed=puriri&land=island&sea=0.55&aspect=1.2&attractors=800&deltas=0.7&trim=0&courses=grown&momentum=0.6&meander=none&bank-variation=0.5&style=ink",
    "country=usual&seed=s6&land=island&sea=0.55&aspect=1.5&attractors=800&trim=43&simplify=95&width=40&bank-variation=0&meander-rounds=80&meander-strength=1&meander-elsewhere=0&great-rivers=16&flat-share=1&neck=3&oxbows=1&style=skeleton",
];

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(&plain(link)).unwrap()).unwrap();
    while session.advance(64).unwrap() {}
    session
}

/// The finished sessions of all these links: grown once, since that is most of the work.
static SESSIONS: LazyLock<[Session; 6]> = LazyLock::new(|| LINKS.map(finished));

fn of_all(check: impl FnMut(&Session)) {
    SESSIONS.iter().for_each(check);
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> Value {
    let mut text = Vec::new();
    write(&mut text).unwrap();
    serde_json::from_slice(&text).unwrap()
}

fn geojson(session: &Session) -> Value {
    written(|text| to_geojson::write(text, &session.map().unwrap()))
}

fn json(session: &Session) -> Value {
    written(|text| to_json::write(text, &session.map().unwrap(), Some(&session.growth().scattered())))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn names(object: &Value) -> Vec<&str> {
    object.as_object().unwrap().keys().map(String::as_str).collect()
}

/// The numbers of a list, to compare with those of a column to the bit.
fn singles(column: &Value) -> Vec<f32> {
    list(column).iter().map(|number| number.as_f64().unwrap() as f32).collect()
}

fn wholes(column: &Value) -> Vec<i64> {
    list(column).iter().map(|number| number.as_i64().unwrap()).collect()
}

/// A number that stands for none is written as null.
fn some(number: u32) -> Option<u64> {
    (number != NONE).then_some(number.into())
}

#[test]
fn there_are_lakes_to_write() {
    let counts = SESSIONS.each_ref().map(|session| lakes(session.network().unwrap()).len());
    assert!(counts.iter().filter(|count| **count > 8).count() >= 4, "{counts:?}");
}

#[test]
fn summary_counts_what_the_network_has() {
    of_all(|session| {
        let (summary, network) = (session.summary(), session.network().unwrap());
        assert_eq!(summary.nodes as usize, session.pruned().origin.len());
        assert_eq!(summary.sources as usize, network.rivers.len());
        assert_eq!(summary.mouths as usize, network.rivers.iter().filter(|river| river.parent == NONE).count());
        assert_eq!(summary.order, definitions::orders(network).into_iter().max().unwrap());
        assert_eq!(summary.oxbows as usize, network.oxbows.len());
        assert_eq!(summary.ticks as usize, session.tree().tick_starts.len() - 1);
    });
}
