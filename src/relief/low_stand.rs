//! The coarse relief of a low stand, from which the coast follows once the sea rises.
//!
//! It is one march from the coast over the corners of the land's own lattice. Every height comes from a lower neighbour,
//! so there is no pit, and water that rises is always connected. The recipe's keys of relief have no part in it: they
//! never move the coast.

use std::sync::Arc;

use super::cells::Cells;
use super::march::{March, Sources};
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
    march: March,
    /// No river is a source.
    rivers: Vec<f32>,
}

/// How many entries of its queue the front moves on by in a step.
const ENTRIES_A_STEP: usize = 40_000;

impl LowStandRelief {
    /// The usual hillsides of a recipe on the land of its low stand.
    pub fn new(recipe: &Recipe, land: &Arc<Land>) -> Result<Self, Refused> {
        let settings = ReliefSettings::new(recipe, None, 1).with_usual_slopes();
        let cells = Cells::of_corners(land.coast_distance())?;
        let steepness = Steepness::of_hillsides(&settings, &cells)?;
        let march = March::new(cells.inland.len())?;
        let mut rivers = Vec::new();
        lengthen(&mut rivers, cells.inland.len(), f32::INFINITY)?;
        Ok(Self { land: land.clone(), cells, steepness, march, rivers })
    }

    /// Raises the land's ridges. Goes on from a piece of them; returns the next, as long as there are more.
    pub fn raise_ridges(&mut self, from: usize) -> Option<usize> {
        self.steepness.raise_ridges(&self.cells, &self.land, from)
    }

    /// Makes the land at each corner so many times as steep.
    pub fn steepen(&mut self, times: impl Fn(usize) -> f32) {
        work::count(self.cells.inland.len());
        for cell in self.cells.land() {
            self.steepness.rises[cell] *= times(self.cells.without_rim(cell));
        }
    }

    /// Sends the front out from the coast.
    pub fn start(&mut self) {
        let (march, sources) = self.march();
        march.restart(&sources);
    }

    /// Moves the front on. Returns `true` if there is more to do.
    pub fn advance(&mut self) -> bool {
        let (march, sources) = self.march();
        march.advance(&sources, ENTRIES_A_STEP)
    }

    fn march(&mut self) -> (&mut March, Sources<'_>) {
        let Self { cells, steepness, march, rivers, .. } = self;
        (march, Sources { cells, rises: &steepness.rises, rivers, rivers_are_final: false })
    }

    /// The height of each corner above the low stand, in units; of the sea, its distance from the coast, negative.
    pub fn heights(&self) -> Vec<f32> {
        let Cells { columns, rows, .. } = self.cells;
        let inside = (1..rows - 1).flat_map(|row| row * columns + 1..(row + 1) * columns - 1);
        // Land that no water can leave stays above any sea.
        const HIGH: f32 = 1e4;
        let height = |cell: usize| match self.cells.is_land(cell) {
            true => self.march.heights[cell].min(HIGH),
            false => self.cells.inland[cell],
        };
        inside.map(height).collect()
    }
}
