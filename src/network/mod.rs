//! The network: a tree of nodes becomes rivers.
//!
//! A river is a course, a polyline from its source to its mouth or to the junction where it joins another, with discharge
//! and two banks at each vertex. A junction is one vertex, the parent river's: a tributary has no copy of it, so
//! nothing that moves a river can detach one.
//!
//! ```text
//! tree ─► uncross ─► courses ─► simplify ─► evenly spaced, smooth ─► widths ─► meander
//!                       └─────────────── as grown ───────────────────► widths
//! ```
//!
//! No two rivers cross, at any time. The courses do not (`uncross.rs`); a vertex goes only if its triangle holds no other
//! (`ranking.rs`); and what moves, moves by less than half of the way to the nearest other line (by the [`ClearanceGrid`]), so two lines
//! can never meet, whatever moves them.

mod banks;
mod centerline;
mod clearance;
mod courses;
mod curvature;
mod evenly;
mod heads;
pub mod hydrology;
pub mod meander;
mod narrow;
mod orders;
mod ranking;
#[cfg(test)]
mod samples;
mod settings;
mod shaping;
mod smooth;
mod turns;
mod uncross;
mod width;

pub use banks::{Banks, Place};
pub use courses::Courses;
pub use meander::Reach;
pub use meander::{Meander, PastCourse, PastCourses, PastRound};
pub use settings::NetworkSettings;
pub(crate) use shaping::ask_for_memory;
pub use shaping::{ShapeError, Shaping};
pub(crate) use turns::greatest_turns;
#[doc(hidden)] // Tests and benchmarks measure with these.
pub use {
    crate::base::geometry::{gap, meet},
    clearance::{ClearanceGrid, NearbyPair},
    curvature::curvature,
};

use std::ops::Range;

use glam::Vec2;

use crate::base::geometry::{distance, lengths};

/// The index that stands for no vertex or no river.
pub const NONE: u32 = u32::MAX;

/// A point of a course.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Vertex {
    /// The position, in domain units.
    pub at: Vec2,
    /// The amount that is drained at the vertex and upstream of it.
    pub discharge: u32,
    /// The distance of the left bank from the course, looking downstream, in units; 0 at a source.
    pub left: f32,
    /// The distance of the right bank from the course, in units; 0 at a source.
    pub right: f32,
    /// The mobility: 0 where the vertex stays, 1 where it meanders fully.
    pub mobility: f32,
    /// The elevation over the sea that the tree gives, in units; 0 everywhere if the tree has no elevations.
    pub elevation: f32,
}

impl Vertex {
    /// Returns the distance from bank to bank, in units.
    #[inline]
    pub fn width(&self) -> f32 {
        self.left + self.right
    }
}

/// A river: a run of the network's vertices, source first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct River {
    /// The index of its first vertex, the source.
    pub start: u32,
    /// The index after its own last vertex, which is its mouth if it joins no other river.
    pub end: u32,
    /// The vertex at which it joins another river; [`NONE`] if it reaches the sea.
    pub junction: u32,
    /// The river it joins; [`NONE`] if it reaches the sea.
    pub parent: u32,
    /// Strahler's order at its end.
    pub order: u8,
    /// Shreve's magnitude at its end: the number of sources upstream.
    pub magnitude: u32,
    /// The identity of its lowest node that grew (`identity` of its tree), by which chance treats it; names know it by
    /// [another](crate::annotate::names::RiverName::identity). No other river has the same, and it stays
    /// whatever becomes of the course.
    pub identity: u32,
}

impl River {
    /// Returns the indices of its own vertices.
    #[inline]
    pub fn vertex_range(&self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// A lake left by a river that cut off one of its loops.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Oxbow {
    /// The river that left it.
    pub river: u32,
    /// The round in which the loop was cut off.
    pub born: u32,
    /// The share of the lake that silt has filled, from 0 when it is young to 1 when it is gone. Pictures show a lake
    /// the fainter, the more silt it has.
    pub silt: f32,
    /// The old course with the widths that the river had.
    pub vertices: Vec<Vertex>,
}

impl Oxbow {
    /// Returns the vertices of the visible lake, each with the share of its width that silt has left: most in the
    /// middle, nothing at the ends, where silt has closed the loop. It is what silt has left of the longest run of
    /// vertices that no river has run over; empty if that is too short to be a lake.
    pub fn lake(&self) -> Vec<(Vertex, f32)> {
        const LEAST_WIDTHS: f32 = 3.0;
        const LEAST_VERTICES: usize = 3;
        const TAPER: f32 = 1.5;
        // Silt comes in at the ends, and makes the rest of the lake shallow.
        const FROM_EITHER_END: f32 = 0.35;
        const FROM_THE_BANKS: f32 = 0.5;
        if self.silt >= 1.0 {
            return Vec::new();
        }
        let runs = self.vertices.split(|vertex| vertex.width() <= 0.0);
        let Some(lake) = runs.max_by_key(|run| run.len()) else { return Vec::new() };
        let along = lengths(&lake.iter().map(|vertex| vertex.at).collect::<Vec<_>>());
        let length = along.last().copied().unwrap_or(0.0);
        let width = lake.iter().map(Vertex::width).fold(0.0, f32::max);
        let (silt, open) = (self.silt * FROM_EITHER_END * length, 1.0 - self.silt * FROM_THE_BANKS);
        if length - 2.0 * silt < LEAST_WIDTHS * width {
            return Vec::new();
        }
        let share = |along: f32| {
            let from_end = along.min(length - along) - silt;
            (from_end >= 0.0).then(|| open * (from_end / (TAPER * width)).min(1.0).sqrt())
        };
        let open: Vec<_> =
            lake.iter().zip(along).filter_map(|(vertex, along)| Some((*vertex, share(along)?))).collect();
        if open.len() < LEAST_VERTICES { Vec::new() } else { open }
    }
}

/// Rivers with their junctions and oxbow lakes.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Network {
    /// All vertices, river by river.
    pub vertices: Vec<Vertex>,
    /// The rivers. They keep their indices while their courses change.
    pub rivers: Vec<River>,
    /// The oxbow lakes, oldest first.
    pub oxbows: Vec<Oxbow>,
}

