//! Promises about maps that are handed over: they are complete.

use super::*;
use crate::recipe::link;
use crate::session::Session;

fn finished(text: &str) -> Map {
    Session::new(link::read(text).unwrap()).unwrap().finish().unwrap()
}

/// Maps that together have every part of a map, and some that lack parts.
const MAPS: [&str; 6] = [
    "land=island&growth=drainage&attractors=900&style=atlas&labels=some&seed=kauri",
    "land=archipelago&growth=colonize&attractors=900&style=past-courses&woods=0.5&great-rivers=4&meander-rounds=60",
    "land=basin&growth=brownian&sensitivity=40&style=survey&labels=many&names=t.Home_s0.Sea+of+Glass",
    "land=rectangle&growth=colonize&mouths=3&attractors=400&style=ink&aspect=2",
    "land=valley&attractors=600&style=basins&hills=0.5&courses=grown",
    "land=drawn&outline=.MzMzzMMzzMzMMzzM&attractors=400&meander=none",
];

#[test]
fn a_map_that_was_handed_over_is_the_same_in_all_its_parts() {
    for text in MAPS {
        let map = finished(text);
        assert!(Map::from_wire(&map.to_wire()).as_ref() == Some(&map), "{text}");
        let raised = map.with_relief().unwrap();
        let read = Map::from_wire(&raised.to_wire()).unwrap();
        assert!(read == raised && read.relief().is_some(), "{text}");
    }
}

#[cfg(feature = "json")]
#[test]
fn the_files_of_a_map_that_was_handed_over_are_those_of_the_map() {
    use crate::export::rasters::{Layer, Rasters};
    use crate::export::{geojson, json, svg};

    let files = |map: &Map| {
        let (mut data, rasters) = (Vec::new(), Rasters::new(map).unwrap());
        json::write(&mut data, map, None).unwrap();
        geojson::write(&mut data, map).unwrap();
        (svg::svg(map).unwrap(), data, Layer::ALL.map(|layer| rasters.values(layer)))
    };
    for text in MAPS {
        let map = finished(text);
        assert!(files(&Map::from_wire(&map.to_wire()).unwrap()) == files(&map), "{text}");
    }
}

#[test]
fn land_that_was_handed_over_lets_rivers_pass_where_it_did() {
    for land in crate::lands::lands_with_a_coast() {
        let map = finished(&format!("{land}&attractors=200&seed=kea"));
        let read = Map::from_wire(&map.to_wire()).unwrap();
        assert!(read.land() == map.land() && map.land().is_some(), "{land}");
    }
}

#[test]
fn making_and_cloning_a_map_copies_no_river() {
    let mut session = Session::new(link::read("attractors=300").unwrap()).unwrap();
    let map = session.finish().unwrap();
    let other = session.map().unwrap();
    assert!(Arc::ptr_eq(map.network(), other.network()) && Arc::ptr_eq(map.tree(), other.tree()));
    // The map stays the same, whatever happens to the session.
    let before = map.clone();
    session.change(link::read("attractors=300&width=30").unwrap()).unwrap();
    assert_ne!(session.finish().unwrap().network(), before.network());
    assert_eq!(map, before);
}

#[test]
fn maps_have_one_id_as_long_as_only_the_style_changes() {
    let mut session = Session::new(link::read("attractors=300").unwrap()).unwrap();
    let id = session.finish().unwrap().id();
    let mut changed = |text: &str| {
        session.change(link::read(text).unwrap()).unwrap();
        session.finish().unwrap().id()
    };
    assert_eq!(changed("attractors=300&style=atlas"), id);
    assert_ne!(changed("attractors=300&style=atlas&width=30"), id);
    assert_ne!(changed("attractors=300"), id);
}
