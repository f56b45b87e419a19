//! Fast marching (Sethian 1996): from sources of given heights over cells of given steepness, the lowest first.

use super::cells::Cells;
use crate::memory::Refused;
use crate::queue::Queue;

/// A wave that runs uphill.
#[derive(Clone, Debug, Default)]
pub(super) struct March {
    /// The heights of the cells that the wave has passed; infinite elsewhere.
    pub height: Vec<f32>,
    /// The least heights found so far.
    reached: Vec<f32>,
    queue: Queue,
}

impl March {
    /// Sets out from the coast. `rise` is by how much a cell of land rises over a neighbour; `held` are heights that no wave
    /// lowers.
    pub fn new(cells: &Cells, rise: &[f32], held: Option<&[f32]>) -> Result<Self, Refused> {
        let none = vec![f32::INFINITY; cells.inland.len()];
        let mut this = Self { height: none.clone(), reached: none, queue: Queue::default() };
        this.queue.reserve(cells.inland.len() * 2)?;
        for cell in cells.land() {
            if let Some(&height) = held.map(|held| &held[cell]).filter(|height| **height < f32::INFINITY) {
                this.reach(cell, height);
            } else if cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside)) {
                // The coast runs somewhere between their middles.
                let way = cells.inland[cell].clamp(0.05 * super::CELL_SIZE, super::CELL_SIZE);
                this.reach(cell, rise[cell] * way / super::CELL_SIZE);
            }
        }
        Ok(this)
    }

    /// Reaches a cell at a height, if it was not reached at a lower one.
    #[inline]
    pub fn reach(&mut self, cell: usize, height: f32) {
        if height < self.reached[cell] {
            self.reached[cell] = height;
            self.queue.push(height, cell as u32);
        }
    }

    /// Passes this many cells at most. Returns whether there are more.
    pub fn advance(&mut self, cells: &Cells, rise: &[f32], held: Option<&[f32]>, steps: usize) -> bool {
        for _ in 0..steps {
            let Some(cell) = self.queue.pop() else { return false };
            let cell = cell as usize;
            if self.height[cell] < f32::INFINITY {
                continue;
            }
            self.height[cell] = self.reached[cell];
            for beside in cells.beside(cell) {
                let is_open = self.height[beside] == f32::INFINITY && cells.is_land(beside);
                if is_open && held.is_none_or(|held| held[beside] == f32::INFINITY) {
                    self.reach(beside, self.solved(cells.columns, beside, rise[beside]));
                }
            }
        }
        true
    }

    /// The height of a cell by those of its neighbours that the wave has passed: first-order and upwind.
    #[inline]
    fn solved(&self, columns: usize, cell: usize, rise: f32) -> f32 {
        let lower = |one: usize, other: usize| self.height[one].min(self.height[other]);
        let (a, b) = (lower(cell - 1, cell + 1), lower(cell - columns, cell + columns));
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        let apart = high - low;
        if apart >= rise {
            return low + rise;
        }
        (low + high + (2.0 * rise * rise - apart * apart).sqrt()) * 0.5
    }
}
