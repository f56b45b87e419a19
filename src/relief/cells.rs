//! The cells of a map, with a rim of one cell around them, so that every cell of the map has eight neighbours.

use std::num::NonZero;

use glam::Vec2;

use super::Grid;
use super::settings::ReliefSettings;
use crate::base::geometry::fast_min;
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::parallel::for_each_row;
use crate::base::work;
use crate::land::{CoastDistance, Parabola, SmoothedDistance};

/// The cells of a map with the distance of each from the sea, which tells land from water.
#[derive(Clone, Debug, Default)]
pub(super) struct Cells {
    /// The number of columns, the rim included.
    pub columns: usize,
    /// The number of rows, the rim included.
    pub rows: usize,
    /// The side of a cell, in units.
    pub size: f32,
    /// The middle of the map's first cell, in cells from the map's corner: 0.5; 0 if middles are the corners of a lattice.
    pub middle: f32,
    /// The distance of the middle of each cell from the coast, in units: positive on land, 0 or less at sea.
    pub inland: Vec<f32>,
    /// The distance of the middle of each cell from the coast of the low stand, in units; empty if the sea has not risen.
    pub from_low_stand: Vec<f32>,
}

/// The distance of cells beyond the map where land runs on or nothing is known: they are neither land nor sea, and
/// water does not run there.
const BEYOND: f32 = f32::NEG_INFINITY;

impl Cells {
    pub fn new(settings: &ReliefSettings) -> Result<Self, Refused> {
        /// The temporary memory of the smoothed distance on the finest land, whose lattice has as many corners as the map has cells.
        const BYTES_A_CELL: usize = 8;
        let Grid { cell_size, columns, rows } = settings.grid;
        let (columns, rows) = (columns + 2, rows + 2);
        let mut this = Self { columns, rows, size: cell_size, middle: 0.5, ..Self::default() };
        lengthen(&mut this.inland, columns * rows, BEYOND)?;
        ask(columns * rows * BYTES_A_CELL)?;
        work::count(columns * rows);
        match &settings.land {
            Some(land) => {
                let list = std::mem::take(&mut this.inland);
                this.inland = this.measured(&SmoothedDistance::of(land.coast_distance()), list, settings.threads);
            }
            None => this.open(settings),
        }
        if let Some(low_stand) = &settings.low_stand {
            lengthen(&mut this.from_low_stand, columns * rows, BEYOND)?;
            work::count(columns * rows);
            let list = std::mem::take(&mut this.from_low_stand);
            this.from_low_stand = this.measured(&SmoothedDistance::of(low_stand), list, settings.threads);
        }
        if !(0..this.inland.len()).any(|cell| this.is_sea(cell)) {
            // Water has to leave the map somewhere.
            this.inland.iter_mut().filter(|inland| **inland == BEYOND).for_each(|inland| *inland = 0.0);
        }
        Ok(this)
    }

    /// Makes cells whose middles are the corners of a lattice of coast distances.
    pub fn of_corners(distance: &CoastDistance) -> Result<Self, Refused> {
        let (columns, rows) = distance.size();
        let (columns, rows) = (columns + 2, rows + 2);
        let mut this = Self { columns, rows, size: distance.spacing(), middle: 0.0, ..Self::default() };
        lengthen(&mut this.inland, columns * rows, BEYOND)?;
        for (row, heights) in (1..).zip(distance.heights().chunks(columns - 2)) {
            this.inland[row * columns + 1..][..heights.len()].copy_from_slice(heights);
        }
        work::count(columns * rows);
        Ok(this)
    }

    /// Fills a list with the distance of the middle of each cell of the map from the coast, as pictures show that; leaves the rim.
    fn measured(&self, distance: &SmoothedDistance, mut list: Vec<f32>, threads: NonZero<usize>) -> Vec<f32> {
        // The same in all rows.
        let places: Vec<(usize, f32)> =
            (0..self.columns).map(|column| distance.column(self.coordinate(column))).collect();
        for_each_row(&mut list, self.columns, threads, |row, list| {
            if !(1..self.rows - 1).contains(&row) {
                return;
            }
            let across = distance.across(self.coordinate(row));
            for (inland, &(nearest, t)) in list.iter_mut().zip(&places).take(self.columns - 1).skip(1) {
                *inland = Parabola::of(across.around(nearest)).at(t);
            }
        });
        list
    }

    /// Makes all cells land, and the rim sea where a side of the map is open.
    fn open(&mut self, settings: &ReliefSettings) {
        let mut list = std::mem::take(&mut self.inland);
        let is_open = settings.domain.sides(Vec2::ZERO).map(|(side, _)| settings.sides.contains(side));
        for_each_row(&mut list, self.columns, settings.threads, |row, list| {
            let is_rim_row = row == 0 || row + 1 == self.rows;
            for (column, inland) in list.iter_mut().enumerate() {
                let at = Vec2::new(self.coordinate(column), self.coordinate(row));
                let sides = settings.domain.sides(at).into_iter().zip(is_open).filter(|(_, is_open)| *is_open);
                let nearest = sides.map(|((_, far), _)| far).fold(f32::INFINITY, fast_min);
                let is_rim_column = column == 0 || column + 1 == self.columns;
                *inland = match is_rim_row || is_rim_column {
                    true if (is_rim_row && is_rim_column) || nearest > self.size => BEYOND,
                    true => nearest.min(0.0),
                    // The last cells may reach over the border, and are land even so.
                    false => nearest.max(self.size * 0.1),
                };
            }
        });
        self.inland = list;
    }

