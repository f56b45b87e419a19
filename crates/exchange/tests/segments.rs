//! Segments are a graph of each river system, and what runs through it adds up.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use riverseed::Map;
use riverseed::network::NONE;
use riverseed_exchange::{Form, Options};
use serde_json::Value;

use crate::maps::{LINKS, file_with, map};

/// Lands, forms and lines of many kinds.
const MORE: [&str; 5] = [
    "country=usual&seed=kauri&land=island&attractors=3000",
    "country=usual&seed=kea&land=continent&attractors=1500&growth=brownian",
    "country=usual&seed=moa&land=archipelago&attractors=900&drowning=0.5",
    "country=usual&seed=tui&land=rectangle&attractors=900&courses=grown",
    "country=usual&seed=pipi&land=basin&attractors=900&trim=40&meander-rounds=200&meander-strength=1",
];

struct Segment {
    from: u64,
    to: u64,
    value: Value,
}

impl Segment {
    fn whole(&self, name: &str) -> u64 {
        self.value["properties"][name].as_u64().unwrap()
    }

    fn line(&self) -> &Vec<Value> {
        self.value["geometry"]["coordinates"].as_array().unwrap()
    }
}

/// A map and the features of its GeoJSON.
struct Written {
    link: &'static str,
    map: Map,
    features: Vec<Value>,
}

impl Written {
    fn of(link: &'static str) -> Self {
        let (map, options) = (map(link), Options { has_segments: true, ..Options::default() });
        let file: Value = serde_json::from_slice(&file_with(Form::GeoJson, &map, None, None, &options)).unwrap();
        Self { link, map, features: file["features"].as_array().unwrap().clone() }
    }
}

/// All maps, each grown and written once.
static ALL: LazyLock<Vec<Written>> = LazyLock::new(|| LINKS.into_iter().chain(MORE).map(Written::of).collect());

fn segments(features: &[Value]) -> Vec<Segment> {
    let of_kind = features.iter().filter(|feature| feature["properties"]["kind"] == "segment").cloned();
    let node = |value: &Value, name: &str| value["properties"][name].as_u64().unwrap();
    of_kind.map(|value| Segment { from: node(&value, "from_node"), to: node(&value, "to_node"), value }).collect()
}

/// Counts the connected pieces of a graph.
fn pieces<T: Ord + Clone>(edges: impl Iterator<Item = (T, T)>) -> usize {
    let mut piece_of: BTreeMap<T, usize> = BTreeMap::new();
    let mut pieces: BTreeMap<usize, BTreeSet<T>> = BTreeMap::new();
    for (number, (a, b)) in edges.enumerate() {
        let mut all: BTreeSet<T> = [a, b].into();
        for node in all.clone() {
            all.extend(piece_of.get(&node).and_then(|piece| pieces.remove(piece)).unwrap_or_default());
        }
        piece_of.extend(all.iter().map(|node| (node.clone(), number)));
        pieces.insert(number, all);
    }
    pieces.len()
}

#[test]
fn graph_has_a_piece_for_each_mouth_by_its_nodes_and_by_the_ends_of_its_lines() {
    for Written { link, map, features } in &*ALL {
        let segments = segments(features);
        let mouths = map.network().rivers.iter().filter(|river| river.parent == NONE).count();
        assert_eq!(pieces(segments.iter().map(|segment| (segment.from, segment.to))), mouths, "{link}");
        let end = |at: Option<&Value>| at.unwrap().to_string();
        let ends = segments.iter().map(|segment| (end(segment.line().first()), end(segment.line().last())));
        assert_eq!(pieces(ends), mouths, "{link}");
    }
}

#[test]
fn segments_of_a_river_are_its_line() {
    for Written { link, features, .. } in &*ALL {
        let mut lines: BTreeMap<u64, Vec<Value>> = BTreeMap::new();
        for segment in segments(features) {
            let line = lines.entry(segment.whole("river")).or_default();
            let joint = line.pop();
            assert!(joint.is_none_or(|joint| joint == segment.line()[0]), "{link}");
            line.extend(segment.line().iter().cloned());
        }
        let rivers = features.iter().filter(|feature| feature["properties"]["kind"] == "river");
        for river in rivers {
            let number = river["properties"]["number"].as_u64().unwrap();
            assert_eq!(lines.get(&number), river["geometry"]["coordinates"].as_array(), "{link}: {number}");
        }
    }
}

