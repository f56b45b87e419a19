//! Points over the whole map, as even as blue noise and in no pattern: no two are nearer than a distance, and there is room for next to
//! none between them. They depend on the seed and the map's size alone.
//!
//! After Bridson (*Fast Poisson disk sampling in arbitrary dimensions*, 2007), but with candidates of each cell in place of a front, so that
//! no point depends on where one begins.

use glam::Vec2;

use crate::base::random::{Purpose, Seed};

/// The least distance between points, in units.
pub const APART: f32 = 5.0;

/// The number of candidates of a cell.
const CANDIDATES: u32 = 3;
/// The number of cells within reach of one, to each side.
const REACH: usize = 2;
/// No point: farther from all others than can be squared.
const NOTHING: Vec2 = Vec2::splat(f32::MAX);

/// Scatters points over a map. Returns them row by row.
pub fn scatter(size: Vec2, seed: Seed) -> Vec<Vec2> {
    // So small that two points in one are too near.
    let side = APART * std::f32::consts::FRAC_1_SQRT_2;
    let [columns, rows] = [size.x, size.y].map(|length| (length / side) as usize + 1);
    let stride = columns + 2 * REACH;
    let mut cells = vec![NOTHING; stride * (rows + 2 * REACH)];
    let chance = seed.item_hash(Purpose::Scenery);
    for candidate in 0..CANDIDATES {
        for cell in evenly(columns * rows) {
            let (column, row) = (cell as u32 % columns as u32, cell as u32 / columns as u32);
            let (column, row) = (column as usize, row as usize);
            let place = (row + REACH) * stride + column + REACH;
            if cells[place] != NOTHING {
                continue;
            }
            let bits = chance.bits([cell as u32, candidate, 0]);
            let [x, y] = [bits >> 16, bits & 0xffff].map(|bits| bits as f32 / 65536.0);
            let at = Vec2::new(column as f32 + x, row as f32 + y) * side;
            let is_inside = at.cmplt(size).all();
            if is_inside && is_free(&cells, place, stride, at) {
                cells[place] = at;
            }
        }
    }
    cells.retain(|at| *at != NOTHING);
    cells
}

/// Returns `true` if no point in the cells around is too near.
fn is_free(cells: &[Vec2], place: usize, stride: usize, at: Vec2) -> bool {
    let is_far = |other: &Vec2| at.distance_squared(*other) >= APART * APART;
    let first = place - REACH * stride - REACH;
    // Those beside it are the likeliest to be too near.
    [2, 1, 3, 0, 4].into_iter().all(|row| cells[first + row * stride..][..=2 * REACH].iter().all(is_far))
}

/// Returns all numbers below a count, in steps of the golden section of it: any run of them is spread evenly.
fn evenly(count: usize) -> impl Iterator<Item = usize> {
    const GOLDEN: f64 = 0.618_033_988_75;
    let mut step = ((count as f64 * GOLDEN) as usize).max(1);
    while greatest_divisor(step, count) > 1 {
        step += 1;
    }
    // A remainder for each would take as long as all else.
    let next = move |number: &usize| Some(if number + step < count { number + step } else { number + step - count });
    std::iter::successors(Some(0), next).take(count)
}

fn greatest_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_apart_and_leave_hardly_any_room() {
        let (size, seed) = (Vec2::new(300.0, 200.0), Seed::from_text("kauri"));
        let points = scatter(size, seed);
        assert!(points.iter().all(|at| at.cmpge(Vec2::ZERO).all() && at.cmplt(size).all()));
        for (i, at) in points.iter().enumerate() {
            assert!(points[..i].iter().all(|other| at.distance(*other) >= APART * 0.999_99), "{at}");
        }
        let nearest = |at: Vec2| points.iter().map(|other| at.distance(*other)).fold(f32::MAX, f32::min);
        let samples: Vec<Vec2> =
            (0..1500).map(|i| size * Vec2::new((i % 50) as f32 / 50.0, (i / 50) as f32 / 30.0)).collect();
        let bare = samples.iter().filter(|at| nearest(**at) > APART * 1.05).count();
        assert!(bare < 60, "{bare} of {}", samples.len());
        assert_eq!(points, scatter(size, seed));
        assert_ne!(points, scatter(size, Seed::from_text("rimu")));
    }

    #[test]
    fn every_number_comes_once() {
        for count in [0, 1, 2, 5, 12, 100, 1597] {
            let mut all: Vec<usize> = evenly(count).collect();
            all.sort_unstable();
            assert_eq!(all, (0..count).collect::<Vec<_>>());
        }
    }
}
