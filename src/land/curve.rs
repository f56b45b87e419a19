//! Curves along which spines lie.

use glam::Vec2;

use super::spine::Spine;
use crate::base::geometry::{direction, distance};
use crate::base::trigonometry::sine_and_cosine;

/// A cubic curve (Bézier).
#[derive(Clone, Copy)]
pub(super) struct Curve(pub [Vec2; 4]);

impl Curve {
    /// Makes a curve between two points that bends aside by shares of its length, after a third and after two thirds of it.
    #[inline(never)] // each copy weighs a hundred bytes
    pub fn bent(from: Vec2, to: Vec2, bends: [f32; 2]) -> Self {
        let (along, aside) = (to - from, (to - from).perp());
        let control = |share: f32, bend: f32| from + along * share + aside * (bend * 4.0 / 3.0);
        Self([from, control(0.333, bends[0]), control(0.667, bends[1]), to])
    }

    /// Returns the point at a share of the curve.
    #[inline(never)] // each copy weighs ninety bytes
    pub fn at(&self, t: f32) -> Vec2 {
        let [a, b, c, d] = self.0;
        let s = 1.0 - t;
        a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
    }

    /// Returns the direction in which the curve runs at a share of it, as a unit vector.
    #[inline(never)]
    pub fn way(&self, t: f32) -> Vec2 {
        direction(self.at((t + 0.05).min(1.0)) - self.at((t - 0.05).max(0.0)))
    }

    /// Estimates the length, in units.
    #[inline(never)]
    pub fn length(&self) -> f32 {
        distance(self.at(0.0), self.at(0.5)) + distance(self.at(0.5), self.at(1.0))
    }

    /// Returns the curve in the opposite direction.
    pub fn reversed(&self) -> Self {
        let [a, b, c, d] = self.0;
        Self([d, c, b, a])
    }

    /// Makes a spine along the curve, in a number of pieces, with a half width for each share of it.
    #[inline(never)]
    pub fn spine(&self, pieces: u32, width: &dyn Fn(f32) -> f32) -> Spine {
        let place = |i: u32| i as f32 / pieces as f32;
        Spine::new((0..=pieces).map(|i| (self.at(place(i)), width(place(i)))).collect())
    }
}

/// Returns a share that grows from `end` at both ends, 0 and 1, to 1 at `middle`.
#[inline(never)]
pub(super) fn swelling(t: f32, middle: f32, end: f32) -> f32 {
    let off = if t < middle { (middle - t) / middle } else { (t - middle) / (1.0 - middle) };
    end + (1.0 - end) * (1.0 - off * off)
}

/// Rotates a vector by an angle of up to π.
#[inline(never)] // each copy weighs a hundred bytes
pub(super) fn turned(vector: Vec2, angle: f32) -> Vec2 {
    let (sine, cosine) = sine_and_cosine(angle);
    Vec2::new(cosine, sine).rotate(vector)
}
