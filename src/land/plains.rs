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
        let coast = before.with_heights_of(heights).settled().like(before, &before.changed_by(heights));
        let domain = Domain { size: self.size() };
        Self::on(Grid::above_water(&domain, &coast), coast, self.ridges().to_vec()).with_rivers_of(self)
    }
}

impl CoastDistance {
    /// Measures distances from the corners whose heights change, negative outside.
    fn changed_by(&self, heights: &[f32]) -> Self {
        let spacing = self.spacing();
        let side = |(then, now): (&f32, &f32)| if then == now { -spacing } else { spacing };
        let sides: Vec<f32> = self.heights().iter().zip(heights).map(side).collect();
        self.with_heights_of(&sides).settled()
    }

    /// Replaces distances by earlier ones where these are as they were, since they were measured from the exact coast: those that are
    /// shorter than the way to what has changed, and those that hardly differ.
    fn like(mut self, before: &Self, changed: &Self) -> Self {
        const HARDLY: f32 = 0.5;
        let near = 2.0 * before.spacing();
        self.replace(|now, corner| {
            let then = before.heights()[corner];
            let is_far = then.abs() + near < -changed.heights()[corner];
            let is_alike = (now - then).abs() < HARDLY && (now > 0.0) == (then > 0.0);
            if is_far || is_alike { then } else { now }
        });
        self
    }
}
