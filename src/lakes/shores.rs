//! The shores of a lake: the line of its level on the ground.

use glam::Vec2;

use super::cells::{around, cell_at, middle};
use super::flood::{Dam, Flooded, Ground, sorted_cells};
use crate::base::rings::area;
use crate::base::work;
use crate::land::trace;
use crate::relief::Grid;

/// The least area of an island, in square units.
const ISLAND: f32 = 16.0;

/// The height, in units, over which a shore moves from the middle of one cell to that of the next.
const BLEND: f32 = 20.0;

/// The least share of that by which a cell counts as water or as land.
const LEAST: f32 = 0.01;

impl Ground<'_> {
    /// Adds cells to a lake where others touch only at a corner, so that no shore is tied off there.
    pub fn widen(&self, flooded: &mut Flooded, dam: &Dam) {
        let Grid { columns, .. } = self.relief.grid();
        let first = flooded.cells.len();
        let wet = sorted_cells(flooded);
        for i in 0..first {
            let (cell, below) = (flooded.cells[i], self.upstream.to[flooded.cells[i]] as usize);
            if cell == dam.cell || cell % columns == below % columns || cell / columns == below / columns {
                continue;
            }
            let corners = [cell / columns * columns + below % columns, below / columns * columns + cell % columns];
            let is_wet = |corner: &usize| wet.binary_search(corner).is_ok() || flooded.cells[first..].contains(corner);
            if corners.iter().any(is_wet) {
                continue;
            }
            let heights = self.relief.heights();
            let runs_in = |corner: usize| is_wet(&(self.upstream.to[corner] as usize));
            let may_be = |corner: &usize| {
                !self.is_taken[*corner] && self.upstream.is_above(*corner, dam.cell) && runs_in(*corner)
            };
            let lower = corners.into_iter().filter(may_be).min_by(|a, b| heights[*a].total_cmp(&heights[*b]));
            flooded.cells.extend(lower);
        }
    }

    /// Traces the shores of a lake, in units: the outer one first, then those of islands.
    pub fn shores(&self, flooded: &Flooded, dam: &Dam) -> Vec<Vec<Vec2>> {
        let Grid { cell_size, columns, rows } = self.relief.grid();
        let across = || flooded.cells.iter().map(|cell| cell % columns);
        let down = || flooded.cells.iter().map(|cell| cell / columns);
        let (left, right) =
            (across().min().unwrap_or(0).saturating_sub(1), (across().max().unwrap_or(0) + 1).min(columns - 1));
        let (top, bottom) =
            (down().min().unwrap_or(0).saturating_sub(1), (down().max().unwrap_or(0) + 1).min(rows - 1));
        let (width, height) = (right - left + 1, bottom - top + 1);
        work::count(width * height);
        let cell = |i: usize| (top + i / width) * columns + left + i % width;
        let over: Vec<f32> = (0..width * height).map(|i| self.over_water(cell(i), flooded.level, dam)).collect();
        let over = blurred(&over, width);
        let mut water: Vec<f32> = over.iter().map(|over| 0.5 - over.max(LEAST)).collect();
        for &cell in &flooded.cells {
            let i = (cell / columns - top) * width + cell % columns - left;
            water[i] = 0.5 - over[i].min(-LEAST);
        }
        let size = Vec2::new(width as f32, height as f32);
        let speck = ISLAND / (size.x * size.y * cell_size * cell_size);
        let corner = Vec2::new(left as f32, top as f32);
        let place = |at: Vec2| (at * size + corner) * cell_size;
        let rings = trace::rings(width, water, speck);
        let traced = |ring: &Vec<Vec2>| ring.iter().map(|at| place(*at)).collect::<Vec<_>>();
        let smooth = rings.iter().map(|ring| smoothed(&smoothed(&evened(&evened(&traced(ring)))))).collect();
        let mut shores = self.bent(smooth);
        let greatest = (0..shores.len()).max_by(|a, b| area(&shores[*a]).abs().total_cmp(&area(&shores[*b]).abs()));
        greatest.into_iter().for_each(|outer| shores.swap(0, outer));
        shores
    }

    /// Bends shores by a field of shifts, as ground does that is too fine for the relief: what runs straight along cells or divides does
    /// not stay straight, and no two shores cross that did not. Where a shore would come to the sea all are bent less,
    /// or not at all.
    fn bent(&self, shores: Vec<Vec<Vec2>>) -> Vec<Vec<Vec2>> {
        const AMOUNTS: [f32; 2] = [1.0, 0.5];
        let bend = |amount: f32| -> Vec<Vec<Vec2>> {
            let shifted = |at: &Vec2| *at + self.unevenness.shift(*at) * amount;
            shores.iter().map(|ring| ring.iter().map(shifted).collect()).collect()
        };
        work::count(8 * shores.iter().map(Vec::len).sum::<usize>());
        let bent = AMOUNTS.into_iter().map(bend).find(|bent| bent.iter().flatten().all(|at| self.is_inland(*at)));
        bent.unwrap_or(shores)
    }

    /// Returns `true` if neither the cell of a place nor one beside it lies in the sea.
    fn is_inland(&self, at: Vec2) -> bool {
        let (grid, heights) = (self.relief.grid(), self.relief.heights());
        let cell = cell_at(&grid, at);
        around(&grid, cell).into_iter().flatten().chain([cell]).all(|cell| heights[cell] > 0.0)
    }

    /// Returns the middle of the cell of a lake that is farthest from its shores, in units; the first of equals.
    pub fn midst(&self, flooded: &Flooded) -> Vec2 {
        let grid = self.relief.grid();
        let mut left = sorted_cells(flooded);
        loop {
            let is_inner = |cell: &usize| {
                around(&grid, *cell)
                    .into_iter()
                    .all(|beside| beside.is_some_and(|beside| left.binary_search(&beside).is_ok()))
            };
            let inner: Vec<usize> = left.iter().copied().filter(is_inner).collect();
            work::count(8 * left.len());
            if inner.is_empty() {
                return left.first().map_or(Vec2::ZERO, |cell| middle(&grid, *cell));
            }
            left = inner;
        }
    }

    /// Returns how far a cell lies over the water, as a share of what moves a shore by a cell, at most a half either way.
    fn over_water(&self, cell: usize, level: f32, dam: &Dam) -> f32 {
        /// The height of a moraine over the water, in units.
        const MORAINE: f32 = 1.5;
        let height = self.height(cell);
        let is_dam = height < level && !self.upstream.is_above(cell, dam.cell);
        let over = if is_dam { MORAINE } else { height - level };
        (over / (2.0 * BLEND)).clamp(-0.5, 0.5)
    }
}

