//! A queue of cells in the order of their heights, in steps. Within a step the latest comes first, so a cell may come too
//! early, and again once it is lower: the more often, the more cells are in one step. So steps are low where ground is flat, by
//! the sea, and higher above.

/// A queue of cells, the lowest step first.
#[derive(Clone, Debug)]
pub(super) struct Buckets {
    lists: Vec<Vec<u32>>,
    /// The number of steps per unit of height, by the sea.
    steps_a_unit: f32,
    /// The index of the first list that may hold a cell.
    lowest: usize,
    len: usize,
}

/// The greatest number of steps. The last one also takes all higher cells.
const MOST: usize = 1 << 15;

/// The number of low steps, and the height of a further step in low ones.
const LOW: f32 = 1500.0;
const HIGH: f32 = 3.0;

impl Buckets {
    /// Makes an empty queue whose low steps have a given height, in units.
    pub fn new(step: f32) -> Self {
        Self { lists: Vec::new(), steps_a_unit: 1.0 / step, lowest: 0, len: 0 }
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    #[inline]
    pub fn push(&mut self, height: f32, cell: u32) {
        let step = self.step(height);
        if step >= self.lists.len() {
            self.lists.resize_with(step + 1, Vec::new);
        }
        self.lists[step].push(cell);
        self.lowest = self.lowest.min(step);
        self.len += 1;
    }

    /// Removes a cell of the lowest step, and returns it with that step; `None` if the queue is empty.
    #[inline]
    pub fn pop(&mut self) -> Option<(usize, usize)> {
        if self.len == 0 {
            self.lowest = 0;
            return None;
        }
        loop {
            if let Some(cell) = self.lists[self.lowest].pop() {
                self.len -= 1;
                return Some((cell as usize, self.lowest));
            }
            self.lowest += 1;
        }
    }

    /// Returns the step that a height, in units, belongs to.
    #[inline]
    pub fn step(&self, height: f32) -> usize {
        let steps = height * self.steps_a_unit;
        let steps = if steps > LOW { LOW + (steps - LOW) / HIGH } else { steps };
        (steps as usize).min(MOST - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_come_by_steps_and_lower_ones_may_come_later() {
        let mut queue = Buckets::new(0.5);
        for (cell, height) in [1.2, 0.1, 1e9, 0.4, 0.7].into_iter().enumerate() {
            queue.push(height, cell as u32);
        }
        assert_eq!([queue.pop(), queue.pop(), queue.pop()], [Some((3, 0)), Some((1, 0)), Some((4, 1))]);
        queue.push(0.2, 7);
        assert_eq!([queue.pop(), queue.pop(), queue.pop()], [Some((7, 0)), Some((0, 2)), Some((2, MOST - 1))]);
        assert_eq!(queue.pop(), None);
        assert_eq!([749.9, 750.0, 751.0, 751.5].map(|height| queue.step(height)), [1499, 1500, 1500, 1501]);
        queue.push(0.9, 1);
        assert_eq!((queue.is_empty(), queue.pop()), (false, Some((1, 1))));
    }
}
