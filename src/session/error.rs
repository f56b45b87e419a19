//! Why a session cannot go on.

use thiserror::Error;

use crate::grow::GrowError;
use crate::network::ShapeError;
use crate::relief::ReliefError;

/// Why a recipe cannot be made into rivers.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// It cannot be grown.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// Its tree cannot be made into rivers.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// There can be no relief.
    #[error(transparent)]
    Relief(#[from] ReliefError),
    /// It cannot be copied.
    #[error("a copy of the rivers needs about {megabytes} MB, and the allocation failed")]
    Copy {
        /// About how much is needed.
        megabytes: u32,
    },
    /// The land that was given lies on another map than the recipe's.
    #[error(
        "the land given is for a map of {width} x {height} units, and the recipe's aspect makes one of {wanted_width} x {wanted_height}"
    )]
    OtherMap {
        /// Width of the land's domain, in units, rounded.
        width: u32,
        /// Its height.
        height: u32,
        /// Width of the recipe's domain.
        wanted_width: u32,
        /// Its height.
        wanted_height: u32,
    },
}
