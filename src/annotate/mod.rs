//! The annotation of a finished map: names, labels set in type, woods and hills.

mod divides;
#[doc(hidden)]
pub mod glyph;
#[doc(hidden)]
pub mod labels;
pub mod names;
#[doc(hidden)]
pub mod place;
mod plates;
#[doc(hidden)]
pub mod scenery;
