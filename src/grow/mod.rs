//! Growing a tree of rivers, from the mouths upstream.
//!
//! [`Colonize`] is a stepper: [`tick`](Colonize::tick) until it says that growth is over. Slicing the work
//! differently gives the same tree to the bit.

mod attractors;
mod changed;
mod colonize;
mod heading;
mod mouths;
mod parameters;
mod pull;
mod scatter;

pub use colonize::{Colonize, Ending, stem_nodes};
pub use mouths::{Mouth, mouths};
pub use parameters::Parameters;
pub use pull::Pull;
pub use scatter::scatter;

use thiserror::Error;

/// Why a recipe cannot be grown here.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GrowError {
    /// The memory was not to be had.
    #[error("attractors: {attractors} of them need about {megabytes} MB, which this machine does not give")]
    OutOfMemory {
        /// How many were asked for.
        attractors: u32,
        /// About how much they need.
        megabytes: u32,
    },
}

impl GrowError {
    /// The error for parameters that ask for too much: about 130 bytes an attractor, as measured.
    fn out_of_memory(parameters: &Parameters) -> Self {
        let attractors = parameters.attractors;
        Self::OutOfMemory { attractors, megabytes: attractors / 7_500 + 1 }
    }
}
