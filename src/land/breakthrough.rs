//! Breakthroughs: the straits by which inner waters reach the open sea.
//!
//! A water that land surrounds would have rivers in and none out. It would rise until it ran over at the lowest place of its
//! rim, and cut its way to the sea there, as the Bosporus and the Dardanelles are cut. So each breaks through along the way
//! that is lowest, and short: narrow at the col, wider where the ground is lower, toward both ends.

use glam::{Vec2, Vec3};

use super::cell::Cell;
use super::coast_distance::CoastDistance;
use super::regions::Region;
use crate::base::geometry::nearest;
use crate::base::queue::Queue;
use crate::base::work;

/// The distance between the nodes of the search, in units, on any lattice: a draft of a land finds the same way.
const STEP: f32 = CoastDistance::COARSE_SPACING;

/// The label of a node on land, and that of one in the open sea; inner waters are numbered from there.
const LAND: u32 = 0;
const OPEN: u32 = 1;

/// Half the width of a strait at its narrowest, in units: as a share of the root of the area behind it, the least and the
/// most. A great river's mouth is about as wide.
const HALF_BY_AREA: f32 = 0.026;
const HALVES: (f32, f32) = (3.4, 6.0);

/// Joins all inner waters of a land of some size to the open sea; where there is none, to the border. `noise` gives each place a number
/// from −1 to 1, by which ways and banks wind. The result has yet to be [settled](CoastDistance::settled).
pub(super) fn open(lattice: CoastDistance, size: Vec2, noise: &dyn Fn(Vec2) -> f32) -> CoastDistance {
    let waters = lattice.regions(Cell::Water);
    let inner: Vec<&Region> = waters.iter().filter(|water| !is_open(&lattice, size, water)).collect();
    if inner.is_empty() {
        return lattice;
    }
    let mut labels = labels(&lattice, &inner);
    if inner.len() == waters.len() {
        open_border(&lattice, &mut labels);
    }
    let mut heights = lattice.heights().to_vec();
    for way in Search::new(&lattice, &labels, noise).ways(inner.len()) {
        let area = inner[way.water].cells as f32 * lattice.spacing() * lattice.spacing();
        Strait::new(&lattice, &way.nodes, area).carve(&lattice, noise, &mut heights);
    }
    lattice.with_heights_of(&heights)
}

/// Returns `true` if a water reaches the border, beyond which it goes on.
fn is_open(lattice: &CoastDistance, size: Vec2, water: &Region) -> bool {
    let reaches = |corner: usize| {
        let (at, columns) = (lattice.corner(corner), lattice.size().0);
        let beyond = size - lattice.spacing();
        let border = Vec2::select(at.cmpge(beyond), size, at);
        is_border(lattice, corner % columns, corner / columns) && lattice.height(border) <= 0.0
    };
    lattice.corners_of(water).any(reaches)
}

/// Returns `true` for corners on the border of the domain or next to it.
fn is_border(lattice: &CoastDistance, column: usize, row: usize) -> bool {
    let (columns, rows) = lattice.size();
    row == 0 || column == 0 || row + 2 >= rows || column + 2 >= columns
}

/// Labels the corners of land, of the open sea and of inner waters.
fn labels(lattice: &CoastDistance, inner: &[&Region]) -> Vec<u32> {
    let mut labels: Vec<u32> = lattice.heights().iter().map(|&height| if height > 0.0 { LAND } else { OPEN }).collect();
    for (number, water) in (OPEN + 1..).zip(inner) {
        lattice.corners_of(water).for_each(|corner| labels[corner] = number);
    }
    labels
}

/// Labels the border as open sea.
fn open_border(lattice: &CoastDistance, labels: &mut [u32]) {
    let columns = lattice.size().0;
    for (corner, label) in labels.iter_mut().enumerate() {
        if is_border(lattice, corner % columns, corner / columns) {
            *label = OPEN;
        }
    }
}

