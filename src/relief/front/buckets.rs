//! A queue of cells in the order of their heights, in steps. Within a step the latest comes first, so a cell may come too
//! early, and again once it is lower: the more often, the more cells are in one step. So steps are low where ground is flat, by
//! the sea, and higher above.

/// A queue of cells, the lowest step first.
#[derive(Clone, Debug)]
pub(super) struct Buckets {
    /// For each step, one more than the index in `entries` of the latest; 0 if there is none. Empty until a cell comes, so that
    /// tiles of sea take no memory.
    latest: Vec<u32>,
    /// The entries of all steps, and free ones, which are used again, the last freed first: it is still at hand.
    entries: Vec<Entry>,
    /// One more than the index of the entry that is used next; 0 if a new one is.
    free: u32,
    /// The number of steps per unit of height, by the sea.
    steps_a_unit: f32,
    /// The lowest step that may have a cell.
    lowest: usize,
    len: usize,
}

/// A cell in the queue.
#[derive(Clone, Copy, Debug)]
struct Entry {
    cell: u32,
    /// One more than the index of the entry before it in its step, or of the free entry to be used after it; 0 if there is none.
    before: u32,
}

/// The greatest number of steps. The last one also takes all higher cells.
const MOST: usize = 1 << 15;

/// The number of low steps, and the height of a further step in low ones.
const LOW: f32 = 1500.0;
const HIGH: f32 = 3.0;

impl Buckets {
    /// Makes an empty queue whose low steps have a given height, in units.
    pub fn new(step: f32) -> Self {
        Self { latest: Vec::new(), entries: Vec::new(), free: 0, steps_a_unit: 1.0 / step, lowest: 0, len: 0 }
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    #[inline]
    pub fn push(&mut self, height: f32, cell: u32) {
        if self.latest.is_empty() {
            self.latest = vec![0; MOST];
        }
        let step = self.step(height);
        let entry = Entry { cell, before: self.latest[step] };
        self.latest[step] = self.stored(entry);
        self.lowest = self.lowest.min(step);
        self.len += 1;
    }

    /// Stores an entry. Returns one more than its index.
    #[inline]
    fn stored(&mut self, entry: Entry) -> u32 {
        let place = self.free;
        match self.entries.get_mut((place as usize).wrapping_sub(1)) {
            Some(unused) => {
                self.free = unused.before;
                *unused = entry;
                place
            }
            None => {
                self.entries.push(entry);
                self.entries.len() as u32
            }
        }
    }

    /// Removes a cell of the lowest step, and returns it with that step; `None` if the queue is empty.
    #[inline]
    pub fn pop(&mut self) -> Option<(usize, usize)> {
        if self.len == 0 {
            self.lowest = 0;
            return None;
        }
        loop {
            let place = self.latest[self.lowest];
            if place > 0 {
                let entry = &mut self.entries[place as usize - 1];
                self.latest[self.lowest] = std::mem::replace(&mut entry.before, self.free);
                self.free = place;
                self.len -= 1;
                return Some((entry.cell as usize, self.lowest));
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
