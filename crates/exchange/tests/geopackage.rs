//! SQLite reads a GeoPackage, and finds in it what GeoJSON has.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::mpsc;
use std::time::Duration;
use std::{fs, thread};

use riverseed::Map;
use riverseed::export::degrees::METRES_A_DEGREE;
use riverseed_exchange::gis::crs::{self, Crs};
use riverseed_exchange::gis::geopackage;
use riverseed_exchange::gis::layers::{LAYERS, Layer};
use riverseed_exchange::{Form, Found, Options};
use rusqlite::types::Value;
use rusqlite::{Connection, MAIN_DB};
use serde_json::Value as Json;

use crate::maps::{LINKS, file, file_with, map};

/// A map with a lake at the sea's level.
const LAKE: &str = "country=usual&seed=leven&land=basin&attractors=300";
const LAKES: &str = "country=usual&seed=kauri&land=island&attractors=700&lakes=0.6";

/// Returns the layer of each kind of feature.
fn layer_of(kind: &str) -> &'static str {
    match kind {
        "river" => "rivers",
        "segment" => "segments",
        "reach" => "reaches",
        "oxbow" => "oxbow_lakes",
        "basin" => "basins",
        "land" => "land",
        "water" => "lakes",
        "delta" => "deltas",
        "distributary" => "distributaries",
        "ridge" => "ridges",
        _ => "places",
    }
}

fn database(bytes: &[u8]) -> Connection {
    let mut database = Connection::open_in_memory().unwrap();
    database.deserialize_read_exact(MAIN_DB, bytes, bytes.len(), true).unwrap();
    database
}

/// Lists all numbers of a shape in the order in which GeoJSON has them, with the numbers of its parts.
fn shape(blob: &[u8]) -> (Vec<f64>, Vec<u32>) {
    assert_eq!(&blob[..4], b"GP\0\x03");
    assert_eq!(i32::from_le_bytes(blob[4..8].try_into().unwrap()), crs::NUMBER);
    let mut reader = Reader { bytes: &blob[40..], numbers: Vec::new(), counts: Vec::new() };
    reader.shape();
    assert!(reader.bytes.is_empty());
    (reader.numbers, reader.counts)
}

struct Reader<'a> {
    bytes: &'a [u8],
    numbers: Vec<f64>,
    counts: Vec<u32>,
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (taken, rest) = self.bytes.split_first_chunk().unwrap();
        self.bytes = rest;
        *taken
    }

    fn count(&mut self) -> u32 {
        let count = u32::from_le_bytes(self.take());
        self.counts.push(count);
        count
    }

    fn places(&mut self, count: u32, dimensions: u32) {
        for _ in 0..count * dimensions {
            let number = f64::from_le_bytes(self.take());
            self.numbers.push(number);
        }
    }

    fn shape(&mut self) {
        assert_eq!(self.take(), [1]);
        let kind = u32::from_le_bytes(self.take());
        let dimensions = if kind > 1000 { 3 } else { 2 };
        match kind % 1000 {
            1 => self.places(1, dimensions),
            2 => {
                let count = self.count();
                self.places(count, dimensions);
            }
            3 => {
                for _ in 0..self.count() {
                    let count = self.count();
                    self.places(count, dimensions);
                }
            }
            6 => (0..self.count()).for_each(|_| self.shape()),
            kind => panic!("shape {kind}"),
        }
    }
}

/// Collects the numbers of GeoJSON's coordinates, degrees in hundred-thousandths.
fn coordinates(json: &Json, numbers: &mut Vec<f64>, counts: &mut Vec<u32>) {
    let list = json.as_array().unwrap();
    if list[0].is_number() {
        numbers.extend(list.iter().map(|number| number.as_f64().unwrap()));
    } else {
        counts.push(list.len() as u32);
        list.iter().for_each(|item| coordinates(item, numbers, counts));
    }
}

/// Writes and reads the GeoJSON of a map.
fn geojson(map: &Map, options: &Options) -> Json {
    serde_json::from_slice(&file_with(Form::GeoJson, map, None, None, options)).unwrap()
}

