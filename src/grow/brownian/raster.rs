//! The raster in which a Brownian tree grows.

use std::sync::Arc;

use glam::Vec2;

use crate::grow::{GrowthSettings, Start};
use crate::land::{CELL_SIZE, Cell, Land, Region};
use crate::recipe::Sides;

/// Cells of land, water and ridges: the raster of availability in Demiurge, part 2. Places beyond it are none of these,
/// and no particle may go there.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    columns: i32,
    rows: i32,
    side: f32,
    /// The size of the domain, in units. The last cells may extend beyond it.
    size: Vec2,
    cells: Vec<Cell>,
    /// The drawn mouths, the only places where rivers begin; if empty, rivers begin wherever there is water beside
    /// land.
    pub(super) starts: Arc<[Start]>,
    /// The cell of each drawn mouth: water beside land.
    pub(super) mouths: Vec<Place>,
}

impl Raster {
    /// Makes a raster of columns and rows (each 1 or more) of cells whose sides have the given length in units.
    pub fn new(columns: i32, rows: i32, side: f32, cell: impl Fn(i32, i32) -> Cell) -> Self {
        let (columns, rows) = (columns.max(1), rows.max(1));
        let mut cells = Vec::with_capacity(columns as usize * rows as usize);
        for row in 0..rows {
            cells.extend((0..columns).map(|column| cell(column, row)));
        }
        let size = Vec2::new(columns as f32, rows as f32) * side;
        Self { columns, rows, side, size, cells, starts: Arc::default(), mouths: Vec::new() }
    }

    /// Makes the raster of a recipe. A plain rectangle gets the sea that it lacks: a line of water cells along the
    /// chosen sides, or the cells of the drawn mouths.
    pub fn of(settings: &GrowthSettings) -> Self {
        let size = settings.domain.size;
        let mut raster = match &settings.land {
            Some(land) => Self::of_land(land),
            None if !settings.starts.is_empty() => {
                let [columns, rows] = size.to_array().map(|length| (length / CELL_SIZE).ceil() as i32);
                Self::new(columns, rows, CELL_SIZE, |_, _| Cell::Land)
            }
            None => Self::with_sea(
                (size.x / CELL_SIZE).ceil() as i32,
                (size.y / CELL_SIZE).ceil() as i32,
                CELL_SIZE,
                settings.sides,
            ),
        };
        raster.size = size;
        raster.mouths = settings.starts.iter().map(|start| raster.mouth_cell(start.mouth.at)).collect();
        (0..raster.mouths.len()).for_each(|i| raster.flood(raster.mouths[i]));
        raster.starts = settings.starts.clone();
        if let Some(land) = settings.land.as_deref().filter(|_| !settings.starts.is_empty()) {
            let dry = land.regions().iter().zip(&settings.basins).filter(|(_, starts)| **starts == 0);
            dry.filter(|(region, _)| !region.shores.is_empty())
                .for_each(|(region, _)| raster.fill(region, Cell::Water));
        }
        raster
    }

    /// Returns the cell of a mouth: water beside it or, on a rectangle, its own cell.
    fn mouth_cell(&self, mouth: Vec2) -> Place {
        let cell = |x: f32, cells: i32| ((x / self.side) as i32).min(cells - 1);
        let shore = Place { column: cell(mouth.x, self.columns), row: cell(mouth.y, self.rows) };
        shore.beside().into_iter().find(|&at| self.cell(at) == Some(Cell::Water)).unwrap_or(shore)
    }

    /// Returns `true` if a river may begin in a cell of water.
    pub(super) fn may_be_mouth(&self, at: Place) -> bool {
        self.mouths.is_empty() || self.mouths.contains(&at)
    }

    fn fill(&mut self, region: &Region, cell: Cell) {
        for run in &region.runs {
            let first = run.row as usize * self.columns as usize;
            self.cells[first + run.start as usize..first + run.end as usize].fill(cell);
        }
    }

    /// Makes the raster of a land. Land that ridges cut off from the sea is left out: particles born there would count,
    /// but could never make a river.
    fn of_land(land: &Land) -> Self {
        let mut this = Self::new(land.columns(), land.rows(), CELL_SIZE, |column, row| land.cell(column, row));
        let shut_off = land.regions().iter().filter(|region| region.shores.is_empty());
        shut_off.for_each(|region| this.fill(region, Cell::Ridge));
        this
    }

