//! Questions about a finished map: measures of the whole network, and what lies at a place.

pub mod query;
pub mod statistics;
