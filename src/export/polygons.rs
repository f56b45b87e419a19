//! Polygons of rings that run around areas of a raster: which ring is a hole of which, on the grid of the numbers that are written.

use super::rings::{GridPoint, doubled_area};

/// Rings, closed, whose last point is their first: the outer one, counterclockwise, then its holes, clockwise.
pub(super) type Polygon = Vec<Vec<GridPoint>>;

/// The polygons of the rings around some areas, the largest first. All outer rings run one way, all holes the other, and none cross.
pub(super) fn polygons(rings: impl IntoIterator<Item = Vec<GridPoint>>) -> Vec<Polygon> {
    let mut outer: Vec<(i64, Polygon)> = Vec::new();
    let mut holes = Vec::new();
    for ring in rings.into_iter().flat_map(apart) {
        match doubled_area(&ring) {
            0 => {}
            area @ 1.. => outer.push((area, vec![ring])),
            _ => holes.push(ring),
        }
    }
    // The least that holds one is the one that it is in.
    outer.sort_by_key(|(area, _)| *area);
    for hole in holes {
        let around = outer.iter_mut().find(|(_, polygon)| hole.iter().all(|at| is_in(&polygon[0], *at)));
        around.into_iter().for_each(|(_, polygon)| polygon.push(hole.clone()));
    }
    outer.into_iter().rev().map(|(_, polygon)| polygon.into_iter().map(closed).collect()).collect()
}

/// A ring without points that tell nothing; one that comes to a place twice is two.
fn apart(ring: Vec<GridPoint>) -> Vec<Vec<GridPoint>> {
    let mut rings = Vec::new();
    let mut way: Vec<GridPoint> = Vec::with_capacity(ring.len());
    let mut places = std::collections::BTreeMap::new();
    for at in ring {
        if let Some(&first) = places.get(&at) {
            let round = way.split_off(first);
            round.iter().for_each(|at| {
                places.remove(at);
            });
            rings.push(round);
        }
        places.insert(at, way.len());
        way.push(at);
    }
    rings.push(way);
    rings.into_iter().map(without_straight).filter(|ring| ring.len() > 2).collect()
}

/// Leaves out points on straight sides.
fn without_straight(ring: Vec<GridPoint>) -> Vec<GridPoint> {
    let count = ring.len();
    let is_corner = |i: &usize| {
        let (a, b, c) = (ring[(i + count - 1) % count], ring[*i], ring[(i + 1) % count]);
        doubled_area(&[a, b, c]) != 0
    };
    (0..count).filter(is_corner).map(|i| ring[i]).collect()
}

fn closed(mut ring: Vec<GridPoint>) -> Vec<GridPoint> {
    ring.extend(ring.first().copied());
    ring
}

/// Whether a place lies within a ring or on it: a line to the east crosses the ring an odd number of times.
fn is_in(ring: &[GridPoint], [x, y]: GridPoint) -> bool {
    let before = ring.iter().cycle().skip(ring.len() - 1);
    let mut is_in = false;
    for (&a, &b) in before.zip(ring) {
        if [x, y] == b {
            return true;
        }
        let (lower, upper) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        if (lower[1]..upper[1]).contains(&y) {
            is_in ^= doubled_area(&[lower, upper, [x, y]]) > 0;
        }
    }
    is_in
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with this half side, around a place.
    fn square(x: i32, half: i32) -> Vec<GridPoint> {
        [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[dx, y]| [x + dx, y]).to_vec()
    }

    fn reversed(mut ring: Vec<GridPoint>) -> Vec<GridPoint> {
        ring.reverse();
        ring
    }

    #[test]
    fn hole_belongs_to_the_least_ring_around_it() {
        let rings = [square(0, 50), reversed(square(0, 40)), square(0, 30), reversed(square(0, 5)), square(200, 9)];
        let shapes: Vec<(usize, i32)> =
            polygons(rings).iter().map(|polygon| (polygon.len(), polygon[0][0][0])).collect();
        assert_eq!(shapes, [(2, -50), (2, -30), (1, 191)]);
    }

    #[test]
    fn ring_that_touches_itself_is_two_and_straight_points_go() {
        // Corner on side: the ring is cut there, and its parts keep their sides.
        let eight = vec![[0, 0], [10, 0], [10, 10], [0, 10], [-5, 10], [-10, 10], [-10, 20], [0, 20], [0, 10]];
        let all = polygons([eight]);
        assert_eq!(all.iter().map(Vec::len).collect::<Vec<_>>(), [1], "{all:?}");
        assert_eq!(polygons([vec![[0, 0], [5, 0], [9, 0], [9, 9]]]), [[[[0, 0], [9, 0], [9, 9], [0, 0]]]]);
        assert!(polygons([vec![[0, 0], [9, 0], [0, 0]], vec![]]).is_empty());
    }
}
