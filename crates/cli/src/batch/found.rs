//! Existing files of a map. Each form contains its recipe's link (or for JSON, the recipe itself) near its beginning,
//! and ends in a way that shows that it is complete. Comparing both makes a record of finished files unnecessary.

use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

use flate2::read::DeflateDecoder;
use rawzip::{RECOMMENDED_BUFFER_SIZE, ZipArchive};
use riverseed::domain::Domain;
use riverseed::export::rasters::{LINK_KEYWORD, Layer, Rasters};
use riverseed::export::{json, pack};
use riverseed::paint::View;
use riverseed::recipe::{Recipe, link};
use riverseed::relief::Grid;
use riverseed_exchange::engine::{normals, splat};
use riverseed_exchange::{self as exchange, Asked};

use super::super::form::Form;
use super::super::map::Options;

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
    /// Examines the place.
    pub fn at(path: &Path, form: Form, recipe: &Recipe, options: Options) -> Self {
        // Checked before opening, because a pipe would wait for a writer.
        if !fs::metadata(path).is_ok_and(|there| there.is_file()) {
            return Self::Nothing;
        }
        let Ok(mut file) = File::open(path) else { return Self::Nothing };
        match Wanted::of(form, recipe, options).is_in(&mut file) {
            Ok(true) => Self::Whole,
            Ok(false) | Err(_) => Self::Other,
        }
    }
}

/// The features by which a file is recognized.
enum Wanted {
    /// The beginning and the end.
    Text {
        head: String,
        tail: &'static str,
    },
    /// A part near the beginning, and the end.
    Markup {
        part: String,
        tail: &'static str,
    },
    Png(Png),
    Pack {
        picture: Png,
        raster: Png,
    },
    /// What its own reader says.
    Exchange(Form, Asked),
}

impl Wanted {
    fn of(form: Form, recipe: &Recipe, options: Options) -> Self {
        let link = link::write_for_file(recipe);
        match form {
            Form::Json => {
                let recipe = serde_json::to_string(&json::recipe(recipe)).unwrap_or_default();
                let tail = if options.has_attractors { "]}}\n" } else { "]}\n" };
                Self::Text { head: format!("{{\"recipe\":{recipe},"), tail }
            }
            Form::GeoJson => {
                let link = serde_json::Value::from(link);
                Self::Text { head: format!("{{\"type\":\"FeatureCollection\",\"riverseed\":{link},"), tail: "]}\n" }
            }
            // This is the only character of links that XML escapes.
            Form::Svg => Self::Markup { part: format!(">{}</metadata>", link.replace('&', "&amp;")), tail: "</svg>\n" },
            Form::Png => Self::Png(Png::picture(&link, recipe, options)),
            Form::Raster(layer) => Self::Png(Png::raster(&link, layer, recipe, options)),
            Form::Pack => Self::Pack {
                picture: Png::picture(&link, recipe, options),
                raster: Png::raster(&link, Layer::Heights, recipe, options),
            },
            Form::Normals | Form::Splat => Self::Png(Png::texture(&link, form, recipe, options)),
            Form::Splines => {
                let link = serde_json::Value::from(link);
                let [columns, rows] = sides_of_rasters(recipe, options);
                Self::Text { head: format!("{{\"riverseed\":{link},\"rasters\":[{columns},{rows}],"), tail: "]}\n" }
            }
            Form::HeightStyle => {
                Self::Markup { part: format!("value=\"{}\"", link.replace('&', "&amp;")), tail: "</qgis>\n" }
            }
            form => Self::Exchange(form, asked(form, link, recipe, options)),
        }
    }

    fn is_in(&self, file: &mut File) -> io::Result<bool> {
        match self {
            Self::Text { head, tail } => {
                Ok(ends_with(file, tail.as_bytes())? && start(file, head.len())? == head.as_bytes())
            }
            Self::Markup { part, tail } => {
                Ok(ends_with(file, tail.as_bytes())? && contains(&start(file, part.len() + NEAR)?, part.as_bytes()))
            }
            Self::Exchange(form, asked) => exchange::is_whole(*form, file, asked),
            Self::Png(png) => Ok(ends_with(file, Png::END)? && png.begins(&start(file, png.chunk.len() + NEAR)?)),
            Self::Pack { picture, raster } => is_pack(file, picture, raster),
        }
    }
}

/// The greatest distance of a link from the beginning of a file, in bytes: it may follow a seed as a title, or a few
/// small chunks.
const NEAR: usize = 2048;

