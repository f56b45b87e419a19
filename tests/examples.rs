//! The programs in `examples/` do what they say; `documents.rs` runs the one that draws figures.
#![allow(clippy::unwrap_used, dead_code, reason = "a test fails by panicking, and runs all of an example but `main`")]

#[path = "../examples/geojson.rs"]
mod geojson_example;
#[path = "../examples/own_land.rs"]
mod own_land;
#[path = "../examples/picture.rs"]
mod picture;
#[path = "../examples/statistics.rs"]
mod statistics;
#[path = "../examples/stepping.rs"]
mod stepping;
#[path = "../examples/svg.rs"]
mod svg;

use std::fs;
use std::path::PathBuf;

/// Makes an empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("examples").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The number of different colours in a PNG.
fn colours(png: Vec<u8>) -> usize {
    let image = riverseed::import::png::read(std::io::Cursor::new(png)).unwrap();
    image.rgba.chunks_exact(4).collect::<std::collections::BTreeSet<_>>().len()
}

fn rivers_of_svg(path: PathBuf) -> usize {
    let text = fs::read_to_string(path).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let is_river = |id: &str| id.strip_prefix("river-").is_some_and(|number| number.parse::<u32>().is_ok());
    document.descendants().filter(|node| node.attribute("id").is_some_and(is_river)).count()
}

#[test]
fn picture_is_drawn() {
    let folder = folder("picture");
    picture::write(&folder).unwrap();
    assert!(colours(fs::read(folder.join("kauri.png")).unwrap()) > 100);
}

#[test]
fn svg_holds_rivers() {
    let folder = folder("svg");
    svg::write(&folder).unwrap();
    assert!(rivers_of_svg(folder.join("kauri.svg")) > 100);
}

#[test]
fn geojson_holds_rivers() {
    let folder = folder("geojson");
    geojson_example::write(&folder).unwrap();
    let text = fs::read_to_string(folder.join("totara.geojson")).unwrap();
    let collection: geojson::FeatureCollection = text.parse::<geojson::GeoJson>().unwrap().try_into().unwrap();
    assert!(collection.features.len() > 100);
}

#[test]
fn steps_are_four_different_pictures() {
    let folder = folder("stepping");
    stepping::write(&folder).unwrap();
    let pictures: Vec<_> = (0..4).map(|number| fs::read(folder.join(format!("kea-{number}.png"))).unwrap()).collect();
    assert!(pictures.windows(2).all(|pair| pair[0] != pair[1]));
}

#[test]
fn rivers_run_on_a_land_of_one_s_own() {
    let folder = folder("own-land");
    let (width, height, rgba) = own_land::disc();
    own_land::write(&folder, (width, height, &rgba)).unwrap();
    assert!(rivers_of_svg(folder.join("matai.svg")) > 100);
}

#[test]
fn statistics_are_those_of_a_network() {
    let all = statistics::statistics("country=usual&seed=kauri&growth=drainage&land=rectangle").unwrap();
    assert!(all.rivers.windows(2).all(|pair| pair[0] > pair[1]) && all.rivers.len() > 3, "{all:?}");
    assert!((2.0..6.0).contains(&all.bifurcation) && all.sinuosity > 1.0 && all.density > 0.01, "{all:?}");
}
