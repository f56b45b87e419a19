//! The places of a map that have names, with the facts that their names depend on.

use super::PlaceKind;
use super::lattice::Lattice;
use super::regions::{self, Found};
use super::{ranges, shores};
use crate::base::sort;
use crate::land::{Land, Region};
use crate::map::Map;

/// A place, its rank among its kind, and what decides between large and small forms of its name.
pub(super) struct Place {
    pub found: Found,
    rank: u32,
    /// The height over the sea of a range, the size of any other, in units.
    pub height_or_size: f32,
}

impl Place {
    pub fn kind_and_rank(&self) -> (PlaceKind, u32) {
        (self.found.kind, self.rank)
    }
}

/// Finds the places of a map that have names, by kind, the most important of each first. Those that are no seas, lakes or islands have no
/// region.
pub(super) fn of(map: &Map, land: &Land) -> Vec<(Place, Region)> {
    /// The least area of seas, lakes and islands with names, in square units.
    const LEAST_SEA: f32 = 10_000.0;
    const LEAST_LAKE: f32 = 400.0;
    const LEAST_ISLAND: f32 = 150.0;
    let [seas, lakes, islands] = regions::tracts(land);
    let lattice =
        Lattice::of(land.size(), [&seas, &islands].map(|tracts| tracts.iter().map(|tract| &tract.region).collect()));
    let mut places = Vec::new();
    let kinds = [(PlaceKind::Sea, LEAST_SEA), (PlaceKind::Lake, LEAST_LAKE), (PlaceKind::Island, LEAST_ISLAND)];
    for ((kind, least), tracts) in kinds.into_iter().zip([seas, lakes, islands]) {
        for (rank, tract) in (0..).zip(tracts).filter(|(_, tract)| tract.area >= least) {
            let is_main_land = kind == PlaceKind::Island && rank == 0;
            let line = if is_main_land { regions::axis(&lattice) } else { Vec::new() };
            let found = Found { kind, at: tract.midst(land), line, size: tract.area.sqrt() };
            places.push((Place { rank, height_or_size: found.size, found }, tract.region));
        }
    }
    let parts = shores::found(&lattice, |at| land.coast_distance().height(at).abs());
    let parts = parts.into_iter().map(|found| (found.size, found));
    let ranges = map.shown_relief().map_or_else(Vec::new, |relief| ranges::found(&lattice, relief));
    for (height_or_size, found) in parts.chain(ranges.into_iter().map(|(found, height)| (height, found))) {
        let rank = places.iter().filter(|(place, _): &&(Place, Region)| place.found.kind == found.kind).count();
        places.push((Place { rank: rank as u32, height_or_size, found }, Region::default()));
    }
    /// More than there are places of a kind.
    const RANKS: u32 = 1 << 24;
    sort::sorted_by(places, |(place, _)| place.found.kind as u32 * RANKS + place.rank.min(RANKS - 1))
}
