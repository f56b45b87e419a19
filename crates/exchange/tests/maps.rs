//! Maps for tests, and their files.

use std::sync::OnceLock;

use riverseed::export::rasters::Rasters;
use riverseed::recipe::link;
use riverseed::tiny_skia::Pixmap;
use riverseed::{Map, Picture, Recipe, Session};
use riverseed_exchange::{Form, Options, Source, write};

/// Small maps of many kinds: lands, growths, oxbow lakes, ridges, no sea at all, and a seed that would like to be markup.
pub const LINKS: [&str; 7] = [
    "country=usual&seed=kauri&land=island&attractors=700&deltas=0.7",
    "country=usual&seed=kea&land=archipelago&attractors=300&growth=colonize",
    "country=usual&seed=matai&land=valley&attractors=300",
    "country=usual&seed=totara&land=rectangle&attractors=600&oxbows=1&meander-rounds=300&meander-strength=1&flat-share=1&great-rivers=16&neck=3&width=16",
    "country=usual&seed=rimu&land=island&attractors=300&aspect=2",
    "country=usual&seed=weka&land=drawn&outline=.MzMzzMMzzMzMMzzM&attractors=300",
    "country=usual&seed=%3Cb%3E%22%27..%2F..%2Fx&land=island&attractors=300&aspect=0.5&names=t.%3Cscript%3E%26",
];

/// The maps of [`LINKS`], grown once for all tests.
static MAPS: [OnceLock<Map>; LINKS.len()] = [const { OnceLock::new() }; LINKS.len()];

/// Grows a map with its relief.
pub fn map(text: &str) -> Map {
    match LINKS.iter().position(|link| *link == text) {
        Some(i) => MAPS[i].get_or_init(|| grown(text)).clone(),
        None => grown(text),
    }
}

fn grown(text: &str) -> Map {
    let recipe: Recipe = link::read(text).unwrap();
    let mut session = Session::new(recipe).unwrap();
    session.finish().unwrap();
    while session.raise_relief().unwrap() {}
    session.finish().unwrap()
}

/// Paints a small picture of a map.
pub fn picture(map: &Map) -> Pixmap {
    let mut picture = Picture::new(120, 80).unwrap();
    picture.paint_map(map);
    picture.pixmap().clone()
}

/// Makes a file.
pub fn file(form: Form, map: &Map, rasters: Option<&Rasters>, picture: Option<&Pixmap>) -> Vec<u8> {
    with_beds(form, map, rasters, picture, false)
}

/// Makes a file, whose heights are lowered under rivers or not.
pub fn with_beds(
    form: Form,
    map: &Map,
    rasters: Option<&Rasters>,
    picture: Option<&Pixmap>,
    has_beds: bool,
) -> Vec<u8> {
    file_with(form, map, rasters, picture, &Options { beds: Some(has_beds), ..Options::default() })
}

/// Makes a file with options.
pub fn file_with(
    form: Form,
    map: &Map,
    rasters: Option<&Rasters>,
    picture: Option<&Pixmap>,
    options: &Options,
) -> Vec<u8> {
    let mut out = Vec::new();
    write(form, &mut out, &Source { map, rasters, picture, attractors: None, options }).unwrap();
    out
}
