//! What stands on a finished map besides its rivers: names, labels set in type, woods and hills.

#[cfg(feature = "names")]
#[doc(hidden)]
pub mod builder;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod glyph;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod labels;
pub mod names;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod place;
#[cfg(feature = "names")]
mod plates;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod scenery;
