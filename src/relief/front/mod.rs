//! The front that moves uphill from the coast and from rivers: the eikonal equation on cells (Sethian 1996), the lowest
//! first, with one more condition: a river is nowhere higher than upstream. Both only ever lower a cell, so one run
//! finds the highest surface that satisfies all of them, whatever the order. Only the last bits are another matter: rounding can
//! make a cell lower by a bit while a neighbour is still higher, so the order of the queue is part of the result.
//!
//! The grid is divided into tiles. In each round every tile in which cells wait is solved by itself, with the heights
//! around it from the round before; therefore the result does not depend on the number of threads.

mod buckets;
mod ground;
mod tile;
mod upwind;

use std::num::NonZero;

use ground::CLOSED;
use tile::Tile;
pub(super) use upwind::solved;

use super::cells::Cells;
use super::channels::Channels;
use crate::base::memory::{Refused, ask};
use crate::base::parallel::{for_each, for_each_row};
use crate::base::work;

/// The front on the cells of a map.
#[derive(Clone, Debug, Default)]
pub(super) struct Front {
    /// The number of columns of the grid, the rim included.
    columns: usize,
    tiles: Vec<Tile>,
    /// The number of tiles in a row.
    across: usize,
    /// The tile that is solved next in this round.
    next: usize,
    /// The longest side of a tile, in cells.
    side: usize,
    /// The number of cells of land.
    cells: usize,
}

/// The longest side of a tile of large maps, in cells: so much fits into the cache of a core.
pub(super) const TILE: usize = 256;

/// The least height of a river, in sides of a cell.
const LEAST_HEIGHT: f32 = 5e-5;

/// The height of a low step of the queue, in sides of a cell: less than the rise of most cells, also of flat ground.
const STEP: f32 = 0.03;

