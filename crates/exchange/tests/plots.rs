//! Lines for plotters, as an XML reader and a reader of paths of others have them.

use std::collections::BTreeSet;

use kurbo::{BezPath, PathEl, Point};
use riverseed::domain::Domain;
use riverseed::recipe::link;
use riverseed_exchange::{Form, Options, Sheet};

use crate::maps::{LINKS, file, file_with, map};

const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

fn on(sheet: Sheet, text: &str) -> String {
    let options = Options { sheet: Some(sheet), ..Options::default() };
    String::from_utf8(file_with(Form::Plot, &map(text), None, None, &options)).unwrap()
}

/// Reads the width and the height of a sheet, in millimetres: the unit that the view box counts in.
fn sides(document: &roxmltree::Document) -> [f64; 2] {
    let root = document.root_element();
    let [width, height] = ["width", "height"].map(|name| root.attribute(name).unwrap().strip_suffix("mm").unwrap());
    assert_eq!(root.attribute("viewBox").unwrap(), format!("0 0 {width} {height}"));
    [width, height].map(|side| side.parse().unwrap())
}

/// Lists the corners of a path, of which all lines are straight.
fn corners(data: &str) -> Vec<Point> {
    let corner = |element| match element {
        PathEl::MoveTo(at) | PathEl::LineTo(at) => Some(at),
        PathEl::ClosePath => None,
        other => panic!("{other:?}"),
    };
    BezPath::from_svg(data).unwrap().into_iter().filter_map(corner).collect()
}

#[test]
fn a_layer_holds_the_rivers_of_one_order_and_all_that_lies_on_the_map_is_on_the_sheet() {
    for text in LINKS {
        let map = map(text);
        let plot = String::from_utf8(file(Form::Plot, &map, None, None)).unwrap();
        let document = roxmltree::Document::parse(&plot).unwrap();
        let [width, height] = sides(&document);
        let size = map.domain().size;
        assert_eq!((width < height, width.max(height)), (size.x < size.y, 297.0), "{text}");
        let metadata = document.descendants().find(|node| node.attribute("id") == Some("riverseed"));
        assert_eq!(link::read(metadata.unwrap().text().unwrap()).as_ref(), Ok(map.recipe()));
        let layers: Vec<_> = document.root_element().children().filter(|node| node.tag_name().name() == "g").collect();
        let mut rivers = BTreeSet::new();
        for (layer, number) in layers.iter().rev().zip(1..) {
            assert_eq!(layer.attribute((INKSCAPE, "groupmode")), Some("layer"));
            let label = layer.attribute((INKSCAPE, "label")).unwrap();
            assert!(label.starts_with(&format!("{number} ")), "{label}");
            assert_eq!((layer.attribute("fill"), layer.attribute("stroke-width")), (Some("none"), Some("0.3")));
            for path in layer.children().filter(roxmltree::Node::is_element) {
                let corners = corners(path.attribute("d").unwrap());
                assert!(corners.len() > 1);
                let is_on_map = |at: &Point| {
                    let aside = |x: f64, side: f64| (x - side / 2.0).abs();
                    let scale = (277.0 / f64::from(size.max_element())).min(190.0 / f64::from(size.min_element()));
                    aside(at.x, width) <= f64::from(size.x) * scale / 2.0 + 0.006
                        && aside(at.y, height) <= f64::from(size.y) * scale / 2.0 + 0.006
                };
                assert!(corners.iter().all(is_on_map), "{text}: {label}");
                if let Some(river) = path.attribute("data-river") {
                    assert_eq!(path.attribute("id"), Some(format!("river-{river}").as_str()));
                    let river: usize = river.parse().unwrap();
                    assert_eq!(u32::from(map.network().rivers[river].order), number);
                    assert!(rivers.insert(river));
                }
            }
        }
        assert_eq!(rivers.len(), map.network().rivers.len(), "{text}");
        let has = |name: &str| layers.iter().any(|layer| layer.attribute("id") == Some(name));
        assert_eq!((has("coast"), has("contours")), (true, true));
    }
}

#[test]
fn a_tributary_ends_on_its_river_to_the_digit() {
    let map = map(LINKS[0]);
    let plot = String::from_utf8(file(Form::Plot, &map, None, None)).unwrap();
    let document = roxmltree::Document::parse(&plot).unwrap();
    let course = |number: usize| {
        let id = format!("river-{number}");
        let path = document.descendants().find(|node| node.attribute("id") == Some(&id)).unwrap();
        corners(path.attribute("d").unwrap())
    };
    let mut tributaries = 0;
    for (number, river) in map.network().rivers.iter().enumerate() {
        if map.network().rivers.get(river.parent as usize).is_some() {
            assert!(course(river.parent as usize).contains(course(number).last().unwrap()), "{number}");
            tributaries += 1;
        }
    }
    assert!(tributaries > 0);
}

#[test]
fn a_map_is_as_large_as_its_sheet_and_the_same_on_all() {
    let size = Domain::of(map(LINKS[0]).recipe()).size;
    let plots = [Sheet::A5, Sheet::A3, Sheet::Letter].map(|sheet| on(sheet, LINKS[0]));
    let documents = plots.each_ref().map(|plot| roxmltree::Document::parse(plot).unwrap());
    assert_eq!(documents.each_ref().map(sides), [[210.0, 148.0], [420.0, 297.0], [279.4, 215.9]]);
    let first = documents.each_ref().map(|document| {
        let [width, _] = sides(document);
        let path = document.descendants().find(|node| node.has_attribute("data-river")).unwrap();
        let at = corners(path.attribute("d").unwrap())[0];
        (at.x - width / 2.0) / (width - 20.0) * f64::from(size.x)
    });
    assert!(first.iter().all(|x| (x - first[0]).abs() < 0.2), "{first:?}");
}
