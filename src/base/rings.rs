//! Rings: closed lines whose last point is followed by their first, and the area within an odd number of them.

use glam::Vec2;

use super::sort;

/// Returns the sides of rings, from each point to the next.
pub(crate) fn sides(rings: &[Vec<Vec2>]) -> impl Iterator<Item = [Vec2; 2]> {
    let last = |ring: &[Vec2]| ring.last().zip(ring.first()).map(|(last, first)| [*last, *first]);
    rings.iter().flat_map(move |ring| ring.windows(2).map(|pair| [pair[0], pair[1]]).chain(last(ring)))
}

/// Returns the stretches of a level line that lie within an odd number of rings, each from west to east.
pub(crate) fn stretches(rings: &[Vec<Vec2>], y: f32) -> Vec<[f32; 2]> {
    stretches_between(sides(rings), y)
}

/// Returns the stretches of a level line that lie within an odd number of rings, of which all sides that meet the line are given.
pub(crate) fn stretches_between(sides: impl Iterator<Item = [Vec2; 2]>, y: f32) -> Vec<[f32; 2]> {
    let mut places = Vec::new();
    sides.for_each(|[a, b]| {
        if (a.y > y) != (b.y > y) {
            places.push(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
    });
    sort::sorted(&places).as_chunks::<2>().0.to_vec()
}

/// Returns `true` if a point lies within an odd number of rings.
pub(crate) fn are_around(rings: &[Vec<Vec2>], point: Vec2) -> bool {
    stretches(rings, point.y).into_iter().any(|[from, to]| (from..to).contains(&point.x))
}

/// Returns the area within a ring; negative if it runs the other way round.
pub(crate) fn area(ring: &[Vec2]) -> f32 {
    let origin = ring.first().copied().unwrap_or_default();
    let edges = ring.iter().zip(ring.iter().skip(1));
    edges.map(|(a, b)| (*a - origin).perp_dot(*b - origin)).sum::<f32>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(from: f32, to: f32) -> Vec<Vec2> {
        [(from, from), (to, from), (to, to), (from, to)].map(Vec2::from).to_vec()
    }

    #[test]
    fn what_lies_within_an_odd_number_of_rings_is_the_square_without_its_hole() {
        let rings = [square(0.0, 10.0), square(4.0, 6.0)];
        assert_eq!(stretches(&rings, 1.0), [[0.0, 10.0]]);
        assert_eq!(stretches(&rings, 5.0), [[0.0, 4.0], [6.0, 10.0]]);
        assert!(stretches(&rings, 11.0).is_empty());
        let points = [(1.0, 5.0), (5.0, 5.0), (7.0, 5.0), (12.0, 5.0), (5.0, -1.0)].map(Vec2::from);
        assert_eq!(points.map(|point| are_around(&rings, point)), [true, false, true, false, false]);
    }

    #[test]
    fn area_has_the_sign_of_the_way_round() {
        let mut ring = square(2.0, 5.0);
        assert_eq!(area(&ring), 9.0);
        ring.reverse();
        assert_eq!((area(&ring), area(&[])), (-9.0, 0.0));
    }
}
