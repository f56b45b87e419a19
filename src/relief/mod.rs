//! Relief: the height field that belongs to a finished network.
//!
//! Height is the cost of walking up from the sea, where hillsides are steep and rivers cost little: the eikonal equation
//! |∇h| = s(x) with the coast and the rivers as sources (Sethian 1996), and no river higher than upstream. Each cell takes
//! its height from a lower neighbour, so there is no pit. High ground is worn, which keeps that order.
//!
//! ```text
//! land ────► steepness ─┬─► profiles ─► rivers on cells ─┐
//! network ──────────────┘                                ├─► front ─► wear ─► rivers fall ─► creep
//! trimmed tree ─► rills ─► steepness, carved ────────────┘
//! ```

mod beds;
mod cells;
mod channels;
mod contours;
mod creep;
mod draft;
mod error;
mod falling;
mod finer;
mod flow;
mod front;
mod grid;
mod hillsides;
mod low_stand;
mod profile;
mod rain;
mod rill_cells;
mod rills;
mod settings;
mod solver;
mod steepness;
mod summits;
#[cfg(test)]
mod tests;

use glam::Vec2;

use crate::base::sort::quantile;
use crate::network::Network;

pub(crate) use draft::ReliefDrafts;
pub use error::ReliefError;
pub use falling::let_fall;
pub use flow::Flow;
pub(crate) use flow::rings_around;
pub use grid::Grid;
pub(crate) use low_stand::LowStandRelief;
pub(crate) use rain::{Rainfall, Wind};
pub(crate) use rills::Rills;
pub use settings::ReliefSettings;
pub use solver::ReliefSolver;

/// The side of a cell of a map's own grid, in units.
pub const CELL_SIZE: f32 = 2.0;

/// The heights of the cells of a grid, row by row, from north to south.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    grid: Grid,
    heights: Vec<f32>,
}

impl Relief {
    /// Solves the relief of some rivers in one go. [`ReliefSolver`] does it in steps.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn of(network: &Network, settings: ReliefSettings) -> Result<Self, ReliefError> {
        let mut solver = ReliefSolver::new(network, settings)?;
        loop {
            if let Some(relief) = solver.step(network)? {
                return Ok(relief);
            }
        }
    }

    /// Makes the relief of a map from its heights, in units; `None` unless there is one for each cell of the map's own grid.
    #[cfg(test)]
    pub(crate) fn of_heights(domain: &crate::domain::Domain, heights: Vec<f32>) -> Option<Self> {
        let grid = Grid::of(domain);
        (heights.len() == grid.columns * grid.rows).then_some(Self { grid, heights })
    }

    /// Makes a relief from the heights of the cells of a grid, in units, one for each.
    pub(crate) fn on(grid: Grid, heights: Vec<f32>) -> Self {
        Self { grid, heights }
    }

    /// Gives away the heights of the cells, in units.
    pub(crate) fn into_heights(self) -> Vec<f32> {
        self.heights
    }

    /// Returns the number of cells in a row. The last may reach over the map's border.
    pub fn columns(&self) -> usize {
        self.grid.columns
    }

    /// Returns the number of rows.
    pub fn rows(&self) -> usize {
        self.grid.rows
    }

    /// Returns the grid of cells.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Returns the side of a cell, in units.
    pub fn cell_size(&self) -> f32 {
        self.grid.cell_size
    }

    /// Returns the height of each cell over the sea, in units, row by row: positive on land, 0 or less at sea.
    pub fn heights(&self) -> &[f32] {
        &self.heights
    }

    /// Returns the height that a share of all land lies below, in units; 0 without land.
    pub fn quantile(&self, share: f32) -> f32 {
        // A seventh of the cells will do.
        let some: Vec<f32> = self.heights.iter().copied().filter(|height| *height > 0.0).step_by(7).collect();
        quantile(&some, share)
    }

    /// Returns the height of the cell at a point, in units.
    pub fn at(&self, point: Vec2) -> f32 {
        self.heights[self.cell(point)]
    }

    /// Returns the cell at a point; the nearest for a point beyond the map.
    pub(crate) fn cell(&self, point: Vec2) -> usize {
        let Grid { cell_size, columns, rows } = self.grid;
        let index = |x: f32, count: usize| ((x / cell_size) as usize).min(count - 1);
        index(point.y, rows) * columns + index(point.x, columns)
    }
}
