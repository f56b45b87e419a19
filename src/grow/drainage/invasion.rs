//! An invasion of the land by the sea (invasion percolation: Wilkinson and Willemsen 1983): the lowest parcel beside what is invaded is
//! invaded next, and drains to the one it was reached from. Its areas are where valleys lie.
//!
//! A parcel comes in by its own height, never by that of the level that has been flooded: flooding a hollow at one level would fill it as
//! a front does, from all sides.

use super::directions::{FlowDirections, NONE};
use super::parcels::{DEVIATION, Parcels};
use super::queue::Queue;
use super::settings::DrainageSettings;
use crate::memory::Refused;
use crate::random::Purpose;
use crate::work;

/// How far chance of its own raises a parcel, against noise of the valleys' wavelength from −1 to 1.
const CHANCE: f32 = 0.45;

/// The octaves of the ground, down to a wavelength of about two parcels.
const OCTAVES: i32 = 5;
const GAIN: f32 = 0.65;

/// How much higher the ground is at a border where land runs on.
const BORDER: f32 = 2.0;

/// How much lower the ground is along a drawn river: lower than any other.
const STEM: f32 = 20.0;

/// An invasion in progress.
#[derive(Clone, Debug)]
pub(super) struct Invasion {
    height: Vec<f32>,
    frontier: Queue,
    directions: FlowDirections,
}

impl Invasion {
    /// Begins at all outlets.
    pub fn new(parcels: &Parcels, settings: &DrainageSettings) -> Result<Self, Refused> {
        Self::over(heights(parcels, settings), parcels)
    }

    /// Begins at all outlets of parcels of these heights.
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

    /// Invades `count` more parcels. Returns whether there are more.
    pub fn advance(&mut self, parcels: &Parcels, count: usize) -> Result<bool, Refused> {
        self.frontier.reserve(6 * count)?;
        work::count(6 * count);
        for _ in 0..count {
            let Some(here) = self.frontier.pop() else { return Ok(false) };
            self.directions.order.push(here);
            for there in parcels.neighbours[here as usize].into_iter().filter(|&there| there != NONE) {
                if self.directions.to[there as usize] == NONE {
                    self.directions.to[there as usize] = here;
                    self.frontier.push(self.height[there as usize], there);
                }
            }
        }
        Ok(true)
    }

    /// How each parcel drains.
    pub fn into_directions(self) -> FlowDirections {
        self.directions
    }
}

/// The heights that are invaded, before any river has worn them down: fractal noise, chance, and a rise away from the outlets.
pub(super) fn heights(parcels: &Parcels, settings: &DrainageSettings) -> Vec<f32> {
    let noise = settings.noise(3, settings.valley_spacing, OCTAVES, GAIN);
    let chance = settings.seed.item_hash(Purpose::Ground);
    let distance = distances(parcels);
    let tilt = settings.spacing / settings.valley_spacing;
    (0..parcels.len())
        .map(|i| {
            let (at, [column, row]) = (parcels.at[i], parcels.identity[i]);
            let own = CHANCE * (2.0 * chance.unit([column, row, 1]) - 1.0);
            let border = BORDER * parcels.border[i] + STEM * (parcels.toll[i] - 1.0);
            DEVIATION * noise.get_noise_2d(at.x, at.y) + own + tilt * distance[i] as f32 + border
        })
        .collect()
}

/// How many parcels away the nearest outlet is.
fn distances(parcels: &Parcels) -> Vec<u32> {
    let mut distance = vec![u32::MAX; parcels.len()];
    let mut reached: Vec<u32> = parcels.outlets.iter().map(|outlet| outlet.parcel).collect();
    reached.iter().for_each(|&parcel| distance[parcel as usize] = 0);
    let mut next = 0;
    while let Some(&here) = reached.get(next) {
        next += 1;
        for there in parcels.neighbours[here as usize].into_iter().filter(|&there| there != NONE) {
            if distance[there as usize] == u32::MAX {
                distance[there as usize] = distance[here as usize] + 1;
                reached.push(there);
            }
        }
    }
    work::count(6 * reached.len());
    distance
}
