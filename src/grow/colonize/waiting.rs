//! Attractors that wait for a river to reach them, the lowest first. Space colonization uses them where it follows
//! valleys.

use crate::base::memory::Refused;
use crate::base::queue::Queue;

/// The rank of an attractor that need not join those that wait.
const NONE: u32 = u32::MAX;

/// The attractors within reach of some node, except those that have had their turn. Each is identified by its place in
/// the index of attractors, and ordered by its rank by height.
#[derive(Clone, Debug)]
pub(super) struct Waiting {
    /// The place in the index of the attractor of each rank.
    places: Vec<u32>,
    /// The rank of the attractor at each place, until it joins.
    ranks: Vec<u32>,
    queue: Queue,
}

impl Waiting {
    /// Begins with none waiting. `places` are those in the index, the lowest attractor's first.
    pub fn new(places: Vec<u32>) -> Result<Self, Refused> {
        let end = places.iter().max().map_or(0, |&last| last as usize + 1);
        let mut ranks = vec![NONE; end];
        for (rank, &place) in (0..).zip(&places) {
            ranks[place as usize] = rank;
        }
        let mut queue = Queue::default();
        queue.reserve(places.len())?;
        Ok(Self { places, ranks, queue })
    }

    /// Adds an attractor, unless it already waits or has had its turn.
    #[inline]
    pub fn join(&mut self, place: u32) {
        let rank = std::mem::replace(&mut self.ranks[place as usize], NONE);
        if rank != NONE {
            self.queue.push(0.0, rank);
        }
    }

    /// Removes the lowest attractor that waits, and returns its rank and place.
    pub fn next(&mut self) -> Option<(u32, u32)> {
        self.queue.pop().map(|rank| (rank, self.places[rank as usize]))
    }

    /// Allows an attractor to join again, because no river could reach it.
    pub fn put_back(&mut self, rank: u32) {
        self.ranks[self.places[rank as usize] as usize] = rank;
    }
}
