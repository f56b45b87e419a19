//! The grid of a relief: the size of its cells, and how many there are.

use std::ops::RangeInclusive;

use super::CELL_SIZE;
use crate::domain::Domain;

/// Square cells that cover a map, from its north-western corner on. The last of a row or column may reach over the map's border.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grid {
    /// The side of a cell, in units.
    pub cell_size: f32,
    /// The number of cells in a row.
    pub columns: usize,
    /// The number of rows.
    pub rows: usize,
}

impl Grid {
    /// Returns the map's own grid, whose cells are [`CELL_SIZE`] wide.
    pub fn of(domain: &Domain) -> Self {
        let size = (domain.size / CELL_SIZE).ceil();
        Self { cell_size: CELL_SIZE, columns: size.x as usize, rows: size.y as usize }
    }
}

impl Grid {
    /// The greatest number of cells on the longer side of a grid: the largest that game engines take, which want a power of two plus one.
    pub const MOST: u32 = 4097;

    /// Returns how many cells a grid of a map may have on its longer side: from that of the map's own grid to [`Grid::MOST`].
    pub fn sizes(domain: &Domain) -> RangeInclusive<u32> {
        Self::of(domain).longer_side()..=Self::MOST
    }

    /// Returns the grid with a number of cells on the map's longer side, which they fill exactly; the map's own grid if
    /// it has that number. `None` if the number is not in [`Grid::sizes`].
    pub fn with_longer_side(domain: &Domain, cells: u32) -> Option<Self> {
        let own = Self::of(domain);
        if cells == own.longer_side() {
            return Some(own);
        }
        let longer = domain.size.max_element();
        let counted = |length: f32| fitting(f64::from(length) / f64::from(longer) * f64::from(cells));
        let (columns, rows) = (counted(domain.size.x), counted(domain.size.y));
        Self::sizes(domain).contains(&cells).then(|| Self { cell_size: longer / cells as f32, columns, rows })
    }

    fn longer_side(&self) -> u32 {
        self.columns.max(self.rows) as u32
    }
}

/// Rounds a length in cells up to whole cells. A sliver, which may be a rounding error, gets no cell.
fn fitting(cells: f64) -> usize {
    const SLIVER: f64 = 1e-3;
    (cells - SLIVER).ceil().max(1.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_fill_the_longer_side_and_cover_the_other() {
        for aspect in [0.25, 0.3, 0.5, 1.0, 1.28, 1.5, 2.0, 3.7, 4.0] {
            let domain = Domain::with_aspect(aspect);
            for cells in Grid::sizes(&domain).skip(1).step_by(97).chain([1024, 1025, 2049, 4096, 4097]) {
                let grid = Grid::with_longer_side(&domain, cells).unwrap();
                assert_eq!(grid.longer_side(), cells);
                let (width, height) = (grid.cell_size * grid.columns as f32, grid.cell_size * grid.rows as f32);
                let over = [width - domain.size.x, height - domain.size.y].map(|over| over / grid.cell_size);
                assert!(over.iter().all(|over| (-0.002..1.002).contains(over)), "{aspect}, {cells}: {over:?}");
            }
        }
        // No row for a rounding.
        for (aspect, rows) in [(1.0, 1025), (2.0, 513)] {
            let domain = Domain::with_aspect(aspect);
            assert_eq!(Grid::with_longer_side(&domain, 1025).unwrap().rows, rows);
        }
        assert_eq!(Grid::with_longer_side(&Domain::with_aspect(2.0), 1024).unwrap().rows, 512);
    }

    #[test]
    fn grids_are_as_fine_as_the_map_s_own_or_finer() {
        let domain = Domain::with_aspect(1.5);
        assert_eq!(Grid::sizes(&domain), 613..=4097);
        assert_eq!(Grid::with_longer_side(&domain, 613), Some(Grid::of(&domain)));
        assert_eq!((Grid::of(&domain).columns, Grid::of(&domain).rows), (613, 409));
        let refused = [0, 612, 4098, u32::MAX].map(|cells| Grid::with_longer_side(&domain, cells));
        assert_eq!(refused, [None; 4]);
    }
}
