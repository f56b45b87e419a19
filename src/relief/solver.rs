//! The relief stage as a stepper: no step keeps a page waiting for long.

use thiserror::Error;

use super::Relief;
use super::cells::Cells;
use super::channels::Channels;
use super::march::March;
use super::settings::ReliefSettings;
use super::steepness::rises;
use crate::memory::{Refused, can_allocate};
use crate::network::Network;

/// Why there can be no relief.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReliefError {
    /// There was not enough memory.
    #[error("the relief needs about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// About how much is needed.
        megabytes: u32,
    },
}

/// A relief in the making.
#[derive(Clone, Debug)]
pub struct ReliefSolver {
    cells: Cells,
    /// By how much each cell rises over a neighbour, in units.
    rises: Vec<f32>,
    channels: Channels,
    /// The heights of the final rivers; infinite elsewhere.
    held: Option<Vec<f32>>,
    march: March,
    passes: u32,
}

/// How many cells a step passes.
const CELLS_A_STEP: usize = 20_000;

/// How often rivers are lowered at most.
const MOST_PASSES: u32 = 5;

impl ReliefSolver {
    /// Begins the relief of a finished network.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(network: &Network, settings: &ReliefSettings) -> Result<Self, ReliefError> {
        const BYTES_A_CELL: usize = 64;
        let cells = Cells::new(settings);
        let bytes = cells.inland.len() * BYTES_A_CELL + network.vertices.len() * 40;
        let refused = ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
        if !can_allocate(bytes) {
            return Err(refused);
        }
        let rises = rises(settings, &cells, network);
        let channels = Channels::new(&cells, network, settings.total_discharge);
        let march = March::default();
        let mut this = Self { cells, rises, channels, held: None, march, passes: 0 };
        this.set_out().map_err(|_| refused)?;
        Ok(this)
    }

    /// Makes a step. Returns the relief, once it is finished.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn step(&mut self) -> Result<Option<Relief>, ReliefError> {
        if self.march.advance(&self.cells, &self.rises, self.held.as_deref(), CELLS_A_STEP) {
            return Ok(None);
        }
        if self.held.is_some() {
            return Ok(Some(self.finished()));
        }
        let megabytes = (self.cells.inland.len() * 16 / 1_000_000) as u32 + 1;
        self.lower_rivers().map_err(|_| ReliefError::OutOfMemory { megabytes })?;
        Ok(None)
    }

    /// A wave has passed everything: rivers that stand higher than the land are lowered, and it sets out once more.
    fn lower_rivers(&mut self) -> Result<(), Refused> {
        /// So little a cell of river, in units, is as good as nothing.
        const ENOUGH: f32 = 0.01;
        let lowered = self.channels.lower(&self.march.height);
        self.passes += 1;
        if lowered < ENOUGH * self.channels.steps().count() as f32 || self.passes == MOST_PASSES {
            self.channels.meet(self.cells.inland.len());
            self.channels.let_fall();
            let mut held = vec![f32::INFINITY; self.cells.inland.len()];
            for (cell, height) in self.channels.steps().filter(|&(cell, _)| self.cells.is_land(cell)) {
                held[cell] = held[cell].min(height);
            }
            self.held = Some(held);
        }
        self.set_out()
    }

    fn set_out(&mut self) -> Result<(), Refused> {
        self.march = March::new(&self.cells, &self.rises, self.held.as_deref())?;
        if self.held.is_none() {
            let steps = self.channels.steps().filter(|&(cell, _)| self.cells.is_land(cell));
            steps.for_each(|(cell, height)| self.march.reach(cell, height));
        }
        Ok(())
    }

    fn finished(&self) -> Relief {
        let Cells { columns, rows, .. } = self.cells;
        let height = |cell: usize| {
            if self.cells.is_land(cell) { self.march.height[cell] } else { depth(self.cells.inland[cell]) }
        };
        let inside = (1..rows - 1).flat_map(|row| (1..columns - 1).map(move |column| row * columns + column));
        Relief { columns: columns - 2, rows: rows - 2, heights: inside.map(height).collect() }
    }
}

/// The height of the sea's ground at a distance from the coast, which is negative there: it falls to this depth.
fn depth(inland: f32) -> f32 {
    const DEEPEST: f32 = 12.0;
    const FAR: f32 = 80.0;
    DEEPEST * (libm::expf(inland / FAR) - 1.0)
}
