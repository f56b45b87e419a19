//! A tile: a rectangle of cells with a ring of the cells around it, in one piece of memory.

use super::buckets::Buckets;
use super::upwind::{solved, solved_beside};

/// The steepness of cells that the front does not enter: the sea, what lies beyond the map, and the ring.
pub(super) const CLOSED: f32 = f32::INFINITY;

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
    /// For each cell that a river passes, one more than the index in `next` of the first cell that a river passes next;
    /// 0 elsewhere.
    first: Vec<u32>,
    /// The cells that rivers pass next; those after the same cell follow one another.
    next: Vec<u32>,
    queue: Buckets,
    /// The number of cells that have passed their heights on.
    pub passed: usize,
}

/// A cell of a tile. Whoever looks at its height looks at its steepness, so they lie together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// The least height found so far.
    pub height: f32,
    /// The height by which it rises above a neighbour, in units; [`CLOSED`] where the front does not enter.
    pub rise: f32,
}

impl Ground {
    pub fn is_open(self) -> bool {
        self.rise < CLOSED
    }
}

/// The bit that marks, in `next`, the last of the cells after the same cell.
const LAST: u32 = 1 << 31;

impl Tile {
    /// Makes a tile at a place on the grid, to be [closed](Self::close). Its queue has steps of a given height, in units.
    pub fn new(place: (usize, usize), size: (usize, usize), step: f32) -> Self {
        let ((left, top), (columns, rows)) = (place, size);
        Self {
            left,
            top,
            columns,
            rows,
            cells: Vec::new(),
            first: Vec::new(),
            next: Vec::new(),
            queue: Buckets::new(step),
            passed: 0,
        }
    }

    /// Makes all cells infinitely high, and lets the front enter none.
    pub fn close(&mut self) {
        self.cells = vec![Ground { height: f32::INFINITY, rise: CLOSED }; self.columns * self.rows];
    }

    /// Sets the ways of rivers: sorted pairs of a cell and the cell that a river passes next.
    pub fn set_ways(&mut self, ways: &[(u32, u32)]) {
        self.first = vec![0; self.cells.len()];
        self.next = Vec::with_capacity(ways.len());
        for (i, &(cell, next)) in ways.iter().enumerate() {
            if self.first[cell as usize] == 0 {
                self.first[cell as usize] = i as u32 + 1;
            }
            let is_last = ways.get(i + 1).is_none_or(|way| way.0 != cell);
            self.next.push(if is_last { next | LAST } else { next });
        }
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
        let first = self.first.get(cell).copied().unwrap_or(0);
        if first > 0 {
            self.lower_downstream(first as usize - 1, self.cells[cell].height);
        }
    }

    fn lower_downstream(&mut self, mut way: usize, height: f32) {
        loop {
            let next = self.next[way];
            self.lower((next & !LAST) as usize, height);
            if next & LAST != 0 {
                return;
            }
            way += 1;
        }
    }
}
