//! A map as the bytes of a file, the same as the command line writes.

use std::io::{self, Write};
use std::num::NonZero;

use pyo3::prelude::*;
use riverseed::export::rasters::{Layer, Rasters};
use riverseed::export::{Form, geojson, json, pack, png, svg};
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
        Form::Svg => text(py, map, |map, out| {
            let svg = if options.has_svg_text { svg::svg_with_text(map) } else { svg::svg(map) };
            Ok(out.write_all(svg?.as_bytes())?)
        }),
        Form::GeoJson => {
            map.raise_relief(py)?;
            text(py, map, |map, out| Ok(geojson::write(out, map)?))
        }
        Form::Json => text(py, map, |map, out| Ok(json::write(out, map, None)?)),
        form @ (Form::RawHeights
        | Form::Normals
        | Form::Splat
        | Form::Splines
        | Form::Gltf
        | Form::Engine(_)
        | Form::GeoPackage
        | Form::GeoTiff
        | Form::RasterTiff(_)
        | Form::HeightStyle) => exchanged(py, map, form, options),
    }
}

/// Makes the bytes of a file for an engine or a geographic information system.
fn exchanged(py: Python<'_>, map: &Map, form: Form, options: &Options) -> PyResult<Vec<u8>> {
    if let Some(size) = options.raster_size {
        // Before the relief is raised.
        map.read(py, |map| exchange::check_size(&[form], &map.domain(), size).map_err(refused_size))?;
    }
    if form.has_relief() {
        map.raise_relief(py)?;
    }
    let rasters = map.read(py, |map| {
        exchange::rasters(form, map, options.raster_size, NonZero::<usize>::MIN).map_err(refused_size)
    })?;
    let picture = form.has_pixels().then(|| map.paint(py, options.size, options.ratio)).transpose()?;
    map.read(py, |map| {
        let source = Source { map, rasters: rasters.as_ref(), picture: picture.as_ref().map(Picture::pixmap) };
        written(|out| Ok(exchange::write(form, out, &source)?))
    })
}

fn refused_size(error: EngineError) -> Failure {
    match error {
        EngineError::Export(error) => Failure::from(error).of_option("raster_size"),
        error => Failure::Refused(format!("raster_size: {error}")),
    }
}

fn raster(rasters: &Rasters, layer: Layer) -> Done<Vec<u8>> {
    written(|out| Ok(png::write_raster(out, rasters, layer).map_err(io::Error::from)?))
}

/// Makes text that ends with a line break, as files do.
fn text(
    py: Python<'_>,
    map: &Map,
    write: impl FnOnce(&riverseed::Map, &mut Vec<u8>) -> Done<()> + Send,
) -> PyResult<Vec<u8>> {
    map.read(py, |map| {
        written(|out| {
            write(map, out)?;
            Ok(writeln!(out)?)
        })
    })
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> Done<()>) -> Done<Vec<u8>> {
    let mut bytes = Vec::new();
    write(&mut bytes)?;
    Ok(bytes)
}
