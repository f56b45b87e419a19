//! Outlines of rivers and lakes in SVG are valid polygons for others' readers, whatever they make of curves.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use geo::{LineString, Polygon, Validation};
use kurbo::{BezPath, ParamCurve};
use riverseed::export::svg;
use riverseed::recipe::link;
use riverseed::session::Session;

/// Reads an outline as a ring: each curve becomes this number of sides. Relative coordinates are added up, as all readers do.
fn ring(data: &str, sides: u32) -> LineString {
    let path = BezPath::from_svg(data).unwrap();
    let mut points: Vec<(f64, f64)> = Vec::new();
    for piece in path.segments() {
        let is_straight = matches!(piece, kurbo::PathSeg::Line(_));
        let shares = if is_straight { 1..=1 } else { 1..=sides };
        let count = if is_straight { 1 } else { sides };
        points.extend(shares.map(|i| piece.eval(f64::from(i) / f64::from(count))).map(|at| (at.x, at.y)));
    }
    points.dedup();
    points.into_iter().collect()
}

/// Counts the outlines of a recipe's rivers and lakes, and those of them that cross themselves.
fn counted(recipe: &str) -> (usize, usize) {
    let map = Session::new(link::read(recipe).unwrap()).unwrap().finish().unwrap();
    let text = svg::svg(&map).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let is_water = |id: &str| {
        let number = id.strip_prefix("river-").or_else(|| id.strip_prefix("oxbow-"));
        number.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    let waters: Vec<(&str, &str)> = document
        .descendants()
        .filter_map(|node| Some((node.attribute("id").filter(|id| is_water(id))?, node.attribute("d")?)))
        .collect();
    let is_valid = |data: &str| [1, 4].into_iter().all(|sides| Polygon::new(ring(data, sides), vec![]).is_valid());
    (waters.len(), waters.iter().filter(|(_, data)| !is_valid(data)).count())
}

#[test]
fn outlines_of_rivers_and_lakes_are_valid_polygons() {
    let maps = ["kauri", "rimu"].map(|seed| counted(&format!("country=usual&seed={seed}&land=island")));
    let [all, crossed] = [maps[0].0 + maps[1].0, maps[0].1 + maps[1].1];
    // Banks made loops in narrow bends once, in one outline of three. As measured on 24 maps: 2 in 1,000 still do, on these 7.
    assert!(all > 500 && 100 * crossed < all, "{crossed} of {all}");
}

#[test]
fn outlines_of_wide_rivers_and_of_lakes_are_valid_polygons() {
    let wide = counted(
        "country=usual&seed=p2&edition=1&growth=colonize&valleys=0&sea=0.3&attractors=900&trim=120&simplify=42&width=21&bank-variation=0.20&meander-strength=1&meander-elsewhere=0&great-rivers=12&flat-share=1&neck=1&clearance=0&taper=3&oxbows=1",
    );
    let past = counted("country=usual&seed=kauri&land=island&style=past-courses&attractors=3000");
    assert!(wide.0 > 20 && past.0 > 20 && wide.1 + past.1 == 0, "{wide:?}, {past:?}");
}
