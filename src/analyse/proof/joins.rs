//! Every river arrives: each tributary at the river that it joins, each mouth on the coast.

use glam::Vec2;

use super::{Breach, Fault, Finding, Promise};
use crate::analyse::statistics::inland;
use crate::base::geometry::distance;
use crate::map::Map;
use crate::network::{NONE, Network, River};

/// The promise that each tributary ends in its junction, and each other river at the sea.
pub const JOINS: Promise = Promise { name: "joins", says: "Every river arrives", counted: "rivers" };

/// The distance that a mouth may have from the coast, in units: cells of land along a coast reach over it.
const NEAR: f32 = 3.0;

/// Finds the rivers of a map that do not arrive: tributaries whose junction is no vertex of the river that they join,
/// mouths more than three units from the coast, and rivers from which no way leads to a mouth. Where all of the map is
/// land, its open sides are the coast.
pub fn joins(map: &Map) -> Finding {
    let sides = map.recipe().open_sides();
    arrivals(map.network(), |at| inland(map, sides, at))
}

/// Finds the rivers of a network that do not arrive; `inland` is a point's distance from the coast, in units.
pub(super) fn arrivals(network: &Network, inland: impl Fn(Vec2) -> f32) -> Finding {
    let breach = |(number, river): (u32, &River)| {
        let (at, fault) = fault(network, river, &inland)?;
        Some(Breach { river: number, at, fault })
    };
    let breaches = (0..).zip(&network.rivers).filter_map(breach).collect();
    Finding { promise: JOINS, looked_at: network.rivers.len(), breaches }
}

/// Returns what is wrong at the end of a river, and where that is.
fn fault(network: &Network, river: &River, inland: impl Fn(Vec2) -> f32) -> Option<(Vec2, Fault)> {
    let end = network.course(river).next_back().map_or(Vec2::ZERO, |vertex| vertex.at);
    let fault = match network.rivers.get(river.parent as usize) {
        _ if !comes_to_a_mouth(network, river) => Some(Fault::Lost),
        Some(joined) => (!joined.vertex_range().contains(&(river.junction as usize)))
            .then(|| Fault::Detached(gap(network, joined, end))),
        None => Some(inland(end)).filter(|far| far.abs() > NEAR).map(Fault::OffCoast),
    };
    fault.map(|fault| (end, fault))
}

/// Returns `true` if the way down from a river, from each to the one that it joins, ends at a river that joins none.
fn comes_to_a_mouth(network: &Network, river: &River) -> bool {
    let mut here = river;
    // A way through more rivers than there are comes back to itself.
    for _ in 0..network.rivers.len() {
        if here.end <= here.start || (here.junction == NONE) != (here.parent == NONE) {
            return false;
        }
        match network.rivers.get(here.parent as usize) {
            Some(joined) => here = joined,
            None => return here.parent == NONE,
        }
    }
    false
}

/// Returns the distance of a place from the nearest of a river's own vertices.
fn gap(network: &Network, river: &River, at: Vec2) -> f32 {
    let own = &network.vertices[river.vertex_range()];
    own.iter().map(|vertex| distance(vertex.at, at)).fold(f32::INFINITY, f32::min)
}
