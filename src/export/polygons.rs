//! Polygons from the rings around areas of a raster, on the grid of the written numbers. It finds the holes of each
//! outer ring.

use super::rings::{GridPoint, doubled_area};
use crate::base::sort::{argsort, key};

/// Closed rings whose last point is their first: the outer one, counterclockwise, then its holes, clockwise.
pub(super) type Polygon = Vec<Vec<GridPoint>>;

/// Makes polygons from the rings around some areas, the largest first. All outer rings run one way, all holes the
/// other, and no two cross.
pub(super) fn polygons(rings: impl IntoIterator<Item = Vec<GridPoint>>) -> Vec<Polygon> {
    let (mut outer, mut holes) = (Vec::new(), Vec::new());
    for ring in rings.into_iter().flat_map(apart) {
        match doubled_area(&ring) {
            0 => {}
            1.. => outer.push(vec![ring]),
            _ => holes.push(ring),
        }
    }
    let mut polygons: Vec<Polygon> = largest_first(&outer).into_iter().map(|i| outer[i].clone()).collect();
    for hole in holes {
        // A hole belongs to the smallest polygon around it.
        let is_around = |polygon: &&mut Polygon| hole.iter().all(|at| is_in(&polygon[0], *at));
        if let Some(polygon) = polygons.iter_mut().rev().find(is_around) {
            polygon.push(hole);
        }
    }
    polygons.iter_mut().flatten().for_each(|ring| ring.extend(ring.first().copied()));
    polygons
}

/// Makes polygons of the holes of others, the largest first. What lies in a hole is a hole there.
pub(super) fn inside_out(polygons: &[Polygon]) -> Vec<Polygon> {
    self::polygons(polygons.iter().flatten().map(|ring| ring.iter().rev().copied().collect()))
}

fn largest_first(polygons: &[Polygon]) -> Vec<usize> {
    argsort(polygons.iter().map(|polygon| key(-(doubled_area(&polygon[0]) as f32))))
}

/// Splits a ring wherever it comes to a place twice, and leaves out points on straight sides.
fn apart(ring: Vec<GridPoint>) -> Vec<Vec<GridPoint>> {
    let (mut waiting, mut rings) = (vec![ring], Vec::new());
    while let Some(mut ring) = waiting.pop() {
        match met_twice(&ring) {
            Some((first, second)) => {
                waiting.push(ring.drain(first..second).collect());
                waiting.push(ring);
            }
            None => rings.push(without_straight(ring)),
        }
    }
    rings.into_iter().filter(|ring| ring.len() > 2).collect()
}

/// Finds two positions of one place in a ring, the earlier first; `None` if all places differ.
fn met_twice(ring: &[GridPoint]) -> Option<(usize, usize)> {
    // The sort is stable: equal places end up side by side, in the order of the ring.
    let by_north = argsort(ring.iter().map(|at| at[1] as u32));
    let order = argsort(by_north.iter().map(|&i| ring[i][0] as u32));
    let pairs = order.windows(2).map(|pair| (by_north[pair[0]], by_north[pair[1]]));
    pairs.into_iter().find(|&(first, second)| ring[first] == ring[second])
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

/// Returns `true` if a place lies within a ring or on it: a line to the east then crosses the ring an odd number of
/// times.
pub(super) fn is_in(ring: &[GridPoint], [x, y]: GridPoint) -> bool {
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

    /// Makes a square around a place on the axis, with this half side.
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
    fn island_is_a_hole_of_the_lake_right_around_it_and_no_other() {
        let land = polygons([
            square(0, 90),
            reversed(square(0, 70)),
            square(0, 50),
            reversed(square(0, 30)),
            square(0, 10),
            square(200, 9),
        ]);
        let ring = |half| {
            let mut ring = square(0, half);
            ring.push(ring[0]);
            ring
        };
        let lake = |shore, island| vec![ring(shore), reversed(ring(island))];
        let corners = |polygons: &[Polygon]| -> Vec<Vec<Vec<GridPoint>>> {
            let sorted = |ring: &Vec<GridPoint>| {
                let mut ring = ring.clone();
                ring.sort_unstable();
                ring.dedup();
                ring
            };
            polygons.iter().map(|polygon| polygon.iter().map(sorted).collect()).collect()
        };
        let lakes = inside_out(&land);
        assert_eq!(corners(&lakes), corners(&[lake(70, 50), lake(30, 10)]));
        assert!(lakes.iter().all(|lake| doubled_area(&lake[0]) > 0 && doubled_area(&lake[1]) < 0));
    }

    #[test]
    fn ring_that_touches_itself_is_two_and_straight_points_go() {
        // A corner lies on a side: the ring is cut there, and its parts keep their sides.
        let eight = vec![[0, 0], [10, 0], [10, 10], [0, 10], [-5, 10], [-10, 10], [-10, 20], [0, 20], [0, 10]];
        let all = polygons([eight]);
        assert_eq!(all.iter().map(Vec::len).collect::<Vec<_>>(), [1], "{all:?}");
        assert_eq!(polygons([vec![[0, 0], [5, 0], [9, 0], [9, 9]]]), [[[[0, 0], [9, 0], [9, 9], [0, 0]]]]);
        assert!(polygons([vec![[0, 0], [9, 0], [0, 0]], vec![]]).is_empty());
    }
}
