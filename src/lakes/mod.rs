//! Lakes along rivers: local drownings of a finished relief.
//!
//! A lake is the ground above a dam, as a moraine leaves one: all that lies upstream of a river's cell and not above a level. So
//! it has one outlet, the river at the dam, and the rivers that enter it join there. The land, the courses and the flow of water
//! stay as they are: a lake has the heights of its ground as its bed.
//!
//! ```text
//! relief ─► ways of water ─► sites of dams ─► floods, the greatest first ─► shores
//! ```
//!
//! Areas follow a power law, as those of real lakes do (Cael and Seekell 2016).

mod areas;
mod flood;
mod maker;
mod shores;
mod sites;
#[cfg(test)]
mod tests;
mod upstream;

use glam::Vec2;

pub(crate) use maker::LakeMaker;

use crate::network::NONE;
use crate::relief::Grid;

/// A lake through which a river runs.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Lake {
    /// The identity of the river at the outlet, mixed with the place of the dam along it. No other lake has the same.
    pub identity: u32,
    /// The height of the water over the sea, in units.
    pub level: f32,
    /// The greatest depth, in units.
    pub depth: f32,
    /// The area of the water, in square units.
    pub area: f32,
    /// The river that runs out of the lake, and its vertex nearest to the dam.
    pub outlet: Outlet,
    /// The shores, in units: first the outer one, then those of islands. The last point of a ring is followed by its first.
    pub rings: Vec<Vec<Vec2>>,
}

/// The outlet of a lake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Outlet {
    /// The index of the river.
    pub river: u32,
    /// The index of the vertex in the network.
    pub vertex: u32,
}

/// The lakes of a map, the greatest first.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Lakes {
    /// The lakes.
    pub list: Vec<Lake>,
    /// For each cell of the map's own relief, the index of its lake, or [`NONE`]; empty if there are no lakes.
    cells: Vec<u32>,
    /// The grid of these cells; `None` if there are no lakes.
    grid: Option<Grid>,
}

impl Lakes {
    /// Returns `true` if there are no lakes.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns the index of the lake that a cell of the map's own relief lies in.
    pub fn of_cell(&self, cell: usize) -> Option<usize> {
        self.cells.get(cell).filter(|lake| **lake != NONE).map(|lake| *lake as usize)
    }

    /// Returns the index of the lake at a point in units.
    pub fn at(&self, point: Vec2) -> Option<usize> {
        let around = |lake: &Lake| lake.rings.iter().filter(|ring| is_within(ring, point)).count();
        self.list.iter().position(|lake| around(lake) % 2 == 1)
    }
}

/// Returns `true` if a point lies within a ring.
fn is_within(ring: &[Vec2], point: Vec2) -> bool {
    let crosses = |(a, b): (&Vec2, &Vec2)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)
    };
    ring.iter().zip(ring.iter().cycle().skip(1)).filter(|edge| crosses(*edge)).count() % 2 == 1
}
