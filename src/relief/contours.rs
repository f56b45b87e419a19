//! Contours: the closed lines around all that is higher than some height.

use glam::Vec2;

use super::Relief;
use crate::land::trace::rings;

impl Relief {
    /// Traces closed contour lines around all land higher than a level, in units. Along the border they run a little
    /// outside of the map. Specks are left out.
    pub fn rings_above(&self, level: f32) -> Vec<Vec<Vec2>> {
        // The difference from the level, in units, beyond which heights no longer move the line.
        const FAR: f32 = 4.0;
        self.rings_around(self.heights.iter().map(|height| (height - level) / FAR))
    }

    /// Traces the rings around all cells with a value above 0. Values below -1 or above 1 count as -1 or 1.
    pub(crate) fn rings_around(&self, values: impl Iterator<Item = f32>) -> Vec<Vec<Vec2>> {
        /// The smallest area that gets a ring, as a share of the map: some ten cells.
        const SPECK: f32 = 4e-5;
        let share = |value: f32| (0.5 + value / 2.0).clamp(0.0, 1.0);
        let size = Vec2::new(self.columns() as f32, self.rows() as f32) * self.cell_size();
        let rings = rings(self.columns(), values.map(share).collect(), SPECK);
        rings.into_iter().map(|ring| ring.into_iter().map(|at| at * size).collect()).collect()
    }
}
