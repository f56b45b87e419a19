//! Files for game engines: heights as bare numbers, textures, rivers as lines in space, a mesh, and a pack of all that
//! for each engine, in its own axes and units.

mod beds;
pub mod gltf;
pub mod normals;
pub mod pack;
mod recipe;
mod sizes;
pub mod splat;
pub mod splines;
mod terrain;
mod textures;

pub use sizes::{EngineError, check, name, rasters, sizes, usual};
pub use terrain::Terrain;

use std::io::{Result, Write};

use riverseed::Map;
use riverseed::export::rasters::Rasters;

/// Writes the heights of a map as bare numbers; with beds, lowered under rivers.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub(crate) fn write_raw(out: impl Write, map: &Map, rasters: &Rasters, has_beds: bool) -> Result<()> {
    let terrain = Terrain::of(rasters);
    if has_beds { beds::lowered(&terrain, map, rasters)?.write_raw(out) } else { terrain.write_raw(out) }
}
