//! The work of waves: where ground is soft they straighten coasts into beaches and open bays, while hard headlands stay.
//!
//! Heights are blurred where ground is soft, so the coast of every level is smoother there, and land still only shrinks
//! as the sea rises. Pits that the blur has left are filled.

use crate::base::memory::{Refused, ask, lengthen};
use crate::base::queue::Queue;
use crate::base::work;
use crate::land::CoastDistance;

/// Heights at the corners of a lattice, with a rim of one corner, while waves work on them.
#[derive(Clone, Debug)]
pub(super) struct Waves {
    heights: Vec<f32>,
    /// The corners of soft land, each with the share by which it moves toward the mean of its neighbours in a round.
    soft: Vec<(u32, f32)>,
    /// The heights of those corners after the round.
    moved: Vec<f32>,
    columns: usize,
    rows: usize,
    round: u32,
}

/// The number of rounds of blur, and the number of rounds in a step.
const ROUNDS: u32 = 24;
const ROUNDS_A_STEP: u32 = 4;

/// The height of the rim, which is neither land nor sea.
const RIM: f32 = f32::INFINITY;

impl Waves {
    /// Begins with the heights at the corners of a lattice, in units, above 0 on land, and the softness of the ground, from 0 to 1.
    pub fn new(lattice: &CoastDistance, heights: Vec<f32>, softness: &[f32]) -> Result<Self, Refused> {
        let (columns, rows) = lattice.size();
        let (wide, high) = (columns + 2, rows + 2);
        let (soft, moved) = (Vec::new(), Vec::new());
        let mut this = Self { heights: Vec::new(), soft, moved, columns: wide, rows: high, round: 0 };
        lengthen(&mut this.heights, wide * high, RIM)?;
        ask(wide * high * size_of::<(u32, f32, f32)>())?;
        for (corner, (height, softness)) in heights.into_iter().zip(softness).enumerate() {
            let cell = (corner / columns + 1) * wide + corner % columns + 1;
            this.heights[cell] = height;
            if height > 0.0 && *softness > 0.0 {
                this.soft.push((cell as u32, *softness));
            }
        }
        Ok(this)
    }

    /// Does some more rounds of blur, and fills pits after the last. Returns `true` if there is more to do.
    pub fn advance(&mut self) -> bool {
        if self.round >= ROUNDS {
            self.lift();
            return false;
        }
        for _ in 0..ROUNDS_A_STEP {
            self.blur();
        }
        self.round += ROUNDS_A_STEP;
        true
    }

    /// Moves each corner of soft land toward the mean of its neighbours.
    fn blur(&mut self) {
        work::count(4 * self.soft.len());
        let mut moved = std::mem::take(&mut self.moved);
        moved.clear();
        moved.extend(self.soft.iter().map(|&(cell, softness)| {
            let here = self.heights[cell as usize];
            let lifted = |beside: usize| if self.heights[beside] == RIM { here } else { self.heights[beside] };
            let sum: f32 = self.beside(cell as usize).into_iter().map(lifted).sum();
            here + softness * (0.25 * sum - here)
        }));
        self.soft.iter().zip(&moved).for_each(|(&(cell, _), &height)| self.heights[cell as usize] = height);
        self.moved = moved;
    }

    /// Fills pits: lifts each corner of land, in the order of flooding from the sea, above the neighbour that its water leaves to.
    fn lift(&mut self) {
        /// The least rise from one corner to the next, in units.
        const RISE: f32 = 1e-3;
        let mut queue = Queue::default();
        let mut is_queued: Vec<bool> = self.heights.iter().map(|height| *height <= 0.0 || *height == RIM).collect();
        work::count(6 * self.heights.len());
        for cell in (0..self.heights.len()).filter(|&cell| self.heights[cell] <= 0.0) {
            queue.push(0.0, cell as u32);
        }
        while let Some(cell) = queue.pop() {
            let cell = cell as usize;
            let least = self.heights[cell].max(0.0) + RISE;
            for beside in self.beside(cell) {
                if !std::mem::replace(&mut is_queued[beside], true) {
                    self.heights[beside] = self.heights[beside].max(least);
                    queue.push(self.heights[beside], beside as u32);
                }
            }
        }
    }

    fn beside(&self, cell: usize) -> [usize; 4] {
        [cell - 1, cell + 1, cell - self.columns, cell + self.columns]
    }

    /// Returns the heights without the rim, row by row.
    pub fn into_heights(self) -> Vec<f32> {
        let Self { heights, columns, rows, .. } = self;
        let mut inside = Vec::with_capacity((columns - 2) * (rows - 2));
        for row in 1..rows - 1 {
            inside.extend_from_slice(&heights[row * columns + 1..(row + 1) * columns - 1]);
        }
        inside
    }
}
