//! Deltas: land that great rivers build into the sea, with the branches that they divide into.
//!
//! A delta grows at the mouth of a finished river, out of the sediment that is left once its drowned valley is filled
//! (`drown`). Branches split at their tips, about 72° apart (Coffey and Shaw 2017), unequally (Edmonds and Slingerland
//! 2008). Waves close the bays between them. The river itself ends at the apex, so the network stays a forest: branches are no
//! rivers, and no measure counts them.
//!
//! ```text
//! sediment ─► branches ─► land along them ─► bays closed ─► branches carried to the sea ─► land
//! ```

mod ends;
mod fan;
mod maker;
mod pieces;
mod plain;
mod sediment;
#[cfg(test)]
mod tests;
mod tips;

use glam::Vec2;

pub(crate) use maker::{DeltaMaker, DeltaSettings, Shore};
pub(crate) use sediment::{Load, RIVERS, Sediment, expected_area};

use crate::network::Place;

/// Land that a river has built into the sea.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Delta {
    /// The index of its river.
    pub river: u32,
    /// The river's mouth, where it divides, in units.
    pub apex: Vec2,
    /// The strength of waves, from 0 to 1.
    pub waves: f32,
    /// The area of the new land, in square units.
    pub area: f32,
    /// The borders of the new land, in units: outer ones and those of holes. The last point of a ring is followed by its first.
    pub rings: Vec<Vec<Vec2>>,
}

/// A branch of a river in its delta.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Distributary {
    /// Its number, which is its index.
    pub id: u32,
    /// The index of its river.
    pub river: u32,
    /// The branch that it is one of the two arms of; `None` if it begins at the apex.
    pub parent: Option<u32>,
    /// The share of the river's water that it carries.
    pub share: f32,
    /// The middle line with half the width at each place, from where it begins.
    pub line: Vec<Place>,
    /// `true` if it ends in the sea, `false` if it divides.
    pub reaches_sea: bool,
}

impl Distributary {
    /// Returns the middle line with half the width at each place, and the point that follows the last one.
    pub(crate) fn middle(&self) -> Vec<Place> {
        let mut line = self.line.clone();
        if let [.., from, to] = self.line[..] {
            line.push(Place { at: 2.0 * to.at - from.at, ..to });
        }
        line
    }
}

/// The deltas of a map.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Deltas {
    /// The deltas, that of the greatest river first.
    pub list: Vec<Delta>,
    /// The branches, delta by delta, each after the one that it belongs to.
    pub distributaries: Vec<Distributary>,
}

impl Deltas {
    /// Returns `true` if there are no deltas.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}