#[test]
fn layers_hold_the_features_of_geojson_in_metres() {
    let mut all = BTreeMap::new();
    for link in LINKS.into_iter().chain([LAKE, LAKES]) {
        let map = map(link);
        let database = database(&file(Form::GeoPackage, &map, None, None));
        let collection = geojson(&map, &Options { has_segments: true, ..Options::default() });
        let mut rows = BTreeMap::new();
        for feature in collection["features"].as_array().unwrap() {
            let layer = layer_of(feature["properties"]["kind"].as_str().unwrap());
            let row = rows.entry(layer).or_insert(0);
            *row += 1;
            *all.entry(layer).or_insert(0) += 1;
            assert_equal(&database, layer, *row, feature);
        }
        for layer in LAYERS.iter().map(|layer| layer.name) {
            let count: i64 =
                database.query_row(&format!("SELECT count(*) FROM {layer}"), [], |row| row.get(0)).unwrap();
            assert_eq!(count, rows.get(layer).copied().unwrap_or(0), "{link}: {layer}");
        }
    }
    assert_eq!(all.len(), LAYERS.len(), "every layer has a feature somewhere: {all:?}");
}

fn assert_equal(database: &Connection, layer: &str, row: i64, feature: &Json) {
    let mut query = database.prepare(&format!("SELECT * FROM {layer} WHERE fid = ?1")).unwrap();
    let names: Vec<String> = query.column_names().map(Into::into).collect();
    query
        .query_row([row], |found| {
            let (numbers, counts) = shape(&found.get::<_, Vec<u8>>("geom")?);
            let (mut degrees, mut parts) = (Vec::new(), Vec::new());
            coordinates(&feature["geometry"]["coordinates"], &mut degrees, &mut parts);
            assert_eq!(counts, parts, "{layer} {row}");
            let dimensions = if matches!(layer, "rivers" | "segments") { 3 } else { 2 };
            for (i, (metres, degrees)) in numbers.iter().zip(&degrees).enumerate() {
                let back =
                    if i % dimensions == 2 { *metres } else { (metres / METRES_A_DEGREE * 1e9).round() / 1e9 + 0.0 };
                assert_eq!(back, *degrees, "{layer} {row}");
            }
            assert_eq!(numbers.len(), degrees.len(), "{layer} {row}");
            for name in names.iter().filter(|name| !matches!(name.as_str(), "fid" | "geom")) {
                let value: Value = found.get(name.as_str())?;
                let expected = match &feature["properties"][name.as_str()] {
                    Json::Null => Value::Null,
                    Json::String(text) => Value::Text(text.clone()),
                    number if number.is_i64() => Value::Integer(number.as_i64().unwrap()),
                    number => Value::Real(number.as_f64().unwrap()),
                };
                assert_eq!(value, expected, "{layer} {row} {name}");
            }
            Ok(())
        })
        .unwrap();
}

/// The names of a layer's columns, with the kind, which is no column.
fn columns(layer: &Layer) -> BTreeSet<String> {
    layer.columns.iter().map(|column| column.name).chain(["kind"]).map(String::from).collect()
}

#[test]
fn every_property_of_geojson_is_a_column_and_every_column_a_property() {
    // Waters at the level of the sea have no outlet, level or depth, and lakes along rivers lie on no one land.
    let mut of_waters = BTreeSet::new();
    for link in LINKS.into_iter().chain([LAKE, LAKES]) {
        let collection = geojson(&map(link), &Options { has_segments: true, ..Options::default() });
        for feature in collection["features"].as_array().unwrap() {
            let kind = feature["properties"]["kind"].as_str().unwrap();
            let mut layers = LAYERS.iter().filter(|layer| layer.kinds.contains(&kind));
            let (layer, other) = (layers.next().unwrap(), layers.next());
            assert!(other.is_none(), "{kind} is in two layers");
            let properties = feature["properties"].as_object().unwrap().keys().cloned().collect::<BTreeSet<_>>();
            if kind == "water" {
                of_waters.extend(properties);
            } else {
                assert_eq!(properties, columns(layer), "{kind}");
            }
        }
    }
    let waters = LAYERS.iter().find(|layer| layer.kinds.contains(&"water")).unwrap();
    assert_eq!(of_waters, columns(waters), "water");
}

