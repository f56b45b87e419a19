//! The lines that the names of ranges run along: on divides, over the highest ground near, and off all rivers.
//!
//! ```text
//! middle of a range ─► high places on divides ─► ways from each (Dijkstra) ─► their ends ─► the cheapest that can be read, smoothed
//! ```

use glam::Vec2;

use super::lattice::smoothed;
use crate::annotate::divides::{CELL, Divide, Divides};
use crate::base::geometry::{direction, distance, fast_max};
use crate::base::queue::Queue;
use crate::base::sort;
use crate::relief::Relief;

/// The distance within which ways begin around the middle of a range, in units, their number, and the least distance between them.
const REACH: f32 = 160.0;
const STARTS: usize = 12;
const APART: f32 = 20.0;
/// The least and the greatest length of a way, in units, and the least share of it that is left of it as the crow flies.
const LEAST: f32 = 195.0;
const MOST: f32 = 320.0;
const STRAIGHT: f32 = 0.78;
/// The greatest mean cost of the longest way, by the unit.
const MOST_RATE: f32 = 3.0;
/// The length in units that makes a way cost twice as much as a line.
const SHORT: f32 = 150.0;
/// The factor by which a way off divides costs more, and the weight of the share of height by which ground beside a way is higher.
const OFF: f32 = 6.0;
const LOW: f32 = 3.0;
/// The distance from the middle of rivers that ways keep, and smoothed lines, in units.
const FROM_RIVERS: f32 = 6.0;
const SMOOTHED_FROM_RIVERS: f32 = 5.5;
/// The length of the uppermost stretch of a river that names may cover, in units.
const HEAD: f32 = 25.0;
/// The greatest turn of a line, all its bends together: the sum of their sines.
const MOST_TURN: f32 = 2.2;
/// The number of ends that are tried of the ways from one place, and the least distance between them, in units.
const ENDS: usize = 16;
const ENDS_APART: f32 = 12.0;
/// The distance around a line that later ones keep, in cells.
const KEPT: usize = 5;

/// A way to a cell.
#[derive(Clone, Copy)]
struct Way {
    cost: f32,
    /// Its length, in units.
    length: f32,
    /// The cell before.
    before: usize,
    /// `true` once no other way can be cheaper.
    is_best: bool,
}

const NO_WAY: Way = Way { cost: f32::INFINITY, length: 0.0, before: 0, is_best: false };

/// A search for lines on the cells of a map.
pub(super) struct Crests<'a> {
    divides: &'a Divides,
    /// The height of each cell, and the greatest around it, in units.
    heights: Vec<f32>,
    highest: Vec<f32>,
    /// The cost of a way over each cell by the unit; NaN as long as nobody has asked.
    rates: Vec<f32>,
    ways: Vec<Way>,
}

impl<'a> Crests<'a> {
    pub fn new(divides: &'a Divides, relief: &Relief) -> Self {
        let (columns, cells) = (divides.columns, divides.columns * divides.rows);
        let heights: Vec<f32> = (0..cells).map(|cell| relief.at(middle(cell, columns))).collect();
        let highest = highest_near(&heights, columns);
        Self { divides, heights, highest, rates: vec![f32::NAN; cells], ways: vec![NO_WAY; cells] }
    }

    /// Finds the best line near a place, from west to east, and keeps later ones away from it; `None` if there is none.
    pub fn line(&mut self, near: Vec2) -> Option<Vec<Vec2>> {
        let (mut least, mut best) = (f32::INFINITY, Vec::new());
        for start in self.starts(near) {
            let reached = self.spread(start, most_cost(least));
            if let Some((cost, line)) = self.line_from(start, &reached)
                && cost < least
            {
                (least, best) = (cost, line);
            }
            reached.iter().for_each(|&cell| self.ways[cell] = NO_WAY);
        }
        for &at in &best {
            self.around(at, KEPT).into_iter().for_each(|cell| self.rates[cell] = f32::INFINITY);
        }
        if best.first()?.x > best.last()?.x {
            best.reverse();
        }
        Some(best)
    }

    /// Returns the middle of a cell, in units.
    fn at(&self, cell: usize) -> Vec2 {
        middle(cell, self.divides.columns)
    }

