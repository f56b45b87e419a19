//! Attractors that wait for a river to come to them, the lowest first: what space colonization goes by where it follows valleys.

use crate::memory::Refused;
use crate::queue::Queue;

/// No rank, of an attractor that need not join those that wait.
const NONE: u32 = u32::MAX;

/// The attractors within reach of some node, but for those that have had their turn. Each is known by its place in the index of
/// attractors, and comes by its rank in the order of heights.
#[derive(Clone, Debug)]
pub(super) struct Waiting {
    /// Where in the index the attractor of each rank is.
    places: Vec<u32>,
    /// The rank of the attractor at each place, until it joins.
    ranks: Vec<u32>,
    queue: Queue,
}

impl Waiting {
    /// None waits. `places` are those in the index, the lowest attractor's first.
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

    /// Lets an attractor join, unless it waits already or has had its turn.
    #[inline]
    pub fn join(&mut self, place: u32) {
        let rank = std::mem::replace(&mut self.ranks[place as usize], NONE);
        if rank != NONE {
            self.queue.push(0.0, rank);
        }
    }

    /// The rank and place of the lowest that waits: its turn has come.
    pub fn next(&mut self) -> Option<(u32, u32)> {
        self.queue.pop().map(|rank| (rank, self.places[rank as usize]))
    }

    /// No river can come to an attractor: it may join again.
    pub fn put_back(&mut self, rank: u32) {
        self.ranks[self.places[rank as usize] as usize] = rank;
    }
}
