//! The settings of painting.

use super::relief::{Light, ReliefDisplay};
use super::styles::{Scheme, palette};
use crate::base::random::Seed;
use crate::recipe::{CourseShape, NumberKey, Recipe};
use crate::relief::Wind;
use crate::scale::MapScale;

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
    /// The display of the relief.
    pub(crate) relief: ReliefDisplay,
    /// The wind that brings rain; `None` if rain falls evenly.
    pub(crate) wind: Option<Wind>,
    /// The seed and the roughness of the coast, which in large pictures has more detail beside finished rivers.
    pub(super) coast: (Seed, f32),
}

impl PaintSettings {
    /// Resolves a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        let scheme = Scheme::of(recipe);
        let has_contours = palette(scheme).relief.is_some_and(|look| look.contours.is_some());
        Self {
            scheme,
            courses: recipe.get(),
            max_width: recipe.number(NumberKey::Width),
            relief: ReliefDisplay {
                light: Light { exaggeration: recipe.shade() },
                metres_up: if has_contours { MapScale::of(recipe).metres_up } else { 0.0 },
            },
            wind: Wind::of(recipe),
            coast: (Seed::from_text(recipe.seed()), recipe.number(NumberKey::Roughness)),
        }
    }
}
