//! What files say is what the session holds: every value of SVG, GeoJSON and JSON is worked out anew, by its definition, from the
//! tree and the rivers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![cfg(feature = "cli")]

mod common;

use std::collections::BTreeSet;
use std::sync::LazyLock;

use common::plain::plain;
use glam::{DVec2, Vec2};
use riverseed::export::{geojson as to_geojson, json as to_json, svg as to_svg};
use riverseed::grow::{Ending, scatter};
use riverseed::network::{NONE, Network, Oxbow, River};
use riverseed::recipe::{Key, Kind, json as json_recipe, link, table::TABLE};
use riverseed::session::Session;
use riverseed::tree::{Hydrology, NO_PARENT};
use serde_json::Value;

/// Maps of all kinds: wide and tall, with many lakes, with islands, of either growth, trimmed and not.
const LINKS: [&str; 6] = [
    "seed=kauri&land=rectangle&aspect=1.5&attractors=1500&great=9&gentle=1&meander-rounds=200&meander-strength=1&style=ink",
    "seed=rimu&land=rectangle&aspect=3&attractors=1200&sides=ew&mouths=5&meander=flow&great=9&gentle=1&meander-rounds=120&style=dark",
    "seed=kea&land=archipelago&aspect=0.6&attractors=1200&mouths=9&curl=0.9&stretch=5&great=9&meander-rounds=150&style=map",
    "seed=totara&land=valley&aspect=1&growth=brownian&sensitivity=24&trim=10&great=4&meander-rounds=100&style=map",
    "seed=puriri&land=island&aspect=1.2&attractors=800&trim=0&simplify=0&momentum=0.3&meander=none&vary=0.5&style=ink",
    "seed=s6&land=island&aspect=1.5&attractors=800&trim=5&simplify=95&width=40&vary=0&meander-rounds=400&meander-strength=1&gentle=0&great=16&flat=1&style=skeleton",
];

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(&plain(link)).unwrap(), 1, 1).unwrap();
    while session.advance(64).unwrap() {}
    session
}

/// The finished sessions of all these links: grown once, since that is most of the work.
static SESSIONS: LazyLock<[Session; 6]> = LazyLock::new(|| LINKS.map(finished));

