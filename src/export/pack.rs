//! A map's files for a game, in one archive: rasters, rivers, the picture, and a text with the scale.

#[cfg(feature = "pack")]
use std::io::{Error, Result, Write};
use std::ops::Range;

#[cfg(feature = "pack")]
use flate2::{Compression, write::DeflateEncoder};
#[cfg(feature = "pack")]
use rawzip::time::UtcDateTime;
#[cfg(feature = "pack")]
use rawzip::{CompressionMethod, ZipArchiveWriter};
#[cfg(feature = "pack")]
use tiny_skia::Pixmap;

use super::rasters::{Layer, Rasters, decimal, shortest};
#[cfg(feature = "pack")]
use super::{geojson, png};
#[cfg(feature = "pack")]
use crate::map::Map;
use crate::relief::METRES;

/// The file name of the text.
pub const README: &str = "README.txt";
/// The file name of the picture.
pub const PICTURE: &str = "map.png";
/// The file name of the rivers and of the land around them.
pub const FEATURES: &str = "map.geojson";

/// Makes the text of the README: the contents of each file, and the scale.
pub fn readme(rasters: &Rasters) -> String {
    let scale = rasters.scale;
    let mut text = format!(
        "A map by Riverseed. This draws it again:\n  {link}\n\n\
         SCALE\n\
         A raster has {columns} x {rows} pixels, north at the top. A pixel is {pixel} x {pixel} units.\n{part}\
         A unit of height is {unit} m. On the ground a unit is what you like; GeoJSON takes a hundredth of a degree, 1113 m.\n\
         Heights: 0 is {deepest} m, {sea} is the sea's surface, 65535 is {highest} m.\n\
         One step is {step} m: metres = (value - {sea}) * {step}\n\n\
         FILES\n",
        link = rasters.link,
        columns = rasters.columns,
        rows = rasters.rows,
        pixel = shortest(rasters.cell_size.into(), 6),
        part = rasters.part().map(|part| words_of(&part)).unwrap_or_default(),
        unit = decimal(METRES.into(), 0),
        deepest = decimal(scale.metres(0), 1),
        highest = decimal(scale.metres(u16::MAX), 1),
        sea = scale.sea_level,
        step = decimal(scale.metres_a_step, 6),
    );
    for layer in Layer::ALL {
        text += &format!("{}.png\n  {}\n", layer.name(), rasters.meaning(layer));
    }
    text += &format!("{FEATURES}\n  Land, basins, rivers, lakes and ridges (RFC 7946); heights of rivers in metres.\n");
    text += &format!("{PICTURE}\n  The picture in the style of the recipe.\n");
    text += "\nEvery river falls all along its way, no land is a pit, and flow directions lead from all land to the sea or off the map.\n";
    text
}

/// Says where the map lies in rasters that it does not fill.
fn words_of([columns, rows]: &[Range<usize>; 2]) -> String {
    format!(
        "The map takes {} x {} of them, from column {} and row {}, counted from 0; around it is sea.\n",
        columns.len(),
        rows.len(),
        columns.start,
        rows.start
    )
}

/// Writes the archive in the ZIP format, with the rasters and the picture of the map. A recipe always gives the same
/// bytes, because files have a fixed time.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
#[cfg(feature = "pack")]
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
#[cfg(feature = "pack")]
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
