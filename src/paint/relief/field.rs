//! A value for each cell of a map as a surface without facets: of parabolas (a biquadratic B-spline).

use glam::Vec2;

use crate::land::{Parabola, beside, nearest};
use crate::paint::view::View;
use crate::relief::{CELL_SIZE, Relief};

pub(super) struct Field {
    pub columns: usize,
    pub rows: usize,
    pub values: Vec<f32>,
}

impl Field {
    /// The heights of a relief, each made into a value.
    pub fn of(relief: &Relief, value: impl Fn(f32) -> f32) -> Self {
        let values = relief.heights().iter().map(|&height| value(height)).collect();
        Self { columns: relief.columns(), rows: relief.rows(), values }
    }

    /// The cell of a point; `None` beyond the map.
    pub fn cell(&self, at: Vec2) -> Option<usize> {
        let (x, y) = ((at.x / CELL_SIZE).floor(), (at.y / CELL_SIZE).floor());
        let is_inside = x >= 0.0 && y >= 0.0 && x < self.columns as f32 && y < self.rows as f32;
        is_inside.then(|| y as usize * self.columns + x as usize)
    }

    /// The middle of a cell, in units.
    pub fn middle(&self, cell: usize) -> Vec2 {
        (Vec2::new((cell % self.columns) as f32, (cell / self.columns) as f32) + 0.5) * CELL_SIZE
    }

    /// The value at a point, and by how much it rises by the unit.
    pub fn at(&self, at: Vec2) -> (f32, Vec2) {
        let place = at / CELL_SIZE - 0.5;
        let ((column, along), (row, down)) = (nearest(place.x, self.columns), nearest(place.y, self.rows));
        let columns = beside(column, self.columns);
        let across = beside(row, self.rows)
            .map(|row| Parabola::of(columns.map(|column| self.values[row * self.columns + column])));
        let heights = Parabola::of(across.map(|parabola| parabola.at(along)));
        let east = Parabola::of(across.map(|parabola| parabola.rise(along))).at(down);
        (heights.at(down), Vec2::new(east, heights.rise(down)) / CELL_SIZE)
    }

    /// Smoothed this many times, each time by √2 units.
    pub fn smoothed(mut self, times: u32) -> Self {
        let (along, down) = ((1, self.columns), (self.columns, self.rows));
        for _ in 0..times {
            for ((step, length), (aside, lines)) in [(along, down), (down, along)] {
                for line in 0..lines {
                    let at = |place: usize| line * aside + place * step;
                    let mut before = self.values[at(0)];
                    for place in 0..length {
                        let (here, after) = (self.values[at(place)], self.values[at((place + 1).min(length - 1))]);
                        self.values[at(place)] = (before + here + here + after) * 0.25;
                        before = here;
                    }
                }
            }
        }
        self
    }

    /// The control points along one y of a map, in units.
    pub fn line(&self, y: f32, heights: &mut Vec<f32>) {
        let (controls, t) = self.controls(y);
        heights.clear();
        heights.extend(controls.map(|parabola| parabola.at(t)));
    }

    /// Those of how much higher the surface is a cell to the south.
    pub fn rises(&self, y: f32, rises: &mut Vec<f32>) {
        let (controls, t) = self.controls(y);
        rises.clear();
        rises.extend(controls.map(|parabola| parabola.rise(t)));
    }

    fn controls(&self, y: f32) -> (impl Iterator<Item = Parabola>, f32) {
        let (middle, t) = nearest(y / CELL_SIZE - 0.5, self.rows);
        let [north, here, south] =
            beside(middle, self.rows).map(|row| &self.values[row * self.columns..][..self.columns]);
        (north.iter().zip(here).zip(south).map(|((&a, &b), &c)| Parabola::of([a, b, c])), t)
    }
}

/// The columns of cells that the pixels of a picture's rows are nearest to, and how far beyond their middles.
pub(super) fn places(view: &View, columns: usize) -> Vec<(usize, f32)> {
    let x = |x: u32| view.point(Vec2::splat(x as f32 + 0.5)).x;
    (0..view.width).map(|column| nearest(x(column) / CELL_SIZE - 0.5, columns)).collect()
}

/// A piece of a line around a column.
#[inline]
pub(super) fn piece(line: &[f32], column: usize) -> Parabola {
    Parabola::of(beside(column, line.len()).map(|column| line[column]))
}
