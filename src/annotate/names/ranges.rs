//! Ranges of mountains and hills, where there is relief: the highest land, along its crest.

use glam::Vec2;

use super::PlaceKind;
use super::lattice::{Lattice, SIDE, smoothed};
use super::regions::Found;
use crate::base::sort;
use crate::relief::Relief;

/// The greatest number of ranges of a map.
const MOST: usize = 3;
/// The share of land that lies lower than a range.
const LOWER: f32 = 0.86;
/// The fewest cells of a range, and the least length of its crest, in units.
const LEAST_CELLS: usize = 12;
const SHORTEST: f32 = 90.0;

/// Finds the ranges of a map, the longest first, each with its height over the sea, in units.
pub(super) fn found(lattice: &Lattice, relief: &Relief) -> Vec<(Found, f32)> {
    let high = relief.quantile(LOWER);
    let heights: Vec<f32> = (0..lattice.lands.len()).map(|cell| relief.at(lattice.at(cell))).collect();
    let classes: Vec<u32> = heights.iter().map(|&height| u32::from(height > 0.0 && height >= high)).collect();
    let mut ranges = Vec::new();
    for cells in lattice.components(&classes).into_iter().filter(|cells| cells.len() >= LEAST_CELLS) {
        let line = crest(relief, &lattice.spine(&cells));
        let size: f32 = line.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let peak = cells.iter().map(|&cell| heights[cell]).fold(0.0, f32::max);
        if let Some(&at) = line.get(line.len() / 2).filter(|_| size >= SHORTEST) {
            ranges.push((Found { kind: PlaceKind::Range, at, line, size }, peak));
        }
    }
    let order = sort::argsort(ranges.iter().map(|(range, _): &(Found, f32)| sort::key(-range.size)));
    order.into_iter().take(MOST).map(|i| ranges[i].clone()).collect()
}

/// Moves a line to the highest places beside it, and smooths it.
fn crest(relief: &Relief, line: &[Vec2]) -> Vec<Vec2> {
    const CELLS: i32 = 2;
    let highest = |&at: &Vec2| {
        let around = (-CELLS..=CELLS).flat_map(|south| (-CELLS..=CELLS).map(move |east| (east, south)));
        let places = around.map(|(east, south)| at + Vec2::new(east as f32, south as f32) * SIDE);
        places.max_by(|a, b| relief.at(*a).total_cmp(&relief.at(*b))).unwrap_or(at)
    };
    let crest: Vec<Vec2> = line.iter().map(highest).collect();
    smoothed(&smoothed(&crest))
}