    /// Returns the cells of the square that reaches some cells to each side of a place.
    fn around(&self, at: Vec2, reach: usize) -> Vec<usize> {
        let Divides { columns, rows, .. } = *self.divides;
        let within = |x: f32, count: usize| {
            let cell = (x / CELL) as usize;
            cell.saturating_sub(reach)..(cell + reach + 1).min(count)
        };
        let mut cells = Vec::with_capacity((2 * reach + 1) * (2 * reach + 1));
        for row in within(at.y, rows) {
            cells.extend(within(at.x, columns).map(|column| row * columns + column));
        }
        cells
    }

    /// Chooses the highest places on divides near a place, apart from each other.
    fn starts(&mut self, near: Vec2) -> Vec<usize> {
        let cells = self.around(near, (REACH / CELL) as usize);
        let mut starts: Vec<usize> = Vec::new();
        for i in sort::argsort(cells.iter().map(|&cell| sort::key(-self.heights[cell]))) {
            let (cell, at) = (cells[i], self.at(cells[i]));
            let is_apart = starts.iter().all(|&other| distance(self.at(other), at) >= APART);
            if is_apart && self.divides.at(at) != Divide::No && self.rate(cell) < f32::INFINITY {
                starts.push(cell);
            }
            if starts.len() == STARTS {
                break;
            }
        }
        starts
    }

    /// Returns the cost of a way over a cell by the unit; infinite at sea, in rivers and beside lines that were found before.
    fn rate(&mut self, cell: usize) -> f32 {
        if self.rates[cell].is_nan() {
            self.rates[cell] = self.rate_of(cell);
        }
        self.rates[cell]
    }

    fn rate_of(&self, cell: usize) -> f32 {
        let (at, height) = (self.at(cell), self.heights[cell]);
        if height <= 0.0 || !self.is_dry(at, FROM_RIVERS) {
            return f32::INFINITY;
        }
        let off = if self.divides.at(at) == Divide::No { OFF } else { 1.0 };
        off * (1.0 + LOW * (1.0 - height / self.highest[cell]))
    }

    /// Returns `true` if a place is so far from the nearest river, or by its head.
    fn is_dry(&self, at: Vec2, away: f32) -> bool {
        let (distance, below) = self.divides.river_at(at);
        distance >= away || below <= HEAD
    }

    /// Finds the cheapest ways from a cell that cost at most so much, and returns the cells that they reach.
    fn spread(&mut self, start: usize, most: f32) -> Vec<usize> {
        let Divides { columns, rows, .. } = *self.divides;
        let diagonal = distance(Vec2::ZERO, Vec2::splat(CELL));
        let (mut queue, mut reached) = (Queue::default(), vec![start]);
        self.ways[start] = Way { cost: 0.0, before: start, ..NO_WAY };
        queue.push(0.0, start as u32);
        while let Some(cell) = queue.pop().map(|cell| cell as usize) {
            if std::mem::replace(&mut self.ways[cell].is_best, true) {
                continue;
            }
            let (way, column, row) = (self.ways[cell], cell % columns, cell / columns);
            for other in row.saturating_sub(1)..(row + 2).min(rows) {
                for beside in other * columns + column.saturating_sub(1)..other * columns + (column + 2).min(columns) {
                    if self.ways[beside].is_best {
                        continue;
                    }
                    let is_straight = other == row || beside % columns == column;
                    let (before, step) = (self.ways[beside].cost, if is_straight { CELL } else { diagonal });
                    let (cost, length) = (way.cost + step * self.rate(beside), way.length + step);
                    if cost < before && cost <= most && length <= MOST {
                        if before == f32::INFINITY {
                            reached.push(beside);
                        }
                        self.ways[beside] = Way { cost, length, before: cell, is_best: false };
                        queue.push(cost, beside as u32);
                    }
                }
            }
        }
        reached
    }

