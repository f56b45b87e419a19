//! The random numbers of a layout, drawn one after the other.

use glam::Vec2;

use super::curve::turned;
use super::kinds::Shape;
use crate::base::random::{ItemHash, Purpose};

/// A sequence of random numbers that no other layout of the seed has.
pub(super) struct Draws {
    hash: ItemHash,
    number: u32,
    next: u32,
}

impl Draws {
    /// Begins the sequence of a draft, or of a side, given by its number.
    pub fn new(shape: &Shape, number: u32) -> Self {
        Self { hash: shape.seed.item_hash(Purpose::Land), number, next: 0 }
    }

    /// Draws a number from `least` to `most`.
    #[inline(never)] // each copy weighs sixty bytes, and layouts draw often
    pub fn between(&mut self, least: f32, most: f32) -> f32 {
        /// The item of random numbers, apart from all others of land.
        const LAYOUT: u32 = 100;
        self.next += 1;
        least + (most - least) * self.hash.unit([LAYOUT, self.number, self.next])
    }

    /// Draws a number from 0 to 1, more often about a half than near the ends.
    #[inline(never)]
    pub fn middling(&mut self) -> f32 {
        0.5 * (self.between(0.0, 1.0) + self.between(0.0, 1.0))
    }

    /// Draws whether something happens that has a likelihood from 0 to 1.
    #[inline(never)]
    pub fn is(&mut self, likelihood: f32) -> bool {
        self.between(0.0, 1.0) < likelihood
    }

    /// Draws a number from `least` to `most`, and makes it negative in half of all cases.
    #[inline(never)]
    pub fn either(&mut self, least: f32, most: f32) -> f32 {
        let sign = if self.is(0.5) { -1.0 } else { 1.0 };
        sign * self.between(least, most)
    }

    /// Draws a whole number from `least` to `most`.
    #[inline(never)]
    pub fn count(&mut self, least: u32, most: u32) -> u32 {
        (self.between(least as f32, most as f32 + 1.0) as u32).min(most)
    }

    /// Draws a unit vector in any direction.
    #[inline(never)]
    pub fn direction(&mut self) -> Vec2 {
        turned(Vec2::X, self.between(-std::f32::consts::PI, std::f32::consts::PI))
    }
}
