//! Shapes as a GeoPackage stores them: a header with the rectangle around them, and well-known binary.

use super::super::feature::{Place, Shape};
use super::Bounds;

/// Little-endian numbers, and a header with a rectangle.
const FLAGS: u8 = 0b0000_0011;
const LITTLE_ENDIAN: u8 = 1;
/// The number that is added to a type whose places have heights.
const WITH_HEIGHTS: u32 = 1000;

/// Makes the binary form of a shape.
pub fn geometry(shape: &Shape, system: i32) -> Vec<u8> {
    let mut out = Vec::new();
    out.extend(b"GP\0");
    out.push(FLAGS);
    out.extend(system.to_le_bytes());
    let Bounds([west, south, east, north]) = bounds(shape);
    [west, east, south, north].iter().for_each(|number| out.extend(number.to_le_bytes()));
    match shape {
        Shape::Point(place) => {
            head(&mut out, 1, place.height.is_some());
            add_place(&mut out, place);
        }
        Shape::Line(places) => {
            head(&mut out, 2, places.iter().any(|place| place.height.is_some()));
            add_places(&mut out, places);
        }
        Shape::Polygon(rings) => add_polygon(&mut out, rings),
        Shape::MultiPolygon(polygons) => {
            head(&mut out, 6, false);
            count(&mut out, polygons.len());
            polygons.iter().for_each(|rings| add_polygon(&mut out, rings));
        }
    }
    out
}

/// Returns the rectangle around a shape.
pub fn bounds(shape: &Shape) -> Bounds {
    let around = |places: &[Place]| {
        places.iter().fold(Bounds::NONE, |bounds, at| bounds.with(Bounds([at.east, at.north, at.east, at.north])))
    };
    let of_rings = |rings: &[Vec<Place>]| rings.iter().fold(Bounds::NONE, |bounds, ring| bounds.with(around(ring)));
    match shape {
        Shape::Point(place) => around(&[*place]),
        Shape::Line(places) => around(places),
        Shape::Polygon(rings) => of_rings(rings),
        Shape::MultiPolygon(polygons) => {
            polygons.iter().fold(Bounds::NONE, |bounds, rings| bounds.with(of_rings(rings)))
        }
    }
}

fn add_polygon(out: &mut Vec<u8>, rings: &[Vec<Place>]) {
    head(out, 3, false);
    count(out, rings.len());
    rings.iter().for_each(|ring| add_places(out, ring));
}

fn head(out: &mut Vec<u8>, kind: u32, has_heights: bool) {
    out.push(LITTLE_ENDIAN);
    out.extend((kind + if has_heights { WITH_HEIGHTS } else { 0 }).to_le_bytes());
}

fn count(out: &mut Vec<u8>, count: usize) {
    out.extend((count as u32).to_le_bytes());
}

fn add_places(out: &mut Vec<u8>, places: &[Place]) {
    count(out, places.len());
    places.iter().for_each(|place| add_place(out, place));
}

fn add_place(out: &mut Vec<u8>, place: &Place) {
    [Some(place.east), Some(place.north), place.height]
        .into_iter()
        .flatten()
        .for_each(|number| out.extend(number.to_le_bytes()));
}
