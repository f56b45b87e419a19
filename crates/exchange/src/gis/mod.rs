//! Files for geographic information systems: a GeoPackage with all layers, and rasters and pictures at their place.

pub mod crs;
mod feature;
mod features;
pub mod geojson;
pub mod geopackage;
pub mod geotiff;
mod heights;
pub mod layers;
mod segments;
pub mod style;
