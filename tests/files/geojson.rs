//! GeoJSON: each feature, its place on the globe and its properties.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use glam::{DVec2, Vec2};
use riverseed::NumberKey;
use riverseed::recipe::link;
use riverseed::session::Session;
use serde_json::Value;

use super::definitions::{course, heights, lakes, length, line, magnitudes, mouth, orders};
use super::{SESSIONS, finished, geojson, list, names, some};

/// The metres of a unit: the map is as many kilometres wide as its span says.
fn metres_a_unit(session: &Session) -> f64 {
    f64::from(session.recipe().number(NumberKey::Span)) * 1000.0 / session.domain().size.as_dvec2().x
}

/// Where a point of the domain lies on the globe, east and north: a degree is 111.32 km, the middle at 0, 0.
fn degrees(session: &Session, at: Vec2) -> DVec2 {
    let size = session.domain().size.as_dvec2();
    let (at, unit) = (at.as_dvec2(), metres_a_unit(session) / 111_320.0);
    DVec2::new((at.x - size.x / 2.0) * unit, (size.y / 2.0 - at.y) * unit)
}

fn position(value: &Value) -> DVec2 {
    DVec2::new(value[0].as_f64().unwrap(), value[1].as_f64().unwrap())
}

/// Half of a millionth of a degree, which is written of maps of 200 km, and what floats of units lose.
const ROUNDING: f64 = 7e-7;

/// Checks the files of all maps, each written once.
fn of_all_files(check: impl Fn(&Session, &Value)) {
    static FILES: LazyLock<[Value; 6]> = LazyLock::new(|| SESSIONS.each_ref().map(geojson));
    SESSIONS.iter().zip(&*FILES).for_each(|(session, file)| check(session, file));
}

#[test]
fn file_has_the_recipe_and_a_feature_for_each_river_and_lake() {
    of_all_files(|session, file| {
        let network = session.network().unwrap();
        assert_eq!(names(file), ["type", "riverseed", "bbox", "title", "features"]);
        assert_eq!(file["type"], "FeatureCollection");
        let link = file["riverseed"].as_str().unwrap();
        assert_eq!(link::read(link).as_ref(), Ok(session.recipe()));
        assert!(link.contains("style="), "{link}");
        let kinds = |feature: &Value| {
            assert_eq!(feature["type"], "Feature");
            let properties = &feature["properties"];
            (properties["kind"].as_str().unwrap().to_owned(), properties["number"].as_u64().unwrap())
        };
        let rivers = (0..network.rivers.len() as u64).map(|number| ("river".to_owned(), number));
        let lakes = lakes(network).into_iter().map(|(number, _)| ("oxbow".to_owned(), number.into()));
        let expected: Vec<(String, u64)> = rivers.chain(lakes).collect();
        let all: Vec<(String, u64)> = list(&file["features"]).iter().map(kinds).collect();
        assert_eq!(all[..expected.len()], expected, "every river, every lake");
        let grounds = [
            "basin",
            "land",
            "water",
            "delta",
            "distributary",
            "ridge",
            "reach",
            "sea",
            "gulf",
            "lake",
            "island",
            "bay",
            "cape",
            "strait",
            "range",
        ];
        let is_ground = |(kind, _): &(String, u64)| grounds.contains(&kind.as_str());
        assert!(all[expected.len()..].iter().all(is_ground) && all.iter().any(|(kind, _)| kind == "land"));
        let ids: BTreeSet<String> = list(&file["features"]).iter().map(|feature| feature["id"].to_string()).collect();
        assert_eq!(ids.len(), all.len(), "each feature has an id of its own");
        let keys: Vec<u64> = list(&file["features"]).iter().map(key).collect();
        assert_eq!(keys, (1..=all.len() as u64).collect::<Vec<_>>(), "and a number of its own");
    });
}

fn key(feature: &Value) -> u64 {
    feature["properties"]["key"].as_u64().unwrap()
}

#[test]
fn frame_is_that_of_the_map() {
    of_all_files(|session, file| {
        let size = session.domain().size;
        let [south_west, north_east] = [Vec2::new(0.0, size.y), Vec2::new(size.x, 0.0)].map(|at| degrees(session, at));
        let expected = [south_west.x, south_west.y, north_east.x, north_east.y];
        let frame: Vec<f64> = list(&file["bbox"]).iter().map(|side| side.as_f64().unwrap()).collect();
        assert_eq!(frame.len(), 4);
        assert!(frame.iter().zip(expected).all(|(side, expected)| (side - expected).abs() < ROUNDING), "{frame:?}");
    });
}

