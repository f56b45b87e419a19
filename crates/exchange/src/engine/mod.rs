//! Files for game engines: heights as bare numbers, textures, rivers as lines in space, a mesh, and a pack of all that
//! for each engine, in its own axes and units.

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
pub use terrain::{METRES_A_UNIT, Terrain};