    /// Makes a rectangle of land with a line of water along some of its sides.
    pub fn with_sea(columns: i32, rows: i32, side: f32, sea: Sides) -> Self {
        let [north, east, south, west] = ['n', 'e', 's', 'w'].map(|side| sea.contains(side));
        Self::new(columns, rows, side, |column, row| {
            let is_sea = (north && row == 0)
                || (east && column == columns - 1)
                || (south && row == rows - 1)
                || (west && column == 0);
            if is_sea { Cell::Water } else { Cell::Land }
        })
    }

    /// Returns the number of columns of cells.
    pub fn columns(&self) -> i32 {
        self.columns
    }

    /// Returns the number of rows of cells.
    pub fn rows(&self) -> i32 {
        self.rows
    }

    /// Returns the side of a cell, in units.
    pub fn side(&self) -> f32 {
        self.side
    }

    /// Returns all cells, row by row.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Returns the number of cells of land.
    pub fn available(&self) -> u32 {
        self.cells.iter().filter(|&&cell| cell == Cell::Land).count() as u32
    }

    /// Returns the cell at a place; `None` outside the raster.
    #[inline]
    pub(super) fn cell(&self, at: Place) -> Option<Cell> {
        self.holds(at).then(|| self.cells[self.index(at)])
    }

    #[inline]
    pub(super) fn holds(&self, at: Place) -> bool {
        // A negative coordinate becomes a very large one.
        (at.column as u32) < self.columns as u32 && (at.row as u32) < self.rows as u32
    }

    /// Returns the index of a cell of the raster, row by row.
    #[inline]
    pub(super) fn index(&self, at: Place) -> usize {
        (at.row * self.columns + at.column) as usize
    }

    /// Returns the cell with an index.
    #[inline]
    pub(super) fn place(&self, index: u32) -> Place {
        let index = index as i32;
        Place { column: index % self.columns, row: index / self.columns }
    }

    /// Turns land into water.
    pub(super) fn flood(&mut self, at: Place) {
        let index = self.index(at);
        self.cells[index] = Cell::Water;
    }

    /// Converts a point in cells to a point of the domain.
    pub(super) fn point(&self, cells: Vec2) -> Vec2 {
        (cells * self.side).min(self.size)
    }

    /// Returns the point where a river that ends in a water cell reaches the sea: the middle of the cell or, for a cell
    /// on the border, a point of the border.
    pub(super) fn mouth(&self, at: Place) -> Vec2 {
        let along = |cell: i32, cells: i32| match cell {
            0 => 0.0,
            _ if cell == cells - 1 => cells as f32,
            _ => cell as f32 + 0.5,
        };
        self.point(Vec2::new(along(at.column, self.columns), along(at.row, self.rows)))
    }
}

/// A cell by column and row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub column: i32,
    pub row: i32,
}

impl Place {
    /// Returns the eight cells around the cell.
    pub fn around(self) -> [Self; 8] {
        [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)]
            .map(|(column, row)| Self { column: self.column + column, row: self.row + row })
    }

    /// Returns the four cells that share a side with the cell.
    pub fn beside(self) -> [Self; 4] {
        [(0, -1), (-1, 0), (1, 0), (0, 1)]
            .map(|(column, row)| Self { column: self.column + column, row: self.row + row })
    }

    /// Returns `true` if two cells are the same, or share a side or a corner.
    pub fn touches(self, other: Self) -> bool {
        self.column.abs_diff(other.column) <= 1 && self.row.abs_diff(other.row) <= 1
    }

    /// Returns the squared distance between the middles of two cells.
    #[inline]
    pub fn squared_distance(self, other: Self) -> i32 {
        let (x, y) = (self.column - other.column, self.row - other.row);
        x * x + y * y
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    #[test]
    fn what_ridges_enclose_is_no_land_for_particles() {
        // A square of six tenths of a side, and in it a ridge around two tenths.
        let outline = ".MzMzzMMzzMzMMzzM..ZmZmmZZmmZmZZmmZZmZm";
        let settings =
            GrowthSettings::of(&link::read(&format!("land=drawn&roughness=0&aspect=1&outline={outline}")).unwrap());
        let land = settings.land.as_deref().unwrap();
        let raster = Raster::of(&settings);
        let [within, without] = [500, 300].map(|column| Place { column, row: 500 });
        assert_eq!(land.cell(within.column, within.row), Cell::Land);
        assert_eq!(raster.cell(within), Some(Cell::Ridge));
        assert_eq!(raster.cell(without), Some(Cell::Land));
        let watered: u32 = settings.watered().map(|region| region.cells).sum();
        assert_eq!(raster.available(), watered);
        assert!((watered as f32 / 320_000.0 - 1.0).abs() < 0.02, "{watered}");
    }
}