    /// Returns the cheapest line from a cell that can be read, with its cost; `None` if there is none among those that are tried.
    fn line_from(&self, start: usize, reached: &[usize]) -> Option<(f32, Vec<Vec2>)> {
        let is_long = |cell: &usize| {
            let length = self.ways[*cell].length;
            length >= LEAST && distance(self.at(*cell), self.at(start)) >= STRAIGHT * length
        };
        let ends: Vec<usize> = reached.iter().copied().filter(is_long).collect();
        let costs: Vec<f32> = ends.iter().map(|&end| self.cost(start, end)).collect();
        let mut tried: Vec<Vec2> = Vec::new();
        for i in sort::argsort(costs.iter().map(|&cost| sort::key(cost))) {
            let at = self.at(ends[i]);
            if tried.iter().any(|&other| distance(other, at) < ENDS_APART) {
                continue;
            }
            let line = self.line_between(start, ends[i]);
            if is_readable(&line) && line.iter().all(|&at| self.is_dry(at, SMOOTHED_FROM_RIVERS)) {
                return Some((costs[i], line));
            }
            tried.push(at);
            if tried.len() == ENDS {
                break;
            }
        }
        None
    }

    /// Returns the cost of the way between two cells as a line for a name: by the unit, and more for a short or a steep one.
    fn cost(&self, start: usize, end: usize) -> f32 {
        /// The share by which a line from south to north costs more.
        const STEEP: f32 = 0.3;
        let Way { cost, length, .. } = self.ways[end];
        let climb = direction(self.at(end) - self.at(start)).y;
        cost / length * (1.0 + SHORT / length) * (1.0 + STEEP * climb * climb)
    }

    /// Returns the way between two cells as a line, smoothed.
    fn line_between(&self, start: usize, end: usize) -> Vec<Vec2> {
        let (mut line, mut cell) = (vec![self.at(end)], end);
        while cell != start {
            cell = self.ways[cell].before;
            line.push(self.at(cell));
        }
        (0..3).for_each(|_| line = smoothed(&line));
        line
    }
}

/// Returns the greatest cost of a way that can be a better line than one that costs so much: the longest way is the cheapest by the unit.
fn most_cost(least: f32) -> f32 {
    /// What rounding may take away.
    const ROUNDING: f32 = 1.001;
    (ROUNDING * least * MOST / (1.0 + SHORT / MOST)).min(MOST_RATE * MOST)
}

/// Returns the middle of a cell, in units.
fn middle(cell: usize, columns: usize) -> Vec2 {
    Vec2::new((cell % columns) as f32 + 0.5, (cell / columns) as f32 + 0.5) * CELL
}

/// Returns for each cell the greatest height within some cells of it to each side: along rows, and then along columns.
fn highest_near(heights: &[f32], columns: usize) -> Vec<f32> {
    /// The distance within which other ground may be higher, in cells.
    const BESIDE: usize = 4;
    let greatest = |heights: &[f32]| heights.iter().copied().fold(f32::NEG_INFINITY, fast_max);
    let along = |row: &[f32]| -> Vec<f32> {
        (0..columns)
            .map(|column| greatest(&row[column.saturating_sub(BESIDE)..(column + BESIDE + 1).min(columns)]))
            .collect()
    };
    let rows: Vec<Vec<f32>> = heights.chunks(columns).map(along).collect();
    let near = |row: usize| &rows[row.saturating_sub(BESIDE)..(row + BESIDE + 1).min(rows.len())];
    (0..heights.len())
        .map(|cell| near(cell / columns).iter().map(|row| row[cell % columns]).fold(f32::NEG_INFINITY, fast_max))
        .collect()
}

