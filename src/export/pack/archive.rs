//! The archive.

use std::io::{Error, Result, Write};

use flate2::{Compression, write::DeflateEncoder};
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use tiny_skia::Pixmap;

use super::super::rasters::{Layer, Rasters};
use super::super::{geojson, png};
use super::{FEATURES, PICTURE, README, readme};
use crate::map::Map;

/// Writes the archive in the ZIP format, with the rasters and the picture of the map. A recipe always gives the same
/// bytes, because files have a fixed time.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(out: impl Write, map: &Map, rasters: &Rasters, picture: &Pixmap) -> Result<()> {
    let mut archive = ZipArchiveWriter::new(out);
    add(&mut archive, README, |file| file.write_all(readme(rasters).as_bytes()))?;
    for layer in Layer::ALL {
        let name = format!("{}.png", layer.name());
        add(&mut archive, &name, |file| Ok(png::write_raster(file, rasters, layer)?))?;
    }
    add(&mut archive, FEATURES, |file| geojson::write(file, map))?;
    add(&mut archive, PICTURE, |file| Ok(png::write(file, picture, &rasters.link)?))?;
    archive.finish().map(drop).map_err(Error::other)
}

/// Adds a file to an archive, compressed and with a fixed time.
///
/// # Errors
/// Fails with the errors of the writer and of the file's content.
pub fn add<W: Write>(
    archive: &mut ZipArchiveWriter<W>,
    name: &str,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    /// The earliest time in a ZIP, 1980-01-01. It is fixed so that the bytes are the same on any day.
    const EARLIEST: i64 = 315_532_800;
    let moment = UtcDateTime::from_unix(EARLIEST);
    let file = archive.new_file(name).last_modified(moment).compression_method(CompressionMethod::DEFLATE);
    let (mut entry, config) = file.start().map_err(Error::other)?;
    let mut content = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
    write(&mut content)?;
    let (encoder, descriptor) = content.finish().map_err(Error::other)?;
    encoder.finish()?;
    entry.finish(descriptor).map(drop).map_err(Error::other)
}