#[test]
fn lakes_are_the_holes_of_the_land_and_have_the_names_of_their_points() {
    let lake = map(LAKE);
    for map in [&lake, &map(LINKS[1])] {
        let database = database(&file(Form::GeoPackage, map, None, None));
        let rows = |query: &str| -> Vec<(Vec<f64>, Vec<u32>, Option<String>)> {
            let mut query = database.prepare(query).unwrap();
            let row = |row: &rusqlite::Row<'_>| Ok((row.get::<_, Vec<u8>>(0)?, row.get(1)?));
            let found = query.query_map([], row).unwrap().map(Result::unwrap);
            found.map(|(blob, name)| (shape(&blob), name)).map(|((at, counts), name)| (at, counts, name)).collect()
        };
        let mut holes = BTreeSet::new();
        for (numbers, counts, _) in rows("SELECT geom, NULL FROM land ORDER BY fid") {
            let mut rest: Vec<[u64; 2]> = numbers.chunks(2).map(|at| [at[0].to_bits(), at[1].to_bits()]).collect();
            rest.drain(..counts[1] as usize);
            for count in &counts[2..] {
                holes.insert(rest.drain(..*count as usize).collect::<BTreeSet<_>>());
            }
        }
        let lakes = rows("SELECT geom, name FROM lakes ORDER BY fid");
        // Each ring as a set, since either may begin anywhere.
        let shores: BTreeSet<BTreeSet<[u64; 2]>> = lakes
            .iter()
            .map(|(numbers, counts, _)| {
                numbers.chunks(2).take(counts[1] as usize).map(|at| [at[0].to_bits(), at[1].to_bits()]).collect()
            })
            .collect();
        assert_eq!(shores, holes);
        let names: Vec<&String> = lakes.iter().filter_map(|(.., name)| name.as_ref()).collect();
        for (.., name) in rows("SELECT geom, name FROM places WHERE kind = 'lake'") {
            assert_eq!(names.iter().filter(|own| Some(**own) == name.as_ref()).count(), 1, "{name:?} in {names:?}");
        }
        assert_eq!(std::ptr::eq(map, &lake), !names.is_empty(), "{names:?}");
    }
}

#[test]
fn rectangles_are_those_around_the_shapes() {
    let database = database(&file(Form::GeoPackage, &map(LINKS[0]), None, None));
    let [west, south, east, north]: [f64; 4] = ["min_x", "min_y", "max_x", "max_y"].map(|side| {
        let query = format!("SELECT {side} FROM gpkg_contents WHERE table_name = 'land'");
        database.query_row(&query, [], |row| row.get(0)).unwrap()
    });
    let mut query = database.prepare("SELECT geom FROM land").unwrap();
    let shapes = query.query_map([], |row| row.get::<_, Vec<u8>>(0)).unwrap();
    let mut around = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    for blob in shapes.map(Result::unwrap) {
        let header: Vec<f64> = blob[8..40].chunks(8).map(|part| f64::from_le_bytes(part.try_into().unwrap())).collect();
        let numbers = shape(&blob).0;
        let (xs, ys) = (numbers.iter().step_by(2), numbers.iter().skip(1).step_by(2));
        let least = |values: &mut dyn Iterator<Item = &f64>| values.fold(f64::INFINITY, |a, &b| a.min(b));
        assert_eq!([header[0], header[2]], [least(&mut xs.clone()), least(&mut ys.clone())]);
        for (x, y) in xs.zip(ys) {
            around = [around[0].min(*x), around[1].min(*y), around[2].max(*x), around[3].max(*y)];
        }
    }
    assert_eq!([west, south, east, north], around);
}