#[test]
fn what_runs_through_segments_adds_up() {
    for Written { link, map, features } in &*ALL {
        let (segments, network) = (segments(features), map.network());
        let mut ends = BTreeMap::new();
        for (number, segment) in (1..).zip(&segments) {
            assert_eq!(segment.whole("number"), number, "{link}");
            let upstream: Vec<&Segment> = segments.iter().filter(|other| other.to == segment.from).collect();
            assert!(upstream.iter().all(|other| other.whole("next") == number), "{link}: {number}");
            let sum = |name: &str| upstream.iter().map(|other| other.whole(name)).sum::<u64>();
            assert_eq!(segment.whole("discharge"), sum("discharge") + segment.whole("lateral"), "{link}: {number}");
            let area = |segment: &Segment| segment.value["properties"]["area_m2"].as_f64().unwrap();
            // Each is rounded to a square metre.
            let above: f64 = upstream.iter().map(|other| area(other)).sum();
            assert!(area(segment) >= above - 2.0, "{link}: {number}");
            assert_eq!(segment.whole("magnitude"), sum("magnitude").max(1), "{link}: {number}");
            let orders: Vec<u64> = upstream.iter().map(|other| other.whole("order")).collect();
            let greatest = orders.iter().max().copied().unwrap_or(1);
            let is_met = orders.iter().filter(|order| **order == greatest).count() > 1;
            assert_eq!(segment.whole("order"), greatest + u64::from(is_met), "{link}: {number}");
            ends.insert(segment.whole("river"), segment);
        }
        // At their ends, rivers have what they are said to have.
        for (number, river) in (0..).zip(&network.rivers) {
            let last = ends[&number];
            assert_eq!(last.whole("discharge"), u64::from(network.discharge(river)), "{link}: {number}");
            assert_eq!(
                (last.whole("order"), last.whole("magnitude")),
                (u64::from(river.order), u64::from(river.magnitude)),
                "{link}: {number}"
            );
            assert_eq!(last.whole("next") == 0, river.parent == NONE, "{link}: {number}");
        }
    }
}

#[test]
fn catchment_at_a_mouth_is_its_basin() {
    for Written { link, features, .. } in &*ALL {
        let at_mouths: BTreeMap<u64, f64> = segments(features)
            .iter()
            .filter(|segment| segment.whole("next") == 0)
            .map(|segment| (segment.whole("river"), segment.value["properties"]["area_m2"].as_f64().unwrap()))
            .collect();
        let basins = features.iter().filter(|feature| feature["properties"]["kind"] == "basin");
        let mut count = 0;
        for basin in basins.map(|feature| &feature["properties"]) {
            let mouth = basin["mouth"].as_u64().unwrap();
            assert_eq!(at_mouths.get(&mouth).copied(), basin["area_m2"].as_f64(), "{link}: {mouth}");
            count += 1;
        }
        assert!(count > 0, "{link}");
    }
}

#[test]
fn flat_file_is_the_same_without_heights() {
    let asked = |has_segments, is_flat| -> Value {
        let options = Options { has_segments, is_flat, ..Options::default() };
        serde_json::from_slice(&file_with(Form::GeoJson, &map(LINKS[0]), None, None, &options)).unwrap()
    };
    let cut = |position: &mut Value| position.as_array_mut().unwrap().truncate(2);
    for has_segments in [false, true] {
        let (mut tall, flat) = (asked(has_segments, false), asked(has_segments, true));
        assert_eq!((tall["segments"].as_bool(), flat["flat"].as_bool()), (has_segments.then_some(true), Some(true)));
        let mut heights = 0;
        for feature in tall["features"].as_array_mut().unwrap() {
            if feature["geometry"]["type"] == "LineString" {
                let line = feature["geometry"]["coordinates"].as_array_mut().unwrap();
                heights += line.iter().filter(|at| at.as_array().unwrap().len() == 3).count();
                line.iter_mut().for_each(cut);
            }
        }
        assert!(heights > 100);
        let pairs = tall["features"].as_array().unwrap().iter().zip(flat["features"].as_array().unwrap());
        pairs.for_each(|(tall, flat)| assert!(tall == flat, "{}", tall["id"]));
        assert_eq!(tall["features"].as_array().map(Vec::len), flat["features"].as_array().map(Vec::len));
    }
}