    #[inline]
    pub fn is_land(&self, cell: usize) -> bool {
        self.inland[cell] > 0.0
    }

    /// Returns the distance of a cell of land from the coast by which hillsides steepen, in units: from the coast of the
    /// low stand if the sea has risen, so that drowned valleys stay as steep at the water as they were at that height.
    #[inline]
    pub fn way_inland(&self, cell: usize) -> f32 {
        self.from_low_stand.get(cell).map_or(self.inland[cell], |far| far.max(self.inland[cell]))
    }

    #[inline]
    pub fn is_sea(&self, cell: usize) -> bool {
        self.inland[cell] <= 0.0 && self.inland[cell] > BEYOND
    }

    /// Returns `true` if a cell lies in the rim, beyond the map.
    pub fn is_rim(&self, cell: usize) -> bool {
        let (row, column) = (cell / self.columns, cell % self.columns);
        row == 0 || column == 0 || row + 1 == self.rows || column + 1 == self.columns
    }

    /// Returns the cell at a point; the nearest for a point beyond the map.
    #[inline]
    pub fn of(&self, point: Vec2) -> usize {
        let index = |x: f32, count: usize| ((x / self.size + (0.5 - self.middle)) as usize + 1).min(count - 2);
        index(point.y, self.rows) * self.columns + index(point.x, self.columns)
    }

    /// Returns the index of a cell of the map in lists without the rim.
    #[inline]
    pub fn without_rim(&self, cell: usize) -> usize {
        (cell / self.columns - 1) * (self.columns - 2) + cell % self.columns - 1
    }

    /// Returns the cells to the west, east, north and south of a cell.
    #[inline]
    pub fn beside(&self, cell: usize) -> [usize; 4] {
        [cell - 1, cell + 1, cell - self.columns, cell + self.columns]
    }

    /// Returns the eight cells around a cell.
    pub fn around(&self, cell: usize) -> [usize; 8] {
        let (north, south) = (cell - self.columns, cell + self.columns);
        [cell - 1, cell + 1, north - 1, north, north + 1, south - 1, south, south + 1]
    }

    /// Returns `true` if two cells share a side or a corner.
    pub fn touch(&self, one: usize, other: usize) -> bool {
        let (row, column) = (one / self.columns, one % self.columns);
        row.abs_diff(other / self.columns) <= 1 && column.abs_diff(other % self.columns) <= 1
    }

    /// Returns a cell that shares a side with each of two cells that touch only at a corner; `None` for other cells.
    pub fn between(&self, one: usize, other: usize) -> Option<usize> {
        let (row, column) = (one / self.columns, other % self.columns);
        (row != other / self.columns && column != one % self.columns).then_some(row * self.columns + column)
    }

    /// Finds the cell of the sea nearest to a cell, at most four cells away along each axis; among equals the first, row by row.
    pub fn sea_near(&self, cell: usize) -> Option<usize> {
        const FAR: isize = 4;
        const SIDE: isize = 2 * FAR + 1;
        let (row, column) = ((cell / self.columns) as isize, (cell % self.columns) as isize);
        let is_inside = |row: isize, column: isize| {
            row >= 0 && column >= 0 && row < self.rows as isize && column < self.columns as isize
        };
        let mut nearest: Option<(isize, usize)> = None;
        for (down, along) in (0..SIDE * SIDE).map(|i| (i / SIDE - FAR, i % SIDE - FAR)) {
            let far = down * down + along * along;
            if !is_inside(row + down, column + along) || nearest.is_some_and(|(least, _)| least <= far) {
                continue;
            }
            let other = (row + down) as usize * self.columns + (column + along) as usize;
            if self.is_sea(other) {
                nearest = Some((far, other));
            }
        }
        nearest.map(|(_, sea)| sea)
    }

    /// Iterates over the cells of land, row by row.
    pub fn land(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.inland.len()).filter(|&cell| self.is_land(cell))
    }

    /// Counts the cells of land.
    #[inline(never)] // one copy
    pub fn land_count(&self) -> usize {
        // The list can be counted many entries at a time, a range of indices cannot.
        self.inland.iter().filter(|&&inland| inland > 0.0).count()
    }

    /// Returns the area of all land, in square units.
    pub fn land_area(&self) -> f32 {
        self.land_count() as f32 * self.size * self.size
    }

    /// Returns the middle of a cell, in units.
    pub fn point(&self, cell: usize) -> Vec2 {
        Vec2::new(self.coordinate(cell % self.columns), self.coordinate(cell / self.columns))
    }

    /// Returns the middle of a column or row, in units.
    #[inline]
    pub fn coordinate(&self, index: usize) -> f32 {
        (index as f32 - 1.0 + self.middle) * self.size
    }
}
