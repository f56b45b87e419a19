//! The grid of cells of land and water.

use std::ops::Range;

use glam::Vec2;

use super::cell::{CELL_SIZE, Cell};
use super::coast_distance::CoastDistance;
use super::obstacles::Obstacles;
use super::regions::{Region, Run, Shore, without};
use super::walk::walk;
use crate::base::sort;
use crate::domain::Domain;

/// Cells, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    pub cells: Vec<Cell>,
    /// The stretches of land, row by row.
    pub runs: Vec<Run>,
    /// The number of cells of land, ridges included.
    land: u32,
    pub columns: i32,
    pub rows: i32,
    /// The size of the domain, in units. The last cells may extend beyond its border.
    pub size: Vec2,
}

impl Grid {
    /// Makes a grid whose cells are land where their middles lie above water.
    pub fn above_water(domain: &Domain, coast_distance: &CoastDistance) -> Self {
        Self::of_runs(domain, runs_above_water(domain, coast_distance))
    }

    /// Makes a grid from a list of cells, row by row; `true` is land. Rows may have more columns than are needed.
    pub fn of_cells(domain: &Domain, is_land: &[bool], row_length: usize) -> Self {
        let (columns, rows) = extent(domain.size);
        let mut runs = Vec::new();
        for (row, cells) in (0..).zip(is_land.chunks(row_length).take(rows)) {
            let mut start = 0;
            for stretch in cells[..columns].chunk_by(|a, b| a == b) {
                let end = start + stretch.len() as u32;
                if stretch[0] {
                    runs.push(Run { row, start, end, before: 0 });
                }
                start = end;
            }
        }
        Self::of_runs(domain, runs)
    }

    /// Makes a grid whose land is in these runs, row by row.
    pub fn of_runs(domain: &Domain, runs: Vec<Run>) -> Self {
        let (columns, rows) = extent(domain.size);
        let mut cells = vec![Cell::Water; columns * rows];
        for Run { row, start, end, .. } in &runs {
            let first = *row as usize * columns;
            cells[first + *start as usize..first + *end as usize].fill(Cell::Land);
        }
        let land = runs.iter().map(|run| run.end - run.start).sum();
        Self { cells, runs, land, columns: columns as i32, rows: rows as i32, size: domain.size }
    }

    /// Counts the cells that a domain is cut into.
    pub fn cells_on(domain: &Domain) -> usize {
        let (columns, rows) = extent(domain.size);
        columns * rows
    }

    /// Returns the share of the cells that is land, ridges included.
    pub fn share_of_land(&self) -> f32 {
        self.land as f32 / self.cells.len() as f32
    }

    /// Turns the land along ridges into ridge cells. Returns their indices in ascending order.
    pub fn raise(&mut self, ridges: &[Vec<Vec2>]) -> Vec<usize> {
        let mut raised = Vec::new();
        for pair in ridges.iter().flat_map(|ridge| ridge.windows(2)) {
            for (column, row) in walk(pair[0] / CELL_SIZE, pair[1] / CELL_SIZE) {
                if let Some(i) = self.index(column, row)
                    && self.cells[i] == Cell::Land
                {
                    self.cells[i] = Cell::Ridge;
                    raised.push(i);
                }
            }
        }
        let order = sort::argsort(raised.iter().map(|&i| i as u32));
        let raised: Vec<usize> = order.into_iter().map(|i| raised[i]).collect();
        self.runs = without(&self.runs, &raised, self.columns as usize);
        raised
    }

    /// Returns the cells that are not land, as obstacles.
    pub fn borders(&self) -> Obstacles {
        let columns = self.columns as usize;
        let number = |run: &Run, column: u32| run.row as usize * columns + column as usize;
        let starts = self.runs.iter().map(|run| number(run, run.start)).chain([self.cells.len()]);
        let ends = [0].into_iter().chain(self.runs.iter().map(|run| number(run, run.end)));
        Obstacles::of(columns, self.rows as usize, true, ends.zip(starts).map(|(end, start)| end..start))
    }

    /// Returns some cells, given by their indices, as obstacles.
    pub fn obstacles(&self, cells: &[usize]) -> Obstacles {
        let cells = cells.iter().map(|&cell| cell..cell + 1);
        Obstacles::of(self.columns as usize, self.rows as usize, false, cells)
    }

    /// Lists the cells of a region that are beside the sea.
    pub fn shores(&self, region: &Region, coast_distance: &CoastDistance) -> Vec<Shore> {
        let mut shores = Vec::new();
        let is_water = |cells: &[Cell], column: usize| cells.get(column) == Some(&Cell::Water);
        for run in &region.runs {
            let (row, start, end) = (run.row as usize, run.start as usize, run.end as usize);
            let (above, here, below) = (self.row(row.wrapping_sub(1)), self.row(row), self.row(row + 1));
            let mut add = |column: usize| {
                let at = middle(column as i32, row as i32).min(self.size);
                shores.push(Shore { at, inland: coast_distance.slope(at).normalize_or(Vec2::NEG_Y) });
            };
            let (west, east) = (is_water(here, start.wrapping_sub(1)), is_water(here, end));
            let is_end = |column: usize| (column == start && west) || (column + 1 == end && east);
            // Most of a run lies between other runs, so many cells are skipped at a time.
            for first in (start..end).step_by(MANY) {
                let columns = first..(first + MANY).min(end);
                if has_water(above, &columns) || has_water(below, &columns) || is_end(first) || is_end(columns.end - 1)
                {
                    let is_shore = |&c: &usize| is_water(above, c) || is_water(below, c) || is_end(c);
                    columns.filter(is_shore).for_each(&mut add);
                }
            }
        }
        shores
    }

