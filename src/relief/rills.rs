//! Rills: the streams above the heads of drawn rivers, which carve the hillsides. Trimming removed them from the tree;
//! here they are strips of gentle ground, the gentler the more they drain, so that spurs stand between them.
//!
//! Only steepness changes. Coast and drawn rivers stay the only sources of the march, so there is no pit, and no river
//! moves.

use std::sync::Arc;

use glam::Vec2;

use crate::base::work;
use crate::prune::{self, Trim};
use crate::tree::{Hydrology, Tree};

/// The part of a tree that trimming removed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Rills {
    pub(super) segments: Vec<Segment>,
}

/// A segment of a rill, from one node to the next downstream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Segment {
    pub from: Vec2,
    pub to: Vec2,
    /// The share of the whole map's discharge that it drains.
    pub share: f32,
}

impl Rills {
    /// Collects the segments from each node that trimming removes to the next downstream. `total_discharge` is that of
    /// a river that would drain the whole map.
    pub fn of(tree: &Tree, trim: Trim, total_discharge: u32) -> Arc<Self> {
        let Hydrology { discharge, .. } = Hydrology::of(tree);
        let stays = prune::stays(tree, &discharge, trim);
        let segment = |node: usize| {
            let parent = tree.parent_of(node).filter(|_| !stays[node])?;
            let share = discharge[node] as f32 / total_discharge.max(1) as f32;
            Some(Segment { from: tree.at[node], to: tree.at[parent], share })
        };
        work::count(2 * tree.len());
        Arc::new(Self { segments: (0..tree.len()).filter_map(segment).collect() })
    }
}

/// The catchment, in square units, up to which rills are equally steep.
pub(super) const LEAST_CATCHMENT: f32 = 60.0;

/// The law by which ground is gentler where rills run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gentleness {
    /// The strength of rills, from 0 to 1.
    rills: f32,
    /// The share of the whole map up to which rills are equally steep.
    least_share: f32,
}

impl Gentleness {
    /// Derives the law from the strength of rills, from 0 to 1, and the area of land, in square units.
    pub fn new(rills: f32, land: f32) -> Self {
        Self { rills, least_share: LEAST_CATCHMENT / land.max(LEAST_CATCHMENT) }
    }

    /// Returns the factor for the steepness of a cell whose greatest rill drains a share of the whole map, 0 if no rill
    /// passes. Slope falls with a power of the drained area (Flint 1974).
    pub fn factor(self, share: f32) -> f32 {
        const RIDGES: f32 = 0.25;
        const VALLEYS: f32 = 0.67;
        const CONCAVITY: f32 = 0.67;
        if share == 0.0 {
            return 1.0 + RIDGES * self.rills;
        }
        let times = (share / self.least_share).max(1.0);
        (1.0 - VALLEYS * self.rills) * libm::powf(times, -CONCAVITY * self.rills)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ground_is_the_gentler_the_more_a_rill_drains_and_steeper_without() {
        let law = Gentleness::new(0.6, 60_000.0);
        let factors = [0.0, 1e-5, 1e-3, 4e-3, 0.1].map(|share| law.factor(share));
        assert!(factors.is_sorted_by(|a, b| a >= b), "{factors:?}");
        assert!(factors[0] > 1.0 && factors[1] == factors[2] && factors[3] < factors[2], "{factors:?}");
        assert_eq!([0.0, 0.1].map(|share| Gentleness::new(0.0, 60_000.0).factor(share)), [1.0, 1.0]);
    }
}
