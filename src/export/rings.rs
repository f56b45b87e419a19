//! Valid rings for readers of polygons. They are made on the grid of the written numbers, so that no rounding
//! invalidates them.

/// A place on the grid: east, north.
pub(super) type GridPoint = [i32; 2];

/// Makes a closed ring, whose last point is its first, without small loops. `None` unless it then runs counterclockwise
/// around an area and neither crosses nor touches itself. Repeated points count once.
pub(super) fn simple_ring(mut ring: Vec<GridPoint>) -> Option<Vec<GridPoint>> {
    ring.dedup();
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    cut_small_loops(&mut ring);
    if ring.len() < 3 || doubled_area(&ring) <= 0 || !is_simple(&ring) {
        return None;
    }
    ring.push(ring[0]);
    Some(ring)
}

/// Cuts loops of a few points, between two sides that meet. A bank makes them in a bend that is tighter than the river
/// is wide.
fn cut_small_loops(ring: &mut Vec<GridPoint>) {
    let few = (ring.len() / 4).min(12);
    let mut i = 0;
    while i + 3 < ring.len() {
        let last = (i + few).min(ring.len() - 2);
        let meets = |j: &usize| meet((ring[i], ring[i + 1]), (ring[*j], ring[*j + 1]));
        match (i + 2..=last).rev().find(meets) {
            // The sides before now lead elsewhere, and may meet something there.
            Some(j) => {
                ring.drain(i + 1..=j);
                i = i.saturating_sub(few);
            }
            None => i += 1,
        }
    }
}

/// Returns twice the area that a ring encloses counterclockwise, in cells of the grid.
pub(super) fn doubled_area(ring: &[GridPoint]) -> i64 {
    (2..ring.len()).map(|i| turn(ring[0], ring[i - 1], ring[i])).sum()
}

/// Returns `true` if no two sides have a point in common, except for the corners of neighbours.
fn is_simple(ring: &[GridPoint]) -> bool {
    let count = ring.len();
    let corner = |i: usize| ring[i % count];
    let folds_back = |i: usize| {
        let (a, b, c) = (corner(i), corner(i + 1), corner(i + 2));
        turn(a, b, c) == 0 && along(b, a, c) > 0
    };
    let side = |i: usize| (corner(i), corner(i + 1));
    let is_apart = |i: usize, j: usize| (i == 0 && j + 1 == count) || !meet(side(i), side(j));
    (0..count).all(|i| !folds_back(i) && (i + 2..count).all(|j| is_apart(i, j)))
}

/// Returns twice the area of a triangle, negative if it is clockwise.
fn turn(a: GridPoint, b: GridPoint, c: GridPoint) -> i64 {
    let ([px, py], [qx, qy]) = (way(a, b), way(a, c));
    px * qy - py * qx
}

/// Returns the dot product of two ways from one place.
fn along(from: GridPoint, a: GridPoint, b: GridPoint) -> i64 {
    let ([px, py], [qx, qy]) = (way(from, a), way(from, b));
    px * qx + py * qy
}

fn way(from: GridPoint, to: GridPoint) -> [i64; 2] {
    [0, 1].map(|axis| i64::from(to[axis]) - i64::from(from[axis]))
}

/// Returns `true` if two sides have a point in common; touching counts.
fn meet((a, b): (GridPoint, GridPoint), (c, d): (GridPoint, GridPoint)) -> bool {
    let are_apart =
        |axis: usize| a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis]);
    let parts = |a, b, c, d| turn(a, b, c).signum() * turn(a, b, d).signum() <= 0;
    !are_apart(0) && !are_apart(1) && parts(a, b, c, d) && parts(c, d, a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ring_is_closed_and_points_that_fall_together_count_once() {
        let square = vec![[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]];
        assert_eq!(simple_ring(vec![[0, 0], [9, 0], [9, 0], [9, 9], [0, 9]]), Some(square.clone()));
        assert_eq!(simple_ring(square.clone()), Some(square));
    }

    /// Makes a figure of eight with this number of points on either side.
    fn eight(points: i32) -> Vec<GridPoint> {
        let half = points / 2;
        let right = (1..=points).map(|i| [10 + 3 * i.min(points - i), 3 * (i - half)]);
        let left = (1..=points).map(|i| [-10 - 3 * i.min(points - i), 3 * (i - half)]);
        right.chain(left).collect()
    }

    #[test]
    fn what_no_reader_of_polygons_takes_is_refused() {
        for (ring, why) in [
            (vec![], "nothing"),
            (vec![[0, 0], [9, 9], [0, 0]], "no inside"),
            (vec![[0, 0], [0, 9], [9, 9], [9, 0]], "clockwise"),
            (eight(40), "crosses itself"),
            (vec![[20, 0], [9, 0], [9, 9], [0, 9], [0, 0]], "folds back"),
        ] {
            assert_eq!(simple_ring(ring), None, "{why}");
        }
    }

    #[test]
    fn small_loop_is_left_out() {
        let (before, after) = ([[0, 0], [20, 1], [40, 0], [40, 20], [40, 40]], [[25, 30], [0, 40], [1, 30], [0, 20]]);
        let round = [[15, 40], [15, 50], [25, 50]];
        let looped = before.into_iter().chain(round).chain(after).collect();
        let without = before.into_iter().chain(after).chain([before[0]]).collect();
        assert_eq!(simple_ring(looped), Some(without));
    }
}