/// The known parts of a PNG that has not been made yet.
struct Png {
    sides: [u32; 2],
    /// The chunk with the link.
    chunk: Vec<u8>,
    /// The beginning of the chunk that explains a raster's values; `None` for a picture.
    meaning: Option<Vec<u8>>,
}

impl Png {
    /// The last chunk of every PNG.
    const END: &[u8] = b"\0\0\0\0IEND\xae\x42\x60\x82";

    fn picture(link: &str, recipe: &Recipe, options: Options) -> Self {
        let (width, height) = View::sides_for(&Domain::of(recipe), options.size);
        Self { sides: [width, height], chunk: chunk(link), meaning: None }
    }

    fn raster(link: &str, layer: Layer, recipe: &Recipe, options: Options) -> Self {
        Self::of_cells(link, layer.subject(), recipe, options)
    }

    /// A texture made from rasters.
    fn texture(link: &str, form: Form, recipe: &Recipe, options: Options) -> Self {
        let subject = if form == Form::Normals { normals::SUBJECT } else { splat::SUBJECT };
        Self::of_cells(link, subject, recipe, options)
    }

    fn of_cells(link: &str, subject: &str, recipe: &Recipe, options: Options) -> Self {
        let meaning = [MEANING, subject.as_bytes()].concat();
        Self { sides: sides_of_rasters(recipe, options), chunk: chunk(link), meaning: Some(meaning) }
    }

    fn begins(&self, start: &[u8]) -> bool {
        let [width, height] = self.sides.map(u32::to_be_bytes);
        let has_meaning = match &self.meaning {
            Some(meaning) => contains(start, meaning),
            None => !contains(start, MEANING),
        };
        start.get(16..24) == Some(&[width, height].concat()) && contains(start, &self.chunk) && has_meaning
    }
}

/// Columns and rows of the rasters that the options ask for.
fn sides_of_rasters(recipe: &Recipe, options: Options) -> [u32; 2] {
    let domain = Domain::of(recipe);
    let own = Grid::of(&domain);
    let grid = options.raster_size.and_then(|size| Rasters::grid(&domain, size).ok()).unwrap_or(own);
    [grid.columns as u32, grid.rows as u32]
}

/// Makes what a file that this program does not read by itself has to hold.
fn asked(form: Form, link: String, recipe: &Recipe, options: Options) -> Asked {
    let rasters = match form {
        Form::Engine(engine) => [options.raster_size.unwrap_or(exchange::engine::usual(engine)); 2],
        _ => sides_of_rasters(recipe, options),
    };
    Asked { link, rasters, picture: View::sides_for(&Domain::of(recipe), options.size).into() }
}

/// The beginning of the chunk that explains a raster's values.
const MEANING: &[u8] = b"tEXtDescription\0";

/// The length, kind and content of the chunk with a link.
fn chunk(link: &str) -> Vec<u8> {
    let content = format!("{LINK_KEYWORD}\0{link}");
    [&(content.len() as u32).to_be_bytes()[..], b"tEXt", content.as_bytes()].concat()
}

/// Returns `true` if a complete archive contains this picture and rasters like this one.
fn is_pack(file: &File, picture: &Png, raster: &Png) -> io::Result<bool> {
    let mut buffer = vec![0; RECOMMENDED_BUFFER_SIZE];
    let archive = ZipArchive::from_file(file.try_clone()?, &mut buffer).map_err(io::Error::other)?;
    let mut entries = archive.entries(&mut buffer);
    let mut found = 0;
    while let Some(entry) = entries.next_entry().map_err(io::Error::other)? {
        let name = entry.file_path();
        let png = match name.as_ref() {
            name if name == pack::PICTURE.as_bytes() => picture,
            name if name == format!("{}.png", Layer::Heights.name()).as_bytes() => raster,
            _ => continue,
        };
        let content = archive.get_entry(entry.wayfinder()).map_err(io::Error::other)?;
        let mut start = Vec::new();
        DeflateDecoder::new(content.reader()).take((png.chunk.len() + NEAR) as u64).read_to_end(&mut start)?;
        found += u32::from(png.begins(&start));
    }
    Ok(found == 2)
}

fn ends_with(file: &mut File, end: &[u8]) -> io::Result<bool> {
    if file.metadata()?.len() < end.len() as u64 {
        return Ok(false);
    }
    file.seek(SeekFrom::End(-(end.len() as i64)))?;
    Ok(start_here(file, end.len())? == end)
}

fn start(file: &mut File, length: usize) -> io::Result<Vec<u8>> {
    file.rewind()?;
    start_here(file, length)
}

fn start_here(file: &mut File, length: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::with_capacity(length);
    file.take(length as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn contains(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}
