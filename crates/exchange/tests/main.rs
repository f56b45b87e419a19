//! Files are read by readers of others, and hold what the map holds.
#![cfg(not(target_arch = "wasm32"))]

mod geopackage;
mod geotiff;
mod maps;
