//! What lies upstream of a cell: the cells in an order in which all that drain through one follow it.

use crate::base::memory::{Refused, ask};
use crate::base::work;
use crate::network::NONE;

/// The forest of cells by the ways of their water.
#[derive(Clone, Debug, Default)]
pub(super) struct Upstream {
    /// For each cell, the cell that its water runs to; [`NONE`] for the sea and for cells whose water leaves the map.
    pub to: Vec<u32>,
    /// The place of each cell in the order, and the number of cells that drain through it, itself included.
    place: Vec<u32>,
    count: Vec<u32>,
}

impl Upstream {
    /// Orders cells by the ways of their water.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn of(to: &[u32]) -> Result<Self, Refused> {
        /// Three lists that stay and three that do not.
        const BYTES_A_CELL: usize = 24;
        ask(to.len() * BYTES_A_CELL)?;
        work::count(4 * to.len());
        let downward = downward(to);
        let mut count = vec![1; to.len()];
        for &cell in &downward {
            if let Some(below) = count_below(to, cell) {
                count[below] += count[cell as usize];
            }
        }
        let mut place = vec![0; to.len()];
        // The next free place among the cells that drain through each; of the forest, that after the last tree.
        let (mut next, mut last) = (vec![0; to.len()], 0);
        for &cell in downward.iter().rev() {
            let own = count[cell as usize];
            let from = match count_below(to, cell) {
                Some(below) => &mut next[below],
                None => &mut last,
            };
            place[cell as usize] = *from;
            *from += own;
            next[cell as usize] = place[cell as usize] + 1;
        }
        Ok(Self { to: to.to_vec(), place, count })
    }

    /// Returns `true` if the water of a cell runs through another, or if they are the same.
    pub fn is_above(&self, cell: usize, dam: usize) -> bool {
        (self.place[dam]..self.place[dam] + self.count[dam]).contains(&self.place[cell])
    }

    /// Returns the number of cells that drain through a cell, itself included.
    pub fn count(&self, cell: usize) -> u32 {
        self.count[cell]
    }
}

fn count_below(to: &[u32], cell: u32) -> Option<usize> {
    Some(to[cell as usize]).filter(|below| *below != NONE).map(|below| below as usize)
}

/// Lists cells, each before the one that its water runs to.
fn downward(to: &[u32]) -> Vec<u32> {
    let mut above = vec![0_u32; to.len()];
    for below in to.iter().filter(|below| **below != NONE) {
        above[*below as usize] += 1;
    }
    let mut order: Vec<u32> = (0..to.len() as u32).filter(|cell| above[*cell as usize] == 0).collect();
    let mut next = 0;
    while let Some(&cell) = order.get(next) {
        next += 1;
        if let Some(below) = count_below(to, cell) {
            above[below] -= 1;
            if above[below] == 0 {
                order.push(below as u32);
            }
        }
    }
    order
}
