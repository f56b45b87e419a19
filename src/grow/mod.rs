//! Growth of a tree of rivers, from the mouths upstream.
//!
//! There are three methods: [`Drainage`] finds the cheapest ways for water, [`Colonize`] follows attractors, and in
//! [`Brownian`] wandering particles meet rivers. All are steppers. [`Growth`] is the one that a recipe asks for: call
//! [`tick`](Growth::tick) until it returns `false`. Slicing the work differently gives the same tree, to the bit.

mod brownian;
mod colonize;
mod drainage;
mod grown;
mod growth;
mod mouth;
mod mouths;
mod scatter;
mod settings;
mod starts;
mod watered;

pub use brownian::Brownian;
pub use colonize::Colonize;
pub use drainage::{Capture, Drainage, DrainageSettings};
pub use grown::Grown;
pub use growth::Growth;
pub use mouth::Mouth;
pub use settings::GrowthSettings;
pub use starts::Start;
#[doc(hidden)] // The twins of growth in the tests rest on these.
pub use {
    brownian::{ParticleOrder, Raster},
    colonize::{Pull, curl_toward, stem_nodes},
    mouths::{mouths, shores},
    scatter::scatter,
};

use thiserror::Error;

/// The way growth ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// No node could grow any more, as in the paper.
    Complete,
    /// The tree reached its limit of nodes.
    NodeLimit,
    /// There was not enough memory for more nodes.
    OutOfMemory,
}

/// The reason why a recipe cannot be grown here.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GrowError {
    /// There was not enough memory.
    #[error("attractors: {attractors} of them need about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// The requested number of attractors.
        attractors: u32,
        /// The approximate memory that they need.
        megabytes: u32,
    },
    /// There was not enough memory for a Brownian tree.
    #[error("growth: a Brownian tree needs about {megabytes} MB, and the allocation failed")]
    NoRoomForRaster {
        /// The approximate memory that it needs.
        megabytes: u32,
    },
}

/// The memory of growth at the usual step and kill distance, as measured.
const BYTES_AN_ATTRACTOR: usize = 140;

impl GrowError {
    /// Makes the error for settings that need too much memory.
    fn out_of_memory(settings: &GrowthSettings) -> Self {
        let attractors = settings.attractors;
        Self::OutOfMemory { attractors, megabytes: (attractors as usize * BYTES_AN_ATTRACTOR / 1_000_000) as u32 + 1 }
    }

    /// Makes the error for a raster with too many cells, at about 10 bytes a cell.
    fn no_room_for(cells: usize) -> Self {
        Self::NoRoomForRaster { megabytes: cells as u32 / 100_000 + 1 }
    }
}

/// Returns the number of parcels or attractors that a front along valleys gains in a tick: about as many as lie along
/// one side of the map.
fn front(count: usize) -> usize {
    ((count as f32).sqrt() as usize).max(8)
}
