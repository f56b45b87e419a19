//! Pictures and networks as files.
//!
//! The contents of a file are built as plain data, for programs and pages alike. Only programs write JSON as text.

mod banks;
mod data;
pub mod degrees;
pub mod geojson;
pub mod json;
mod levels;
mod names;
pub mod pack;
#[cfg(feature = "png")]
pub mod png;
mod polygons;
pub mod rasters;
mod rings;
pub mod svg;
mod waters;

pub use data::Json;

use thiserror::Error;

use crate::base::memory;
use crate::map::Map;
use crate::network::Network;

/// Reasons why a file cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// Rasters of this map cannot have that many pixels.
    #[error("rasters of this map are from {least} to {most} pixels long, not {size}")]
    RasterSize {
        /// The requested number of pixels on the longer side.
        size: u32,
        /// The smallest possible number.
        least: u32,
        /// The greatest possible number.
        most: u32,
    },
    /// There was not enough memory.
    #[error("the file needs about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// Approximate memory needed, in MB.
        megabytes: u32,
    },
}

/// Returns the rivers of a map, if there is enough memory for each of their vertices.
fn rivers(map: &Map, bytes_a_vertex: usize) -> Result<&Network, ExportError> {
    let network: &Network = map.network();
    let vertices = network.vertices.len() + network.oxbows.iter().map(|oxbow| oxbow.vertices.len()).sum::<usize>();
    let bytes = vertices.saturating_mul(bytes_a_vertex);
    if !memory::can_allocate(bytes) {
        return Err(ExportError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 });
    }
    Ok(network)
}
