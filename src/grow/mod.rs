//! Growing a tree of rivers, from the mouths upstream.
//!
//! Three procedures: [`Drainage`] finds the cheapest ways for water, [`Colonize`] is drawn on by attractors, [`Brownian`] is met by
//! wandering particles. All are steppers, and so is [`Growth`], which is whichever a recipe asks for: [`tick`](Growth::tick) until it
//! says that growth is over.
//! Slicing the work differently gives the same tree to the bit.

mod brownian;
mod colonize;
mod drainage;
mod grown;
mod growth;
mod mouths;
mod scatter;
mod settings;
mod starts;
mod watered;

pub use brownian::Brownian;
#[doc(hidden)]
pub use brownian::{ParticleOrder, Raster};
pub use colonize::Colonize;
#[doc(hidden)]
pub use colonize::{Pull, curl_toward, stem_nodes};
pub use drainage::{Capture, Drainage, DrainageSettings};
pub use grown::Grown;
pub use growth::Growth;
pub use mouths::Mouth;
#[doc(hidden)]
pub use mouths::{mouths, shores};
#[doc(hidden)]
pub use scatter::scatter;
pub use settings::GrowthSettings;
pub use starts::Start;

use thiserror::Error;

/// How growth came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// No node could grow any more, as the paper intends.
    Complete,
    /// The tree reached its limit of nodes.
    NodeLimit,
    /// There was not enough memory for more nodes.
    OutOfMemory,
}

/// Why a recipe cannot be grown here.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GrowError {
    /// There was not enough memory.
    #[error("attractors: {attractors} of them need about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// How many were asked for.
        attractors: u32,
        /// About how much they need.
        megabytes: u32,
    },
    /// There was not enough memory for a Brownian tree.
    #[error("growth: a Brownian tree needs about {megabytes} MB, and the allocation failed")]
    NoRoomForRaster {
        /// About how much it needs.
        megabytes: u32,
    },
}

/// What growth takes at the usual step and kill distance, as measured.
const BYTES_AN_ATTRACTOR: usize = 140;

impl GrowError {
    /// The error for settings that ask for too much.
    fn out_of_memory(settings: &GrowthSettings) -> Self {
        let attractors = settings.attractors;
        Self::OutOfMemory { attractors, megabytes: (attractors as usize * BYTES_AN_ATTRACTOR / 1_000_000) as u32 + 1 }
    }

    /// The error for a raster of too many cells: about 10 bytes a cell.
    fn no_room_for(cells: usize) -> Self {
        Self::NoRoomForRaster { megabytes: cells as u32 / 100_000 + 1 }
    }
}

/// How many parcels or attractors a front that follows valleys gains in a tick: about as many as lie along one side of the map.
fn front(count: usize) -> usize {
    ((count as f32).sqrt() as usize).max(8)
}
