//! Questions about a finished map: measures of the whole network, and what lies at a place.

#[cfg(all(feature = "files", feature = "controls"))]
#[doc(hidden)]
pub mod query;
pub mod statistics;
