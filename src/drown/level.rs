//! The level to which the sea rises: the one at which it covers the share of the map that the recipe asks for.

use super::rias::{self, Silted};
use super::silt::{self, GreatRivers};
use crate::base::memory::{Refused, ask};
use crate::base::sort;
use crate::base::work;
use crate::deltas::{Sediment, expected_area};
use crate::domain::Domain;
use crate::land::{Land, RisenSea};

/// The search for a level, over the heights at the corners of a low stand's lattice.
#[derive(Clone, Debug)]
pub(super) struct Level {
    heights: Vec<f32>,
    /// The corners in ascending order of their heights, each with its weight: the number of squares around it in the domain.
    sorted: Vec<(u32, u32)>,
    /// The share of the domain that is to be sea, and the share of heights below the level that is tried next.
    sea: f32,
    share: f32,
    tries: u32,
    /// `true` until a level is nearly right.
    is_rough: bool,
    /// The sediment with which rivers fill their rias; `None` if they carry none.
    sediment: Option<Sediment>,
    /// The rias that have been filled.
    silted: Silted,
}

/// The greatest difference from the share of sea asked for that is near enough.
const NEAR: f32 = 5e-4;

/// The greatest number of levels that are tried.
const TRIES: u32 = 6;

impl Level {
    /// Begins the search for the level at which the sea covers a share of the domain.
    pub fn new(low_stand: &Land, heights: Vec<f32>, sea: f32) -> Result<Self, Refused> {
        /// Two entries, each of a key and a place, then a corner with its count, and the counts.
        const BYTES_A_CORNER: usize = 48;
        ask(heights.len() * BYTES_A_CORNER)?;
        let sorted = sort_corners(low_stand, &heights);
        let silted = Silted::default();
        Ok(Self { heights, sorted, sea, share: sea, tries: 0, is_rough: true, sediment: None, silted })
    }

    /// Lets great rivers fill their rias with sediment.
    #[must_use]
    pub fn with_sediment(self, sediment: Option<Sediment>) -> Self {
        Self { sediment, ..self }
    }

    /// Tries a level. Returns it, and the land above it, if the share of sea is right; the exact coast is traced only
    /// once a level is nearly right, and rivers have silted up the inlets where they meet.
    ///
    /// # Errors
    /// If there is not enough memory to fill rias.
    pub fn advance(&mut self, low_stand: &Land, rivers: &GreatRivers) -> Result<Option<(f32, Land)>, Refused> {
        // Below the low stand the sea would have to fall.
        let level = self.quantile(self.share).max(0.0);
        if !self.is_rough {
            silt::fill_ponds(low_stand.coast_distance(), &mut self.heights, level);
        }
        let sea = RisenSea::new(low_stand, &self.heights, level);
        let is_last = level == 0.0 || self.tries + 1 == TRIES;
        if self.is_rough && !is_last {
            self.is_rough = !self.is_right(sea.share());
            if !self.is_rough {
                let has_silt = rivers.silt_up(low_stand.coast_distance(), &mut self.heights, level);
                let has_plains = self.fill_rias(low_stand, rivers, level)?;
                if has_silt || has_plains {
                    self.sorted = sort_corners(low_stand, &self.heights);
                }
            }
            return Ok(None);
        }
        let land = sea.into_land();
        Ok((self.is_right(land.share_of_sea()) || is_last).then_some((level, land)))
    }

    /// Fills rias at a level that is nearly right, and leaves room for deltas. Returns `true` if heights may have changed.
    fn fill_rias(&mut self, low_stand: &Land, rivers: &GreatRivers, level: f32) -> Result<bool, Refused> {
        let Some(sediment) = &self.sediment else { return Ok(false) };
        self.silted = rias::fill(rivers, sediment, low_stand.coast_distance(), &mut self.heights, level)?;
        self.sea += expected_area(&self.silted.loads) / (low_stand.size().x * low_stand.size().y);
        Ok(true)
    }

    /// Takes the rias that rivers have filled.
    pub fn take_silted(&mut self) -> Silted {
        std::mem::take(&mut self.silted)
    }

    /// Returns `true` if a share of sea is near enough to what is asked for. Prepares the next try, which is nearer.
    fn is_right(&mut self, share: f32) -> bool {
        let off = self.sea - share;
        self.share = (self.share + off).clamp(0.0, 1.0);
        self.tries += 1;
        off.abs() < NEAR
    }

    /// Returns the heights at the corners, in units.
    pub fn into_heights(self) -> Vec<f32> {
        self.heights
    }

    /// Returns the heights at the corners, in units.
    #[cfg(test)]
    pub fn heights(&self) -> &[f32] {
        &self.heights
    }

    /// Returns the height that a share of the domain lies below, in units.
    fn quantile(&self, share: f32) -> f32 {
        let all: u32 = self.sorted.iter().map(|(_, squares)| squares).sum();
        let wanted = (share * all as f32) as u32;
        let mut below = 0;
        let is_reached = |(_, squares): &&(u32, u32)| {
            below += squares;
            below > wanted
        };
        let found = self.sorted.iter().find(is_reached).or(self.sorted.last());
        found.map_or(0.0, |(corner, _)| self.heights[*corner as usize])
    }
}

/// Sorts the corners of a low stand by their heights, each with the number of squares around it in the domain.
fn sort_corners(low_stand: &Land, heights: &[f32]) -> Vec<(u32, u32)> {
    work::count(3 * heights.len());
    let squares = low_stand.coast_distance().squares_around(&Domain { size: low_stand.size() });
    let order = sort::argsort(heights.iter().map(|&height| sort::key(height)));
    order.into_iter().map(|corner| (corner as u32, squares[corner])).collect()
}
