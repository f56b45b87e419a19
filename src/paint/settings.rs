//! The settings of painting.

use super::relief::Light;
use crate::base::random::Seed;
use crate::recipe::{CourseShape, NumberKey, Recipe, Style};

/// The settings of painting, resolved.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct PaintSettings {
    /// The style.
    pub style: Style,
    /// The lines that rivers follow.
    pub courses: CourseShape,
    /// The width of a river that drains the whole map, in domain units.
    pub max_width: f32,
    /// The light on the relief.
    pub(crate) light: Light,
    /// The seed and the roughness of the coast, which in large pictures has more detail beside finished rivers.
    pub(super) coast: (Seed, f32),
}

impl PaintSettings {
    /// Resolves a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        Self {
            style: recipe.get(),
            courses: recipe.get(),
            max_width: recipe.number(NumberKey::Width),
            light: Light { exaggeration: recipe.shade() },
            coast: (Seed::from_text(recipe.seed()), recipe.number(NumberKey::Roughness)),
        }
    }
}
