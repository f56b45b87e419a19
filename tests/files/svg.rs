//! SVG: each path and its data.

use glam::Vec2;
use riverseed::export::svg as to_svg;
use riverseed::network::NONE;
use riverseed::recipe::{Key, link};

use super::definitions::{lakes, magnitudes, orders};
use super::{geojson, json, list, of_all, some};

#[test]
fn data_are_what_the_network_says() {
    of_all(|session| {
        let (text, network) = (to_svg::svg(&session.map().unwrap()).unwrap(), session.network().unwrap());
        let document = roxmltree::Document::parse(&text).unwrap();
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        let (mut rivers, mut lakes_seen) = (Vec::new(), Vec::new());
        for path in document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "path"))) {
            let of_a_kind = path.attribute("id").and_then(|id| id.split_once('-'));
            let Some((kind, id)) = of_a_kind.filter(|(kind, _)| ["river", "oxbow"].contains(kind)) else { continue };
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
            let discharge = network.vertices[river.vertex_range()].last().unwrap().discharge;
            assert_eq!(data("discharge"), Some(discharge.into()));
            assert_eq!(data("river"), Some(id.into()));
            assert_eq!(all, 4 + usize::from(river.parent != NONE));
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

#[test]
fn branches_of_deltas_are_in_all_files() {
    let mut count = 0;
    of_all(|session| {
        let map = session.map().unwrap();
        let (branches, deltas) = (&map.deltas().distributaries, &map.deltas().list);
        let text = to_svg::svg(&map).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let data =
            |node: roxmltree::Node<'_, '_>, name: &str| node.attribute(name).map(|text| text.parse::<f64>().unwrap());
        let paths = document
            .descendants()
            .filter(|node| node.attribute("id").is_some_and(|id| id.starts_with("distributary-")));
        let drawn: Vec<_> =
            paths.map(|node| ["data-river", "data-parent", "data-share"].map(|name| data(node, name))).collect();
        let expected: Vec<_> = branches
            .iter()
            .map(|branch| {
                [
                    Some(f64::from(branch.river)),
                    branch.parent.map(f64::from),
                    Some(f64::from((branch.share * 100.0).round() / 100.0)),
                ]
            })
            .collect();
        assert_eq!(drawn.len(), expected.len());
        for (drawn, expected) in drawn.iter().zip(&expected) {
            assert_eq!(drawn[..2], expected[..2]);
            assert!((drawn[2].unwrap() - expected[2].unwrap()).abs() < 0.006);
        }
        let (form, collection) = (json(session), geojson(session));
        let of_kind = |kind: &str| {
            list(&collection["features"]).iter().filter(|feature| feature["properties"]["kind"] == kind).count()
        };
        assert_eq!((list(&form["distributaries"]).len(), of_kind("distributary")), (branches.len(), branches.len()));
        assert_eq!((list(&form["deltas"]).len(), of_kind("delta")), (deltas.len(), deltas.len()));
        for (written, branch) in list(&form["distributaries"]).iter().zip(branches) {
            assert_eq!(list(&written["points"]).len(), branch.line.len());
            assert_eq!(
                (written["sea"].as_bool(), written["parent"].as_u64()),
                (Some(branch.reaches_sea), branch.parent.map(u64::from))
            );
        }
        count += branches.len();
    });
    assert!(count > 5, "{count}");
}

/// Whether a path's first point is one of the domain, in units, y down.
fn begins_at(path: &str, at: Vec2) -> bool {
    let numbers = path.strip_prefix('M').unwrap().split(|c: char| c.is_ascii_lowercase()).next().unwrap();
    let numbers: Vec<f32> = numbers.split(' ').map(|number| number.parse().unwrap()).collect();
    (Vec2::new(numbers[0], numbers[1]) - at).abs().max_element() < 0.011
}
