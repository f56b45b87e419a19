//! Existing files of a map. Each form contains its recipe's link (or for JSON, the recipe itself) near its beginning,
//! and ends in a way that shows that it is complete. Comparing both makes a record of finished files unnecessary.

mod png;
mod text;

use std::fs::{self, File};
use std::io::{BufReader, Error, Read, Result, Seek};
use std::path::Path;

use riverseed::domain::Domain;
use riverseed::export::json;
use riverseed::export::rasters::Rasters;
use riverseed::recipe::{Recipe, link};
use riverseed::relief::Grid;
use rusqlite::{Connection, MAIN_DB};
use serde_json::Value;
use tiff::decoder::Decoder;
use tiff::decoder::ifd;
use tiff::tags::Tag;

use self::png::{Png, is_pack};
use self::text::{is_between, is_marked};
use crate::engine::{self, normals, splat};
use crate::form::Form;
use crate::gis::crs::Crs;
use crate::gis::{geojson, geopackage, geotiff};
use crate::options::Options;
use crate::plot;

/// The state of a file's place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// There is no file, or none that can be read.
    Nothing,
    /// The complete file, as far as its content tells.
    Whole,
    /// Another file, or an incomplete one.
    Other,
}

impl Found {
    /// Examines the place of a recipe's file with these options.
    pub fn at(path: &Path, form: Form, recipe: &Recipe, options: &Options) -> Self {
        // Checked before opening, because a pipe would wait for a writer.
        if !fs::metadata(path).is_ok_and(|there| there.is_file()) {
            return Self::Nothing;
        }
        let Ok(mut file) = File::open(path) else { return Self::Nothing };
        match is_whole(form, &mut file, recipe, options) {
            Ok(true) => Self::Whole,
            Ok(false) | Err(_) => Self::Other,
        }
    }
}

/// The beginning of every SVG.
const SVG_HEAD: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
/// The beginning of every style of QGIS.
const QGIS_HEAD: &str = "<!DOCTYPE qgis ";

/// The contents that a file has to have.
struct Asked {
    /// The link of the recipe.
    link: String,
    /// Columns and rows of the rasters.
    rasters: [u32; 2],
    /// Width and height of the picture, in pixels.
    picture: [u32; 2],
    crs: Crs,
}

impl Asked {
    /// Finds what files of a recipe hold with these options.
    fn of(form: Form, recipe: &Recipe, options: &Options) -> Self {
        let domain = Domain::of(recipe);
        let rasters = match form {
            Form::Engine(engine) => [options.raster_size.unwrap_or(engine::usual(engine)); 2],
            _ => sides_of_rasters(&domain, options.raster_size),
        };
        Self { link: link::write_for_file(recipe), rasters, picture: options.sides(&domain), crs: options.crs }
    }
}

/// Returns columns and rows of rasters with this longer side.
fn sides_of_rasters(domain: &Domain, longer: Option<u32>) -> [u32; 2] {
    let own = Grid::of(domain);
    let grid = longer.and_then(|size| Rasters::grid(domain, size).ok()).unwrap_or(own);
    [grid.columns as u32, grid.rows as u32]
}

/// Returns `true` if a file is complete and has the contents. Bare numbers, which have no link, never are.
fn is_whole(form: Form, file: &mut File, recipe: &Recipe, options: &Options) -> Result<bool> {
    let asked = &Asked::of(form, recipe, options);
    let link = || Value::from(asked.link.as_str());
    // This is the only character of links that XML escapes.
    let escaped = || asked.link.replace('&', "&amp;");
    match form {
        Form::Png => Png::picture(asked).is_in(file),
        Form::Svg => is_marked(file, SVG_HEAD, &format!(">{}</metadata>", escaped()), "</svg>\n"),
        Form::Plot => {
            let head = plot::head(&Domain::of(recipe), options.sheet());
            is_marked(file, &head, &format!(">{}</metadata>", escaped()), "</svg>\n")
        }
        Form::GeoJson => is_between(file, &geojson::head(&asked.link, options.has_segments, options.is_flat), "]}\n"),
        Form::Json => {
            let recipe = serde_json::to_string(&json::recipe(recipe)).unwrap_or_default();
            let tail = if options.has_attractors { "]}}\n" } else { "]}\n" };
            is_between(file, &format!("{{\"recipe\":{recipe},"), tail)
        }
        Form::Pack => is_pack(file, asked),
        Form::Raster(layer) => Png::of_cells(asked, layer.subject()).is_in(file),
        Form::RawHeights => Ok(false),
        Form::Normals => Png::of_cells(asked, normals::SUBJECT).is_in(file),
        Form::Splat => Png::of_cells(asked, splat::SUBJECT).is_in(file),
        Form::Splines => {
            let [columns, rows] = asked.rasters;
            is_between(file, &format!("{{\"riverseed\":{},\"rasters\":[{columns},{rows}],", link()), "]}\n")
        }
        Form::Gltf => is_gltf(file, asked),
        Form::Engine(engine) => {
            let has_beds = options.has_beds(form);
            engine::pack::is_of(file, engine, &asked.link, asked.rasters[0], asked.picture, has_beds)
        }
        Form::GeoPackage => is_geopackage(file, asked),
        Form::GeoTiff => is_geotiff(file, asked.picture, geotiff::PICTURE, asked),
        Form::RasterTiff(layer) => is_geotiff(file, asked.rasters, geotiff::subject(layer), asked),
        Form::HeightStyle => is_marked(file, QGIS_HEAD, &format!("value=\"{}\"", escaped()), "</qgis>\n"),
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
    Ok(geopackage::is_of(&database, &asked.link, asked.crs))
}

fn is_geotiff(file: &mut File, sides: [u32; 2], subject: &str, asked: &Asked) -> Result<bool> {
    file.rewind()?;
    let mut decoder = Decoder::new(BufReader::new(file)).map_err(Error::other)?;
    let (width, height) = decoder.dimensions().map_err(Error::other)?;
    let text = |decoder: &mut Decoder<_>, tag| decoder.get_tag_ascii_string(tag).map_err(Error::other);
    let description = text(&mut decoder, Tag::ImageDescription)?;
    let metadata = text(&mut decoder, geotiff::GDAL_METADATA)?;
    let keys = decoder.find_tag(Tag::GeoKeyDirectoryTag).map_err(Error::other)?;
    let keys = keys.map_or(Ok(Vec::new()), ifd::Value::into_u16_vec).map_err(Error::other)?;
    let is_here = keys == geotiff::keys(asked.crs).0;
    Ok(is_here
        && [width, height] == sides
        && description.starts_with(subject)
        && metadata == geotiff::metadata(&asked.link))
}
