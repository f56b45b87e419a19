//! Fast marching (Sethian 1996): from sources of given heights over cells of given steepness, the lowest first.

use super::cells::Cells;
use crate::base::memory::{Refused, lengthen};
use crate::base::queue::Queue;
use crate::base::work;

/// A front that moves uphill, cell by cell.
#[derive(Clone, Debug, Default)]
pub(super) struct March {
    /// The heights of the cells behind the front; infinite elsewhere.
    pub heights: Vec<f32>,
    /// The least heights found so far, of the cells behind the front and of those at it.
    tentative: Vec<f32>,
    queue: Queue,
    /// How many cells lie behind the front.
    pub passed: usize,
}

/// What the front starts from.
#[derive(Clone, Copy)]
pub(super) struct Sources<'a> {
    pub cells: &'a Cells,
    /// By how much each cell of land rises over a neighbour, in units.
    pub rises: &'a [f32],
    /// The height of the water in each cell; infinite where no river is.
    pub rivers: &'a [f32],
    /// Whether rivers stay as high as that wherever the front comes lower.
    pub rivers_are_final: bool,
}

impl Sources<'_> {
    /// Whether the front may say how high a cell is.
    #[inline]
    fn is_open(&self, cell: usize) -> bool {
        !(self.rivers_are_final && self.rivers[cell] < f32::INFINITY)
    }
}

impl March {
    /// Room for the front on a number of cells.
    pub fn new(cells: usize) -> Result<Self, Refused> {
        let mut this = Self::default();
        lengthen(&mut this.heights, cells, f32::INFINITY)?;
        lengthen(&mut this.tentative, cells, f32::INFINITY)?;
        // A cell may be queued again at a lower height; half of that is as much as has been seen.
        this.queue.reserve(cells * 2)?;
        Ok(this)
    }

    /// Goes back to the coast and the rivers. A front that is under way has to come to its end first.
    pub fn restart(&mut self, sources: &Sources<'_>) {
        let &Sources { cells, rises, rivers, .. } = sources;
        self.heights.fill(f32::INFINITY);
        self.tentative.fill(f32::INFINITY);
        self.passed = 0;
        work::count(cells.inland.len());
        for cell in cells.land() {
            self.propose(cell, rivers[cell]);
            if sources.is_open(cell) && cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside)) {
                // The coast runs somewhere between their middles. `clamp` would bring a message with numbers, which weighs 8 kB.
                let way = cells.inland[cell].max(0.05 * cells.size).min(cells.size);
                self.propose(cell, rises[cell] * way / cells.size);
            }
        }
    }

    /// Takes a height for a cell, if none so low was found before.
    #[inline]
    fn propose(&mut self, cell: usize, height: f32) {
        if height < self.tentative[cell] {
            self.tentative[cell] = height;
            self.queue.push(height, cell as u32);
        }
    }

    /// Moves on by this many entries of the queue at most. Returns whether there are more.
    pub fn advance(&mut self, sources: &Sources<'_>, entries: usize) -> bool {
        let cells = sources.cells;
        work::count(5 * entries);
        for _ in 0..entries {
            let Some(cell) = self.queue.pop() else { return false };
            let cell = cell as usize;
            if self.heights[cell] < f32::INFINITY {
                continue;
            }
            self.heights[cell] = self.tentative[cell];
            self.passed += 1;
            for beside in cells.beside(cell) {
                let is_ahead = self.heights[beside] == f32::INFINITY && cells.is_land(beside);
                if is_ahead && sources.is_open(beside) {
                    self.propose(beside, solved(&self.heights, cells.columns, beside, sources.rises[beside]));
                }
            }
        }
        true
    }
}

/// The height of a cell by those of its neighbours behind the front, the others being infinite: first-order and upwind.
#[inline]
pub(super) fn solved(heights: &[f32], columns: usize, cell: usize, rise: f32) -> f32 {
    let lower = |one: usize, other: usize| heights[one].min(heights[other]);
    let (a, b) = (lower(cell - 1, cell + 1), lower(cell - columns, cell + columns));
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let apart = high - low;
    if apart >= rise {
        return low + rise;
    }
    (low + high + (2.0 * rise * rise - apart * apart).sqrt()) * 0.5
}
