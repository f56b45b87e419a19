//! The settings of painting.

use super::relief::Light;
use super::styles::Scheme;
use crate::base::random::Seed;
use crate::recipe::{CourseShape, NumberKey, Recipe};
use crate::relief::Wind;

/// The settings of painting, resolved.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct PaintSettings {
    /// The style, in the climate.
    pub(crate) scheme: Scheme,
    /// The lines that rivers follow.
    pub courses: CourseShape,
    /// The width of a river that drains the whole map, in domain units.
    pub max_width: f32,
    /// The light on the relief.
    pub(crate) light: Light,
    /// The wind that brings rain; `None` if rain falls evenly.
    pub(crate) wind: Option<Wind>,
    /// The seed and the roughness of the coast, which in large pictures has more detail beside finished rivers.
    pub(super) coast: (Seed, f32),
}

impl PaintSettings {
    /// Resolves a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        Self {
            scheme: Scheme::of(recipe),
            courses: recipe.get(),
            max_width: recipe.number(NumberKey::Width),
            light: Light { exaggeration: recipe.shade() },
            wind: Wind::of(recipe),
            coast: (Seed::from_text(recipe.seed()), recipe.number(NumberKey::Roughness)),
        }
    }
}
