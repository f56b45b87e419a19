//! Every river arrives: each tributary at the river that it joins, each mouth on the coast, or in a delta each of its branches.

use glam::Vec2;

use super::{Breach, Fault, Finding, Promise};
use crate::analyse::statistics::inland;
use crate::base::geometry::distance;
use crate::deltas::Distributary;
use crate::map::Map;
use crate::network::{NONE, Network, River};

/// The promise that each tributary ends in its junction, and each other river at the sea.
pub const JOINS: Promise = Promise { name: "joins", says: "Every river arrives", counted: "rivers" };

/// The distance that a mouth may have from the coast, in units: cells of land along a coast reach over it.
const NEAR: f32 = 3.0;

/// The distance between two places, in units, that are the same but for rounding.
const TOUCHING: f32 = 0.01;

/// Finds the rivers of a map that do not arrive: tributaries whose junction is no vertex of the river that they join,
/// mouths more than three units from the coast, and rivers from which no way leads to a mouth. A river that divides has a
/// mouth at the end of each branch that does not divide again, and all branches begin where it or another branch ends. Where
/// all of the map is land, its open sides are the coast.
pub fn joins(map: &Map) -> Finding {
    let sides = map.recipe().open_sides();
    arrivals(map.network(), &map.deltas().distributaries, |at| inland(map, sides, at))
}

/// Finds the rivers of a network that do not arrive; `inland` is a point's distance from the coast, in units.
pub(super) fn arrivals(network: &Network, branches: &[Distributary], inland: impl Fn(Vec2) -> f32) -> Finding {
    let breach = |(number, river): (u32, &River)| {
        let own: Vec<&Distributary> = branches.iter().filter(|branch| branch.river == number).collect();
        let (at, fault) = fault(network, river, &own, &inland)?;
        Some(Breach { river: number, at, fault })
    };
    let breaches = (0..).zip(&network.rivers).filter_map(breach).collect();
    Finding { promise: JOINS, looked_at: network.rivers.len(), breaches }
}

/// Returns what is wrong at the end of a river or of its branches, and where that is.
fn fault(
    network: &Network,
    river: &River,
    branches: &[&Distributary],
    inland: impl Fn(Vec2) -> f32,
) -> Option<(Vec2, Fault)> {
    let end = network.course(river).next_back().map_or(Vec2::ZERO, |vertex| vertex.at);
    let fault = match network.rivers.get(river.parent as usize) {
        _ if !comes_to_a_mouth(network, river) => Some(Fault::Lost),
        Some(joined) => (!joined.vertex_range().contains(&(river.junction as usize)))
            .then(|| Fault::Detached(gap(network, joined, end))),
        None if branches.is_empty() => off_coast(inland(end)),
        None => {
            // Branches begin midway between the banks; the line between them runs on past the end.
            let middle = network.middle(river);
            let apex = middle.iter().nth_back(1).map_or(end, |place| place.at);
            return branches.iter().find_map(|branch| fault_of_branch(branch, branches, apex, &inland));
        }
    };
    fault.map(|fault| (end, fault))
}

fn off_coast(inland: f32) -> Option<Fault> {
    (inland.abs() > NEAR).then_some(Fault::OffCoast(inland))
}

/// Returns what is wrong with one of the branches of a river that ends at `apex`, and where that is.
fn fault_of_branch(
    branch: &Distributary,
    branches: &[&Distributary],
    apex: Vec2,
    inland: impl Fn(Vec2) -> f32,
) -> Option<(Vec2, Fault)> {
    let [from, to] = ends(branch)?;
    let begin = match branch.parent {
        None => apex,
        Some(parent) => branches.iter().find(|other| other.id == parent).and_then(|parent| ends(parent))?[1],
    };
    let gap = distance(from, begin);
    if gap > TOUCHING {
        return Some((from, Fault::Parted(gap)));
    }
    let divides = branches.iter().any(|other| other.parent == Some(branch.id));
    let fault = if divides { None } else { off_coast(inland(to)) };
    fault.map(|fault| (to, fault))
}

/// Returns the first and the last place of a branch.
fn ends(branch: &Distributary) -> Option<[Vec2; 2]> {
    Some([branch.line.first()?.at, branch.line.last()?.at])
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
