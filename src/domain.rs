//! The domain: the rectangle that rivers grow in.
//!
//! Its area is always a million square units, whatever its aspect, and it knows nothing of pixels: a picture has the
//! same rivers at 300 and at 3000 of them. x runs east, y runs south, as on a screen.

use glam::Vec2;

use crate::recipe::{Key, Recipe};

/// The area of every domain, in square units.
pub const AREA: f32 = 1_000_000.0;

/// The rectangle from the origin, its north-western corner, to `size`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Width and height, in units.
    pub size: Vec2,
}

impl Domain {
    /// The domain of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        Self::with_aspect(recipe.number(Key::Aspect))
    }

    /// The domain of the given width to height.
    pub fn with_aspect(aspect: f32) -> Self {
        let height = (AREA / aspect).sqrt();
        Self { size: Vec2::new(AREA / height, height) }
    }

    /// Whether a point lies in it, its border included.
    pub fn contains(&self, point: Vec2) -> bool {
        point.x >= 0.0 && point.y >= 0.0 && point.x <= self.size.x && point.y <= self.size.y
    }
}