/// The rings of all features of a kind, with the feature's own properties.
fn polygons<'a>(file: &'a Value, kind: &str) -> Vec<(&'a Value, Vec<Vec<DVec2>>)> {
    let features = list(&file["features"]).iter().filter(|feature| feature["properties"]["kind"] == kind);
    let rings = |feature: &Value| -> Vec<Vec<DVec2>> {
        list(&feature["geometry"]["coordinates"]).iter().map(|ring| list(ring).iter().map(position).collect()).collect()
    };
    features.map(|feature| (&feature["properties"], rings(feature))).collect()
}

/// The places of a ring as texts, in an order that does not depend on where it begins.
fn places(ring: &[DVec2]) -> BTreeSet<String> {
    ring.iter().map(|at| format!("{} {}", at.x, at.y)).collect()
}

#[test]
fn lakes_are_the_holes_of_the_land_with_the_islands_in_them_as_holes() {
    let (mut lakes, mut all_islands) = (0, 0);
    for link in [
        "country=usual&seed=kea&land=basin&attractors=300",
        "country=usual&seed=kauri&land=basin&attractors=300&roughness=1&sea=0.4",
    ] {
        let file = geojson(&finished(link));
        let (land, water) = (polygons(&file, "land"), polygons(&file, "water"));
        let holes = land.iter().flat_map(|(properties, rings)| {
            rings[1..].iter().map(|ring| (properties["number"].as_u64(), places(ring)))
        });
        let shores = water.iter().map(|(properties, rings)| (properties["land"].as_u64(), places(&rings[0])));
        assert_eq!(shores.collect::<BTreeSet<_>>(), holes.collect::<BTreeSet<_>>(), "{link}");
        let islands: BTreeSet<_> = land.iter().map(|(_, rings)| places(&rings[0])).collect();
        for (properties, rings) in &water {
            assert_eq!(names(properties), ["kind", "number", "land", "name", "key"]);
            assert!(turned(&rings[0]) > 0.0 && rings[1..].iter().all(|ring| turned(ring) < 0.0), "{link}");
            assert!(rings[1..].iter().all(|ring| islands.contains(&places(ring))), "{link}");
        }
        let named = |properties: &Value| properties["name"].as_str().map(str::to_owned);
        let points = list(&file["features"]).iter().filter(|feature| feature["properties"]["kind"] == "lake");
        let expected: BTreeSet<String> = points.filter_map(|feature| named(&feature["properties"])).collect();
        assert_eq!(water.iter().filter_map(|(properties, _)| named(properties)).collect::<BTreeSet<_>>(), expected);
        lakes += water.len();
        all_islands += water.iter().map(|(_, rings)| rings.len() - 1).sum::<usize>();
    }
    assert!(lakes > 1 && all_islands > 2, "{lakes} with {all_islands}");
}

#[test]
fn lines_lie_where_the_rivers_are_north_up_and_to_scale() {
    of_all_files(|session, file| {
        let (network, heights) = (session.network().unwrap(), heights(session));
        for (river, feature) in network.rivers.iter().zip(list(&file["features"])) {
            let vertices = course(river);
            let line = list(&feature["geometry"]["coordinates"]);
            assert_eq!(line.len(), vertices.len().max(2));
            for (written, &vertex) in line.iter().zip(&vertices) {
                let at = network.vertices[vertex].at;
                let off = (position(written) - degrees(session, at)).abs().max_element();
                assert!(off < ROUNDING, "{written} is not where {at} lies, {}", degrees(session, at));
                let height = written[2].as_f64().unwrap();
                let expected = heights[vertex];
                assert!((height - expected).abs() < 0.6 + expected * 1e-4, "{height} m and not {expected} m high");
            }
        }
    });
}

#[test]
fn south_is_where_a_map_s_mouths_are() {
    // By hand: rivers of a plain rectangle run to its lower border, and a map of 200 km by 133 is 1.8 degrees by 1.2.
    let session =
        finished("country=usual&seed=kauri&land=rectangle&aspect=1.5&mouths=3&sides=s&attractors=300&meander=none");
    for feature in list(&geojson(&session)["features"]) {
        if feature["properties"]["kind"] != "river" {
            continue;
        }
        let line = list(&feature["geometry"]["coordinates"]);
        if feature["properties"]["parent"].is_null() {
            let mouth = position(line.last().unwrap());
            assert!((mouth.y + 0.598_874).abs() < 3e-6, "a mouth in the south lies at latitude {}", mouth.y);
            assert!(line[0][1].as_f64().unwrap() > mouth.y, "its source lies north of it");
        }
        assert!(line.iter().all(|at| at[0].as_f64().unwrap().abs() < 0.898_31));
    }
}

