//! A smooth surface through a value for each cell of a map, made of parabolas (a biquadratic B-spline).

use glam::Vec2;

use super::blur::{blurred, radius_of};
use crate::land::{Parabola, beside, nearest};
use crate::paint::view::View;
use crate::relief::{CELL_SIZE, Grid, Relief};

#[derive(Clone, Debug)]
pub(super) struct Field {
    pub grid: Grid,
    pub values: Vec<f32>,
}

impl Field {
    /// Makes a field of the heights of a relief, each converted by `value`.
    pub fn of(relief: &Relief, value: impl Fn(f32) -> f32) -> Self {
        let values = relief.heights().iter().map(|&height| value(height)).collect();
        Self { grid: relief.grid(), values }
    }

    /// Finds the cell of a point; `None` beyond the map.
    pub fn cell(&self, at: Vec2) -> Option<usize> {
        let Grid { cell_size, columns, rows } = self.grid;
        let (x, y) = ((at.x / cell_size).floor(), (at.y / cell_size).floor());
        let is_inside = x >= 0.0 && y >= 0.0 && x < columns as f32 && y < rows as f32;
        is_inside.then(|| y as usize * columns + x as usize)
    }

    /// Returns the middle of a cell, in units.
    pub fn middle(&self, cell: usize) -> Vec2 {
        let Grid { cell_size, columns, .. } = self.grid;
        (Vec2::new((cell % columns) as f32, (cell / columns) as f32) + 0.5) * cell_size
    }

    /// Returns the value at a point, and its gradient per unit.
    pub fn at(&self, at: Vec2) -> (f32, Vec2) {
        let Grid { cell_size, columns: length, rows } = self.grid;
        let place = at / cell_size - 0.5;
        let ((column, along), (row, down)) = (nearest(place.x, length), nearest(place.y, rows));
        let columns = beside(column, length);
        let across =
            beside(row, rows).map(|row| Parabola::of(columns.map(|column| self.values[row * length + column])));
        let heights = Parabola::of(across.map(|parabola| parabola.at(along)));
        let east = Parabola::of(across.map(|parabola| parabola.rise(along))).at(down);
        (heights.at(down), Vec2::new(east, heights.rise(down)) / cell_size)
    }

    /// Smooths the values a number of times, each time over √2 units; on cells finer than a map's own, as much at once. Beyond its borders the field goes on as steep as it is there, so
    /// along them values are smoothed in one direction only.
    pub fn smoothed(mut self, times: u32) -> Self {
        let Grid { cell_size, columns, rows } = self.grid;
        if cell_size < CELL_SIZE {
            let deviation = CELL_SIZE * (0.5 * times as f32).sqrt();
            self.values = blurred(self.values, columns, radius_of(deviation / cell_size));
            return self;
        }
        let mean = |before: f32, here: f32, after: f32| (before + here + here + after) * 0.25;
        let mut before = Vec::new();
        for _ in 0..times {
            before.clear();
            before.extend_from_slice(&self.values[..columns]);
            for row in 1..rows.saturating_sub(1) {
                let (upper, after) = self.values.split_at_mut((row + 1) * columns);
                let here = &mut upper[row * columns..];
                for ((here, before), &after) in here.iter_mut().zip(&mut before).zip(&*after) {
                    let was = *here;
                    *here = mean(*before, was, after);
                    *before = was;
                }
            }
            for row in self.values.chunks_mut(columns) {
                before.copy_from_slice(row);
                for (here, around) in row[1..].iter_mut().zip(before.windows(3)) {
                    *here = mean(around[0], around[1], around[2]);
                }
            }
        }
        self
    }

    /// Returns the surface along one y of a map, in units, with a piece for each column of cells; with `rises`, its
    /// rise over a cell to the south.
    #[inline(never)]
    pub fn line(&self, y: f32, rises: bool) -> Vec<Parabola> {
        let Grid { cell_size, columns, rows } = self.grid;
        let (middle, t) = nearest(y / cell_size - 0.5, rows);
        let [north, here, south] = beside(middle, rows).map(|row| &self.values[row * columns..][..columns]);
        let mut controls = north.iter().zip(here).zip(south).map(|((&a, &b), &c)| {
            let across = Parabola::of([a, b, c]);
            if rises { across.rise(t) } else { across.at(t) }
        });
        let mut line = Vec::with_capacity(columns);
        let Some(mut here) = controls.next() else { return line };
        let mut before = here;
        for after in controls {
            line.push(Parabola::of([before, here, after]));
            (before, here) = (here, after);
        }
        line.push(Parabola::of([before, here, here]));
        line
    }
}

/// The position of a pixel in its row: the nearest column of cells, and the distance beyond its middle in cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub column: usize,
    pub along: f32,
}

/// Returns the positions of the pixels of a row.
#[inline(never)]
pub(super) fn places(view: &View, Grid { cell_size, columns, .. }: Grid) -> Vec<Place> {
    let x = |pixel: u32| view.point(Vec2::splat(pixel as f32 + 0.5)).x;
    let place = |pixel| {
        let (column, along) = nearest(x(pixel) / cell_size - 0.5, columns);
        Place { column, along }
    };
    (0..view.width).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    #[test]
    fn a_slope_stays_what_it_is_inside_and_a_spike_keeps_its_volume() {
        let (columns, rows) = (12, 9);
        let grid = Grid { cell_size: CELL_SIZE, columns, rows };
        let slope = |i: usize| (i % columns) as f32 * 3.0 - (i / columns) as f32;
        let field = Field { grid, values: (0..columns * rows).map(slope).collect() }.smoothed(2);
        let (height, rise) = field.at(Vec2::new(11.3, 9.7));
        let expected = (11.3 / CELL_SIZE - 0.5) * 3.0 - (9.7 / CELL_SIZE - 0.5);
        assert!((height - expected).abs() < 1e-4, "{height}, not {expected}");
        assert!((rise - Vec2::new(3.0, -1.0) / CELL_SIZE).abs().max_element() < 1e-4, "{rise}");
        let mut values = vec![0.0; columns * rows];
        values[4 * columns + 5] = 16.0;
        let field = Field { grid, values }.smoothed(1);
        assert_eq!(
            (field.values[4 * columns + 5], field.values[3 * columns + 5], field.values[3 * columns + 4]),
            (4.0, 2.0, 1.0)
        );
        assert!((field.values.iter().sum::<f32>() - 16.0).abs() < 1e-4);
    }

    #[test]
    fn finer_cells_are_smoothed_over_the_same_distance() {
        /// Returns the standard deviation of a spike after smoothing, in units.
        fn deviation(cell_size: f32) -> f32 {
            let side = (80.0 / cell_size) as usize;
            let grid = Grid { cell_size, columns: side, rows: side };
            let mut values = vec![0.0; side * side];
            let middle = side / 2;
            values[middle * side + middle] = 1.0;
            let spread = Field { grid, values }.smoothed(4).values;
            let squared = |cell: usize| ((cell % side) as f32 - middle as f32) * ((cell % side) as f32 - middle as f32);
            (0..side * side).map(|cell| spread[cell] * squared(cell)).sum::<f32>().sqrt() * cell_size
        }
        let own = deviation(CELL_SIZE);
        for cell_size in [1.0, 0.5, 0.25] {
            assert!(
                (deviation(cell_size) / own - 1.0).abs() < 0.25,
                "{cell_size}: {}, not {own}",
                deviation(cell_size)
            );
        }
    }
}