/// Blurs the cells of a grid, but for those at its border.
fn blurred(values: &[f32], width: usize) -> Vec<f32> {
    let mut blurred = values.to_vec();
    let inner = values.len().saturating_sub(width + 1);
    for (i, blurred) in blurred.iter_mut().enumerate().take(inner).skip(width + 1) {
        if i % width == 0 || i % width == width - 1 {
            continue;
        }
        let row = |i: usize| values[i - 1] + 2.0 * values[i] + values[i + 1];
        *blurred = (row(i - width) + 2.0 * row(i) + row(i + width)) / 16.0;
    }
    blurred
}

/// Moves each point of a ring half of the way to the middle between its neighbours.
fn evened(ring: &[Vec2]) -> Vec<Vec2> {
    let count = ring.len();
    let at = |i: usize| ring[i % count];
    (0..count).map(|i| at(i) * 0.5 + (at(i + 1) + at(i + count - 1)) * 0.25).collect()
}

/// Cuts the corners of a ring (Chaikin 1974).
fn smoothed(ring: &[Vec2]) -> Vec<Vec2> {
    let mut cut = Vec::with_capacity(2 * ring.len());
    for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        cut.extend([a.lerp(*b, 0.25), a.lerp(*b, 0.75)]);
    }
    cut
}
