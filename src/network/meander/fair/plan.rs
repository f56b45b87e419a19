//! The plan of a network while its bends are eased: the rivers that join, and the widths of those that do not.

use super::super::super::{NONE, Network, River, Vertex};
use super::super::river_of;
use crate::base::geometry::fast_max;
use crate::base::sort::argsort;

/// The river of each vertex, the tributaries that end in it, and the widths of the rivers apart from it.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub river_of: Vec<u32>,
    /// The river that each river joins, if any.
    parents: Vec<u32>,
    pub is_junction: Vec<bool>,
    /// The greatest width of any river, in units; and for each river, that of all which neither join it nor are joined by it.
    pub widest: f32,
    widest_apart: Vec<f32>,
    /// For each vertex, the last vertex of a tributary that ends there; and for each last vertex, that of the next such tributary.
    arms: Vec<u32>,
    next: Vec<u32>,
}

impl Plan {
    pub fn of(network: &Network) -> Self {
        let none = vec![NONE; network.vertices.len()];
        let (parents, widths) = (parents(network), widths(network));
        let mut plan = Self {
            river_of: river_of(network),
            widest: widths.iter().copied().fold(0.0, fast_max),
            widest_apart: widest_apart(&parents, &widths),
            is_junction: network.junctions(),
            parents,
            arms: none.clone(),
            next: none,
        };
        // In reverse, so that the first tributary comes first in its list.
        for river in network.rivers.iter().rev().filter(|river| river.junction != NONE && river.end > river.start) {
            let last = river.end - 1;
            plan.next[last as usize] = std::mem::replace(&mut plan.arms[river.junction as usize], last);
        }
        plan
    }

    /// Returns `true` if two segments belong to one river, or to two of which one joins the other.
    #[inline]
    pub fn are_joined(&self, a: u32, b: u32) -> bool {
        are_joined(&self.parents, self.river_of[a as usize], self.river_of[b as usize])
    }

    /// Returns the greatest width, in units, of all rivers that neither join that of a segment nor are joined by it.
    pub fn widest_apart(&self, segment: u32) -> f32 {
        self.widest_apart[self.river_of[segment as usize] as usize]
    }

    /// Iterates over the last vertices of the rivers that join at a vertex.
    pub fn arms(&self, junction: u32) -> impl Iterator<Item = u32> {
        let some = |i: u32| (i != NONE).then_some(i);
        std::iter::successors(some(self.arms[junction as usize]), move |&last| some(self.next[last as usize]))
    }
}

/// Returns the greatest width of each river, in units.
fn widths(network: &Network) -> Vec<f32> {
    let widest = |river: &River| network.vertices[river.vertex_range()].iter().map(Vertex::width).fold(0.0, fast_max);
    network.rivers.iter().map(widest).collect()
}

/// Returns for each river the greatest width, in units, of all that neither join it nor are joined by it.
fn widest_apart(parents: &[u32], widths: &[f32]) -> Vec<f32> {
    let by_width = argsort(widths.iter().map(|width| u32::MAX - width.to_bits()));
    let apart = |river: u32| by_width.iter().find(|&&other| !are_joined(parents, river, other as u32));
    (0..parents.len() as u32).map(|river| apart(river).map_or(0.0, |&other| widths[other])).collect()
}

/// Returns the river that each river joins, if any.
fn parents(network: &Network) -> Vec<u32> {
    network.rivers.iter().map(|river| river.parent).collect()
}

/// Returns `true` if two rivers are one, or one joins the other.
#[inline]
fn are_joined(parents: &[u32], a: u32, b: u32) -> bool {
    a == b || parents[a as usize] == b || parents[b as usize] == a
}