    /// Returns the cells of a row; none outside the grid.
    fn row(&self, row: usize) -> &[Cell] {
        let columns = self.columns as usize;
        row.checked_mul(columns).and_then(|start| self.cells.get(start..start + columns)).unwrap_or_default()
    }

    /// Returns the cell at a column and row; water outside the grid.
    #[inline]
    pub fn cell(&self, column: i32, row: i32) -> Cell {
        self.index(column, row).map_or(Cell::Water, |i| self.cells[i])
    }

    #[inline]
    fn index(&self, column: i32, row: i32) -> Option<usize> {
        let inside = (0..self.columns).contains(&column) && (0..self.rows).contains(&row);
        inside.then(|| (row * self.columns + column) as usize)
    }
}

/// Returns the number of columns and rows of cells that cover a domain.
fn extent(size: Vec2) -> (usize, usize) {
    let count = |length: f32| (length / CELL_SIZE).ceil() as usize;
    (count(size.x), count(size.y))
}

/// The number of cells that are looked at together.
const MANY: usize = 32;

/// Returns `true` if there is water in some columns of a row. Columns may lie outside.
#[inline(never)] // two copies of a vectorised loop weigh more than a call
fn has_water(row: &[Cell], columns: &Range<usize>) -> bool {
    let cells = row.get(columns.clone()).unwrap_or_default();
    cells.iter().fold(false, |any, &cell| any | (cell == Cell::Water))
}

/// Lists the stretches of cells whose middles lie above water, row by row. The height is linear from one lattice corner to the
/// next, so most cells need not be looked at one by one.
pub(super) fn runs_above_water(domain: &Domain, coast_distance: &CoastDistance) -> Vec<Run> {
    let (columns, rows) = extent(domain.size);
    // The number of cells in an interval of the lattice.
    let cells = (coast_distance.spacing() / CELL_SIZE) as usize;
    let (mut runs, mut coasts) = (Vec::new(), Vec::new());
    for row in 0..rows {
        let (upper, y) = (row / cells, ((row % cells) as f32 + 0.5) / cells as f32);
        if row.is_multiple_of(cells) {
            coasts = coast_distance.coasts_between(upper, columns.div_ceil(cells));
        }
        let ends = |interval: usize| coast_distance.ends(upper, interval, y);
        land_of_row(row as u32, (columns, cells), &coasts, ends, &mut runs);
    }
    runs
}

/// Adds the stretches of a row's cells that lie above water. The pair holds the number of columns and of cells in an interval; of
/// the intervals to look at, `ends` returns the heights at both ends.
fn land_of_row(
    row: u32,
    (columns, cells): (usize, usize),
    coasts: &[u32],
    ends: impl Fn(usize) -> [f32; 2],
    runs: &mut Vec<Run>,
) {
    let mut start = None;
    let mut turn = |column: usize, is_land: bool| match start {
        None if is_land => start = Some(column as u32),
        Some(first) if !is_land => {
            runs.push(Run { row, start: first, end: column as u32, before: 0 });
            start = None;
        }
        _ => {}
    };
    for interval in coasts.iter().map(|&interval| interval as usize) {
        let (first, [left, right]) = (interval * cells, ends(interval));
        if (left > 0.0) == (right > 0.0) {
            turn(first, left > 0.0);
            continue;
        }
        for i in 0..cells.min(columns - first) {
            let x = (i as f32 + 0.5) / cells as f32;
            turn(first + i, left * (1.0 - x) + right * x > 0.0);
        }
    }
    turn(columns, false);
}

fn middle(column: i32, row: i32) -> Vec2 {
    (Vec2::new(column as f32, row as f32) + 0.5) * CELL_SIZE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::land::Land;
    use crate::recipe::link;

    #[test]
    fn cells_are_land_where_the_relief_is_above_0() {
        let land = Land::of(&link::read("land=archipelago&sea=0.5&roughness=1&aspect=1.7").unwrap()).unwrap();
        let grid = Grid::above_water(&Domain::with_aspect(1.7), land.coast_distance());
        for (column, row) in (0..grid.columns).flat_map(|column| (0..grid.rows).map(move |row| (column, row))) {
            let height = land.coast_distance().height(middle(column, row));
            let is_land = grid.cell(column, row) == Cell::Land;
            assert!(height.abs() < 1e-3 || is_land == (height > 0.0), "{column}, {row}: {height}");
        }
    }
}
