//! The relief: a smooth function of the domain, positive on land, known at the corners of a coarse lattice.

use glam::Vec2;

use crate::domain::Domain;

/// Heights at lattice corners, bilinear between.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    heights: Vec<f32>,
    columns: usize,
    rows: usize,
}

impl Relief {
    /// The distance between lattice corners, in units: finer than any bend of a coast that is to be seen.
    pub(super) const SPACING: f32 = 8.0;
    /// Distances from the coast are not told apart beyond this, in units.
    pub(super) const FARTHEST: f32 = 100.0;

    /// How many columns and rows of corners a lattice has: one more each than would cover the domain.
    pub(super) fn corners(domain: &Domain) -> (usize, usize) {
        let corners = |length: f32| (length / Self::SPACING) as usize + 2;
        (corners(domain.size.x), corners(domain.size.y))
    }

    /// Takes heights that were worked out at the corners, row by row.
    pub(super) fn at_corners(domain: &Domain, heights: Vec<f32>) -> Self {
        let (columns, rows) = Self::corners(domain);
        Self { heights, columns, rows }
    }

    /// Samples a function and lowers it so that the given share of the domain is below 0: that is the sea.
    pub fn with_sea(domain: &Domain, share: f32, height: impl Fn(Vec2) -> f32) -> Self {
        let (columns, rows) = Self::corners(domain);
        let corner = |i: usize| Vec2::new((i % columns) as f32, (i / columns) as f32) * Self::SPACING;
        let mut heights: Vec<f32> = (0..columns * rows).map(|i| height(corner(i))).collect();
        let level = quantile(&heights, share);
        heights.iter_mut().for_each(|height| *height -= level);
        Self { heights, columns, rows }.as_distance()
    }

    /// Divides each height by its steepness: near the coast that is the distance from it.
    fn as_distance(self) -> Self {
        const FLATTEST: f32 = 0.05;
        let distance = |i: usize| {
            let corner = Vec2::new((i % self.columns) as f32, (i / self.columns) as f32) * Self::SPACING;
            let steepness = self.slope(corner).length().max(FLATTEST);
            (self.heights[i] / steepness).max(-Self::FARTHEST).min(Self::FARTHEST)
        };
        Self { heights: (0..self.heights.len()).map(distance).collect(), ..self }
    }

    /// The height of a point, in units: near the coast about its distance from it, negative at sea. Points outside
    /// the domain have that of its border.
    #[inline]
    pub fn height(&self, point: Vec2) -> f32 {
        let (column, x) = lattice(point.x, self.columns);
        let (row, y) = lattice(point.y, self.rows);
        let i = row * self.columns + column;
        let (north, south) = (&self.heights[i..i + 2], &self.heights[i + self.columns..i + self.columns + 2]);
        let along = |pair: &[f32]| pair[0] * (1.0 - x) + pair[1] * x;
        along(north) * (1.0 - y) + along(south) * y
    }

    /// How steeply the height rises, toward higher ground.
    #[inline]
    pub fn slope(&self, point: Vec2) -> Vec2 {
        let step = Self::SPACING;
        let rise = |axis: Vec2| self.height(point + axis * step) - self.height(point - axis * step);
        Vec2::new(rise(Vec2::X), rise(Vec2::Y)) / (2.0 * step)
    }
}

/// The lattice interval a coordinate lies in, and where in it.
#[inline]
fn lattice(x: f32, corners: usize) -> (usize, f32) {
    let x = (x / Relief::SPACING).max(0.0).min((corners - 1) as f32);
    let index = (x as usize).min(corners - 2);
    (index, x - index as f32)
}

/// The value below which the given share of some values lies.
fn quantile(values: &[f32], share: f32) -> f32 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f32::total_cmp);
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f32) as usize).copied().unwrap_or(0.0)
}
