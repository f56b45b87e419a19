//! The search for the driest shore: the place on a coast from which the most attractors are seen that no river has.
//!
//! Such attractors only grow fewer, and so do places that are far enough from all mouths. What a place was once counted to see
//! is therefore the most that it can see later, and it is counted again only when no other is left that could see more (Minoux
//! 1978): the place found is that of counting everywhere. One search may take many ticks, since a coast may be long and a view
//! may cross the map.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::Vec2;

use crate::land::Shore;
use crate::work;

/// A tick's share of a search ends with the first place after this many elementary steps: some milliseconds.
const STEPS_A_TICK: u64 = 2_000_000;

/// A search, kept for the next one with what it has counted.
#[derive(Clone, Debug)]
pub(super) struct Search {
    shores: Vec<Shore>,
    candidates: BinaryHeap<Candidate>,
    number: u32,
    is_under_way: bool,
}

/// A shore that may be the driest. The one that may see the most comes first, of equals the first on the coast.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    /// The most that it can see.
    most: u32,
    shore: Reverse<u32>,
    /// The search in which that was counted.
    counted_in: u32,
}

impl Search {
    /// A search among places on coasts, of which nothing is known yet.
    pub fn among(shores: impl Iterator<Item = Shore>) -> Self {
        let shores: Vec<Shore> = shores.collect();
        let unknown = |shore| Candidate { most: u32::MAX, shore: Reverse(shore), counted_in: 0 };
        let candidates = (0..shores.len() as u32).map(unknown).collect();
        Self { shores, candidates, number: 0, is_under_way: false }
    }

    /// Whether a search has begun that has not ended.
    pub fn is_under_way(&self) -> bool {
        self.is_under_way
    }

    /// Searches for a tick's time. Returns the place that sees the most, the first of equals; `None` if none sees anything,
    /// or while the search is under way. What is seen from a place must not change until it has ended, and never grow.
    pub fn go_on(&mut self, seen_from: impl Fn(Vec2) -> u32) -> Option<Shore> {
        let begun = work::steps();
        self.number += u32::from(!self.is_under_way);
        self.is_under_way = false;
        while let Some(first) = self.candidates.pop() {
            work::count(1);
            let shore = self.shores[first.shore.0 as usize];
            if first.counted_in == self.number {
                self.candidates.push(first);
                return Some(shore);
            }
            let most = seen_from(shore.at);
            if most > 0 {
                self.candidates.push(Candidate { most, counted_in: self.number, ..first });
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

    /// Searches to the end. Returns the number of the place.
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
            let mut places = Search::among((0..seen.borrow().len()).map(shore));
            for (place, loss) in losses {
                let now = seen.borrow().clone();
                let most = now.iter().copied().max().filter(|&most| most > 0);
                let expected = most.and_then(|most| now.iter().position(|&count| count == most));
                // As dear as a tick is every third of them.
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
        let mut places = Search::among((0..seen.len()).map(shore));
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
