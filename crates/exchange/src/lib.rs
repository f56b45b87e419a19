//! Maps as files for game engines and geographic information systems.
//!
//! The core makes pictures, rasters and features; here they become files that other programs read. The command line and
//! the Python package both call `write`, with a map and what its form is made from.
//!
//! Two scales are chosen here. Geographic information systems have 1113.2 m to a unit, as the map's scale bar has it
//! (`gis::crs`); game engines have 50 m (`engine::METRES_A_UNIT`).
//!
//! As wasm it is empty: no page writes these files.
#![cfg(not(target_arch = "wasm32"))]

pub mod engine;
mod found;
pub mod gis;
mod memory;
mod rasters;
mod xml;

pub use found::{Asked, is_whole};
pub use rasters::{check_size, rasters};

use std::io::{Error, ErrorKind, Result, Write};

use engine::normals::{self, Green};
use engine::splines::{self, Axes};
use engine::{Terrain, gltf, pack, splat};
use riverseed::Map;
use riverseed::export::Form;
use riverseed::export::rasters::Rasters;
use riverseed::recipe::link;
use riverseed::tiny_skia::Pixmap;

/// A map with what its files are made from.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The map, with its relief.
    pub map: &'a Map,
    /// Its rasters, for forms that have rasters.
    pub rasters: Option<&'a Rasters>,
    /// Its picture, for forms that have pixels.
    pub picture: Option<&'a Pixmap>,
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
/// Fails for forms that the core makes, if a part of the source is missing, if there is not enough memory, and with the
/// writer's errors.
pub fn write(form: Form, mut out: &mut dyn Write, source: &Source<'_>) -> Result<()> {
    let domain = source.map.domain();
    let link = || link::write_for_file(source.map.recipe());
    match form {
        Form::RawHeights => Terrain::of(source.rasters()?).write_raw(out),
        Form::Normals => normals::write(out, &Terrain::of(source.rasters()?), Green::Up, &link()),
        Form::Splat => {
            let (rasters, terrain) = (source.rasters()?, Terrain::of(source.rasters()?));
            splat::write(out, &terrain, &splat::shares(rasters, &terrain)?, &link())
        }
        Form::Splines => splines::write(out, source.map, &Terrain::of(source.rasters()?), Axes::Plain),
        Form::Gltf => gltf::write(out, &domain, source.rasters()?, source.picture()?),
        Form::Engine(engine) => pack::write(out, source.map, engine, source.rasters()?, source.picture()?),
        Form::GeoPackage => gis::geopackage::write(out, source.map),
        Form::GeoTiff => gis::geotiff::write_picture(out, &domain, source.picture()?, &link()),
        Form::RasterTiff(layer) => gis::geotiff::write_raster(out, &domain, source.rasters()?, layer),
        Form::HeightStyle => gis::style::write_heights(&mut out, &link()),
        Form::Png | Form::Svg | Form::GeoJson | Form::Json | Form::Pack | Form::Raster(_) => {
            Err(Error::new(ErrorKind::InvalidInput, format!(".{} files are written by the core", form.name())))
        }
    }
}