fn of_all(check: impl Fn(&Session)) {
    SESSIONS.iter().for_each(check);
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> Value {
    let mut text = Vec::new();
    write(&mut text).unwrap();
    serde_json::from_slice(&text).unwrap()
}

fn geojson(session: &Session) -> Value {
    written(|text| to_geojson::write(text, session))
}

fn json(session: &Session) -> Value {
    written(|text| to_json::write(text, session, true))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn names(object: &Value) -> Vec<&str> {
    object.as_object().unwrap().keys().map(String::as_str).collect()
}

/// The numbers of a list, to compare with those of a column to the bit.
fn singles(column: &Value) -> Vec<f32> {
    list(column).iter().map(|number| number.as_f64().unwrap() as f32).collect()
}

fn wholes(column: &Value) -> Vec<i64> {
    list(column).iter().map(|number| number.as_i64().unwrap()).collect()
}

/// A number that stands for none is written as null.
fn some(number: u32) -> Option<u64> {
    (number != NONE).then_some(number.into())
}

// ---- what is known of rivers, by definition

/// Strahler's order at the end of each river, from where rivers join each other alone.
fn orders(network: &Network) -> Vec<u8> {
    fn of(network: &Network, river: &River) -> u8 {
        let arms = network.rivers.iter().filter(|arm| arm.joins != NONE && river.own().contains(&(arm.joins as usize)));
        let mut joining: Vec<(u32, u8)> = arms.map(|arm| (arm.joins, of(network, arm))).collect();
        joining.sort_unstable();
        joining.chunk_by(|a, b| a.0 == b.0).fold(1, |order, arms| {
            let orders = || arms.iter().map(|(_, order)| *order).chain([order]);
            let highest = orders().max().unwrap();
            highest + u8::from(orders().filter(|order| *order == highest).count() > 1)
        })
    }
    network.rivers.iter().map(|river| of(network, river)).collect()
}

/// Whether a river is another one, or drains into it.
fn drains_into(network: &Network, mut river: u32, other: u32) -> bool {
    while river != other && river != NONE {
        river = network.rivers[river as usize].parent;
    }
    river == other
}

/// Shreve's magnitude: how many rivers begin upstream of the end of each, itself among them.
fn magnitudes(network: &Network) -> Vec<u32> {
    let all = || 0..network.rivers.len() as u32;
    all().map(|end| all().filter(|&river| drains_into(network, river, end)).count() as u32).collect()
}

fn mouth(network: &Network, river: u32) -> u32 {
    let reaches_sea = |&mouth: &u32| network.rivers[mouth as usize].parent == NONE;
    (0..network.rivers.len() as u32).filter(reaches_sea).find(|&mouth| drains_into(network, river, mouth)).unwrap()
}

/// The vertices of a river, source first, the junction last if it ends in one.
fn course(river: &River) -> Vec<usize> {
    river.own().chain((river.joins != NONE).then_some(river.joins as usize)).collect()
}

fn line(network: &Network, river: &River) -> Vec<DVec2> {
    course(river).into_iter().map(|vertex| network.vertices[vertex].at.as_dvec2()).collect()
}

fn length(line: &[DVec2]) -> f64 {
    line.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// How high each vertex lies over the sea, in metres: slopes of 3 in 10,000 at the mouth of all water, steeper as discharge^-0.4.
fn heights(session: &Session) -> Vec<f64> {
    const METRES_A_UNIT: f64 = 1113.2;
    let (network, all) = (session.network().unwrap(), f64::from(session.network_parameters().everything));
    let mut heights = vec![f64::NAN; network.vertices.len()];
    // A river stands before those that join it, but for what a cutoff has given to another.
    while heights.iter().any(|height| height.is_nan()) {
        for river in &network.rivers {
            let course = course(river);
            for pair in course.windows(2).rev() {
                let [upper, lower] = [pair[0], pair[1]];
                let way = network.vertices[upper].at.as_dvec2().distance(network.vertices[lower].at.as_dvec2());
                // Even a river that drains nothing drains a millionth.
                let share = (f64::from(network.vertices[upper].discharge) / all).max(1e-6);
                let slope = 3e-4 * libm::pow(share, -0.4);
                if lower + 1 == river.end as usize && river.joins == NONE {
                    heights[lower] = 0.0;
                }
                heights[upper] = heights[lower] + slope * way * METRES_A_UNIT;
            }
            if course.len() == 1 {
                heights[course[0]] = 0.0;
            }
        }
    }
    heights
}

/// The lakes that there are to see: those that are open anywhere between their ends, which silt has closed.
fn lakes(network: &Network) -> Vec<(u32, &Oxbow)> {
    let is_open = |oxbow: &Oxbow| oxbow.lake().iter().any(|(vertex, share)| vertex.width() * share > 0.0);
    (0..).zip(&network.oxbows).filter(|(_, oxbow)| is_open(oxbow)).collect()
}

#[test]
fn there_are_lakes_to_write() {
    let counts = SESSIONS.each_ref().map(|session| lakes(session.network().unwrap()).len());
    assert!(counts.iter().filter(|count| **count > 10).count() >= 4, "{counts:?}");
}

// ---- GeoJSON

/// Where a point of the domain lies on the globe, east and north: a unit is a hundredth of a degree, the middle at 0, 0.
fn degrees(session: &Session, at: Vec2) -> DVec2 {
    let size = session.growth().parameters().domain.size.as_dvec2();
    let at = at.as_dvec2();
    DVec2::new((at.x - size.x / 2.0) / 100.0, (size.y / 2.0 - at.y) / 100.0)
}

fn position(value: &Value) -> DVec2 {
    DVec2::new(value[0].as_f64().unwrap(), value[1].as_f64().unwrap())
}

/// Half of a hundred-thousandth of a degree, and what floats of units lose.
const ROUNDING: f64 = 7e-6;

#[test]
fn geojson_has_the_recipe_and_a_feature_for_each_river_and_lake() {
    of_all(|session| {
        let (file, network) = (geojson(session), session.network().unwrap());
        assert_eq!(names(&file), ["type", "riverseed", "features"]);
        assert_eq!(file["type"], "FeatureCollection");
        assert_eq!(link::read(file["riverseed"].as_str().unwrap()).as_ref(), Ok(session.recipe()));
        let kinds = |feature: &Value| {
            assert_eq!(feature["type"], "Feature");
            let properties = &feature["properties"];
            (properties["kind"].as_str().unwrap().to_owned(), properties["number"].as_u64().unwrap())
        };
        let rivers = (0..network.rivers.len() as u64).map(|number| ("river".to_owned(), number));
        let lakes = lakes(network).into_iter().map(|(number, _)| ("oxbow".to_owned(), number.into()));
        let expected: Vec<(String, u64)> = rivers.chain(lakes).collect();
        assert_eq!(list(&file["features"]).iter().map(kinds).collect::<Vec<_>>(), expected, "every river, every lake");
        let ids: BTreeSet<String> = list(&file["features"]).iter().map(|feature| feature["id"].to_string()).collect();
        assert_eq!(ids.len(), expected.len(), "each feature has an id of its own");
    });
}

#[test]
fn geojson_s_lines_lie_where_the_rivers_are_north_up_and_to_scale() {
    of_all(|session| {
        let (file, network, heights) = (geojson(session), session.network().unwrap(), heights(session));
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
fn geojson_s_south_is_where_a_map_s_mouths_are() {
    // By hand: rivers of a plain rectangle run to its lower border, and 1.5 times as wide as high is 12.2 degrees by 8.2.
    let session = finished("seed=kauri&land=rectangle&aspect=1.5&mouths=3&sides=s&attractors=300&meander=none");
    for feature in list(&geojson(&session)["features"]) {
        let line = list(&feature["geometry"]["coordinates"]);
        if feature["properties"]["parent"].is_null() {
            let mouth = position(line.last().unwrap());
            assert!((mouth.y + 4.082_48).abs() < 2e-5, "a mouth in the south lies at latitude {}", mouth.y);
            assert!(line[0][1].as_f64().unwrap() > mouth.y, "its source lies north of it");
        }
        assert!(line.iter().all(|at| at[0].as_f64().unwrap().abs() < 6.123_8));
    }
}

#[test]
fn geojson_s_rivers_have_the_properties_that_they_are_said_to_have() {
    of_all(|session| {
        let (file, network) = (geojson(session), session.network().unwrap());
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        for (id, (river, feature)) in network.rivers.iter().zip(list(&file["features"])).enumerate() {
            let properties = &feature["properties"];
            let expected =
                ["kind", "number", "parent", "mouth", "order", "magnitude", "discharge", "length", "sinuosity"];
            assert_eq!(names(properties), expected);
            assert_eq!(properties["parent"].as_u64(), some(river.parent));
            assert_eq!(properties["mouth"], mouth(network, id as u32));
            assert_eq!(properties["order"], orders[id]);
            assert_eq!(properties["magnitude"], magnitudes[id]);
            assert_eq!(properties["discharge"], network.vertices[river.own()].last().unwrap().discharge);
            let line = line(network, river);
            let straight = line[0].distance(line[line.len() - 1]);
            let near = |name: &str, expected: f64, rounding: f64| {
                let value = properties[name].as_f64().unwrap();
                assert!((value - expected).abs() < rounding + expected * 1e-5, "{name}: {value} and not {expected}");
            };
            near("length", length(&line), 0.006);
            near("sinuosity", if straight > 0.0 { length(&line) / straight } else { 1.0 }, 0.0006);
        }
    });
}

/// Twice the area within a closed line, positive if it runs counterclockwise where north is up.
fn turned(ring: &[DVec2]) -> f64 {
    ring.windows(2).map(|side| side[0].perp_dot(side[1])).sum()
}

#[test]
fn geojson_s_lakes_are_closed_wound_and_where_the_loops_were() {
    of_all(|session| {
        let (file, network) = (geojson(session), session.network().unwrap());
        let features = &list(&file["features"])[network.rivers.len()..];
        for ((id, oxbow), feature) in lakes(network).into_iter().zip(features) {
            let properties = &feature["properties"];
            assert_eq!(names(properties), ["kind", "number", "river", "born"]);
            assert_eq!((&properties["river"], &properties["born"]), (&oxbow.river.into(), &oxbow.born.into()));
            let coordinates = &feature["geometry"]["coordinates"];
            assert_eq!((&feature["geometry"]["type"], list(coordinates).len()), (&"Polygon".into(), 1), "lake {id}");
            let ring: Vec<DVec2> = list(&coordinates[0]).iter().map(position).collect();
            assert!(ring.len() >= 4 && ring.first() == ring.last(), "lake {id} is not closed");
            // RFC 7946: outer rings counterclockwise.
            assert!(turned(&ring) > 0.0, "lake {id} is wound the wrong way");
            let lake = oxbow.lake();
            let width = f64::from(lake.iter().map(|(vertex, _)| vertex.width()).fold(0.0, f32::max)) / 100.0;
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

// ---- SVG

#[test]
fn svg_s_data_are_what_the_network_says() {
    of_all(|session| {
        let (text, network) = (to_svg::svg(session).unwrap(), session.network().unwrap());
        let document = roxmltree::Document::parse(&text).unwrap();
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        let (mut rivers, mut lakes_seen) = (Vec::new(), Vec::new());
        for path in document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "path"))) {
            let Some((kind, id)) = path.attribute("id").and_then(|id| id.split_once('-')) else { continue };
            let data =
                |name: &str| path.attribute(format!("data-{name}").as_str()).map(|text| text.parse::<u64>().unwrap());
            let all = path.attributes().filter(|attribute| attribute.name().starts_with("data-")).count();
            let id: u32 = id.parse().unwrap();
            if kind == "oxbow" {
                assert_eq!((data("river"), all), (Some(network.oxbows[id as usize].river.into()), 1));
                lakes_seen.push(id);
                continue;
            }
            let river = &network.rivers[id as usize];
            assert_eq!(data("parent"), some(river.parent));
            assert_eq!(data("order"), Some(orders[id as usize].into()));
            assert_eq!(data("magnitude"), Some(magnitudes[id as usize].into()));
            let discharge = network.vertices[river.own()].last().unwrap().discharge;
            assert_eq!(data("discharge"), Some(discharge.into()));
            assert_eq!(all, 3 + usize::from(river.parent != NONE));
            assert_eq!(path.parent().unwrap().attribute("id"), Some(format!("order-{}", river.order).as_str()));
            assert!(begins_at(path.attribute("d").unwrap(), network.vertices[river.start as usize].at), "river {id}");
            rivers.push(id);
        }
        rivers.sort_unstable();
        assert!(rivers.into_iter().eq(0..network.rivers.len() as u32), "every river");
        // The skeleton shows rivers alone.
        let skeleton = session.recipe().value(Key::Style) == link::read("style=skeleton").unwrap().value(Key::Style);
        let expected: Vec<u32> = lakes(network).into_iter().map(|(id, _)| id).filter(|_| !skeleton).collect();
        assert_eq!(lakes_seen, expected, "every lake");
    });
}

/// Whether a path's first point is one of the domain, in units, y down.
fn begins_at(path: &str, at: Vec2) -> bool {
    let numbers = path.strip_prefix('M').unwrap().split(|c: char| c.is_ascii_lowercase()).next().unwrap();
    let numbers: Vec<f32> = numbers.split(' ').map(|number| number.parse().unwrap()).collect();
    (Vec2::new(numbers[0], numbers[1]) - at).abs().max_element() < 0.011
}

// ---- JSON

#[test]
fn json_s_members_are_those_that_are_told_of() {
    of_all(|session| {
        let file = json(session);
        let members = ["recipe", "resolved", "domain", "growth", "nodes", "rivers", "oxbows", "attractors"];
        assert_eq!(names(&file), members);
        let without = written(|text| to_json::write(text, session, false));
        assert_eq!(names(&without), members[..7]);
    });
}

#[test]
fn json_s_recipe_is_the_recipe_with_all_its_values() {
    of_all(|session| {
        let recipe = &json(session)["recipe"];
        assert_eq!(names(recipe), TABLE.iter().map(|parameter| parameter.name).collect::<Vec<_>>());
        for parameter in &TABLE {
            let value = &recipe[parameter.name];
            match parameter.kind {
                Kind::Integer { .. } => {
                    assert_eq!(value.as_u64(), Some(session.recipe().integer(parameter.key).into()))
                }
                Kind::Number { .. } => {
                    assert_eq!(value.as_f64().unwrap() as f32, session.recipe().number(parameter.key))
                }
                _ => assert_eq!(value.as_str().unwrap(), parameter.text_of(session.recipe().value(parameter.key))),
            }
        }
        assert_eq!(json_recipe::read(&json(session).to_string()).as_ref(), Ok(session.recipe()));
    });
}

#[test]
fn json_s_lengths_are_resolved() {
    of_all(|session| {
        let (file, recipe) = (json(session), session.recipe());
        let (resolved, domain) = (&file["resolved"], &file["domain"]);
        let near = |value: &Value, expected: f32| {
            let value = value.as_f64().unwrap() as f32;
            assert!((value - expected).abs() <= expected.abs() * 1e-5, "{value} and not {expected}");
        };
        let aspect = recipe.number(Key::Aspect);
        near(&domain["width"], 1000.0 * aspect.sqrt());
        near(&domain["height"], 1000.0 / aspect.sqrt());
        let spacing = resolved["spacing"].as_f64().unwrap() as f32;
        if session.growth().parameters().land.is_none() {
            near(&resolved["spacing"], (1e6 / recipe.number(Key::Attractors)).sqrt());
        }
        for key in [Key::Reach, Key::Kill, Key::Step] {
            near(&resolved[key.parameter().name], recipe.number(key) * spacing);
        }
        let is_brownian = recipe.value(Key::Growth) == link::read("growth=brownian").unwrap().value(Key::Growth);
        let between = if is_brownian { recipe.number(Key::Sensitivity) } else { spacing };
        near(&resolved["trim"], (recipe.number(Key::Trim) * if is_brownian { 4.5 } else { 1.0 }).floor());
        near(&resolved["simplify"], recipe.number(Key::Simplify) / 100.0);
        near(&resolved["buffer"], recipe.number(Key::Buffer) * between);
        near(&resolved["vertex-spacing"], (0.32 * between).clamp(0.25, 5.0));
        if !is_brownian {
            near(&resolved["everything"], session.growth().attractors() as f32);
        }
        assert_eq!(resolved["everything"], session.growth().everything());
        assert_eq!(resolved["meander"], Key::Meander.parameter().text_of(recipe.value(Key::Meander)));
        let as_they_are = [
            Key::Momentum,
            Key::Curl,
            Key::Stretch,
            Key::Sensitivity,
            Key::Width,
            Key::Vary,
            Key::MeanderRounds,
            Key::MeanderStrength,
            Key::MeanderMix,
            Key::Gentle,
            Key::Great,
            Key::Flat,
            Key::Neck,
            Key::Taper,
        ];
        as_they_are.iter().for_each(|key| near(&resolved[key.parameter().name], recipe.number(*key)));
        // All there is: what is not named above is looked at nowhere.
        assert_eq!(names(resolved).len(), as_they_are.len() + 10);
    });
}

#[test]
fn json_s_growth_is_what_the_tree_says() {
    of_all(|session| {
        let (growth, tree) = (&json(session)["growth"], session.tree());
        assert_eq!(names(growth), ["ticks", "attractors", "unreached", "complete"]);
        assert_eq!(growth["ticks"], tree.tick_starts.len() - 1);
        assert_eq!(growth["attractors"], session.growth().attractors());
        assert_eq!(growth["unreached"], session.growth().unreached());
        assert_eq!(growth["complete"], session.growth().ending() == Some(Ending::Complete));
    });
}

#[test]
fn json_s_nodes_are_those_of_the_trimmed_tree_column_by_column() {
    of_all(|session| {
        let (file, tree, origin) = (json(session), session.tree(), session.pruned().origin);
        let nodes = &file["nodes"];
        assert_eq!(names(nodes), ["x", "y", "parent", "tick", "depth", "order", "magnitude", "discharge"]);
        let old = |i: usize| origin[i] as usize;
        let all = || 0..origin.len();
        assert_eq!(singles(&nodes["x"]), all().map(|i| tree.at[old(i)].x).collect::<Vec<_>>());
        assert_eq!(singles(&nodes["y"]), all().map(|i| tree.at[old(i)].y).collect::<Vec<_>>());
        let parents = wholes(&nodes["parent"]);
        let parent_of = |i: usize| tree.parent[old(i)];
        let is_parent = |i: usize| match parents[i] {
            -1 => parent_of(i) == NO_PARENT,
            parent => origin[parent as usize] == parent_of(i) && (parent as usize) < i,
        };
        assert!(parents.len() == origin.len() && all().all(is_parent));
        let ticks: Vec<i64> = tree.ticks().map(i64::from).collect();
        assert_eq!(wholes(&nodes["tick"]), all().map(|i| ticks[old(i)]).collect::<Vec<_>>());
        let discharge = Hydrology::of(tree).discharge;
        assert_eq!(wholes(&nodes["discharge"]), all().map(|i| discharge[old(i)].into()).collect::<Vec<i64>>());
        let by_definition = by_definition(&parents);
        let columns = [wholes(&nodes["depth"]), wholes(&nodes["order"]), wholes(&nodes["magnitude"])];
        assert_eq!(columns, by_definition);
    });
}

/// Depth, Strahler's order and Shreve's magnitude of the nodes of a tree, of which each stands after its parent.
fn by_definition(parents: &[i64]) -> [Vec<i64>; 3] {
    let mut children = vec![Vec::new(); parents.len()];
    for (i, &parent) in parents.iter().enumerate().filter(|(_, parent)| **parent >= 0) {
        children[parent as usize].push(i);
    }
    let [mut depth, mut order, mut magnitude] = [0, 1, 1].map(|at_source| vec![at_source; parents.len()]);
    for i in (0..parents.len()).rev().filter(|&i| !children[i].is_empty()) {
        let of_children = |column: &[i64]| children[i].iter().map(|&child| column[child]).collect::<Vec<_>>();
        depth[i] = of_children(&depth).into_iter().max().unwrap() + 1;
        magnitude[i] = of_children(&magnitude).into_iter().sum();
        let orders = of_children(&order);
        let highest = orders.iter().copied().max().unwrap();
        order[i] = highest + i64::from(orders.iter().filter(|order| **order == highest).count() > 1);
    }
    [depth, order, magnitude]
}

/// Points as they are written.
fn points(value: &Value) -> Vec<[f32; 3]> {
    list(value).iter().map(|point| <[f32; 3]>::try_from(singles(point)).unwrap()).collect()
}

#[test]
fn json_s_rivers_and_lakes_are_the_network_s() {
    of_all(|session| {
        let (file, network) = (json(session), session.network().unwrap());
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        assert_eq!(list(&file["rivers"]).len(), network.rivers.len());
        for (id, (river, written)) in network.rivers.iter().zip(list(&file["rivers"])).enumerate() {
            assert_eq!(names(written), ["id", "parent", "order", "magnitude", "discharge", "points"]);
            assert_eq!((written["id"].as_u64(), written["parent"].as_u64()), (Some(id as u64), some(river.parent)));
            assert_eq!((&written["order"], &written["magnitude"]), (&orders[id].into(), &magnitudes[id].into()));
            let course: Vec<_> = course(river).into_iter().map(|i| network.vertices[i]).collect();
            assert_eq!(written["discharge"], network.vertices[river.own()].last().unwrap().discharge);
            let expected = course.iter().map(|vertex| [vertex.at.x, vertex.at.y, vertex.left + vertex.right]);
            assert_eq!(points(&written["points"]), expected.collect::<Vec<_>>());
        }
        assert_eq!(list(&file["oxbows"]).len(), network.oxbows.len());
        for (id, (oxbow, written)) in network.oxbows.iter().zip(list(&file["oxbows"])).enumerate() {
            assert_eq!(names(written), ["id", "river", "born", "points"]);
            assert_eq!(written["id"], id);
            assert_eq!((&written["river"], &written["born"]), (&oxbow.river.into(), &oxbow.born.into()));
            let lake = oxbow.lake();
            let expected = lake.iter().map(|(vertex, share)| [vertex.at.x, vertex.at.y, vertex.width() * share]);
            assert_eq!(points(&written["points"]), expected.collect::<Vec<_>>());
        }
    });
}

#[test]
fn json_s_attractors_are_those_that_were_scattered() {
    of_all(|session| {
        let attractors = &json(session)["attractors"];
        assert_eq!(names(attractors), ["x", "y"]);
        let parameters = session.growth().parameters();
        let scattered = if session.growth().attractors() > 0 { scatter(parameters) } else { Vec::new() };
        assert_eq!(scattered.len() as u32, session.growth().attractors());
        assert_eq!(singles(&attractors["x"]), scattered.iter().map(|at| at.x).collect::<Vec<_>>());
        assert_eq!(singles(&attractors["y"]), scattered.iter().map(|at| at.y).collect::<Vec<_>>());
    });
}
