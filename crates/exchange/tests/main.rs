//! Files are read by readers of others, and hold what the map holds.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod engines;
mod geopackage;
mod geotiff;
mod gltf_files;
mod hostile;
mod maps;
mod plots;
mod segments;
