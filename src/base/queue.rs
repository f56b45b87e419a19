//! A queue of numbered items, cheapest first; among equally cheap items, the lowest number first.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::base::memory::{Refused, can_allocate};
use crate::base::sort;

#[derive(Clone, Debug, Default)]
pub(crate) struct Queue(BinaryHeap<Reverse<u64>>);

impl Queue {
    /// Reserves memory for more entries.
    pub fn reserve(&mut self, more: usize) -> Result<(), Refused> {
        if self.0.capacity() - self.0.len() >= more {
            return Ok(());
        }
        if !can_allocate((self.0.len() + more) * size_of::<u64>()) {
            return Err(Refused);
        }
        self.0.try_reserve(more).map_err(|_| Refused)
    }

    #[inline]
    pub fn push(&mut self, cost: f32, item: u32) {
        self.0.push(Reverse(u64::from(sort::key(cost)) << 32 | u64::from(item)));
    }

    /// Removes the cheapest item.
    #[inline]
    pub fn pop(&mut self) -> Option<u32> {
        self.0.pop().map(|Reverse(entry)| entry as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cheapest_comes_first_and_of_equals_the_lower_number() {
        let mut queue = Queue::default();
        for (cost, parcel) in [(2.5, 1), (-1.0, 9), (0.0, 4), (2.5, 0), (-3.5, 7), (0.0, 3)] {
            queue.push(cost, parcel);
        }
        let order: Vec<u32> = std::iter::from_fn(|| queue.pop()).collect();
        assert_eq!(order, [7, 9, 3, 4, 0, 1]);
    }
}