#[test]
fn rivers_have_the_properties_that_they_are_said_to_have() {
    of_all_files(|session, file| {
        let network = session.network().unwrap();
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        for (id, (river, feature)) in network.rivers.iter().zip(list(&file["features"])).enumerate() {
            let properties = &feature["properties"];
            let expected =
                "kind number parent mouth order magnitude discharge length_m width_m sinuosity name kind_name key";
            assert_eq!(names(properties), expected.split(' ').collect::<Vec<_>>());
            assert_eq!(properties["parent"].as_u64(), some(river.parent));
            assert_eq!(properties["mouth"], mouth(network, id as u32));
            assert_eq!(properties["order"], orders[id]);
            assert_eq!(properties["magnitude"], magnitudes[id]);
            assert_eq!(properties["discharge"], network.vertices[river.vertex_range()].last().unwrap().discharge);
            let line = line(network, river);
            let straight = line[0].distance(line[line.len() - 1]);
            let near = |name: &str, expected: f64, rounding: f64| {
                let value = properties[name].as_f64().unwrap();
                assert!((value - expected).abs() < rounding + expected * 1e-5, "{name}: {value} and not {expected}");
            };
            near("length_m", length(&line) * metres_a_unit(session), 0.6);
            // As wide as what drains as much: four times the water, twice the width.
            let width = |river: &riverseed::River| f64::from(network.discharge(river).max(1)).sqrt();
            let [first, own] =
                [&file["features"][0]["properties"], properties].map(|of| of["width_m"].as_f64().unwrap());
            let expected = first * width(river) / width(&network.rivers[0]);
            assert!((own - expected).abs() < 0.02 + 0.02 * expected, "{own} m, not {expected}");
            near("sinuosity", if straight > 0.0 { length(&line) / straight } else { 1.0 }, 0.0006);
        }
    });
}

/// Twice the area within a closed line, positive if it runs counterclockwise where north is up.
fn turned(ring: &[DVec2]) -> f64 {
    ring.windows(2).map(|side| side[0].perp_dot(side[1])).sum()
}

#[test]
fn lakes_are_closed_wound_and_where_the_loops_were() {
    of_all_files(|session, file| {
        let network = session.network().unwrap();
        let features = &list(&file["features"])[network.rivers.len()..];
        for ((id, oxbow), feature) in lakes(network).into_iter().zip(features) {
            let properties = &feature["properties"];
            assert_eq!(names(properties), ["kind", "number", "river", "born", "key"]);
            assert_eq!((&properties["river"], &properties["born"]), (&oxbow.river.into(), &oxbow.born.into()));
            let coordinates = &feature["geometry"]["coordinates"];
            assert_eq!((&feature["geometry"]["type"], list(coordinates).len()), (&"Polygon".into(), 1), "lake {id}");
            let ring: Vec<DVec2> = list(&coordinates[0]).iter().map(position).collect();
            assert!(ring.len() >= 4 && ring.first() == ring.last(), "lake {id} is not closed");
            // RFC 7946: outer rings counterclockwise.
            assert!(turned(&ring) > 0.0, "lake {id} is wound the wrong way");
            let lake = oxbow.lake();
            let width = f64::from(lake.iter().map(|(vertex, _)| vertex.width()).fold(0.0, f32::max))
                * metres_a_unit(session)
                / 111_320.0;
            let middle: Vec<DVec2> = lake.iter().map(|(vertex, _)| degrees(session, vertex.at)).collect();
            let off = |at: &DVec2| middle.iter().map(|place| place.distance(*at)).fold(f64::INFINITY, f64::min);
            let step = middle.windows(2).map(|pair| pair[0].distance(pair[1])).fold(0.0, f64::max);
            assert!(ring.iter().all(|at| off(at) < width + step), "lake {id} is elsewhere than its loop was");
            assert!(
                middle.iter().step_by(4).all(|at| {
                    ring.iter().map(|place| place.distance(*at)).fold(f64::INFINITY, f64::min) < width + step
                }),
                "lake {id} is not as long as its loop was"
            );
        }
    });
}
