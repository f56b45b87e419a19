//! The reason why a relief cannot be made.

use thiserror::Error;

/// The reason why there can be no relief.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReliefError {
    /// There was not enough memory.
    #[error("the relief needs about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// The memory that is needed, approximately.
        megabytes: u32,
    },
}