/// Returns `true` if a line bends little enough for a name.
fn is_readable(line: &[Vec2]) -> bool {
    let turn = |at: &[Vec2]| direction(at[1] - at[0]).perp_dot(direction(at[2] - at[1])).abs();
    line.windows(3).map(turn).sum::<f32>() <= MOST_TURN
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::network::{NONE, Network, River, Vertex};

    /// Makes rivers that reach the sea, each with its course.
    fn rivers(courses: &[&[[f32; 2]]]) -> Network {
        let mut network = Network::default();
        for course in courses {
            let start = network.vertices.len() as u32;
            let vertex = |&at: &[f32; 2]| Vertex { at: at.into(), discharge: 10, ..Vertex::default() };
            network.vertices.extend(course.iter().map(vertex));
            let end = network.vertices.len() as u32;
            let river = River { start, end, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: start };
            network.rivers.push(river);
        }
        network
    }

    const NORTH: &[[f32; 2]] = &[[100.0, 420.0], [900.0, 420.0]];
    const SOUTH: &[[f32; 2]] = &[[100.0, 580.0], [900.0, 580.0]];
    const MIDDLE: Vec2 = Vec2::new(500.0, 500.0);

    /// Finds lines, one after the other, on a land that rises to a ridge from west to east through its middle.
    fn lines(network: &Network, near: &[Vec2]) -> Vec<Option<Vec<Vec2>>> {
        lines_on(|y| 60.0 - 0.1 * (y - MIDDLE.y).abs(), network, near)
    }

    /// Finds lines, one after the other, on a land with a height for each y.
    fn lines_on(height: impl Fn(f32) -> f32, network: &Network, near: &[Vec2]) -> Vec<Option<Vec<Vec2>>> {
        let domain = Domain::with_aspect(1.0);
        let heights = (0..250_000).map(|cell| height((cell / 500) as f32 * 2.0 + 1.0));
        let relief = Relief::of_heights(&domain, heights.collect()).unwrap();
        let divides = Divides::new(domain.size, network);
        let mut crests = Crests::new(&divides, &relief);
        near.iter().map(|&near| crests.line(near)).collect()
    }

    #[test]
    fn a_line_runs_from_west_to_east_on_the_divide_between_two_rivers() {
        let line = lines(&rivers(&[NORTH, SOUTH]), &[MIDDLE]).remove(0).unwrap();
        assert!(line.iter().all(|at| (at.y - MIDDLE.y).abs() <= 2.0 * CELL), "{line:?}");
        assert!(line[line.len() - 1].x - line[0].x >= LEAST - CELL, "{line:?}");
    }

    #[test]
    fn a_line_keeps_to_a_slanting_divide_on_level_ground() {
        let [one, other] = [[[0.0, 280.0], [1000.0, 480.0]], [[0.0, 440.0], [1000.0, 640.0]]];
        let line = lines_on(|_| 60.0, &rivers(&[&one, &other]), &[MIDDLE]).remove(0).unwrap();
        let divide = |x: f32| 360.0 + 0.2 * x;
        assert!(line.iter().all(|at| (at.y - divide(at.x)).abs() <= 2.5 * CELL), "{line:?}");
    }

    #[test]
    fn a_line_crosses_no_river_but_may_cover_its_head() {
        let across = [[500.0, 430.0], [500.0, 900.0]];
        let line = lines(&rivers(&[NORTH, SOUTH, &across]), &[MIDDLE]).remove(0).unwrap();
        assert!(line.iter().all(|at| at.x < 500.0) || line.iter().all(|at| at.x > 500.0), "{line:?}");
        let heads: Vec<[[f32; 2]; 2]> = (5..32).map(|i| [[i as f32 * 30.0, 490.0], [i as f32 * 30.0, 512.0]]).collect();
        let heads = heads.iter().map(|head| &head[..]);
        let line = lines(&rivers(&[NORTH, SOUTH].into_iter().chain(heads).collect::<Vec<_>>()), &[MIDDLE]).remove(0);
        assert!(line.is_some());
    }

    #[test]
    fn two_lines_keep_apart() {
        let lines = lines(&rivers(&[NORTH, SOUTH]), &[MIDDLE, MIDDLE]);
        let [Some(one), Some(other)] = &lines[..] else { panic!("{lines:?}") };
        let apart = one.iter().flat_map(|a| other.iter().map(move |b| distance(*a, *b)));
        assert!(apart.fold(f32::MAX, f32::min) >= 2.0 * CELL, "{lines:?}");
    }

    #[test]
    fn there_is_no_line_where_no_two_rivers_meet() {
        assert_eq!(lines(&rivers(&[]), &[MIDDLE, Vec2::ZERO]), [None, None]);
        assert_eq!(lines(&rivers(&[NORTH]), &[MIDDLE]), [None]);
    }

    /// A tall land without height, and places on and off it.
    #[test]
    fn there_is_no_line_without_land_and_no_place_panics() {
        let domain = Domain::with_aspect(0.4);
        let [columns, rows] = domain.size.to_array().map(|side| (side / crate::relief::CELL_SIZE).ceil() as usize);
        let relief = Relief::of_heights(&domain, vec![0.0; columns * rows]).unwrap();
        let divides = Divides::new(domain.size, &rivers(&[NORTH, SOUTH]));
        for near in [Vec2::ZERO, domain.size, domain.size * 2.0, Vec2::splat(-9.0)] {
            assert_eq!(Crests::new(&divides, &relief).line(near), None);
        }
    }
}
