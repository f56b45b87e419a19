//! Requests for memory before the work that needs it, where the library's own requests do not cover it. With too little
//! memory the program must fail with an error, not by a signal.

use riverseed::Map;
use riverseed::picture::Picture;

use super::Failure;
use super::form::Form;

/// Memory for reading a call, including the table of parameters and small lists.
pub const START: usize = 3_000_000;

/// Checks that bytes can be allocated that are needed soon.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask(bytes: usize) -> Result<(), Failure> {
    let asked = Vec::<u8>::new().try_reserve_exact(bytes);
    asked.map_err(|_| Failure::Memory { megabytes: bytes.div_ceil(1_000_000) })
}

/// Checks that there is memory for a picture of a finished map besides its own pixels. Without it the library would
/// leave out letters and scenery.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask_for_picture(map: &Map, picture: &Picture) -> Result<(), Failure> {
    /// The masks of letters, woods and hills.
    const BYTES_A_PIXEL: usize = 9;
    let pixels = picture.pixmap().width() as usize * picture.pixmap().height() as usize;
    ask(bytes_of(map) + pixels * BYTES_A_PIXEL)
}

/// Checks that there is memory for a file of a finished map besides pixels and rasters.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask_for_file(map: &Map, form: Form) -> Result<(), Failure> {
    /// Those of a pack's members, with their buffers.
    const COMPRESSORS: usize = 6_000_000;
    match form {
        // Those of the second line ask for what they need by themselves.
        Form::Png | Form::Raster(_) => Ok(()),
        Form::RawHeights | Form::Normals | Form::Splat | Form::RasterTiff(_) | Form::GeoTiff | Form::Gltf => Ok(()),
        Form::Svg | Form::GeoJson | Form::Json | Form::Splines | Form::HeightStyle => ask(bytes_of(map)),
        // The features are in memory together, and then the file.
        Form::GeoPackage => ask(3 * bytes_of(map)),
        Form::Pack | Form::Engine(_) => ask(bytes_of(map) + COMPRESSORS),
    }
}

/// Memory for the texts, names, labels and scenery of a finished map.
fn bytes_of(map: &Map) -> usize {
    const BYTES_A_VERTEX: usize = 200;
    /// For columns, and for making names.
    const BYTES_A_NODE: usize = 60;
    /// For possible places of letters and trees, and their shapes.
    const BYTES: usize = 20_000_000;
    map.network().vertices.len() * BYTES_A_VERTEX + map.tree().len() * BYTES_A_NODE + BYTES
}
