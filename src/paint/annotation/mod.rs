//! Letters, trees and hills as masks, and how a picture lays them over its rivers.

mod feather;
pub(crate) mod letters;
pub(super) mod masks;
pub(crate) mod scenery;
