//! `riverseed.render`: a map as the bytes of a file, those that the command line writes.

use std::io::{self, Write};

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use riverseed::domain::Domain;
use riverseed::export::rasters::Rasters;
use riverseed::export::{ExportError, Form, geojson, json, pack, png, svg};
use riverseed::recipe::{Recipe, link};
use riverseed::{Map, Session};

use crate::failure::{Done, Failure, raised};
use crate::map;
use crate::order::{self, Parameters};

/// What a file is made by besides its recipe.
struct Options {
    form: Form,
    size: u32,
    ratio: f32,
    raster_size: Option<u32>,
}

impl Options {
    /// The longer side of a picture, in pixels, unless another is asked for: that of the command line.
    const SIZE: u32 = 1200;

    fn read(form: &str, size: Option<u32>, ratio: Option<f32>, raster_size: Option<u32>) -> Done<Self> {
        let kind = named(form)?;
        let is_misplaced = [
            ("size", size.is_some() && !kind.has_pixels()),
            ("ratio", ratio.is_some() && !kind.has_pixels()),
            ("raster_size", raster_size.is_some() && !kind.has_rasters()),
        ];
        if let Some((option, _)) = is_misplaced.iter().find(|(_, is_misplaced)| *is_misplaced) {
            return Err(Failure::Refused(format!("{option} does not go with form '{form}'")));
        }
        let ratio = ratio.unwrap_or(1.0);
        if !((0.5..=4.0).contains(&ratio) && (ratio * 4.0).fract() == 0.0) {
            return Err(Failure::Refused(format!("ratio: {ratio} is not from 0.5 to 4, in quarters")));
        }
        Ok(Self { form: kind, size: size.unwrap_or(Self::SIZE), ratio, raster_size })
    }
}

fn named(form: &str) -> Done<Form> {
    let refused = || {
        let names: Vec<_> = Form::all().map(Form::name).collect();
        Failure::Refused(format!("form: '{}' is none of {}", shown(form), names.join(", ")))
    };
    Form::named(form).ok_or_else(refused)
}

/// Makes the bytes of a file.
#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    link: &str,
    parameters: Parameters,
    form: &str,
    size: Option<u32>,
    ratio: Option<f32>,
    raster_size: Option<u32>,
) -> PyResult<Bound<'py, PyBytes>> {
    let options = Options::read(form, size, ratio, raster_size)?;
    let recipe = order::recipe(link, parameters)?;
    check_raster_size(&recipe, options.raster_size)?;
    let bytes = match options.form {
        Form::Png | Form::Pack => with_picture(py, recipe, &options)?,
        Form::Raster(layer) => {
            let mut session = map::grow(py, recipe)?;
            let rasters = rasters(py, &mut session, options.raster_size)?;
            py.detach(|| written(|out| Ok(png::write_raster(out, &rasters, layer).map_err(io::Error::from)?)))?
        }
        Form::Svg | Form::GeoJson | Form::Json => {
            let map = map::grow(py, recipe)?.finish().map_err(Failure::from)?;
            py.detach(|| written(|out| write_text(out, &map, options.form)))?
        }
    };
    Ok(PyBytes::new(py, &bytes))
}

/// Whether rasters can be that long, before anything grows.
pub fn check_raster_size(recipe: &Recipe, size: Option<u32>) -> Done<()> {
    let grid = size.map(|size| Rasters::grid(&Domain::of(recipe), size));
    grid.transpose().map(drop).map_err(|error| Failure::from(error).of_option("raster_size"))
}

/// The rasters of a finished map.
pub fn rasters(py: Python<'_>, session: &mut Session, size: Option<u32>) -> PyResult<Rasters> {
    map::raise_relief(py, session)?;
    let map = session.finish().map_err(Failure::from)?;
    let made: Result<Rasters, ExportError> =
        py.detach(|| size.map_or_else(|| Rasters::new(&map), |size| Rasters::with_size(&map, size)));
    raised(made)
}

fn with_picture(py: Python<'_>, recipe: Recipe, options: &Options) -> PyResult<Vec<u8>> {
    let mut picture = map::picture(&recipe, options.size, options.ratio)?;
    let mut session = map::grow(py, recipe)?;
    let is_pack = options.form == Form::Pack;
    let rasters = is_pack.then(|| rasters(py, &mut session, options.raster_size)).transpose()?;
    map::paint(py, &mut picture, &session)?;
    let (map, pixmap) = (session.finish().map_err(Failure::from)?, picture.pixmap());
    let bytes = py.detach(|| {
        written(|out| match &rasters {
            Some(rasters) => Ok(pack::write(out, &map, rasters, pixmap)?),
            None => Ok(png::write(out, pixmap, &link::write(map.recipe())).map_err(io::Error::from)?),
        })
    });
    raised(bytes)
}

/// Texts end with a line, as files do.
fn write_text(out: &mut Vec<u8>, map: &Map, form: Form) -> Done<()> {
    match form {
        Form::Svg => out.write_all(svg::svg(map)?.as_bytes())?,
        Form::GeoJson => geojson::write(&mut *out, map)?,
        _ => json::write(&mut *out, map, None)?,
    }
    Ok(writeln!(out)?)
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> Done<()>) -> Done<Vec<u8>> {
    let mut bytes = Vec::new();
    write(&mut bytes)?;
    Ok(bytes)
}

/// A hostile text must not fill the screen.
fn shown(text: &str) -> String {
    const MOST: usize = 40;
    text.chars().take(MOST).map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
