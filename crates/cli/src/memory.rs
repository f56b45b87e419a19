//! Asking for memory before the work that takes it, where the library's own requests do not cover all of that: too little of it is an
//! error of this program, and never its end by a signal.

use riverseed::Map;
use riverseed::picture::Picture;

use super::Failure;
use super::form::Form;

/// What reading a call takes, the table of parameters and small lists included.
pub const START: usize = 3_000_000;

/// Asks for bytes that are taken soon after.
///
/// # Errors
/// If there are not so many.
pub fn ask(bytes: usize) -> Result<(), Failure> {
    let asked = Vec::<u8>::new().try_reserve_exact(bytes);
    asked.map_err(|_| Failure::Memory { megabytes: bytes.div_ceil(1_000_000) })
}

/// Asks for what a picture of a finished map takes besides its own pixels. Without room for letters and scenery the library would leave
/// them out.
///
/// # Errors
/// If there is not so much.
pub fn ask_for_picture(map: &Map, picture: &Picture) -> Result<(), Failure> {
    /// The masks of letters, woods and hills.
    const BYTES_A_PIXEL: usize = 8;
    let pixels = picture.pixmap().width() as usize * picture.pixmap().height() as usize;
    ask(bytes_of(map) + pixels * BYTES_A_PIXEL)
}

/// Asks for what a file of a finished map takes besides pixels and rasters.
///
/// # Errors
/// If there is not so much.
pub fn ask_for_file(map: &Map, form: Form) -> Result<(), Failure> {
    match form {
        Form::Png | Form::Raster(_) => Ok(()),
        Form::Svg | Form::GeoJson | Form::Json | Form::Pack => ask(bytes_of(map)),
    }
}

/// What texts, names, labels and scenery of a finished map take.
fn bytes_of(map: &Map) -> usize {
    const BYTES_A_VERTEX: usize = 200;
    /// Of columns, and of what names are made by.
    const BYTES_A_NODE: usize = 60;
    /// Where letters and trees may stand, and their shapes.
    const BYTES: usize = 20_000_000;
    map.network().vertices.len() * BYTES_A_VERTEX + map.tree().len() * BYTES_A_NODE + BYTES
}
