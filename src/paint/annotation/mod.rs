//! Letters, trees and hills as masks, and how a picture lays them over its rivers.

#[cfg(feature = "names")]
mod feather;
#[cfg(feature = "names")]
pub(crate) mod letters;
pub(super) mod masks;
#[cfg(feature = "names")]
pub(crate) mod scenery;
