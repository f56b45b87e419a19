//! Takes a recipe to its pixels: all of the package `make`, and what `label`, which has names, and `engine` begin with.

pub(crate) mod link;
pub(crate) mod river;
