//! The level to which the sea rises: the one at which it covers the share of the map that the recipe asks for.

use crate::base::memory::{Refused, ask};
use crate::base::sort;
use crate::base::work;
use crate::domain::Domain;
use crate::land::{Land, LowStand, above};

/// The search for a level, in heights at the corners of a lattice.
#[derive(Clone, Debug)]
pub(super) struct Level {
    heights: Vec<f32>,
    /// In ascending order, each as often as its corner counts.
    sorted: Vec<f32>,
    /// The share of heights below the level that is tried next.
    share: f32,
    tries: u32,
}

/// The difference between the share of sea and what is asked for that is near enough.
const NEAR: f32 = 5e-4;

/// How many levels are tried at most.
const TRIES: u32 = 4;

impl Level {
    /// Sorts the heights of a low stand.
    pub fn new(low_stand: &LowStand, heights: Vec<f32>) -> Result<Self, Refused> {
        /// For each corner: four values, each with its key and place, twice.
        const BYTES_A_CORNER: usize = 160;
        ask(heights.len() * BYTES_A_CORNER)?;
        work::count(4 * heights.len());
        let domain = Domain { size: low_stand.land.size() };
        let sorted = sort::sorted(&low_stand.land.coast_distance().by_area(&domain, &heights));
        Ok(Self { heights, sorted, share: low_stand.sea, tries: 0 })
    }

    /// Tries a level. Returns the land above it if it leaves the right share.
    pub fn advance(&mut self, low_stand: &LowStand) -> Option<Land> {
        let index = (self.share * self.sorted.len().saturating_sub(1) as f32) as usize;
        // Below the low stand the sea would have fallen.
        let level = self.sorted.get(index).copied().unwrap_or(0.0).max(0.0);
        let land = above(&low_stand.land, &self.heights, level);
        let off = low_stand.sea - land.share_of_sea();
        self.share = (self.share + off).clamp(0.0, 1.0);
        self.tries += 1;
        (off.abs() < NEAR || self.tries == TRIES || level == 0.0).then_some(land)
    }
}
