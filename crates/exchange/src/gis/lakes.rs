//! Lakes at the sea's level, as polygons. GeoJSON has them as holes in the land, and those with a name as points.

use riverseed::export::Json;

use super::feature::{Feature, Place, Shape};

/// The kind of these features. `lake` is that of the point with the name.
pub const KIND: &str = "water";

type Ring = Vec<Place>;

/// Makes a feature for each hole in the land, in the order of the land's pieces.
pub fn of<'a>(features: &[Feature<'a>]) -> Vec<Feature<'a>> {
    let land: Vec<&[Ring]> = features.iter().filter_map(land).collect();
    let holes: Vec<(usize, &Ring)> = land
        .iter()
        .enumerate()
        .flat_map(|(piece, rings)| rings.iter().skip(1).map(move |hole| (piece, hole)))
        .collect();
    let mut shores: Vec<Vec<Ring>> = holes.iter().map(|(_, hole)| vec![reversed(hole)]).collect();
    for island in land.iter().filter_map(|rings| rings.first()) {
        if let Some(lake) = innermost(&holes, island) {
            shores[lake].push(reversed(island));
        }
    }
    let lake = |(number, ((piece, hole), rings)): (usize, ((usize, &Ring), Vec<Ring>))| Feature {
        shape: Shape::Polygon(rings),
        properties: vec![
            ("kind", Json::Text(KIND)),
            ("number", Json::Whole(number as i64)),
            ("land", Json::Whole(piece as i64)),
            ("name", name(features, hole)),
        ],
    };
    holes.into_iter().zip(shores).enumerate().map(lake).collect()
}

/// Returns the rings of a piece of land.
fn land<'b>(feature: &'b Feature<'_>) -> Option<&'b [Ring]> {
    match &feature.shape {
        Shape::Polygon(rings) if feature.kind() == "land" => Some(rings),
        _ => None,
    }
}

/// Reverses a ring: a hole runs clockwise, the lake in it counterclockwise.
fn reversed(ring: &Ring) -> Ring {
    ring.iter().rev().copied().collect()
}

/// Finds the smallest hole that an island lies in. The lake of an island lies in the lake around that island too.
fn innermost(holes: &[(usize, &Ring)], island: &Ring) -> Option<usize> {
    let around = holes.iter().enumerate().filter(|(_, (_, hole))| island.first().is_some_and(|at| is_in(hole, *at)));
    around.min_by(|(_, (_, a)), (_, (_, b))| area(a).total_cmp(&area(b))).map(|(lake, _)| lake)
}

/// Finds the name of the point of a lake that lies in a ring; null if there is none.
fn name<'a>(features: &[Feature<'a>], ring: &Ring) -> Json<'a> {
    let is_here = |feature: &&Feature<'_>| {
        feature.kind() == "lake" && matches!(feature.shape, Shape::Point(at) if is_in(ring, at))
    };
    match features.iter().find(is_here).and_then(|feature| feature.property("name")) {
        Some(Json::Text(name)) => Json::Text(name),
        Some(Json::Owned(name)) => Json::Owned(name.clone()),
        _ => Json::Null,
    }
}

/// Returns `true` if a place lies in a ring: a line from it to the east crosses the ring an odd number of times.
fn is_in(ring: &Ring, at: Place) -> bool {
    let crosses = |pair: &&[Place]| {
        let (a, b) = (pair[0], pair[1]);
        (a.north > at.north) != (b.north > at.north)
            && at.east < a.east + (b.east - a.east) * (at.north - a.north) / (b.north - a.north)
    };
    ring.windows(2).filter(crosses).count() % 2 == 1
}

/// Returns the area in a ring, in square metres.
fn area(ring: &Ring) -> f64 {
    ring.windows(2).map(|pair| pair[0].east * pair[1].north - pair[1].east * pair[0].north).sum::<f64>().abs() * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a square, counterclockwise, around the origin.
    fn square(half: f64) -> Ring {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        corners.map(|(x, y)| Place { east: x * half, north: y * half, height: None }).to_vec()
    }

    fn feature(kind: &'static str, shape: Shape, name: &'static str) -> Feature<'static> {
        Feature { shape, properties: vec![("kind", Json::Text(kind)), ("name", Json::Text(name))] }
    }

    #[test]
    fn an_island_is_a_hole_of_the_lake_right_around_it_and_no_other() {
        let land = |outer, hole| feature("land", Shape::Polygon(vec![square(outer), reversed(&square(hole))]), "");
        let point = |east| Shape::Point(Place { east, north: 0.0, height: None });
        let features = [
            land(9.0, 7.0),
            land(5.0, 3.0),
            feature("land", Shape::Polygon(vec![square(1.0)]), ""),
            feature("sea", point(2.0), "no lake"),
            feature("lake", point(2.0), "inner"),
        ];
        let lakes = of(&features);
        let shapes: Vec<&Shape> = lakes.iter().map(|lake| &lake.shape).collect();
        let lake = |outer, hole| Shape::Polygon(vec![square(outer), reversed(&square(hole))]);
        assert_eq!(shapes, [&lake(7.0, 5.0), &lake(3.0, 1.0)]);
        assert!(matches!(lakes[1].property("name"), Some(Json::Text("inner"))));
        assert!(matches!(lakes[1].property("land"), Some(Json::Whole(1))));
    }
}
