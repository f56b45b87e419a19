//! Questions about a finished map: measures of the whole network, what lies at a place, and whether it keeps its promises.

pub mod proof;
pub mod query;
pub mod statistics;
