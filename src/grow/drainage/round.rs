//! A round: every parcel finds the way to the sea that costs least (Dijkstra 1959, from all outlets at once), where a step costs the
//! less the more water there was in the round before: S = k A^−θ (Flint 1974), as in optimal channel networks
//! (Rodriguez-Iturbe, Rinaldo and others 1992).

use super::directions::{FlowDirections, NONE};
use super::parcels::Parcels;
use crate::memory::Refused;
use crate::queue::Queue;
use crate::work;

/// A round in progress.
#[derive(Clone, Debug)]
pub(super) struct Round {
    /// What the cheapest known way to the sea costs.
    pub cost: Vec<f32>,
    /// A^−θ of each parcel: the slope of the step down from it, but for the ground.
    slope: Vec<f32>,
    is_settled: Vec<bool>,
    queue: Queue,
    directions: FlowDirections,
}

impl Round {
    /// Begins at all outlets. `area` is what each parcel drained in the round before, at least 1.
    pub fn new(parcels: &Parcels, area: &[f32], concavity: f32) -> Result<Self, Refused> {
        let count = parcels.len();
        work::count(count);
        let mut this = Self {
            cost: vec![f32::INFINITY; count],
            slope: area.iter().map(|&area| libm::powf(area, -concavity)).collect(),
            is_settled: vec![false; count],
            queue: Queue::default(),
            directions: FlowDirections::new(count),
        };
        this.queue.reserve(parcels.outlets.len())?;
        for outlet in &parcels.outlets {
            let parcel = outlet.parcel as usize;
            let cost = parcels.cost_out(parcel) * this.slope[parcel];
            (this.cost[parcel], this.directions.to[parcel]) = (cost, FlowDirections::OUT);
            this.queue.push(cost, outlet.parcel);
        }
        Ok(this)
    }

    /// Settles `count` more parcels. Returns whether there may be more.
    pub fn advance(&mut self, parcels: &Parcels, count: usize) -> Result<bool, Refused> {
        self.queue.reserve(6 * count)?;
        work::count(6 * count);
        let mut left = count;
        while left > 0 {
            let Some(here) = self.queue.pop() else { return Ok(false) };
            if !std::mem::replace(&mut self.is_settled[here as usize], true) {
                self.settle(parcels, here);
                left -= 1;
            }
        }
        Ok(true)
    }

    fn settle(&mut self, parcels: &Parcels, here: u32) {
        self.directions.order.push(here);
        let cost = self.cost[here as usize];
        for (way, there) in parcels.neighbours[here as usize].into_iter().enumerate() {
            if there == NONE || self.is_settled[there as usize] {
                continue;
            }
            let through = cost + parcels.cost(here as usize, way) * self.slope[there as usize];
            if through < self.cost[there as usize] {
                (self.cost[there as usize], self.directions.to[there as usize]) = (through, here);
                self.queue.push(through, there);
            }
        }
    }

    /// How each parcel drains, once the round is over.
    pub fn into_directions(self) -> FlowDirections {
        self.directions
    }

    /// How each parcel drains, as far as is known.
    pub fn directions(&self) -> &FlowDirections {
        &self.directions
    }
}
