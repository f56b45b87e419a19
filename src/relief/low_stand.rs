//! The coarse relief of a low stand, from which the coast follows once the sea rises.
//!
//! A front marches once from the coast over the corners of the land's own lattice. Every height comes from a lower
//! neighbour, so there is no pit, and water that rises is always connected. The recipe's keys of relief have no part in
//! it: they never move the coast.

use std::num::NonZero;
use std::sync::Arc;

use super::cells::Cells;
use super::front::{Front, TILE};
use super::settings::ReliefSettings;
use super::steepness::Steepness;
use crate::base::memory::{Refused, lengthen};
use crate::base::work;
use crate::land::Land;
use crate::recipe::Recipe;

/// The relief of a low stand in the making.
#[derive(Clone, Debug)]
pub(crate) struct LowStandRelief {
    land: Arc<Land>,
    cells: Cells,
    steepness: Steepness,
    front: Front,
}

/// The number of entries of its queue by which the front moves on in a step.
const ENTRIES_A_STEP: usize = 40_000;

/// The number of threads.
const ONE: NonZero<usize> = NonZero::<usize>::MIN;

impl LowStandRelief {
    /// Prepares the relief of a recipe's low stand, with the usual hillsides.
    pub fn new(recipe: &Recipe, land: &Arc<Land>) -> Result<Self, Refused> {
        let settings = ReliefSettings::new(recipe, Some(land.clone()), 1).of_low_stand();
        let cells = Cells::of_corners(land.coast_distance())?;
        let steepness = Steepness::of_hillsides(&settings, &cells)?;
        Ok(Self { land: land.clone(), cells, steepness, front: Front::default() })
    }

    /// Raises the land's ridges from a segment on. Returns the segment to go on from; `None` once all are raised.
    pub fn raise_ridges(&mut self, from: usize) -> Option<usize> {
        self.steepness.raise_ridges(&self.cells, &self.land, from)
    }

    /// Multiplies the steepness of the land at each corner by `times`, which is given the corner's index.
    pub fn steepen(&mut self, times: impl Fn(usize) -> f32) {
        work::count(self.cells.inland.len());
        for cell in self.cells.land() {
            self.steepness.rises[cell] *= times(self.cells.without_rim(cell));
        }
    }

    /// Starts the front at the coast.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn start(&mut self) -> Result<(), Refused> {
        let Self { cells, steepness, .. } = self;
        self.front = Front::new(cells, &steepness.rises, TILE, ONE)?;
        self.front.add_coast(cells, ONE);
        Ok(())
    }

    /// Moves the front on by some entries of its queue. Returns `true` if there is more to do.
    pub fn advance(&mut self) -> bool {
        self.front.advance(ENTRIES_A_STEP, ONE)
    }

    /// Returns the height of each corner above the low stand, in units; at sea, its distance from the coast, which is negative.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn heights(&self) -> Result<Vec<f32>, Refused> {
        let mut heights = Vec::new();
        lengthen(&mut heights, self.cells.inland.len(), f32::INFINITY)?;
        self.front.write(&mut heights, ONE);
        let Cells { columns, rows, .. } = self.cells;
        let inside = (1..rows - 1).flat_map(|row| row * columns + 1..(row + 1) * columns - 1);
        // The height of land that the front did not reach, since no water can leave it: above any sea.
        const HIGH: f32 = 1e4;
        let height = |cell: usize| match self.cells.is_land(cell) {
            true => heights[cell].min(HIGH),
            false => self.cells.inland[cell],
        };
        Ok(inside.map(height).collect())
    }
}
