//! Pictures and networks as files.

#[cfg(feature = "json")]
pub mod json;
#[cfg(feature = "png")]
pub mod png;
