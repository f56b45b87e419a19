//! A file of each form, written from a map and what its form holds.

use std::io::{Error, ErrorKind, Result, Write};

use riverseed::Map;
use riverseed::export::rasters::Rasters;
use riverseed::export::{self, json, svg};
use riverseed::glam::Vec2;
use riverseed::recipe::link;
use riverseed::tiny_skia::Pixmap;

use crate::engine::normals::{self, Green};
use crate::engine::splines::{self, Axes};
use crate::engine::{self, Terrain, gltf, splat};
use crate::form::Form;
use crate::gis;
use crate::options::Options;
use crate::plot;

/// A map with what its files are made from.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The map, with its relief.
    pub map: &'a Map,
    /// Its rasters, for forms that have rasters.
    pub rasters: Option<&'a Rasters>,
    /// Its picture, for forms that have pixels.
    pub picture: Option<&'a Pixmap>,
    /// The attractors that its tree grew to, for JSON that lists them.
    pub attractors: Option<&'a [Vec2]>,
    /// The options of its files.
    pub options: &'a Options,
}

impl<'a> Source<'a> {
    fn rasters(&self) -> Result<&'a Rasters> {
        self.rasters.ok_or_else(|| missing("rasters"))
    }

    fn picture(&self) -> Result<&'a Pixmap> {
        self.picture.ok_or_else(|| missing("a picture"))
    }
}

fn missing(part: &str) -> Error {
    Error::new(ErrorKind::InvalidInput, format!("{part} must be given for files of this form"))
}

/// Writes a file.
///
/// # Errors
/// Fails if a part of the source is missing, if there is not enough memory, and with the writer's errors.
pub fn write(form: Form, mut out: &mut dyn Write, source: &Source<'_>) -> Result<()> {
    let (map, options) = (source.map, source.options);
    let domain = map.domain();
    let link = || link::write_for_file(map.recipe());
    match form {
        Form::Png => Ok(export::png::write(out, source.picture()?, &link())?),
        Form::Svg => {
            let drawn = if options.has_svg_text { svg::svg_with_text(map) } else { svg::svg(map) };
            writeln!(out, "{}", drawn.map_err(Error::other)?)
        }
        Form::Plot => plot::write(out, map, options.sheet()),
        Form::GeoJson => gis::geojson::write(out, map, options.has_segments, options.is_flat),
        Form::Json => json::write(&mut *out, map, source.attractors).and_then(|()| writeln!(out)),
        Form::Pack => export::pack::write(out, map, source.rasters()?, source.picture()?),
        Form::Raster(layer) => Ok(export::png::write_raster(out, source.rasters()?, layer)?),
        Form::RawHeights => engine::write_raw(out, map, source.rasters()?, options.has_beds(form)),
        Form::Normals => normals::write(out, &Terrain::of(source.rasters()?), Green::Up, &link()),
        Form::Splat => {
            let (rasters, terrain) = (source.rasters()?, Terrain::of(source.rasters()?));
            splat::write(out, &terrain, &splat::shares(rasters, &terrain)?, &link())
        }
        Form::Splines => splines::write(out, map, &Terrain::of(source.rasters()?), Axes::Plain),
        Form::Gltf => gltf::write(out, &domain, source.rasters()?, source.picture()?),
        Form::Engine(engine) => {
            let has_beds = options.has_beds(form);
            engine::pack::write(out, map, engine, source.rasters()?, source.picture()?, has_beds)
        }
        Form::GeoPackage => gis::geopackage::write(out, map, options.crs),
        Form::GeoTiff => gis::geotiff::write_picture(out, map, source.picture()?, &link(), options.crs),
        Form::RasterTiff(layer) => gis::geotiff::write_raster(out, &domain, source.rasters()?, layer, options.crs),
        Form::HeightStyle => gis::style::write_heights(&mut out, &link(), &map.scale()),
    }
}
