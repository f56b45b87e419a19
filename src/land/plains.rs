//! Land with plains that rivers have built into the sea.

use super::coast_distance::CoastDistance;
use super::grid::Grid;
use super::queries::Land;
use crate::domain::Domain;

impl Land {
    /// Makes this land where heights at the corners of its lattice, row by row, are above 0. Coasts far from what is new stay as
    /// they are, to the bit.
    pub(crate) fn with_plains(&self, heights: &[f32]) -> Self {
        let before = self.coast_distance();
        let coast = before.with_heights_of(heights).settled().like(before);
        let domain = Domain { size: self.size() };
        Self::on(Grid::above_water(&domain, &coast), coast, self.ridges().to_vec()).with_rivers_of(self)
    }
}

impl CoastDistance {
    /// Replaces distances by earlier ones where they hardly differ: those were measured from the exact coast.
    fn like(mut self, before: &Self) -> Self {
        const HARDLY: f32 = 0.5;
        self.replace(|now, corner| {
            let then = before.heights()[corner];
            if (now - then).abs() < HARDLY && (now > 0.0) == (then > 0.0) { then } else { now }
        });
        self
    }
}
