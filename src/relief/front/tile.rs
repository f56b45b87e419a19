//! A tile: a rectangle of cells with a ring of the cells around it, in one piece of memory.

use super::buckets::Buckets;
use super::ground::{CLOSED, Ground};
use super::upwind::{solved, solved_beside};

/// A tile of a front, with its ring.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    /// The column and row, on the whole grid, of its first cell: a corner of the ring.
    pub left: usize,
    pub top: usize,
    /// The numbers of columns and rows, the ring included.
    pub columns: usize,
    pub rows: usize,
    pub cells: Vec<Ground>,
    /// For each cell, a bit for each of the cells around it that a river passes next, in the order of [`around`]; empty if no river
    /// passes the tile.
    ways: Vec<u8>,
    queue: Buckets,
    /// The number of cells that have passed their heights on.
    pub passed: usize,
}

impl Tile {
    /// Makes a tile at a place on the grid, to be [closed](Self::close). Its queue has steps of a given height, in units.
    pub fn new(place: (usize, usize), size: (usize, usize), step: f32) -> Self {
        let ((left, top), (columns, rows)) = (place, size);
        Self { left, top, columns, rows, cells: Vec::new(), ways: Vec::new(), queue: Buckets::new(step), passed: 0 }
    }

    /// Makes all cells infinitely high, and lets the front enter none.
    pub fn close(&mut self) {
        self.cells = vec![Ground { height: f32::INFINITY, rise: CLOSED }; self.columns * self.rows];
    }

    /// Adds the way of a river from a cell to one that touches it.
    pub fn add_way(&mut self, cell: usize, next: usize) {
        if self.ways.is_empty() {
            self.ways = vec![0; self.cells.len()];
        }
        let place = around(cell, self.columns).into_iter().position(|beside| beside == next);
        place.into_iter().for_each(|place| self.ways[cell] |= 1 << place);
    }

    /// Returns `true` if any cell waits to pass its height on.
    pub fn is_waiting(&self) -> bool {
        !self.queue.is_empty()
    }

    /// Lowers a cell to a height if it is higher, and queues it to pass that on.
    #[inline]
    pub fn lower(&mut self, cell: usize, height: f32) {
        let ground = &mut self.cells[cell];
        if height < ground.height {
            ground.height = height;
            if ground.is_open() {
                self.queue.push(height, cell as u32);
            }
        }
    }

    /// Solves a cell again, after a neighbour in the ring has been lowered.
    pub fn solve(&mut self, cell: usize) {
        if self.cells[cell].is_open() {
            let around = self.beside(cell).map(|beside| self.cells[beside].height);
            self.lower(cell, solved(around, self.cells[cell].rise));
        }
    }

    /// Returns the cells to the west, east, north and south of a cell.
    #[inline]
    fn beside(&self, cell: usize) -> [usize; 4] {
        [cell - 1, cell + 1, cell - self.columns, cell + self.columns]
    }

    /// Moves the front on by at most this many queue entries. Returns `true` if there are more.
    pub fn advance(&mut self, entries: usize) -> bool {
        for _ in 0..entries {
            let Some((cell, step)) = self.queue.pop() else { return false };
            // A cell that has been lowered since then has been queued again.
            if self.queue.step(self.cells[cell].height) == step {
                self.pass_on(cell);
                self.passed += 1;
            }
        }
        self.is_waiting()
    }

    /// Lowers the neighbours of a cell and the cells downstream of it as far as its height demands.
    #[inline]
    fn pass_on(&mut self, cell: usize) {
        let (heights, mut lowered) = solved_beside(&self.cells, self.columns, cell);
        while lowered > 0 {
            let i = lowered.trailing_zeros() as usize % 4;
            lowered &= lowered - 1;
            let beside = self.beside(cell)[i];
            self.cells[beside].height = heights[i];
            self.queue.push(heights[i], beside as u32);
        }
        let ways = self.ways.get(cell).copied().unwrap_or(0);
        if ways > 0 {
            self.lower_downstream(cell, ways);
        }
    }

    fn lower_downstream(&mut self, cell: usize, mut ways: u8) {
        let height = self.cells[cell].height;
        while ways > 0 {
            self.lower(around(cell, self.columns)[ways.trailing_zeros() as usize], height);
            ways &= ways - 1;
        }
    }
}

/// Returns the eight cells around a cell, row by row.
fn around(cell: usize, columns: usize) -> [usize; 8] {
    let (north, south) = (cell - columns, cell + columns);
    [north - 1, north, north + 1, cell - 1, cell + 1, south - 1, south, south + 1]
}
