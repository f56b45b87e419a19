//! Great rivers meet on land: no two of them end side by side at the sea, or fan into one bay.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::tier::{one_in, tiers};
use crate::common::words::WORDS;
use riverseed::Session;
use riverseed::recipe::link;

/// Lists the pairs of great rivers that end nearer to each other than both are wide: those with more than a fortieth of a map's water.
fn neighbours(link: &str) -> Vec<String> {
    let map = Session::new(link::read(link).unwrap()).unwrap().finish().unwrap();
    let network = map.network();
    let ends = network.mouths().into_iter().map(|id| network.vertices[network.rivers[id as usize].end as usize - 1]);
    let all: u32 = ends.clone().map(|end| end.discharge).sum();
    let great: Vec<_> = ends.filter(|end| end.discharge > all / 40).collect();
    let mut pairs = Vec::new();
    for (i, a) in great.iter().enumerate() {
        for b in &great[..i] {
            let apart = a.at.distance(b.at);
            if apart < a.width() + b.width() {
                pairs.push(format!("{link}: {apart} at {}", a.at));
            }
        }
    }
    pairs
}

fn great_rivers_end_apart() {
    let words = WORDS.iter().chain(&["Veldemar", "Greywater", "Lundmark", "Valtara", "Lindqvist", "Sable"]);
    let maps = words.flat_map(|word| ["", "&country=usual"].map(|country| format!("seed={word}{country}")));
    let pairs: Vec<String> = one_in(4, maps).flat_map(|link| neighbours(&link)).collect();
    assert!(pairs.is_empty(), "{pairs:#?}");
}

tiers!(great_rivers_end_apart);

#[test]
fn room_for_deltas_is_left_before_rivers_fill_their_inlets() {
    // With a sea that rises once more after them, two great rivers end at the head of one inlet.
    assert_eq!(neighbours("seed=Oakhollow&deltas=0.5"), Vec::<String>::new());
}
