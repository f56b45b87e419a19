//! Checks of existing files: one that is complete and what would be made now need not be made again.

use std::fs::File;
use std::io::{BufReader, Error, Read, Result, Seek};

use riverseed::export::Form;
use rusqlite::{Connection, MAIN_DB};
use tiff::decoder::Decoder;
use tiff::tags::Tag;

use crate::engine;
use crate::gis::{geopackage, geotiff};

/// The contents that a file has to have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asked {
    /// The link of the recipe.
    pub link: String,
    /// Columns and rows of the rasters.
    pub rasters: [u32; 2],
    /// Width and height of the picture, in pixels.
    pub picture: [u32; 2],
}

/// Returns `true` if a file has the contents and is complete. Files without a link, such as bare numbers, never are.
///
/// # Errors
/// Fails with the reader's errors, also for files of another form.
pub fn is_whole(form: Form, file: &mut File, asked: &Asked) -> Result<bool> {
    match form {
        Form::GeoPackage => is_geopackage(file, asked),
        Form::GeoTiff => is_geotiff(file, asked.picture, geotiff::PICTURE, asked),
        Form::RasterTiff(layer) => is_geotiff(file, asked.rasters, geotiff::subject(layer), asked),
        Form::Gltf => is_gltf(file, asked),
        Form::Engine(engine) => engine::pack::is_of(file, engine, &asked.link, asked.rasters[0], asked.picture),
        _ => Ok(false),
    }
}

fn is_gltf(file: &mut File, asked: &Asked) -> Result<bool> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(engine::gltf::about(&bytes) == Some(engine::gltf::extras(&asked.link, asked.rasters, asked.picture)))
}

fn is_geopackage(file: &mut File, asked: &Asked) -> Result<bool> {
    /// The offsets of the number of pages and of the size of a page in a file of SQLite.
    const PAGES: usize = 28;
    const PAGE_SIZE: usize = 16;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    let word = |at: usize| bytes.get(at..at + 2).map(|part| u64::from(part[0]) << 8 | u64::from(part[1]));
    let (Some(size), Some(high), Some(low)) = (word(PAGE_SIZE), word(PAGES), word(PAGES + 2)) else { return Ok(false) };
    if (high << 16 | low) * size != bytes.len() as u64 {
        return Ok(false);
    }
    let mut database = Connection::open_in_memory().map_err(Error::other)?;
    database.deserialize_read_exact(MAIN_DB, &bytes[..], bytes.len(), true).map_err(Error::other)?;
    Ok(geopackage::is_of(&database, &asked.link))
}

fn is_geotiff(file: &mut File, sides: [u32; 2], subject: &str, asked: &Asked) -> Result<bool> {
    file.rewind()?;
    let mut decoder = Decoder::new(BufReader::new(file)).map_err(Error::other)?;
    let (width, height) = decoder.dimensions().map_err(Error::other)?;
    let text = |decoder: &mut Decoder<_>, tag| decoder.get_tag_ascii_string(tag).map_err(Error::other);
    let description = text(&mut decoder, Tag::ImageDescription)?;
    let metadata = text(&mut decoder, geotiff::GDAL_METADATA)?;
    Ok([width, height] == sides && description.starts_with(subject) && metadata == geotiff::metadata(&asked.link))
}
