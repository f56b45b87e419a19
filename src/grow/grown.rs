//! The result of growth, in numbers.

use super::{Ending, Growth};

/// The result of growth, in numbers: how much its tree reached, and the lengths by which it grew, in units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grown {
    /// Attractors scattered, or parcels of drainage: 0 for a Brownian tree.
    pub attractors: u32,
    /// Attractors that no river came near enough to, or parcels from which no way leads to the sea.
    pub unreached: u32,
    /// The discharge of a river that would drain the whole map; for a Brownian tree an estimate.
    pub total_discharge: u32,
    /// The mean distance between attractors: the unit of the three lengths below in a recipe.
    pub spacing: f32,
    /// The distance from which an attractor pulls.
    pub reach: f32,
    /// The distance from a river at which an attractor is used up.
    pub kill: f32,
    /// The length by which a river grows in a tick.
    pub step: f32,
    /// The approximate distance between streams: that between attractors, or the sensitivity.
    pub stream_spacing: f32,
    /// The way growth ended.
    pub ending: Ending,
}

impl Growth {
    /// Returns the result of growth; `None` while growth goes on.
    pub fn grown(&self) -> Option<Grown> {
        let settings = self.settings();
        Some(Grown {
            attractors: self.attractors(),
            unreached: self.unreached(),
            total_discharge: self.total_discharge(),
            spacing: settings.spacing,
            reach: settings.reach,
            kill: settings.kill,
            step: settings.step,
            stream_spacing: self.stream_spacing(),
            ending: self.ending()?,
        })
    }
}
