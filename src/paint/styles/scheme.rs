//! A style in a climate.

use super::climate::Climate;
use crate::recipe::{NumberKey, Recipe, Style};

/// A style in a climate: all that decides the colours of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scheme {
    pub style: Style,
    pub climate: Climate,
}

impl Scheme {
    /// Reads the scheme of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        let [warmth, rain] = [NumberKey::Warmth, NumberKey::Rain].map(|key| recipe.number(key));
        Self { style: recipe.get(), climate: Climate { warmth, rain, ground: recipe.get() } }
    }
}

impl Scheme {
    /// Returns the scheme where more rain falls, or less.
    pub fn with_more_rain(self, more: f32) -> Self {
        let rain = (self.climate.rain + more).clamp(0.0, 1.0);
        Self { climate: Climate { rain, ..self.climate }, ..self }
    }
}

impl From<Style> for Scheme {
    fn from(style: Style) -> Self {
        Self { style, climate: Climate::TEMPERATE }
    }
}
