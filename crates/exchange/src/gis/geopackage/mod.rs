//! GeoPackage (OGC 12-128r18): the map as one SQLite file with a table for each layer.
//!
//! The same map always gives the same bytes: no row holds the current time. Styles are rows of `layer_styles`, which
//! QGIS applies by itself.

mod binary;
mod schema;

use std::io::{Error, Result, Write};

use riverseed::Map;
use rusqlite::types::Value;
use rusqlite::{Connection, params, params_from_iter};

use super::crs::Crs;
use super::feature::Feature;
use super::features::Collection;
use super::layers::{Column, LAYERS, Layer};
use super::style;
use crate::xml::escaped;
use riverseed::export::Json;

/// Writes the layers of a map, in a coordinate system.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(mut out: impl Write, map: &Map, crs: Crs) -> Result<()> {
    let collection = Collection::of(map)?;
    let mut database = database(&collection, crs).map_err(Error::other)?;
    let bytes = database.serialize("main").map_err(Error::other)?;
    out.write_all(&bytes)
}

/// Returns `true` if a database is the GeoPackage of the map with this link, in this coordinate system.
pub fn is_of(database: &Connection, link: &str, crs: Crs) -> bool {
    let read = || database.query_row("SELECT metadata FROM gpkg_metadata", [], |row| row.get::<_, String>(0));
    has_own_metadata(database) && read().is_ok_and(|metadata| metadata.starts_with(&head(link, crs)))
}

/// Returns `true` if metadata are in a table that was made as ours are. A view or a virtual table of somebody else may compute
/// for ever when it is read.
fn has_own_metadata(database: &Connection) -> bool {
    const MADE_BY: &str = "SELECT sql FROM sqlite_schema WHERE type = 'table' AND name = 'gpkg_metadata'";
    let made_by: rusqlite::Result<String> = database.query_row(MADE_BY, [], |row| row.get(0));
    made_by.is_ok_and(|statement| schema::TABLES.contains(&format!("\n{statement};\n")))
}

/// Writes an item of metadata as GDAL writes it.
fn item(key: &str, value: &str) -> String {
    format!("    <MDI key=\"{key}\">{}</MDI>\n", escaped(value))
}

/// Writes the beginning of the metadata: the coordinate system if it is not the map's own, and the link.
fn head(link: &str, crs: Crs) -> String {
    let crs = if crs == Crs::Own { String::new() } else { item("crs", &crs.to_string()) };
    format!("<GDALMultiDomainMetadata>\n  <Metadata>\n{crs}{}", item("riverseed", link))
}

fn database(collection: &Collection<'_>, crs: Crs) -> rusqlite::Result<Connection> {
    let mut database = Connection::open_in_memory()?;
    let work = database.transaction()?;
    work.execute_batch(schema::TABLES)?;
    if let Some((name, organization, definition)) = crs.row() {
        work.execute(
            "INSERT INTO gpkg_spatial_ref_sys VALUES (?1, ?2, ?3, ?2, ?4, 'The map lies nowhere on Earth: its centre is the origin')",
            params![name, crs.number(), organization, definition],
        )?;
    }
    for layer in &LAYERS {
        add_layer(&work, layer, collection, crs.number())?;
    }
    add_styles(&work, collection)?;
    add_metadata(&work, collection, crs)?;
    work.commit()?;
    Ok(database)
}

/// Adds a layer with its features.
fn add_layer(work: &Connection, layer: &Layer, collection: &Collection<'_>, system: i32) -> rusqlite::Result<()> {
    work.execute_batch(&schema::table(layer))?;
    let mut insert = work.prepare(&schema::insertion(layer))?;
    let mut around = Bounds::NONE;
    for feature in collection.features.iter().filter(|feature| layer.kinds.contains(&feature.kind())) {
        let shape = Value::Blob(binary::geometry(&feature.shape, system));
        around = around.with(binary::bounds(&feature.shape));
        let values = layer.columns.iter().map(|column| value(column, feature));
        insert.execute(params_from_iter(std::iter::once(shape).chain(values)))?;
    }
    let [west, south, east, north] = around.or_null();
    let described = format!("{} Made by {}", layer.description, collection.link);
    work.execute(
        "INSERT INTO gpkg_contents VALUES (?1, 'features', ?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)",
        params![layer.name, described, schema::MOMENT, west, south, east, north, system],
    )?;
    work.execute(
        "INSERT INTO gpkg_geometry_columns VALUES (?1, 'geom', ?2, ?3, ?4, 0)",
        params![layer.name, layer.geometry, system, layer.has_heights],
    )?;
    Ok(())
}

/// Makes the value of a feature in a column.
fn value(column: &Column, feature: &Feature<'_>) -> Value {
    match feature.property(column.name) {
        Some(Json::Whole(whole)) => Value::Integer(*whole),
        Some(Json::Single(single)) => Value::Real(f64::from(*single)),
        Some(Json::Double(double)) => Value::Real(*double),
        Some(Json::Text(text)) => Value::Text((*text).into()),
        Some(Json::Owned(text)) => Value::Text(text.clone()),
        _ => Value::Null,
    }
}

fn add_styles(work: &Connection, collection: &Collection<'_>) -> rusqlite::Result<()> {
    for layer in &LAYERS {
        work.execute(
            "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, \
             styleQML, useAsDefault, description, update_time) VALUES ('', '', ?1, 'geom', 'Riverseed', ?2, 1, '', ?3)",
            params![layer.name, style::of_layer(layer.name), schema::MOMENT],
        )?;
    }
    let described = format!("Styles for QGIS. Made by {}", collection.link);
    work.execute(
        "INSERT INTO gpkg_contents VALUES ('layer_styles', 'attributes', 'layer_styles', ?1, ?2, NULL, NULL, NULL, NULL, NULL)",
        params![described, schema::MOMENT],
    )?;
    Ok(())
}

/// Adds the coordinate system, the link and the title as metadata, in the form in which GDAL shows them as those of the file.
fn add_metadata(work: &Connection, collection: &Collection<'_>, crs: Crs) -> rusqlite::Result<()> {
    let title = collection.title.as_deref().map(|title| item("title", title)).unwrap_or_default();
    let head = head(&collection.link, crs);
    let metadata = format!("{head}{title}  </Metadata>\n</GDALMultiDomainMetadata>\n");
    work.execute("INSERT INTO gpkg_metadata VALUES (1, 'dataset', 'http://gdal.org', 'text/xml', ?1)", [metadata])?;
    work.execute(
        "INSERT INTO gpkg_metadata_reference VALUES ('geopackage', NULL, NULL, NULL, ?1, 1, NULL)",
        [schema::MOMENT],
    )?;
    Ok(())
}

/// The rectangle around some places: west, south, east and north.
#[derive(Clone, Copy)]
struct Bounds([f64; 4]);

impl Bounds {
    const NONE: Self = Self([f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY]);

    fn with(self, other: Self) -> Self {
        let (Self([a, b, c, d]), Self([w, s, e, n])) = (self, other);
        Self([a.min(w), b.min(s), c.max(e), d.max(n)])
    }

    /// Returns the four numbers, or nulls around nothing.
    fn or_null(self) -> [Option<f64>; 4] {
        self.0.map(|number| number.is_finite().then_some(number))
    }
}