/// A way from an inner water to one that has its outlet.
struct Way {
    /// The number of the inner water.
    water: usize,
    /// The corners along the way, both ends in water.
    nodes: Vec<Vec2>,
}

/// The search for the cheapest ways from the open sea to all inner waters (Dijkstra 1959), over every so many corners.
struct Search {
    columns: usize,
    rows: usize,
    /// The effort of a step to each node, for its length: that of a lower one is much less.
    effort: Vec<f32>,
    label: Vec<u32>,
    cost: Vec<f32>,
    from: Vec<u32>,
}

impl Search {
    fn new(lattice: &CoastDistance, labels: &[u32], noise: &dyn Fn(Vec2) -> f32) -> Self {
        let stride = ((STEP / lattice.spacing()) as usize).max(1);
        let [columns, rows] = [lattice.size().0, lattice.size().1].map(|corners| corners.div_ceil(stride));
        let (mut label, mut effort) = (Vec::new(), Vec::new());
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let corner = row * stride * lattice.size().0 + column * stride;
            label.push(labels[corner]);
            effort.push(effort_of(lattice.heights()[corner], noise, lattice.corner(corner)));
        }
        work::count(4 * label.len());
        let (cost, from) = (vec![f32::INFINITY; label.len()], vec![u32::MAX; label.len()]);
        Self { columns, rows, effort, label, cost, from }
    }

    /// Finds the ways to a number of inner waters, each from the open sea or from another of them.
    fn ways(mut self, inner: usize) -> Vec<Way> {
        let (mut ways, mut is_reached) = (Vec::new(), vec![false; inner]);
        let mut queue = Queue::default();
        for node in (0..self.label.len()).filter(|&node| self.label[node] == OPEN) {
            self.cost[node] = self.effort[node];
            if self.beside(node).any(|(beside, _)| self.label[beside] != OPEN) {
                queue.push(self.cost[node], node as u32);
            }
        }
        while let Some(node) = queue.pop() {
            let node = node as usize;
            work::count(8);
            let water = self.label[node].wrapping_sub(OPEN + 1) as usize;
            if is_reached.get(water) == Some(&false) {
                is_reached[water] = true;
                ways.push(Way { water, nodes: self.way_to(node) });
                if ways.len() == inner {
                    break;
                }
            }
            for (beside, length) in self.beside(node) {
                let cost = self.cost[node] + length * self.effort[beside];
                if cost < self.cost[beside] {
                    (self.cost[beside], self.from[beside]) = (cost, node as u32);
                    queue.push(cost, beside as u32);
                }
            }
        }
        ways
    }

    /// Lists the places of the nodes from the last water before a node to it.
    fn way_to(&self, node: usize) -> Vec<Vec2> {
        let place = |node: usize| Vec2::new((node % self.columns) as f32, (node / self.columns) as f32) * STEP;
        let (mut way, mut at) = (vec![place(node)], node);
        while let Some(&from) = self.from.get(at).filter(|from| **from != u32::MAX) {
            at = from as usize;
            way.push(place(at));
            if self.label[at] != LAND {
                break;
            }
        }
        way
    }

    /// Iterates over the nodes around a node, each with its distance, in steps.
    fn beside(&self, node: usize) -> impl Iterator<Item = (usize, f32)> + use<> {
        const DIAGONAL: f32 = std::f32::consts::SQRT_2;
        const AROUND: [(isize, isize, f32); 8] = [
            (1, 0, 1.0),
            (0, 1, 1.0),
            (-1, 0, 1.0),
            (0, -1, 1.0),
            (1, 1, DIAGONAL),
            (-1, 1, DIAGONAL),
            (-1, -1, DIAGONAL),
            (1, -1, DIAGONAL),
        ];
        let (columns, rows) = (self.columns, self.rows);
        AROUND.into_iter().filter_map(move |(east, south, length)| {
            let column = (node % columns).wrapping_add_signed(east);
            let row = (node / columns).wrapping_add_signed(south);
            // Beyond the first row the product would be too large a number.
            (column < columns && row < rows).then(|| (row * columns + column, length))
        })
    }
}

