//! An invasion of the land by the sea (invasion percolation: Wilkinson and Willemsen 1983). The lowest parcel beside
//! the invaded ones is invaded next, and drains to the one it was reached from. Its areas show where valleys lie.
//!
//! The order follows a parcel's own height, not the level that has been flooded: flooding a hollow at one level would
//! fill it like a front, from all sides.

use super::directions::{FlowDirections, NONE};
use super::heights::heights;
use super::parcels::Parcels;
use crate::base::memory::Refused;
use crate::base::queue::Queue;
use crate::base::work;
use crate::grow::GrowthSettings;

/// An invasion in progress.
#[derive(Clone, Debug)]
pub(super) struct Invasion {
    height: Vec<f32>,
    frontier: Queue,
    directions: FlowDirections,
}

impl Invasion {
    /// Begins at all outlets.
    pub fn new(settings: &GrowthSettings, parcels: &Parcels) -> Result<Self, Refused> {
        Self::over(heights(settings, parcels), parcels)
    }

    /// Begins at all outlets of parcels with these heights.
    pub fn over(height: Vec<f32>, parcels: &Parcels) -> Result<Self, Refused> {
        let directions = FlowDirections::new(parcels.len());
        let mut this = Self { height, frontier: Queue::default(), directions };
        this.frontier.reserve(parcels.outlets.len())?;
        for outlet in &parcels.outlets {
            this.frontier.push(this.height[outlet.parcel as usize], outlet.parcel);
            this.directions.to[outlet.parcel as usize] = FlowDirections::OUT;
        }
        Ok(this)
    }

    /// Invades `count` more parcels. Returns `true` if there are more.
    pub fn advance(&mut self, parcels: &Parcels, count: usize) -> Result<bool, Refused> {
        self.frontier.reserve(6 * count)?;
        work::count(6 * count);
        for _ in 0..count {
            let Some(here) = self.frontier.pop() else { return Ok(false) };
            self.directions.order.push(here);
            for &there in parcels.neighbours.of(here as usize) {
                if self.directions.to[there as usize] == NONE {
                    self.directions.to[there as usize] = here;
                    self.frontier.push(self.height[there as usize], there);
                }
            }
        }
        Ok(true)
    }

    /// Returns the flow directions of all parcels.
    pub fn into_directions(self) -> FlowDirections {
        self.directions
    }
}
