//! A map as the bytes of a file, the same as the command line writes.

use pyo3::prelude::*;
use riverseed::export::rasters::Layer;
use riverseed::recipe::shown;
use riverseed_exchange::gis::crs::{Crs, UnknownCrs};
use riverseed_exchange::{Files, Form, Options, Setting, check_size, is_ratio};

use crate::failure::{Done, Failure};
use crate::map::Map;
use crate::steps;

/// Finds the form of a file by its name, and refuses options that do not apply to it.
pub fn read(form: &str, options: &Options) -> Done<Form> {
    let refused = || Failure::Refused(format!("form: '{}' is not one of {}", shown(form), forms().join(", ")));
    let kind = Form::named(form).ok_or_else(refused)?;
    if let Some(setting) = options.misplaced(&[kind]) {
        return Err(Failure::Refused(format!("{} does not go with form '{form}'", name(setting))));
    }
    match options.ratio.filter(|ratio| !is_ratio(*ratio)) {
        Some(ratio) => Err(Failure::Refused(format!("ratio: {ratio} is not from 0.5 to 4, in quarters"))),
        None => Ok(kind),
    }
}

fn name(setting: Setting) -> &'static str {
    match setting {
        Setting::Size => "size",
        Setting::Ratio => "ratio",
        Setting::RasterSize => "raster_size",
        Setting::SvgText => "text",
        Setting::Sheet => "sheet",
        Setting::Beds => "beds",
        Setting::Attractors => "attractors",
        Setting::Segments => "segments",
        Setting::Flat => "flat",
        Setting::Crs => "crs",
    }
}

/// The options of a file as Python gives them: a dictionary of all.
#[derive(FromPyObject)]
pub struct Given {
    #[pyo3(item)]
    size: Option<u32>,
    #[pyo3(item)]
    ratio: Option<f32>,
    #[pyo3(item)]
    raster_size: Option<u32>,
    #[pyo3(item)]
    text: bool,
    #[pyo3(item)]
    segments: bool,
    #[pyo3(item)]
    flat: bool,
    #[pyo3(item)]
    crs: Option<String>,
}

impl Given {
    /// Reads the options, and refuses an unknown coordinate system.
    pub fn read(self) -> Done<Options> {
        let Self { size, ratio, raster_size, text, segments, flat, crs } = self;
        let refused = |text: &str, error: UnknownCrs| Failure::Refused(format!("crs: '{}' {error}", shown(text)));
        let crs = crs.map_or(Ok(Crs::Own), |text| text.parse().map_err(|error| refused(&text, error)))?;
        Ok(Options {
            size,
            ratio,
            raster_size,
            has_svg_text: text,
            has_segments: segments,
            is_flat: flat,
            crs,
            ..Options::default()
        })
    }
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
pub fn bytes(py: Python<'_>, map: &Map, form: Form, options: Options) -> PyResult<Vec<u8>> {
    let forms = [form];
    if let Some(size) = options.raster_size {
        // Before the relief is raised.
        map.read(py, |map| Ok(check_size(&forms, &map.domain(), size)?))?;
    }
    let picture = map.read(py, |map| Ok(options.picture(&forms, &map.domain())?))?;
    if form.has_relief() {
        map.raise_relief(py)?;
    }
    let mut files = map.read(py, |map| Ok(Files::make(map.clone(), &forms, options, picture)?))?;
    steps::run(py, || Ok(files.paint_part()))?;
    let mut bytes = Vec::new();
    py.detach(|| files.write(form, &mut bytes)).map_err(Failure::from)?;
    Ok(bytes)
}
