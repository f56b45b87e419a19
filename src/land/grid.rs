//! The grid of cells that land is cut into.

use glam::Vec2;

use super::clearance::Clearance;
use super::regions::{Region, Shore, regions};
use super::relief::Relief;
use super::walk::walk;
use crate::domain::Domain;

/// What a cell is to rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// Land.
    Available,
    /// Water: rivers end here.
    Unavailable,
    /// A ridge: no river crosses it.
    Illegal,
}

/// The side of a cell, in units: far less than a step of a river at the default number of attractors.
pub const SIDE: f32 = 1.0;

/// Cells, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    pub cells: Vec<Cell>,
    pub columns: i32,
    pub rows: i32,
    /// Of the domain, in units: the last cells reach over its border.
    pub size: Vec2,
}

impl Grid {
    /// The cells whose middles lie above water. Along a row the relief is linear from one lattice corner to the next, so
    /// most cells need not be looked at one by one.
    pub fn above_water(domain: &Domain, relief: &Relief) -> Self {
        const CELLS: usize = (Relief::SPACING / SIDE) as usize;
        let count = |length: f32| (length / SIDE).ceil() as i32;
        let (columns, rows) = (count(domain.size.x), count(domain.size.y));
        let mut cells = vec![Cell::Unavailable; (columns * rows) as usize];
        for (row, cells) in cells.chunks_mut(columns as usize).enumerate() {
            let y = ((row % CELLS) as f32 + 0.5) / CELLS as f32;
            let height = |column: usize| {
                relief.corner(column, row / CELLS) * (1.0 - y) + relief.corner(column, row / CELLS + 1) * y
            };
            let mut left = height(0);
            for (column, cells) in cells.chunks_mut(CELLS).enumerate() {
                let right = height(column + 1);
                if left > 0.0 && right > 0.0 {
                    cells.fill(Cell::Available);
                } else if left > 0.0 || right > 0.0 {
                    for (i, cell) in cells.iter_mut().enumerate() {
                        let x = (i as f32 + 0.5) / CELLS as f32;
                        if left * (1.0 - x) + right * x > 0.0 {
                            *cell = Cell::Available;
                        }
                    }
                }
                left = right;
            }
        }
        Self { cells, columns, rows, size: domain.size }
    }

    /// Makes the land along a ridge illegal.
    pub fn raise(&mut self, ridge: &[Vec2]) {
        for pair in ridge.windows(2) {
            for (column, row) in walk(pair[0] / SIDE, pair[1] / SIDE) {
                if let Some(i) = self.index(column, row)
                    && self.cells[i] == Cell::Available
                {
                    self.cells[i] = Cell::Illegal;
                }
            }
        }
    }

    /// The regions that cells of a kind make, the largest first.
    pub fn regions(&self, kind: Cell) -> Vec<Region> {
        regions(&self.cells, kind, self.columns as usize)
    }

    /// The room there is around every cell.
    pub fn clearance(&self, is_obstacle: impl Fn(Cell) -> bool) -> Clearance {
        Clearance::of(&self.cells, self.columns as usize, |&cell| is_obstacle(cell))
    }

    /// All cells of a region beside the sea.
    pub fn shores(&self, region: &Region, relief: &Relief) -> Vec<Shore> {
        let mut shores = Vec::new();
        let is_water = |cells: &[Cell], column: usize| cells.get(column) == Some(&Cell::Unavailable);
        for run in &region.runs {
            let (row, start, end) = (run.row as usize, run.start as usize, run.end as usize);
            let (above, here, below) = (self.row(row.wrapping_sub(1)), self.row(row), self.row(row + 1));
            for column in start..end {
                let west = column == start && is_water(here, column.wrapping_sub(1));
                let east = column + 1 == end && is_water(here, column + 1);
                if west || east || is_water(above, column) || is_water(below, column) {
                    let at = middle(column as i32, row as i32).min(self.size);
                    shores.push(Shore { at, inland: relief.slope(at).normalize_or(Vec2::NEG_Y) });
                }
            }
        }
        shores
    }

    /// The cells of a row; none outside.
    fn row(&self, row: usize) -> &[Cell] {
        let columns = self.columns as usize;
        row.checked_mul(columns).and_then(|start| self.cells.get(start..start + columns)).unwrap_or_default()
    }

    /// A cell by its place; water outside.
    #[inline]
    pub fn cell(&self, column: i32, row: i32) -> Cell {
        self.index(column, row).map_or(Cell::Unavailable, |i| self.cells[i])
    }

    #[inline]
    fn index(&self, column: i32, row: i32) -> Option<usize> {
        let inside = (0..self.columns).contains(&column) && (0..self.rows).contains(&row);
        inside.then(|| (row * self.columns + column) as usize)
    }
}

fn middle(column: i32, row: i32) -> Vec2 {
    (Vec2::new(column as f32, row as f32) + 0.5) * SIDE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::land::Land;
    use crate::recipe::link;

    #[test]
    fn cells_are_land_where_the_relief_is_above_0() {
        let land = Land::of(&link::read("land=archipelago&rough=1&aspect=1.7").unwrap()).unwrap();
        let grid = Grid::above_water(&Domain::with_aspect(1.7), land.relief());
        for (column, row) in (0..grid.columns).flat_map(|column| (0..grid.rows).map(move |row| (column, row))) {
            let height = land.relief().height(middle(column, row));
            let is_land = grid.cell(column, row) == Cell::Available;
            assert!(height.abs() < 1e-3 || is_land == (height > 0.0), "{column}, {row}: {height}");
        }
    }
}