#[test]
fn same_map_gives_the_same_bytes_and_says_which_it_is() {
    let (map, other) = (map(LINKS[6]), map(LINKS[1]));
    let bytes = file(Form::GeoPackage, &map, None, None);
    assert!(bytes == file(Form::GeoPackage, &map, None, None));
    let database = database(&bytes);
    let link = |map: &riverseed::Map| riverseed::recipe::link::write_for_file(map.recipe());
    assert!(
        geopackage::is_of(&database, &link(&map), Crs::Own) && !geopackage::is_of(&database, &link(&other), Crs::Own)
    );
    let ids: (i64, i64) = ("application_id", "user_version").map_pragma(&database);
    assert_eq!(ids, (0x4750_4b47, 10_300));
    let check: String = database.query_row("PRAGMA integrity_check", [], |row| row.get(0)).unwrap();
    assert_eq!(check, "ok");
    let broken: i64 =
        database.query_row("SELECT count(*) FROM pragma_foreign_key_check", [], |row| row.get(0)).unwrap();
    assert_eq!(broken, 0);
}

#[test]
fn layers_and_their_rows_are_in_the_system_that_was_asked_for() {
    let map = map(LINKS[0]);
    let link = riverseed::recipe::link::write_for_file(map.recipe());
    let all = [Crs::Own, Crs::Unknown, "EPSG:32633".parse().unwrap(), "EPSG:3857".parse().unwrap()];
    for crs in all {
        let options = Options { crs, ..Options::default() };
        let database = database(&file_with(Form::GeoPackage, &map, None, None, &options));
        let systems = |query: &str| -> BTreeSet<i32> {
            let mut query = database.prepare(query).unwrap();
            query.query_map([], |row| row.get(0)).unwrap().map(Result::unwrap).collect()
        };
        assert_eq!(systems("SELECT srs_id FROM gpkg_geometry_columns"), [crs.number()].into());
        assert_eq!(systems("SELECT srs_id FROM gpkg_contents WHERE srs_id NOT NULL"), [crs.number()].into());
        assert!(systems("SELECT srs_id FROM gpkg_spatial_ref_sys").contains(&crs.number()));
        let blob: Vec<u8> = database.query_row("SELECT geom FROM rivers", [], |row| row.get(0)).unwrap();
        assert_eq!(i32::from_le_bytes(blob[4..8].try_into().unwrap()), crs.number());
        for other in all {
            assert_eq!(geopackage::is_of(&database, &link, other), other == crs, "{crs} {other}");
        }
    }
}

trait Pragmas {
    fn map_pragma(self, database: &Connection) -> (i64, i64);
}

impl Pragmas for (&str, &str) {
    fn map_pragma(self, database: &Connection) -> (i64, i64) {
        let read = |name: &str| database.query_row(&format!("PRAGMA {name}"), [], |row| row.get(0)).unwrap();
        (read(self.0), read(self.1))
    }
}

#[test]
fn texts_of_a_map_are_data_and_never_a_style_or_a_statement() {
    let database = database(&file(Form::GeoPackage, &map(LINKS[6]), None, None));
    let mut query = database.prepare("SELECT styleQML FROM layer_styles").unwrap();
    let styles: Vec<String> = query.query_map([], |row| row.get(0)).unwrap().map(Result::unwrap).collect();
    assert_eq!(styles.len(), LAYERS.len());
    assert!(styles.iter().all(|style| !style.contains("script") && !style.contains("../")));
    let titled = "SELECT count(*) FROM places WHERE name = '<script>&' AND kind = 'island'";
    let count: i64 = database.query_row(titled, [], |row| row.get(0)).unwrap();
    assert_eq!(count, 1, "the title is the name of the main land");
    let metadata: String = database.query_row("SELECT metadata FROM gpkg_metadata", [], |row| row.get(0)).unwrap();
    let document = roxmltree::Document::parse(&metadata).unwrap();
    let items: Vec<&str> =
        document.descendants().filter(|node| node.has_tag_name("MDI")).filter_map(|node| node.text()).collect();
    assert!(items[0].starts_with("seed=%3Cb%3E"), "{items:?}");
}

/// Says what is in the place of a map's file. A call that computes for ever fails its test.
fn found(path: &Path, link: &str) -> Found {
    const LONG_ENOUGH: Duration = Duration::from_secs(120);
    let (path, recipe) = (path.to_owned(), riverseed::recipe::link::read(link).unwrap());
    let (tell, told) = mpsc::channel();
    thread::spawn(move || tell.send(Found::at(&path, Form::GeoPackage, &recipe, &Options::default())));
    told.recv_timeout(LONG_ENOUGH).unwrap_or_else(|_| panic!("a foreign file holds up who looks for {link}"))
}