/// Returns the effort of a way over a place with a height, in units, for its length: next to none over water. A low way is
/// worth a long one, and where heights are alike noise winds it.
fn effort_of(height: f32, noise: &dyn Fn(Vec2) -> f32, at: Vec2) -> f32 {
    /// The height at which a way is four times as hard as on the shore, in units.
    const HIGH: f32 = 6.0;
    const AFLOAT: f32 = 0.01;
    if height <= 0.0 {
        return AFLOAT;
    }
    let (steep, wind) = (1.0 + height / HIGH, 1.0 + noise(at).clamp(-1.0, 1.0));
    steep * steep * (0.3 + wind * wind)
}

/// A strait: its course, with half its width at each place, in units.
struct Strait(Vec<(Vec2, f32)>);

impl Strait {
    /// Lays a strait along a way, to a water with an area, in square units.
    fn new(lattice: &CoastDistance, way: &[Vec2], area: f32) -> Self {
        /// The width at both ends, beyond that of the narrowest place, as a share of it.
        const FLARE: f32 = 1.8;
        let narrow = (HALF_BY_AREA * area.sqrt()).clamp(HALVES.0, HALVES.1);
        let course = rounded(smoothed(way.iter().map(|&at| at.extend(lattice.height(at).max(0.0))).collect()));
        let highest = course.iter().fold(1.0, |highest, at| at.z.max(highest));
        let half = |height: f32| {
            let low = 1.0 - height / highest;
            narrow * (1.0 + FLARE * low * low)
        };
        Self(course.into_iter().map(|at| (at.truncate(), half(at.z))).collect())
    }

    /// Lowers the corners in the strait below the sea, and those around it to their distance from its banks.
    fn carve(&self, lattice: &CoastDistance, noise: &dyn Fn(Vec2) -> f32, heights: &mut [f32]) {
        /// The distance by which noise moves the banks, in units.
        const SWAY: f32 = 2.5;
        /// The least half width, in units, and as a share of the spacing of the lattice: corners beside one another lie in it
        /// all the way.
        const LEAST: (f32, f32) = (3.0, 0.75);
        /// The number of corners beside the banks that have their distance from them.
        const BESIDE: f32 = 2.5;
        let ((columns, rows), spacing) = (lattice.size(), lattice.spacing());
        let least = LEAST.0.max(LEAST.1 * spacing);
        let index = |at: f32, count: usize| ((at / spacing).max(0.0) as usize).min(count);
        for ends in self.0.windows(2) {
            let [(from, half), (to, half_to)] = [ends[0], ends[1]];
            let reach = half.max(half_to) + SWAY + BESIDE * spacing;
            let (first, last) = (from.min(to) - reach, from.max(to) + reach + spacing);
            for row in index(first.y, rows)..index(last.y, rows) {
                for column in index(first.x, columns)..index(last.x, columns) {
                    work::count(1);
                    let (corner, at) = (row * columns + column, Vec2::new(column as f32, row as f32) * spacing);
                    let (away, along) = nearest(at, (from, to));
                    let half = half + (half_to - half) * along + SWAY * noise(at);
                    heights[corner] = heights[corner].min(away - half.max(least));
                }
            }
        }
    }
}

/// Moves the inner points of a line halfway toward the middle between those beside them, a few times.
fn smoothed(mut line: Vec<Vec3>) -> Vec<Vec3> {
    const ROUNDS: usize = 3;
    for _ in 0..ROUNDS {
        let before = line.clone();
        for (point, three) in line.iter_mut().skip(1).zip(before.windows(3)) {
            *point = 0.5 * three[1] + 0.25 * (three[0] + three[2]);
        }
    }
    line
}

