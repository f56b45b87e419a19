//! A queue of points by area, the smallest first; among equal areas, the lowest point number first.
//!
//! If there are many points, only those that come soon are in a heap. The others lie unordered in buckets by area until
//! it is their bucket's turn: a heap of all points would be larger than any cache, and each removal would walk through
//! all of it.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The bits of an area, which for numbers from 0 on are ordered as the numbers are, and the number of the point: both
/// in one integer, compared at once.
type Entry = Reverse<u64>;

pub(super) struct Areas {
    /// The entries of all buckets whose turn has come.
    soon: BinaryHeap<Entry>,
    /// The buckets whose turn is still to come.
    later: Vec<Vec<Entry>>,
    /// The index of the first of these.
    next: usize,
    /// The shift that turns an area's bits into the index of its bucket.
    shift: u32,
}

impl Areas {
    /// Makes an empty queue for about this many entries.
    pub fn with_room_for(count: usize) -> Self {
        /// A heap with fewer entries fits in a cache.
        const FEW: usize = 1 << 16;
        /// One bucket for each eighth of an octave.
        const MANY_SHIFT: u32 = 20;
        let shift = if count < FEW { 31 } else { MANY_SHIFT };
        Self { soon: BinaryHeap::new(), later: vec![Vec::new(); 1 << (31 - shift)], next: 0, shift }
    }

    /// Adds a point. The area must not be negative.
    pub fn push(&mut self, area: f32, point: u32) {
        let entry = Reverse(u64::from(area.to_bits()) << 32 | u64::from(point));
        let bucket = (area.to_bits() >> self.shift) as usize;
        match self.later.get_mut(bucket) {
            Some(later) if bucket >= self.next => later.push(entry),
            _ => self.soon.push(entry),
        }
    }

    /// Removes the smallest.
    pub fn pop(&mut self) -> Option<(f32, u32)> {
        while self.soon.is_empty() {
            self.soon = std::mem::take(self.later.get_mut(self.next)?).into();
            self.next += 1;
        }
        self.soon.pop().map(|Reverse(entry)| (f32::from_bits((entry >> 32) as u32), entry as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    /// Zero, the smallest and the greatest numbers, many equal ones, and numbers between.
    fn area() -> impl Strategy<Value = f32> {
        prop_oneof![
            Just(0.0),
            Just(f32::INFINITY),
            (0u32..4).prop_map(|thirds| thirds as f32 / 3.0),
            (0u32..0x7F80_0000).prop_map(f32::from_bits),
            1f32..1.1,
        ]
    }

    proptest! {
        #![proptest_config(cases(256))]

        /// Pushes and pops in turn, below and above the areas popped before. `count` is the number that the queue
        /// expects.
        #[test]
        fn order_is_that_of_one_heap(
            count in prop_oneof![Just(0usize), Just(1 << 20)],
            steps in proptest::collection::vec(proptest::option::weighted(0.6, (area(), 0u32..9)), 0..300),
        ) {
            let (mut queue, mut heap) = (Areas::with_room_for(count), BinaryHeap::new());
            let least = |heap: &mut BinaryHeap<Reverse<(u32, u32)>>| heap.pop().map(|Reverse(least)| least);
            let bits = |popped: Option<(f32, u32)>| popped.map(|(area, point)| (area.to_bits(), point));
            for step in steps {
                match step {
                    Some((area, point)) => {
                        queue.push(area, point);
                        heap.push(Reverse((area.to_bits(), point)));
                    }
                    None => prop_assert_eq!(bits(queue.pop()), least(&mut heap)),
                }
            }
            while let Some(expected) = least(&mut heap) {
                prop_assert_eq!(bits(queue.pop()), Some(expected));
            }
            prop_assert!(queue.pop().is_none());
        }
    }
}
