//! Closed lines of equal height: coasts, and lines at a distance inland or at sea.

use glam::Vec2;

use super::trace::{SPECK, rings};
use super::{CoastDistance, SmoothedDistance};

impl SmoothedDistance {
    /// Traces the rings around all areas higher than a level, in units. Along the border they run slightly outside the
    /// domain. Specks are left out; a finer lattice keeps smaller ones.
    pub fn rings_above(&self, level: f32) -> Vec<Vec<Vec2>> {
        // Heights that differ from the level by more than this are clamped; neighbouring corners differ by less.
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
