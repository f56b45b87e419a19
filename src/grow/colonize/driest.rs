//! The search for the driest shore: the place on a coast that sees the most attractors without a river.
//!
//! The number of such attractors only falls, and so does the number of places far enough from all mouths. An earlier
//! count for a place is therefore an upper bound, and it is counted again only when no other place could see more
//! (Minoux 1978): the result is that of counting everywhere. A search may take many ticks, because a coast may be long
//! and a view may cross the map.

use glam::Vec2;

use crate::base::queue::Queue;
use crate::base::work;
use crate::land::Shore;

/// The number of elementary steps after which a tick's share of a search ends, with the next place: some milliseconds.
const STEPS_A_TICK: u64 = 2_000_000;

/// A search, kept with its counts for the next one.
#[derive(Clone, Debug)]
pub(super) struct Search {
    shores: Vec<Shore>,
    /// The last count for each shore.
    counts: Vec<Count>,
    /// Shores that may be the driest. The one that may see the most comes first; among equals, the first on the coast.
    candidates: Queue,
    number: u32,
    is_under_way: bool,
}

/// A count of the attractors that a shore sees.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    seen: u32,
    /// The search in which it was counted; 0 for none.
    search: u32,
}

impl Search {
    /// Prepares a search among places on coasts, without any counts.
    pub fn among(shores: Vec<Shore>) -> Self {
        let mut candidates = Queue::default();
        (0..shores.len() as u32).for_each(|shore| candidates.push(f32::NEG_INFINITY, shore));
        let counts = vec![Count::default(); shores.len()];
        Self { shores, counts, candidates, number: 0, is_under_way: false }
    }

    /// Returns `true` if a search has begun and not ended.
    pub fn is_under_way(&self) -> bool {
        self.is_under_way
    }

    /// Searches for a tick's time. Returns the place that sees the most, the first among equals; `None` if none sees
    /// anything, or while the search is under way. Until it ends, the number of attractors seen from a place must not
    /// change; afterwards it may only fall.
    pub fn go_on(&mut self, seen_from: impl Fn(Vec2) -> u32) -> Option<Shore> {
        let begun = work::steps();
        self.number += u32::from(!self.is_under_way);
        self.is_under_way = false;
        while let Some(shore) = self.candidates.pop() {
            work::count(1);
            let (place, count) = (self.shores[shore as usize], &mut self.counts[shore as usize]);
            let is_counted = count.search == self.number;
            if !is_counted {
                *count = Count { seen: seen_from(place.at), search: self.number };
            }
            if count.seen > 0 {
                // Exact, because there are fewer than 2²⁴ attractors.
                self.candidates.push(-(count.seen as f32), shore);
            }
            if is_counted {
                return Some(place);
            }
            if work::steps() - begun >= STEPS_A_TICK {
                self.is_under_way = true;
                break;
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;
    use std::cell::RefCell;

    fn shore(i: usize) -> Shore {
        Shore { at: Vec2::new(i as f32, 0.0), inland: Vec2::Y }
    }

    /// Searches to the end. Returns the index of the place.
    fn search(search: &mut Search, seen_from: impl Fn(usize) -> u32) -> Option<usize> {
        loop {
            let found = search.go_on(|at| seen_from(at.x as usize));
            if !search.is_under_way() {
                return found.map(|shore| shore.at.x as usize);
            }
        }
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn the_place_found_is_that_of_counting_everywhere(
            first in proptest::collection::vec(0u32..9, 1..40),
            losses in proptest::collection::vec((0usize..40, 0u32..9), 0..60),
        ) {
            let seen = RefCell::new(first);
            let mut places = Search::among((0..seen.borrow().len()).map(shore).collect());
            for (place, loss) in losses {
                let now = seen.borrow().clone();
                let most = now.iter().copied().max().filter(|&most| most > 0);
                let expected = most.and_then(|most| now.iter().position(|&count| count == most));
                // Every third one costs as much as a tick.
                let found = search(&mut places, |i| {
                    work::count(if i % 3 == 0 { STEPS_A_TICK as usize } else { 1 });
                    now[i]
                });
                prop_assert_eq!(found, expected);
                let place = place % now.len();
                seen.borrow_mut()[place] = now[place].saturating_sub(loss);
            }
        }
    }

    #[test]
    fn a_place_that_sees_too_little_is_not_counted_again() {
        let seen = [5, 9, 3, 1, 0];
        let mut places = Search::among((0..seen.len()).map(shore).collect());
        assert_eq!(search(&mut places, |i| seen[i]), Some(1));
        let counted = RefCell::new(vec![]);
        let later = [5, 4, 3, 1, 0];
        let found = search(&mut places, |i| {
            counted.borrow_mut().push(i);
            later[i]
        });
        assert_eq!((found, counted.into_inner()), (Some(0), vec![1, 0]));
    }
}
