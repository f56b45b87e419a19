//! The relief on a finer grid, for files: hillsides are solved anew, and rivers stay as high as on the map's own grid,
//! except where they would stand on dams.

use glam::Vec2;

use super::channels::parents_first;
use super::{Relief, ReliefError, ReliefSettings, ReliefSolver};
use crate::base::geometry::lengths;
use crate::base::memory::{Refused, lengthen};
use crate::network::{Network, River};

impl Relief {
    /// Solves the relief of the same rivers on the grid of `settings`, which otherwise have to be those of this relief.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn on_grid_of(&self, network: &Network, settings: ReliefSettings) -> Result<Self, ReliefError> {
        let bytes = network.vertices.len() * size_of::<f32>();
        let refused = |_| ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
        let water = Water::new(self, network).map_err(refused)?;
        let mut solver = ReliefSolver::with_water(network, settings, water.heights)?;
        loop {
            if let Some(relief) = solver.step(network)? {
                return Ok(relief);
            }
        }
    }
}

/// The height of the water at each vertex, in units, read from a relief.
struct Water<'a> {
    relief: &'a Relief,
    heights: Vec<f32>,
}

impl<'a> Water<'a> {
    fn new(relief: &'a Relief, network: &Network) -> Result<Self, Refused> {
        let mut this = Self { relief, heights: Vec::new() };
        lengthen(&mut this.heights, network.vertices.len(), 0.0)?;
        for river in parents_first(network)? {
            let river = &network.rivers[river as usize];
            this.follow(river, &network.places(river));
        }
        Ok(this)
    }

    /// Sets the heights along a river, which leaves each cell of the relief at the height of that cell. In between it
    /// falls evenly, not in steps from cell to cell.
    fn follow(&mut self, river: &River, course: &[Vec2]) {
        let along = lengths(course);
        let mut upper: Option<(usize, f32)> = None;
        for (place, height) in self.known(river, course) {
            let (first, from) = upper.unwrap_or((0, height));
            let way = along[place] - along[first];
            for i in first..=place {
                let share = if way > 0.0 { (along[i] - along[first]) / way } else { 1.0 };
                // A junction is a vertex of the river that is joined, and keeps its height.
                if let Some(own) = self.heights[river.vertex_range()].get_mut(i) {
                    *own = from + (height - from) * share;
                }
            }
            upper = Some((place, height));
        }
    }

    /// Lists the indices in a course at which a river leaves a cell of land, and its end, each with the height there,
    /// in units.
    fn known(&self, river: &River, course: &[Vec2]) -> Vec<(usize, f32)> {
        let cells: Vec<usize> = course.iter().map(|&at| self.relief.cell(at)).collect();
        let height = |cell: usize| self.relief.heights[cell];
        let leaves = cells.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1] && height(pair[0]) > 0.0);
        let mut known: Vec<_> = leaves.map(|(place, pair)| (place, height(pair[0]))).collect();
        if let Some(&cell) = cells.last() {
            let junction = self.heights.get(river.junction as usize);
            known.push((course.len() - 1, junction.copied().unwrap_or(height(cell).max(0.0))));
        }
        known
    }
}
