//! A round: every parcel finds the cheapest way to the sea (Dijkstra 1959, from all outlets at once). A step costs less
//! the more water there was in the previous round: S = k A^−θ (Flint 1974), as in optimal channel networks
//! (Rodriguez-Iturbe, Rinaldo and others 1992).

use super::directions::FlowDirections;
use super::parcels::Parcels;
use crate::base::memory::Refused;
use crate::base::queue::Queue;
use crate::base::work;

/// The factor for the cost of leaving the land through a closed outlet.
const CLOSED: f32 = 100.0;

/// A round in progress.
#[derive(Clone, Debug)]
pub(super) struct Round {
    ways: Vec<Way>,
    queue: Queue,
    directions: FlowDirections,
}

/// A parcel's way to the sea. Its parts are stored together because they are read together.
#[derive(Clone, Copy, Debug)]
struct Way {
    /// The cost of the cheapest known way.
    cost: f32,
    /// A^−θ: the slope of its first step, apart from the ground. Infinite once the way is settled, so that no other is
    /// cheaper.
    slope: f32,
}

impl Way {
    fn is_settled(&self) -> bool {
        self.slope == f32::INFINITY
    }
}

/// Returns S = A^−θ. With the usual θ a root does, in a twentieth of the time.
pub(super) fn slope(area: f32, concavity: f32) -> f32 {
    if concavity == 0.5 { 1.0 / area.sqrt() } else { libm::powf(area, -concavity) }
}

impl Round {
    /// Begins at all outlets. `area` is the area that each parcel drained in the previous round, 1 or more. Outlets that are
    /// closed are for parcels without another.
    pub fn new(parcels: &Parcels, area: &[f32], is_closed: &[bool], concavity: f32) -> Result<Self, Refused> {
        let count = parcels.len();
        work::count(count);
        let way = |&area: &f32| Way { cost: f32::INFINITY, slope: slope(area, concavity) };
        let mut this = Self {
            ways: area.iter().map(way).collect(),
            queue: Queue::default(),
            directions: FlowDirections::new(count),
        };
        this.queue.reserve(parcels.outlets.len())?;
        for (outlet, is_closed) in parcels.outlets.iter().zip(is_closed) {
            let parcel = outlet.parcel as usize;
            let toll = if *is_closed { CLOSED } else { 1.0 };
            let cost = toll * parcels.cost_out(parcel) * this.ways[parcel].slope;
            (this.ways[parcel].cost, this.directions.to[parcel]) = (cost, FlowDirections::OUT);
            this.queue.push(cost, outlet.parcel);
        }
        Ok(this)
    }

    /// Settles `count` more parcels. Returns `true` if there may be more.
    pub fn advance(&mut self, parcels: &Parcels, count: usize) -> Result<bool, Refused> {
        self.queue.reserve(6 * count)?;
        work::count(6 * count);
        let mut left = count;
        while left > 0 {
            let Some(here) = self.queue.pop() else { return Ok(false) };
            if !self.ways[here as usize].is_settled() {
                self.settle(parcels, here);
                left -= 1;
            }
        }
        Ok(true)
    }

    fn settle(&mut self, parcels: &Parcels, here: u32) {
        self.directions.order.push(here);
        let way = &mut self.ways[here as usize];
        way.slope = f32::INFINITY;
        let cost = way.cost;
        for (there, crossing) in parcels.ways_to(here as usize) {
            let next = &mut self.ways[there as usize];
            let through = cost + crossing * next.slope;
            if through < next.cost {
                next.cost = through;
                self.directions.to[there as usize] = here;
                self.queue.push(through, there);
            }
        }
    }

    /// Returns the flow directions of all parcels, once the round is over.
    pub fn into_directions(self) -> FlowDirections {
        self.directions
    }

    /// Iterates over the cost of each parcel's cheapest known way.
    #[cfg(test)]
    pub fn costs(&self) -> impl Iterator<Item = f32> {
        self.ways.iter().map(|way| way.cost)
    }

    /// Returns the flow directions as far as they are known.
    pub fn directions(&self) -> &FlowDirections {
        &self.directions
    }
}