impl Network {
    /// A network without rivers.
    pub const EMPTY: &'static Self = &Self { vertices: Vec::new(), rivers: Vec::new(), oxbows: Vec::new() };

    /// Returns the vertex downstream of each; [`NONE`] at a mouth.
    pub fn downstream(&self) -> Vec<u32> {
        let mut downstream: Vec<u32> = (1..=self.vertices.len() as u32).collect();
        for river in self.rivers.iter().filter(|river| river.end > river.start) {
            downstream[river.end as usize - 1] = river.junction;
        }
        downstream
    }

    /// Returns the indices of the rivers that run into the sea, in ascending order.
    pub fn mouths(&self) -> Vec<u32> {
        (0..).zip(&self.rivers).filter(|(_, river)| river.parent == NONE).map(|(id, _)| id).collect()
    }

    /// Returns, for each river, the number of its basin: that of the mouth that its water comes to, counted from 1 in
    /// the order of [`mouths`](Self::mouths).
    pub fn basins(&self) -> Vec<u32> {
        let mouths = self.mouths();
        let basin = |mut id: u32| {
            // After a cutoff a river may join one with a greater index.
            while let Some(river) = self.rivers.get(id as usize).filter(|river| river.parent != NONE) {
                id = river.parent;
            }
            mouths.partition_point(|&mouth| mouth < id) as u32 + 1
        };
        (0..self.rivers.len() as u32).map(basin).collect()
    }

    /// Iterates over a river's course: its own vertices, then the junction if it ends in one.
    pub fn course(&self, river: &River) -> impl DoubleEndedIterator<Item = &Vertex> + Clone {
        let junction = (river.junction != NONE).then(|| &self.vertices[river.junction as usize]);
        self.vertices[river.vertex_range()].iter().chain(junction)
    }

    /// Returns the positions of the vertices of a river's course.
    #[inline(never)] // each copy weighs two hundred bytes
    pub(crate) fn places(&self, river: &River) -> Vec<Vec2> {
        self.course(river).map(|vertex| vertex.at).collect()
    }

    /// Returns, for each vertex, `true` if a river joins another there.
    pub fn junctions(&self) -> Vec<bool> {
        let mut is_junction = vec![false; self.vertices.len()];
        for river in self.rivers.iter().filter(|river| river.junction != NONE) {
            is_junction[river.junction as usize] = true;
        }
        is_junction
    }

    /// Returns the discharge of a river at its end; 0 if it has no vertices.
    pub fn discharge(&self, river: &River) -> u32 {
        self.vertices[river.vertex_range()].last().map_or(0, |vertex| vertex.discharge)
    }

    /// Returns the discharge of all rivers together, at their mouths.
    pub(crate) fn total_discharge(&self) -> u32 {
        let mouths = self.rivers.iter().filter(|river| river.parent == NONE);
        mouths.map(|river| self.discharge(river)).fold(0, u32::saturating_add)
    }

    /// Returns the length of a river, in units.
    pub fn length(&self, river: &River) -> f32 {
        lengths(&self.places(river)).last().copied().unwrap_or(0.0)
    }

    /// Returns the length of a river over the straight line from its source to its end; 1 if it ends where it begins.
    pub fn sinuosity(&self, river: &River) -> f32 {
        let ends = (self.course(river).next(), self.course(river).next_back());
        match ends {
            (Some(source), Some(end)) if source.at != end.at => self.length(river) / distance(source.at, end.at),
            _ => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn basins_are_those_of_mouths_also_where_a_river_joins_one_that_stands_after_it() {
        let river =
            |parent: u32| River { start: 0, end: 0, junction: parent, parent, order: 1, magnitude: 1, identity: 0 };
        let network = Network { rivers: [2, NONE, NONE, 0].map(river).into(), ..Network::default() };
        assert_eq!((network.mouths(), network.basins()), (vec![1, 2], vec![2, 1, 2, 2]));
    }
}