impl Front {
    /// Divides the cells of a map into tiles of at most `side` by `side` cells, on a number of threads; `rises` has the
    /// height by which each cell of land rises above a neighbour, in units.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(cells: &Cells, rises: &[f32], side: usize, threads: NonZero<usize>) -> Result<Self, Refused> {
        /// Heights, steepness, ways of rivers, and the queue.
        const BYTES_A_CELL: usize = 12;
        ask(rises.len() * BYTES_A_CELL)?;
        work::count(2 * rises.len());
        let (inner_columns, inner_rows) = (cells.columns - 2, cells.rows - 2);
        let across = inner_columns.div_ceil(side);
        let mut tiles = Vec::new();
        for top in (0..inner_rows).step_by(side) {
            for left in (0..inner_columns).step_by(side) {
                let size = ((inner_columns - left).min(side) + 2, (inner_rows - top).min(side) + 2);
                tiles.push(Tile::new((left, top), size, STEP * cells.size));
            }
        }
        for_each(tiles.iter_mut(), threads, |tile| fill(tile, cells, rises));
        Ok(Self { columns: cells.columns, tiles, across, next: 0, side, cells: cells.land_count() })
    }

    /// Adds the coast, on a number of threads: each cell of land beside the sea gets the height that it rises from the coast line.
    pub fn add_coast(&mut self, cells: &Cells, threads: NonZero<usize>) {
        work::count(cells.inland.len() + 4 * self.cells);
        for_each(self.tiles.iter_mut(), threads, |tile| {
            for (row, column) in tile.inside() {
                let (cell, local) =
                    ((tile.top + row) * cells.columns + tile.left + column, row * tile.columns + column);
                if cells.is_land(cell) && cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside)) {
                    // The coast runs between the middles of cells. `clamp` would bring a panic message with numbers, which weighs 8 kB.
                    let way = cells.inland[cell].max(0.05 * cells.size).min(cells.size);
                    tile.lower(local, tile.cells[local].rise * way / cells.size);
                }
            }
        });
    }

    /// Adds rivers: each cell of a path is at most as high as the path says there, and as the cell upstream.
    pub fn add_rivers(&mut self, cells: &Cells, channels: &Channels) {
        // Land is above the sea up to the very mouth.
        let least = LEAST_HEIGHT * cells.size;
        for path in channels.paths() {
            work::count(6 * path.len());
            for &(cell, height) in path.iter().filter(|step| cells.is_land(step.0 as usize)) {
                self.lower(cell as usize, height.max(least));
            }
            for pair in path.windows(2) {
                let [cell, next] = [pair[0].0 as usize, pair[1].0 as usize];
                if cells.is_land(cell) && cells.is_land(next) && cell != next {
                    let (tile, local) = self.place(cell);
                    let next = self.tiles[tile].local(self.columns, next);
                    self.tiles[tile].add_way(local, next);
                }
            }
        }
    }

    /// Moves the front on by at most `entries` queue entries or, on several threads, by a whole round. Returns `true`
    /// if there is more to do.
    pub fn advance(&mut self, entries: usize, threads: NonZero<usize>) -> bool {
        if threads.get() > 1 {
            self.solve_all(threads);
        } else if self.solve_some(entries) {
            return true;
        }
        self.exchange()
    }

    /// Solves a tile by at most `entries` queue entries. Returns `true` if there may be more to do in this round.
    fn solve_some(&mut self, entries: usize) -> bool {
        work::count(5 * entries);
        while let Some(tile) = self.tiles.get_mut(self.next) {
            let (was_waiting, is_waiting) = (tile.is_waiting(), tile.advance(entries));
            self.next += usize::from(!is_waiting);
            if was_waiting {
                return true;
            }
        }
        self.next = 0;
        false
    }

    fn solve_all(&mut self, threads: NonZero<usize>) {
        let waiting = self.tiles.iter_mut().filter(|tile| tile.is_waiting());
        for_each(waiting, threads, |tile| while tile.advance(usize::MAX) {});
    }

    /// Passes heights on from tile to tile. Returns `true` if any cell waits.
    fn exchange(&mut self) -> bool {
        for tile in 0..self.tiles.len() {
            let ring = self.tiles[tile].ring();
            work::count(ring.len());
            for (cell, beside) in ring {
                self.exchange_cell(tile, cell, beside);
            }
        }
        self.tiles.iter().any(Tile::is_waiting)
    }

    /// Lowers a cell of a tile's ring, and the same cell in its own tile, to the lower of both; `beside` is the
    /// neighbour of the former inside the ring.
    fn exchange_cell(&mut self, tile: usize, cell: usize, beside: Option<usize>) {
        let Some((own, local)) = self.place_of_ring(tile, cell) else { return };
        let (here, there) = (self.tiles[tile].cells[cell].height, self.tiles[own].cells[local].height);
        if here == there {
            return;
        }
        // Rivers lower cells of the ring, which do not pass that on themselves.
        self.tiles[own].lower(local, here);
        self.tiles[tile].lower(cell, there);
        beside.into_iter().for_each(|beside| self.tiles[tile].solve(beside));
    }

    /// Returns the tile to which a cell of another tile's ring belongs, and its index there; `None` beyond the map.
    fn place_of_ring(&self, tile: usize, cell: usize) -> Option<(usize, usize)> {
        let Tile { left, top, columns, .. } = self.tiles[tile];
        let (column, row) = (left + cell % columns, top + cell / columns);
        let global = row * self.columns + column;
        let last = self.tiles.last()?;
        let is_inside =
            (1..last.left + last.columns - 1).contains(&column) && (1..last.top + last.rows - 1).contains(&row);
        is_inside.then(|| self.place(global))
    }

    /// Returns the tile of a cell of the map, and the cell's index in it.
    fn place(&self, cell: usize) -> (usize, usize) {
        let (column, row) = (cell % self.columns - 1, cell / self.columns - 1);
        let tile = row / self.side * self.across + column / self.side;
        (tile, self.tiles[tile].local(self.columns, cell))
    }

    /// Lowers a cell of the map to a height, if it is higher.
    pub fn lower(&mut self, cell: usize, height: f32) {
        let (tile, local) = self.place(cell);
        self.tiles[tile].lower(local, height);
    }

    /// Writes the heights of all cells into a list that includes the rim, which it leaves, on a number of threads;
    /// infinite where there is no land.
    pub fn write(&self, heights: &mut [f32], threads: NonZero<usize>) {
        work::count(heights.len());
        for_each_row(heights, self.columns, threads, |row, heights| {
            let tiles = self.tiles.iter().filter(|tile| (1..tile.rows - 1).contains(&row.wrapping_sub(tile.top)));
            for tile in tiles {
                let start = (row - tile.top) * tile.columns;
                let inner = &tile.cells[start + 1..start + tile.columns - 1];
                heights[tile.left + 1..].iter_mut().zip(inner).for_each(|(height, cell)| *height = cell.height);
            }
        });
    }

    /// Estimates the share of a run that is done, from 0 to 1. It never decreases.
    pub fn progress(&self) -> f32 {
        /// The number of times that a cell passes its height on, on average.
        const TIMES: f32 = 1.2;
        let passed: usize = self.tiles.iter().map(|tile| tile.passed).sum();
        (passed as f32 / (TIMES * self.cells.max(1) as f32)).min(1.0)
    }
}

impl Tile {
    /// Returns the index in this tile of a cell of the whole grid, which has `columns` columns.
    fn local(&self, columns: usize, cell: usize) -> usize {
        (cell / columns - self.top) * self.columns + cell % columns - self.left
    }

    /// Iterates over the rows and columns of the cells inside the ring.
    fn inside(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        (1..rows - 1).flat_map(move |row| (1..columns - 1).map(move |column| (row, column)))
    }

    /// Lists the cells of the ring, each with its neighbour inside the ring; corners have none.
    fn ring(&self) -> Vec<(usize, Option<usize>)> {
        let (columns, last) = (self.columns, (self.rows - 1) * self.columns);
        let mut ring = Vec::with_capacity(2 * (self.columns + self.rows));
        ring.extend([0, columns - 1, last, last + columns - 1].map(|corner| (corner, None)));
        for column in 1..columns - 1 {
            ring.extend([(column, Some(column + columns)), (last + column, Some(last + column - columns))]);
        }
        for row in 1..self.rows - 1 {
            let (west, east) = (row * columns, (row + 1) * columns - 1);
            ring.extend([(west, Some(west + 1)), (east, Some(east - 1))]);
        }
        ring
    }
}

/// Closes a tile, then opens its cells of land inside the ring to the front.
fn fill(tile: &mut Tile, cells: &Cells, rises: &[f32]) {
    tile.close();
    for (row, column) in tile.inside() {
        let cell = (tile.top + row) * cells.columns + tile.left + column;
        tile.cells[row * tile.columns + column].rise = if cells.is_land(cell) { rises[cell] } else { CLOSED };
    }
}
