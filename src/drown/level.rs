//! The level to which the sea rises: the one at which it covers the share of the map that the recipe asks for.

use super::rias::{self, Silted};
use super::silt::{self, GreatRivers};
use crate::base::memory::{Refused, ask, lengthen};
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
    /// The share of the domain that is to be sea.
    sea: f32,
    /// The share of sea by a rough coast less that by the exact one, as far as it is known.
    offset: f32,
    /// The share of heights below the level that is tried next.
    share: f32,
    /// The share of heights of the try before, with the share of sea that it gave.
    before: Option<(f32, f32)>,
    stage: Stage,
    /// The number of levels that have been tried in this stage, and of coasts that have been traced.
    tries: u32,
    traces: u32,
    /// The sediment with which rivers fill their rias; `None` if they carry none.
    sediment: Option<Sediment>,
    /// The rias that have been filled.
    silted: Silted,
}

/// How far the search has come.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// A level is sought over the ground as it was.
    Bare,
    /// Room is left for deltas, so a level a little higher is sought.
    Roomy,
    /// Rivers have filled what they fill, and a level is sought for which the coast is to be traced.
    Silted,
    /// The exact coast is traced.
    Traced,
}

/// The greatest difference from the share of sea asked for that is near enough.
const NEAR: f32 = 5e-4;

/// The greatest number of levels that are tried in a stage, and the greatest number of coasts that are traced.
const TRIES: u32 = 6;
const TRACES: u32 = 4;

impl Level {
    /// Begins the search for the level at which the sea covers a share of the domain.
    pub fn new(low_stand: &Land, heights: Vec<f32>, sea: f32) -> Result<Self, Refused> {
        /// Two entries, each of a key and a place, then a corner with its count, and the counts.
        const BYTES_A_CORNER: usize = 48;
        ask(heights.len() * BYTES_A_CORNER)?;
        let sorted = sort_corners(low_stand, &heights);
        Ok(Self {
            heights,
            sorted,
            sea,
            offset: 0.0,
            share: sea,
            before: None,
            stage: Stage::Bare,
            tries: 0,
            traces: 0,
            sediment: None,
            silted: Silted::default(),
        })
    }

    /// Lets great rivers fill their rias with sediment.
    #[must_use]
    pub fn with_sediment(self, sediment: Option<Sediment>) -> Self {
        Self { sediment, ..self }
    }

    /// Tries a level. Returns it, and the land above it, if the share of sea is right; the exact coast is traced only
    /// for a level that is nearly right, after rivers have silted up the inlets where they meet.
    ///
    /// # Errors
    /// If there is not enough memory to fill rias.
    pub fn advance(&mut self, low_stand: &Land, rivers: &GreatRivers) -> Result<Option<(f32, Land)>, Refused> {
        // Below the low stand the sea would have to fall.
        let level = self.quantile(self.share).max(0.0);
        if self.stage == Stage::Traced {
            return Ok(self.trace(low_stand, level).map(|land| (level, land)));
        }
        let share = RisenSea::new(low_stand, &self.heights, level).share();
        if self.is_right(share) || self.tries == TRIES || level == 0.0 {
            self.stage = self.go_on(low_stand, rivers, level)?;
            (self.tries, self.before) = (0, None);
        }
        Ok(None)
    }

    /// Does what follows once a level is nearly right. Returns the stage that begins.
    fn go_on(&mut self, low_stand: &Land, rivers: &GreatRivers, level: f32) -> Result<Stage, Refused> {
        if self.stage == Stage::Silted {
            return Ok(Stage::Traced);
        }
        // Rivers silt up where the sea will stand in the end: it would drown valleys anew if it rose later.
        if self.stage == Stage::Bare && self.leave_room(low_stand, rivers, level)? {
            return Ok(Stage::Roomy);
        }
        let has_silt = rivers.silt_up(low_stand.coast_distance(), &mut self.heights, level);
        let has_plains = self.fill_rias(low_stand, rivers, level)?;
        if has_silt || has_plains {
            self.sorted = sort_corners(low_stand, &self.heights);
        }
        Ok(Stage::Silted)
    }

    /// Traces the coast at a level. Returns the land if its share of sea is right; otherwise the search goes on.
    fn trace(&mut self, low_stand: &Land, level: f32) -> Option<Land> {
        silt::fill_ponds(low_stand.coast_distance(), &mut self.heights, level);
        let sea = RisenSea::new(low_stand, &self.heights, level);
        let rough = sea.share();
        let land = sea.into_land();
        let off = self.sea - land.share_of_sea();
        self.traces += 1;
        if off.abs() < NEAR || self.traces == TRACES || level == 0.0 {
            return Some(land);
        }
        self.offset = rough - land.share_of_sea();
        self.share = (self.share + off).clamp(0.0, 1.0);
        self.stage = Stage::Silted;
        None
    }

    /// Leaves room for the deltas that rivers will build at a level that is nearly right. Returns `true` if there will be any.
    fn leave_room(&mut self, low_stand: &Land, rivers: &GreatRivers, level: f32) -> Result<bool, Refused> {
        let Some(sediment) = &self.sediment else { return Ok(false) };
        let mut heights = Vec::new();
        lengthen(&mut heights, self.heights.len(), 0.0)?;
        heights.copy_from_slice(&self.heights);
        let silted = rias::fill(rivers, sediment, low_stand.coast_distance(), &mut heights, level)?;
        let room = expected_area(&silted.loads) / (low_stand.size().x * low_stand.size().y);
        self.sea += room;
        self.share = (self.share + room).min(1.0);
        Ok(room > 0.0)
    }

    /// Fills rias at a level that is nearly right. Returns `true` if heights may have changed.
    fn fill_rias(&mut self, low_stand: &Land, rivers: &GreatRivers, level: f32) -> Result<bool, Refused> {
        let Some(sediment) = &self.sediment else { return Ok(false) };
        self.silted = rias::fill(rivers, sediment, low_stand.coast_distance(), &mut self.heights, level)?;
        Ok(true)
    }

    /// Takes the rias that rivers have filled.
    pub fn take_silted(&mut self) -> Silted {
        std::mem::take(&mut self.silted)
    }

    /// Returns `true` if a share of sea by a rough coast is near enough to what is asked for. Prepares the next try, which is nearer.
    fn is_right(&mut self, share: f32) -> bool {
        /// The least and the greatest share of heights by which more sea is sought for a share of sea that is lacking.
        const GAIN: (f32, f32) = (0.5, 8.0);
        let off = self.sea + self.offset - share;
        let gain = match self.before {
            Some((heights, sea)) if share != sea => ((self.share - heights) / (share - sea)).clamp(GAIN.0, GAIN.1),
            _ => 1.0,
        };
        self.before = Some((self.share, share));
        self.share = (self.share + gain * off).clamp(0.0, 1.0);
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
