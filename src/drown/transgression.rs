//! The transgression: the sea on its way from the low stand to its level. The land of a step is made only when somebody
//! looks at it, so a map that nobody watches pays nothing for the steps.

use std::sync::Arc;

use super::Drowned;
use crate::land::{Land, LowStand, RisenSea};

/// The rise of the sea in even steps to a level that is known.
#[derive(Clone, Debug)]
pub(crate) struct Transgression {
    low_stand: Arc<LowStand>,
    /// The heights of the low stand's corners, in units.
    heights: Vec<f32>,
    /// The height that the sea will reach, in units, and the land and valleys that it leaves there.
    level: f32,
    drowned: Drowned,
    step: u32,
}

impl Transgression {
    /// The number of steps from the low stand to the level. A picture of each takes about a fifteenth of a second.
    pub const STEPS: u32 = 12;

    /// Begins at the low stand, with the level to which the sea will rise over the given heights.
    pub(super) fn new(low_stand: Arc<LowStand>, heights: Vec<f32>, level: f32, drowned: Drowned) -> Self {
        Self { low_stand, heights, level, drowned, step: 0 }
    }

    /// Raises the sea by a step. From the last step on returns the land and valleys that the sea leaves.
    pub fn rise(&mut self) -> Option<&Drowned> {
        self.step = (self.step + 1).min(Self::STEPS);
        (self.step == Self::STEPS).then_some(&self.drowned)
    }

    /// Returns the number of steps made so far.
    pub fn step(&self) -> u32 {
        self.step
    }

    /// Returns the share of the rise that is over, from 0 to 1.
    pub fn share(&self) -> f32 {
        self.step as f32 / Self::STEPS as f32
    }

    /// Returns the land that lies above the sea now, which is known at both ends and else made.
    pub fn land(&self) -> Arc<Land> {
        match self.step {
            0 => self.low_stand.land.clone(),
            Self::STEPS => self.drowned.land.clone(),
            _ => self.land_at(self.share()).into(),
        }
    }

    /// Makes the land that lies above the sea after a share of the rise. The sea is slow at first, since the flat shelf
    /// would drown at once.
    pub(super) fn land_at(&self, share: f32) -> Land {
        let level = share * share.sqrt() * self.level;
        RisenSea::new(&self.low_stand.land, &self.heights, level).into_passing_land()
    }

    /// Returns the land and valleys that the sea leaves once it has risen.
    pub fn into_drowned(self) -> Drowned {
        self.drowned
    }

    /// Returns the memory of a copy, in bytes. Copies share their lands.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.heights[..])
    }
}
