//! A map as the bytes of a file, the same as the command line writes.

use std::io::{self, Write};
use std::num::NonZero;

use pyo3::prelude::*;
use riverseed::export::rasters::{Layer, Rasters};
use riverseed::export::{Engine, Form, geojson, json, pack, png, svg};
use riverseed::picture::Picture;
use riverseed::recipe::{link, shown};
use riverseed_exchange::engine::EngineError;
use riverseed_exchange::{self as exchange, Source};

use crate::failure::{Done, Failure};
use crate::map::Map;
use crate::relief::rasters;

/// The options of a file, besides its map.
pub struct Options {
    form: Form,
    size: u32,
    ratio: f32,
    raster_size: Option<u32>,
    has_svg_text: bool,
}

impl Options {
    /// The default length of a picture's longer side in pixels, as on the command line.
    const SIZE: u32 = 1200;

    /// Reads the options of a file, and refuses those that do not apply to its form.
    pub fn read(
        form: &str,
        size: Option<u32>,
        ratio: Option<f32>,
        raster_size: Option<u32>,
        has_svg_text: bool,
    ) -> Done<Self> {
        let kind = named(form)?;
        let is_misplaced = [
            ("size", size.is_some() && !kind.has_pixels()),
            ("ratio", ratio.is_some() && !kind.has_pixels()),
            ("raster_size", raster_size.is_some() && !kind.has_rasters()),
            ("text", has_svg_text && kind != Form::Svg),
        ];
        if let Some((option, _)) = is_misplaced.iter().find(|(_, is_misplaced)| *is_misplaced) {
            return Err(Failure::Refused(format!("{option} does not go with form '{form}'")));
        }
        let ratio = ratio.unwrap_or(1.0);
        if !((0.5..=4.0).contains(&ratio) && (ratio * 4.0).fract() == 0.0) {
            return Err(Failure::Refused(format!("ratio: {ratio} is not from 0.5 to 4, in quarters")));
        }
        Ok(Self { form: kind, size: size.unwrap_or(Self::SIZE), ratio, raster_size, has_svg_text })
    }
}

fn named(form: &str) -> Done<Form> {
    let refused = || Failure::Refused(format!("form: '{}' is not one of {}", shown(form), forms().join(", ")));
    Form::named(form).ok_or_else(refused)
}

/// Lists the forms of a file, as the endings of their names.
pub fn forms() -> Vec<&'static str> {
    Form::all().map(Form::name).collect()
}

/// Lists the rasters that can be written to a file.
pub fn layers() -> Vec<&'static str> {
    Layer::ALL.map(Layer::name).to_vec()
}

/// Finds the form of a file by the ending of its name.
#[pyfunction]
pub fn form_of_file(name: &str) -> PyResult<&'static str> {
    let endings = || forms().join(", .");
    let refused = || Failure::Refused(format!("path: '{}' ends with none of .{}", shown(name), endings()));
    Ok(Form::of_file(name).ok_or_else(refused)?.name())
}

/// Makes the bytes of a file.
pub fn bytes(py: Python<'_>, map: &Map, options: &Options) -> PyResult<Vec<u8>> {
    match options.form {
        Form::Png => {
            let picture = map.paint(py, options.size, options.ratio)?;
            map.read(py, |map| {
                let link = link::write_for_file(map.recipe());
                written(|out| Ok(png::write(out, picture.pixmap(), &link).map_err(io::Error::from)?))
            })
        }
        Form::Pack => {
            let rasters = rasters(py, map, options.raster_size)?;
            let picture = map.paint(py, options.size, options.ratio)?;
            map.read(py, |map| written(|out| Ok(pack::write(out, map, &rasters, picture.pixmap())?)))
        }
        Form::Raster(layer) => {
            let rasters = rasters(py, map, options.raster_size)?;
            Ok(py.detach(|| raster(&rasters, layer))?)
        }
        Form::Svg | Form::GeoJson | Form::Json => {
            if options.form.has_relief() {
                map.raise_relief(py)?;
            }
            map.read(py, |map| written(|out| write_text(out, map, options)))
        }
        form => exchanged(py, map, form, options),
    }
}

/// Makes the bytes of a file for an engine or a geographic information system.
fn exchanged(py: Python<'_>, map: &Map, form: Form, options: &Options) -> PyResult<Vec<u8>> {
    if form.has_relief() {
        map.raise_relief(py)?;
    }
    let rasters = match form {
        Form::Engine(engine) => Some(landscape(py, map, engine, options.raster_size)?),
        form if form.has_rasters() => Some(rasters(py, map, options.raster_size)?),
        _ => None,
    };
    let picture = form.has_pixels().then(|| map.paint(py, options.size, options.ratio)).transpose()?;
    map.read(py, |map| {
        let source = Source { map, rasters: rasters.as_ref(), picture: picture.as_ref().map(Picture::pixmap) };
        written(|out| Ok(exchange::write(form, out, &source)?))
    })
}

/// Makes the square rasters of an engine.
fn landscape(py: Python<'_>, map: &Map, engine: Engine, size: Option<u32>) -> PyResult<Rasters> {
    let refused = |error: EngineError| match error {
        EngineError::Export(error) => Failure::from(error).of_option("raster_size"),
        error => Failure::Refused(format!("raster_size: {error}")),
    };
    map.read(py, |map| exchange::engine::rasters(map, engine, size, NonZero::<usize>::MIN).map_err(refused))
}

fn raster(rasters: &Rasters, layer: Layer) -> Done<Vec<u8>> {
    written(|out| Ok(png::write_raster(out, rasters, layer).map_err(io::Error::from)?))
}

/// Writes text that ends with a line break, as files do.
fn write_text(out: &mut Vec<u8>, map: &riverseed::Map, options: &Options) -> Done<()> {
    match options.form {
        Form::Svg if options.has_svg_text => out.write_all(svg::svg_with_text(map)?.as_bytes())?,
        Form::Svg => out.write_all(svg::svg(map)?.as_bytes())?,
        Form::GeoJson => geojson::write(&mut *out, map)?,
        Form::Json => json::write(&mut *out, map, None)?,
        // These are no texts, or not of the core.
        _ => {}
    }
    Ok(writeln!(out)?)
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> Done<()>) -> Done<Vec<u8>> {
    let mut bytes = Vec::new();
    write(&mut bytes)?;
    Ok(bytes)
}
