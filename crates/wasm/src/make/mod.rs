//! The package `make`: takes a recipe to its pixels.

pub(crate) mod link;
pub(crate) mod river;
