//! Trees and hills in their places.

use glam::Vec2;

use super::shapes::{Feature, SHAPES, Shape};

/// A glyph in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The number of its shape.
    pub shape: u8,
    /// The number of the point that it stands on: no other of its kind has it.
    pub number: u32,
    /// The middle of its base, in units.
    pub foot: Vec2,
    /// How high a tree is, and half of a hill's width, in units.
    pub size: f32,
}

impl Standing {
    /// One of a feature, in one of its shapes by chance.
    pub(super) fn new(feature: Feature, foot: Vec2, size: f32, number: u32, chance: f32) -> Self {
        let shapes = feature.shapes();
        let shape = shapes.start + (chance * shapes.len() as f32) as u8;
        Self { shape, number, foot, size }
    }

    /// What it looks like.
    pub fn shape(&self) -> &'static Shape {
        &SHAPES[usize::from(self.shape) % SHAPES.len()]
    }

    /// What it is.
    pub fn feature(&self) -> Feature {
        self.shape().feature
    }

    /// Whether it is a tree.
    pub fn is_tree(&self) -> bool {
        self.feature().is_tree()
    }
}
