//! Every inner water of a shaped land has its outlet: all water of a map is connected with the sea at the map's border. But
//! for a basin, whose waters are closed.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::tier::{one_in, tiers};
use crate::common::words::WORDS;
use riverseed::land::{Cell, Land};
use riverseed::recipe::link;
use riverseed::{Session, glam::Vec2};

/// The least area of an inner water that counts, in square units.
const LEAST: usize = 50;

/// The waters of a land that do not reach its border, by flooding all cells: the area of each, and one of its cells.
fn inner_waters(land: &Land) -> Vec<(usize, Vec2)> {
    let (columns, rows) = (land.columns(), land.rows());
    let mut is_seen = vec![false; (columns * rows) as usize];
    let mut inner = Vec::new();
    for start in (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))) {
        let (mut area, mut is_open, mut left) = (0, false, vec![start]);
        while let Some((column, row)) = left.pop() {
            if !(0..columns).contains(&column) || !(0..rows).contains(&row) {
                is_open = true;
            } else if land.cell(column, row) == Cell::Water
                && !std::mem::replace(&mut is_seen[(row * columns + column) as usize], true)
            {
                area += 1;
                left.extend([(column - 1, row), (column + 1, row), (column, row - 1), (column, row + 1)]);
            }
        }
        inner.extend((area >= LEAST && !is_open).then_some((area, Vec2::new(start.0 as f32, start.1 as f32))));
    }
    inner
}

fn land(link: &str) -> std::sync::Arc<Land> {
    Session::new(link::read(link).unwrap()).unwrap().finish().unwrap().land().unwrap().clone()
}

/// Words, as many as are wanted: those of the list, then those with a number.
fn words(count: usize) -> impl Iterator<Item = String> {
    let number = |i: usize| if i < WORDS.len() { String::new() } else { (i / WORDS.len()).to_string() };
    (0..count).map(move |i| format!("{}{}", WORDS[i % WORDS.len()], number(i)))
}

fn no_water_of_a_continent_is_without_outlet() {
    let links = words(200).map(|word| format!("seed={word}&land=continent"));
    let dry = words(40).map(|word| format!("seed={word}&land=continent&drowning=0"));
    for link in one_in(40, links.chain(dry)) {
        assert_eq!(inner_waters(&land(&link)), [], "{link}");
    }
}

fn no_water_of_another_land_is_without_outlet() {
    let lands = ["island", "archipelago", "valley", "gulf", "twins", "crescent", "long", "arms"];
    let links = words(12).flat_map(|word| lands.map(|land| format!("seed={word}&land={land}")));
    for link in one_in(24, links) {
        assert_eq!(inner_waters(&land(&link)), [], "{link}");
    }
}

tiers!(no_water_of_a_continent_is_without_outlet, no_water_of_another_land_is_without_outlet);

#[test]
fn waters_of_a_basin_stay_closed() {
    for link in ["seed=Oslund&land=basin", "seed=Oslund&land=basin&drowning=0"] {
        assert!(!inner_waters(&land(link)).is_empty(), "{link}");
    }
}
