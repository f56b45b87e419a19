//! The places of a map that have names, with the facts that their names depend on.

use super::PlaceKind;
use super::lattice::Lattice;
use super::regions::{self, Found};
use super::{ranges, shores};
use crate::annotate::divides::Divides;
use crate::land::{Land, Region};
use crate::map::Map;
use crate::scale::MapScale;

/// A place that is to have a name.
pub(super) struct Place {
    pub found: Found,
    /// The region of a sea, a lake or an island; empty for other places.
    pub region: Region,
    /// The number of more important places of its kind: the main land is island 0.
    pub rank: u32,
    /// Its real size, which decides between large and small forms of the name: the area of a sea, lake or island in square kilometres, the
    /// height of a range in metres, the size of any other place in kilometres.
    pub extent: f32,
}

impl Place {
    pub fn is_main_land(&self) -> bool {
        self.found.kind == PlaceKind::Island && self.rank == 0
    }
}

/// Finds the places of a map that have names, by kind, the most important of each first.
pub(super) fn of(map: &Map, land: &Land) -> Vec<Place> {
    /// The least area of seas, lakes and islands with names, in square units.
    const LEAST_SEA: f32 = 10_000.0;
    const LEAST_LAKE: f32 = 400.0;
    const LEAST_ISLAND: f32 = 150.0;
    let [seas, lakes, islands] = regions::tracts(land);
    let lattice = Lattice::of(land.size(), [&seas, &islands]);
    let [gulfs, others] = shores::found(&lattice, land);
    let axis = regions::axis(&lattice);
    let scale = map.scale();
    let mut places = Vec::new();
    add_tracts(&mut places, (land, &scale), PlaceKind::Sea, seas, LEAST_SEA);
    add(&mut places, &scale, gulfs);
    add_tracts(&mut places, (land, &scale), PlaceKind::Lake, lakes, LEAST_LAKE);
    add_lakes(&mut places, map, &scale);
    let first = places.len();
    add_tracts(&mut places, (land, &scale), PlaceKind::Island, islands, LEAST_ISLAND);
    if let Some(main_land) = places.get_mut(first) {
        main_land.found.line = axis;
    }
    add(&mut places, &scale, others);
    for (rank, (found, height)) in
        (0..).zip(map.shown_relief().map_or_else(Vec::new, |relief| {
            ranges::found(&lattice, relief, || Divides::new(land.size(), map.network()))
        }))
    {
        places.push(Place { found, region: Region::default(), rank, extent: height * scale.metres_up });
    }
    places
}

/// Adds the tracts of a kind that are at least so large, in square units.
fn add_tracts(
    places: &mut Vec<Place>,
    (land, scale): (&Land, &MapScale),
    kind: PlaceKind,
    tracts: Vec<Region>,
    least: f32,
) {
    for (rank, region) in (0..).zip(tracts) {
        let area = region.area();
        if area >= least {
            let found = Found { kind, at: regions::midst(land, &region), line: Vec::new(), size: area.sqrt() };
            places.push(Place { found, region, rank, extent: scale.square_kilometres(area.into()) as f32 });
        }
    }
}

/// Adds the greatest lakes along rivers.
fn add_lakes(places: &mut Vec<Place>, map: &Map, scale: &MapScale) {
    /// The most of them, and the least area, in square units.
    const MOST: usize = 16;
    const LEAST: f32 = 150.0;
    let named = map.lakes().list.iter().take(MOST).take_while(|lake| lake.area >= LEAST);
    for (number, lake) in named.enumerate() {
        let rank = places.iter().filter(|place| place.found.kind == PlaceKind::Lake).count() as u32;
        let found = Found { kind: PlaceKind::Lake, at: lake.at, line: Vec::new(), size: lake.area.sqrt() };
        let extent = scale.square_kilometres(lake.area.into()) as f32;
        places.push(Place { found, region: map.lakes().region(number, &map.domain()), rank, extent });
    }
}

/// Adds parts of coasts, by kind, the most important of each first.
fn add(places: &mut Vec<Place>, scale: &MapScale, parts: Vec<Found>) {
    for found in parts {
        let rank = places.iter().filter(|place| place.found.kind == found.kind).count() as u32;
        places.push(Place { extent: scale.kilometres(found.size), found, region: Region::default(), rank });
    }
}
