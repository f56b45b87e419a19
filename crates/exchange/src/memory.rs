//! Requests for memory before it is used, so that a shortage is an error instead of an abort.

use std::io::{Error, ErrorKind, Result};

use riverseed::Map;
use riverseed::tiny_skia::Pixmap;

use crate::form::Form;

/// Checks that bytes that are needed soon can be allocated.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask(bytes: usize) -> Result<()> {
    let megabytes = bytes / 1_000_000 + 1;
    let refused = || format!("this needs about {megabytes} MB, and the allocation failed");
    Vec::<u8>::new().try_reserve_exact(bytes).map_err(|_| Error::new(ErrorKind::OutOfMemory, refused()))
}

/// Checks that there is memory for the texts, names, labels and scenery of a finished map.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask_for_features(map: &Map) -> Result<()> {
    ask(bytes_of(map))
}

/// Checks that there is memory for a picture of a finished map besides its own pixels. Without it the library would
/// leave out letters and scenery.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask_for_picture(map: &Map, picture: &Pixmap) -> Result<()> {
    /// The masks of letters, woods and hills.
    const BYTES_A_PIXEL: usize = 9;
    let pixels = picture.width() as usize * picture.height() as usize;
    ask(bytes_of(map) + pixels * BYTES_A_PIXEL)
}

/// Checks that there is memory for a file of a finished map besides pixels and rasters.
///
/// # Errors
/// Fails if there is not enough memory.
pub(crate) fn ask_for_file(map: &Map, form: Form) -> Result<()> {
    /// The compressors of a pack's members, with their buffers, in bytes.
    const COMPRESSORS: usize = 6_000_000;
    ask(form.copies() * bytes_of(map) + if form.has_files() { COMPRESSORS } else { 0 })
}

fn bytes_of(map: &Map) -> usize {
    const BYTES_A_VERTEX: usize = 200;
    /// For columns, and for making names.
    const BYTES_A_NODE: usize = 60;
    /// For possible places of letters and trees, and their shapes.
    const BYTES: usize = 20_000_000;
    map.network().vertices.len() * BYTES_A_VERTEX + map.tree().len() * BYTES_A_NODE + BYTES
}
