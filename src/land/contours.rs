//! Closed lines of one height: coasts, and what lies so far inland or out at sea.

use glam::Vec2;

use super::trace::{SPECK, rings};
use super::{CoastDistance, SmoothedDistance};

impl SmoothedDistance {
    /// The rings around all that lies higher than a level, in units. Along the border they run a little outside of the
    /// domain. Specks are left out: the finer the lattice, the smaller.
    pub fn rings_above(&self, level: f32) -> Vec<Vec<Vec2>> {
        // Heights this far above the level and below count as far off; neighbours differ by less.
        let far = 4.0 * self.spacing();
        let finer = self.spacing() / CoastDistance::COARSE_SPACING;
        let (columns, rows) = self.size();
        let share = |height: f32| (0.5 + (height - level) / (2.0 * far)).clamp(0.0, 1.0);
        let land = (0..rows).flat_map(|row| (0..columns).map(move |column| share(self.control(column, row)))).collect();
        let size = Vec2::new(columns as f32, rows as f32);
        // The lattice's corners are the middles of blocks.
        let place = |at: Vec2| (at * size - 0.5) * self.spacing();
        rings(columns, land, SPECK * finer * finer)
            .into_iter()
            .map(|ring| ring.into_iter().map(place).collect())
            .collect()
    }
}
