//! Errors of a session.

use thiserror::Error;

use crate::grow::GrowError;
use crate::network::ShapeError;
use crate::relief::ReliefError;

/// Reasons why a recipe cannot be made into rivers.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// The recipe cannot be grown.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// The tree cannot be made into rivers.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// The relief cannot be made.
    #[error(transparent)]
    Relief(#[from] ReliefError),
    /// The session cannot be copied.
    #[error("a copy of the rivers needs about {megabytes} MB, and the allocation failed")]
    Copy {
        /// Approximate memory needed, in MB.
        megabytes: u32,
    },
    /// The given land belongs to a map of another size than the recipe's.
    #[error(
        "the land given is for a map of {width} x {height} units, and the recipe's aspect makes one of {wanted_width} x {wanted_height}"
    )]
    OtherMap {
        /// Width of the land's domain, in units, rounded.
        width: u32,
        /// Height of the land's domain.
        height: u32,
        /// Width of the recipe's domain.
        wanted_width: u32,
        /// Height of the recipe's domain.
        wanted_height: u32,
    },
}
