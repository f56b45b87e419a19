//! Nothing runs uphill: the ground falls along every river, from cell to cell of the relief.

use glam::Vec2;

use super::{Breach, Fault, Finding, Promise};
use crate::base::geometry::distance;
use crate::network::Network;
use crate::relief::Relief;

/// The promise that every river falls.
pub const FALLS: Promise = Promise { name: "falls", says: "Nothing runs uphill", counted: "steps from cell to cell" };

/// The height up to which a cell counts as the sea's, in units: rivers may be led on there from their mouths.
const SEA: f32 = 0.01;

/// Finds the places where a river does not fall from one cell of its way to the next. Cells that are passed more than
/// once are left out, since they have one height for several rivers, that of the lowest.
pub fn falls(network: &Network, relief: &Relief) -> Finding {
    let ways: Vec<Vec<Step>> = network.rivers.iter().map(|river| way(relief, &network.places(river))).collect();
    let mut passed = vec![0u32; relief.heights().len()];
    ways.iter().flatten().for_each(|step| passed[step.cell] += 1);
    let (mut looked_at, mut breaches) = (0, Vec::new());
    for (river, mut way) in (0..).zip(ways) {
        way.retain(|step| passed[step.cell] == 1 && relief.heights()[step.cell] > SEA);
        looked_at += way.len().saturating_sub(1);
        let rises = way.windows(2).map(|pair| (pair[1].at, rise(relief, pair)));
        let breach = |(at, up)| Breach { river, at, fault: Fault::Rises(up) };
        breaches.extend(rises.filter(|(_, up)| *up >= 0.0).map(breach));
    }
    Finding { promise: FALLS, looked_at, breaches }
}

/// A cell of a river's way, and the place where the river comes into it.
#[derive(Clone, Copy)]
struct Step {
    cell: usize,
    at: Vec2,
}

fn rise(relief: &Relief, pair: &[Step]) -> f32 {
    relief.heights()[pair[1].cell] - relief.heights()[pair[0].cell]
}

/// Lists the cells that a course runs through, source first.
fn way(relief: &Relief, course: &[Vec2]) -> Vec<Step> {
    let between = |pair: &[Vec2]| {
        let (from, to) = (pair[0], pair[1]);
        // By steps of half a cell, as the relief follows rivers: another rule could cut another corner.
        let count = (distance(from, to) / (0.5 * relief.cell_size())).ceil().max(1.0) as u32;
        (0..=count).map(move |i| from.lerp(to, i as f32 / count as f32))
    };
    let places = course.windows(2).flat_map(between);
    let mut way: Vec<Step> = places.map(|at| Step { cell: relief.cell(at), at }).collect();
    way.dedup_by_key(|step| step.cell);
    way
}
