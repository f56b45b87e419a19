//! Ranges of mountains and hills, where there is relief: the highest land, if a name has room along a crest of it.

use super::PlaceKind;
use super::crests::Crests;
use super::lattice::Lattice;
use super::regions::Found;
use crate::annotate::divides::Divides;
use crate::base::sort;
use crate::relief::Relief;

/// The greatest number of ranges of a map.
const MOST: usize = 3;
/// The share of land that lies lower than a range.
const LOWER: f32 = 0.86;
/// The fewest cells of a range, and its least length, in units.
const LEAST_CELLS: usize = 12;
const SHORTEST: f32 = 90.0;

/// Finds the ranges of a map, the longest first, each with its height over the sea, in units.
pub(super) fn found(lattice: &Lattice, relief: &Relief, divides: impl FnOnce() -> Divides) -> Vec<(Found, f32)> {
    let high = relief.quantile(LOWER);
    let heights: Vec<f32> = (0..lattice.lands.len()).map(|cell| relief.at(lattice.at(cell))).collect();
    let classes: Vec<u32> = heights.iter().map(|&height| u32::from(height > 0.0 && height >= high)).collect();
    let mut spines = Vec::new();
    for cells in lattice.components(&classes).into_iter().filter(|cells| cells.len() >= LEAST_CELLS) {
        let spine = lattice.spine(&cells);
        let size: f32 = spine.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let peak = cells.iter().map(|&cell| heights[cell]).fold(0.0, f32::max);
        if let Some(&at) = spine.get(spine.len() / 2).filter(|_| size >= SHORTEST) {
            spines.push((at, size, peak));
        }
    }
    if spines.is_empty() {
        return Vec::new();
    }
    let divides = divides();
    let mut crests = Crests::new(&divides, relief);
    let mut ranges = Vec::new();
    for i in sort::argsort(spines.iter().map(|(_, size, _)| sort::key(-size))) {
        let (at, size, peak) = spines[i];
        if let Some(line) = (ranges.len() < MOST).then(|| crests.line(at)).flatten() {
            ranges.push((Found { kind: PlaceKind::Range, at, line, size }, peak));
        }
    }
    ranges
}
