//! The cells of a grid as lakes are looked at: their neighbours, their middles, and those within rings.

use glam::Vec2;

use crate::base::rings::stretches;
use crate::relief::Grid;

/// Returns the middle of a cell, in units.
pub(super) fn middle(grid: &Grid, cell: usize) -> Vec2 {
    (Vec2::new((cell % grid.columns) as f32, (cell / grid.columns) as f32) + 0.5) * grid.cell_size
}

/// Returns the cell of a point in units; for points beyond the grid, the nearest.
pub(super) fn cell_at(grid: &Grid, at: Vec2) -> usize {
    let index = |x: f32, count: usize| ((x / grid.cell_size).max(0.0) as usize).min(count - 1);
    index(at.y, grid.rows) * grid.columns + index(at.x, grid.columns)
}

/// Returns the eight cells around a cell; `None` for those beyond the grid.
pub(super) fn around(grid: &Grid, cell: usize) -> [Option<usize>; 8] {
    const OFFSETS: [(isize, isize); 8] = [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];
    let (column, row) = (cell % grid.columns, cell / grid.columns);
    OFFSETS.map(|(east, south)| {
        let column = column.checked_add_signed(east).filter(|column| *column < grid.columns)?;
        let row = row.checked_add_signed(south).filter(|row| *row < grid.rows)?;
        Some(row * grid.columns + column)
    })
}

/// Calls `found` with each cell of a grid whose middle lies within an odd number of rings.
pub(super) fn fill(rings: &[Vec<Vec2>], grid: &Grid, mut found: impl FnMut(usize)) {
    let points = || rings.iter().flatten().map(|at| at.y / grid.cell_size - 0.5);
    let first = points().fold(f32::INFINITY, f32::min).ceil().max(0.0) as usize;
    let last = points().fold(f32::NEG_INFINITY, f32::max).floor() as usize;
    for row in first..=last.min(grid.rows - 1) {
        let y = (row as f32 + 0.5) * grid.cell_size;
        for stretch in stretches(rings, y) {
            let [from, to] =
                stretch.map(|x| (x / grid.cell_size - 0.5).ceil().clamp(0.0, grid.columns as f32) as usize);
            (from..to).for_each(|column| found(row * grid.columns + column));
        }
    }
}