/// Cuts the corners of a line twice, which keeps its ends (Chaikin 1974).
fn rounded(mut line: Vec<Vec3>) -> Vec<Vec3> {
    for _ in 0..2 {
        let cut = line.windows(2).flat_map(|ends| [0.25, 0.75].map(|share| ends[0].lerp(ends[1], share)));
        line = line.iter().take(1).copied().chain(cut).chain(line.iter().skip(1).last().copied()).collect();
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: f32 = 400.0;

    /// Land of the given heights, with waters where they are below 0.
    #[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
    fn land(height: impl Fn(Vec2) -> f32) -> CoastDistance {
        let columns = (SIZE / CoastDistance::SPACING) as usize + 2;
        let at = |i: usize| Vec2::new((i % columns) as f32, (i / columns) as f32) * CoastDistance::SPACING;
        let heights = (0..columns * columns).map(|i| height(at(i))).collect();
        CoastDistance::of_heights(Vec2::splat(SIZE), CoastDistance::SPACING, heights).unwrap()
    }

    fn opened(land: &CoastDistance) -> CoastDistance {
        open(land.clone(), Vec2::splat(SIZE), &|_| 0.0).settled()
    }

    /// A lake of radius 40 in the middle of a plain, and the sea south of y = 350.
    fn lake(plain: f32) -> impl Fn(Vec2) -> f32 {
        move |at| if at.y > 350.0 || at.distance(Vec2::splat(200.0)) < 40.0 { -10.0 } else { plain }
    }

    #[test]
    fn a_water_breaks_through_at_its_lowest_place_and_not_where_it_is_nearest() {
        let low = |at: Vec2| at.x > 200.0 && (at.x - 300.0).abs().max((at.y - 250.0).abs() - 70.0) < 20.0;
        let channel = |at: Vec2| (200.0..320.0).contains(&at.x) && (at.y - 200.0).abs() < 20.0;
        let land = opened(&land(|at| if low(at) || channel(at) { lake(2.0)(at) } else { lake(40.0)(at) }));
        assert_eq!(land.regions(Cell::Water).len(), 1);
        assert!(land.height(Vec2::new(200.0, 300.0)) > 10.0, "the way is straight");
    }

    #[test]
    fn a_strait_is_narrow_and_widens_to_both_ends() {
        let land = opened(&land(|at| lake((40.0 - 0.5 * (at.y - 295.0).abs()).max(1.0))(at)));
        let width = |y: f32| (0..400).filter(|x| land.height(Vec2::new(*x as f32, y)) < 0.0).count();
        let [upper, col, lower] = [255.0, 295.0, 338.0].map(width);
        assert!((5..=10).contains(&col), "{col}");
        assert!(upper > col + 1 && lower > col + 3, "{upper} {col} {lower}");
    }

    #[test]
    fn waters_behind_one_another_all_reach_the_sea() {
        let beyond = |at: Vec2| if at.distance(Vec2::new(200.0, 80.0)) < 40.0 { -10.0 } else { lake(20.0)(at) };
        assert_eq!(opened(&land(beyond)).regions(Cell::Water).len(), 1);
    }

    #[test]
    fn where_there_is_no_open_sea_water_leaves_at_the_border() {
        let alone = |at: Vec2| if at.distance(Vec2::new(300.0, 200.0)) < 40.0 { -10.0 } else { 20.0 };
        let land = opened(&land(alone));
        assert!((0..400).any(|y| land.height(Vec2::new(SIZE, y as f32)) < 0.0));
        assert_eq!(land.regions(Cell::Water).len(), 1);
    }

    #[test]
    fn a_land_without_inner_waters_stays_as_it_is() {
        let land = land(|at| if at.y > 350.0 { -10.0 } else { 20.0 });
        assert_eq!(open(land.clone(), Vec2::splat(SIZE), &|_| 0.0), land);
    }
}
