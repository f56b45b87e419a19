//! Trees and hills in their places.

use glam::Vec2;

use super::pen::{Feature, Shape};
use super::shapes::SHAPES;

/// A glyph in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The number of its shape.
    pub shape: u8,
    /// The number of the point that it stands on: no other of its kind has it.
    pub number: u32,
    /// The middle of its base, in units.
    pub foot: Vec2,
    /// The height of a tree, or half of the width of a hill or a marsh, in units.
    pub size: f32,
}

impl Standing {
    /// Makes a glyph of a feature, in one of its shapes: the first for a chance of 0, the last for one of 1.
    pub(super) fn new(feature: Feature, foot: Vec2, size: f32, number: u32, chance: f32) -> Self {
        let shapes = feature.shapes();
        let shape = (shapes.start + (chance * shapes.len() as f32) as u8).min(shapes.end - 1);
        Self { shape, number, foot, size }
    }

    /// Returns its shape.
    pub fn shape(&self) -> &'static Shape {
        &SHAPES[usize::from(self.shape) % SHAPES.len()]
    }

    /// Returns its feature.
    pub fn feature(&self) -> Feature {
        self.shape().feature
    }

    /// Returns `true` if it belongs to the woods: a tree or a marsh, no hill.
    pub fn is_plant(&self) -> bool {
        self.feature().is_plant()
    }

    /// Returns a disc around all of its discs: its middle and radius, in units.
    pub(super) fn around(&self) -> (Vec2, f32) {
        let discs = &self.shape().discs;
        let middle = discs.iter().fold(Vec2::ZERO, |sum, disc| sum + disc.0) / discs.len().max(1) as f32;
        let reach = discs.iter().map(|(at, radius)| at.distance(middle) + radius).fold(0.0, f32::max);
        // A little more than any rounding.
        (self.foot + middle * self.size, reach * self.size + 1e-3)
    }

    /// Returns the discs that it lies within: their middles and radii, in units.
    pub(super) fn discs(&self) -> impl Iterator<Item = (Vec2, f32)> {
        self.shape().discs.iter().map(|(middle, radius)| (self.foot + *middle * self.size, radius * self.size))
    }
}
