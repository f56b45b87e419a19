//! Rivers that run along a coast, where natural rivers would run into the sea.

use glam::Vec2;

use crate::base::geometry::distance;
use crate::network::{NONE, Network};

/// The last stretch above a mouth, in spacings. It does not count, because every river on its way to the sea comes near
/// the coast.
const LAST_BIT: f32 = 2.0;

/// Measures the length of river within one spacing of a coast, in units, without the last two spacings above each
/// mouth. `inland` is a point's distance from the coast, in units.
pub fn along_coast(network: &Network, spacing: f32, inland: impl Fn(Vec2) -> f32) -> f64 {
    let downstream = network.downstream();
    let to_sea = distances_to_sea(network, &downstream);
    let at = |vertex: u32| network.vertices[vertex as usize].at;
    let pieces = (0..).zip(&downstream).filter(|(_, below)| **below != NONE);
    let beside = pieces.filter(|&(vertex, &below)| {
        to_sea[below as usize] >= LAST_BIT * spacing && inland((at(vertex) + at(below)) / 2.0) < spacing
    });
    beside.map(|(vertex, &below)| f64::from(distance(at(vertex), at(below)))).fold(0.0, |sum, length| sum + length)
}

/// Returns the distance of each vertex from its mouth, along the water.
fn distances_to_sea(network: &Network, downstream: &[u32]) -> Vec<f32> {
    let mut to_sea = vec![f32::NAN; downstream.len()];
    let mut upward = Vec::new();
    for start in 0..downstream.len() as u32 {
        // Down to a known vertex, then up again.
        let mut i = start;
        while i != NONE && to_sea[i as usize].is_nan() {
            upward.push(i);
            i = downstream[i as usize];
        }
        while let Some(i) = upward.pop() {
            let below = downstream[i as usize] as usize;
            let step = network.vertices.get(below).map(|next| distance(network.vertices[i as usize].at, next.at));
            to_sea[i as usize] = step.map_or(0.0, |step| to_sea[below] + step);
        }
    }
    to_sea
}

#[cfg(test)]
mod tests {
    use super::super::samples::{into, network, to_sea};
    use super::*;

    /// ```text
    ///                 T
    ///                 │
    /// S───────────────J────┐
    /// ~~~~~~~~~~~~~~~~~~~~~│~~
    /// ```
    ///
    /// The river runs for 20 units half a unit from the coast, and then into the sea. Its last two units do not count,
    /// half a unit of which is the way to the sea; the other 18.5 do. Of the tributary, the half unit that lies less
    /// than a unit from the coast counts.
    #[test]
    fn what_runs_beside_the_coast_counts_but_for_its_last_bit() {
        let river: Vec<(f32, f32)> = (0..=40).map(|i| (i as f32 / 2.0, 0.5)).chain([(20.0, 0.0)]).collect();
        let tributary: Vec<(f32, f32)> = (1..=20).rev().map(|i| (10.0, 0.5 + i as f32 / 2.0)).collect();
        let network = network(&[to_sea(&river), into(&tributary, 0, 20)]);
        assert_eq!(along_coast(&network, 1.0, |at| at.y), 18.5 + 0.5);
        // The coast is farther away than a spacing everywhere.
        assert_eq!(along_coast(&network, 1.0, |at| at.y + 2.0), 0.0);
    }
}