#[test]
fn view_in_the_place_of_metadata_is_not_read() {
    let link = LINKS[0];
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("geopackage");
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("view.gpkg");
    fs::write(&path, file(Form::GeoPackage, &map(link), None, None)).unwrap();
    assert_eq!(found(&path, link), Found::Whole);
    for view in [
        "SELECT metadata FROM kept",
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i FROM n) SELECT count(*) AS metadata FROM n",
    ] {
        fs::write(&path, file(Form::GeoPackage, &map(link), None, None)).unwrap();
        let renamed =
            "PRAGMA foreign_keys = OFF; CREATE TABLE kept AS SELECT * FROM gpkg_metadata; DROP TABLE gpkg_metadata;";
        let change = format!("{renamed} CREATE VIEW gpkg_metadata AS {view}");
        Connection::open(&path).unwrap().execute_batch(&change).unwrap();
        assert_eq!(found(&path, link), Found::Other, "{view}");
    }
}

/// The numbers of all positions of a collection, with heights where there are any, and the measures that go with lengths.
fn measured(collection: &Json) -> (Vec<f64>, Vec<f64>, Vec<[f64; 2]>) {
    let (mut places, mut heights, mut measures) = (Vec::new(), Vec::new(), Vec::new());
    for feature in collection["features"].as_array().unwrap() {
        let (mut numbers, mut parts) = (Vec::new(), Vec::new());
        coordinates(&feature["geometry"]["coordinates"], &mut numbers, &mut parts);
        let properties = &feature["properties"];
        if matches!(properties["kind"].as_str(), Some("river" | "segment")) {
            for position in numbers.chunks(3) {
                places.extend(&position[..2]);
                heights.push(position[2]);
            }
            measures.push(["length_m", "width_m"].map(|name| properties[name].as_f64().unwrap()));
        }
    }
    (places, heights, measures)
}

#[test]
fn files_of_two_spans_are_one_map_in_two_scales() {
    const LINK: &str = "country=usual&seed=kauri&attractors=900";
    let options = Options { has_segments: true, ..Options::default() };
    let of = |span: f64| {
        let map = map(&format!("{LINK}&span={span}"));
        let collection = geojson(&map, &options);
        let rasters = riverseed::export::rasters::Rasters::new(&map).unwrap();
        (measured(&collection), rasters.metres_a_pixel(), rasters.scale.metres(u16::MAX))
    };
    let ((places, heights, measures), pixel, highest) = of(50.0);
    let ((wide_places, wide_heights, wide_measures), wide_pixel, wide_highest) = of(1600.0);
    // By hand: 32 times as wide, and 32^0.4 = 4 times as high; heights of a unit are rounded to a centimetre.
    assert!((wide_pixel / pixel - 32.0).abs() < 1e-6 && (wide_highest / highest - 4.0).abs() < 2e-3);
    assert_eq!((places.len(), measures.len()), (wide_places.len(), wide_measures.len()));
    assert!(places.iter().zip(&wide_places).all(|(near, far)| (far - near * 32.0).abs() < 4e-5), "degrees");
    assert!(
        heights.iter().zip(&wide_heights).all(|(low, high)| (high - low * 4.0).abs() <= 3.0 + low * 3e-3),
        "heights"
    );
    for (own, wide) in measures.iter().zip(&wide_measures) {
        assert!((wide[0] - own[0] * 32.0).abs() <= 17.0, "a length: {} and {}", own[0], wide[0]);
        // A thousand times the land, the root of that in width.
        assert!((wide[1] - own[1] * 32.0).abs() <= 0.17, "a width: {} and {}", own[1], wide[1]);
    }
    // The whole map is as wide as its span, on a sphere of 111.32 km to a degree.
    let frame = geojson(&map(&format!("{LINK}&span=50")), &options)["bbox"].clone();
    let degrees = frame[2].as_f64().unwrap() - frame[0].as_f64().unwrap();
    assert!((degrees * 111.32 - 50.0).abs() < 1e-3, "{degrees}");
}
