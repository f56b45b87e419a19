//! The settings of drainage, in domain units.

use fastnoise_lite::FastNoiseLite;

use crate::base::random::{Purpose, Seed};
use crate::domain::AREA;
use crate::recipe::{GrowthMethod, IntegerKey, NumberKey, Recipe};

/// The settings of drainage, with spacings turned into lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct DrainageSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The mean distance between parcels, √(area of the domain / attractors). The land leaves parcels out but does not
    /// move any.
    pub spacing: f32,
    /// The influence of valleys, from 0 to 1: the exponent of the areas of an invasion, or the unevenness of the ground
    /// on which attractors lie.
    pub valleys: f32,
    /// The distance between these valleys, in units: the wavelength of the ground that is invaded.
    pub valley_spacing: f32,
    /// Θ of Flint's law S = k A^−θ (1974): the decrease of slope with area.
    pub concavity: f32,
    /// The number of rounds after the first.
    pub captures: u32,
    /// The contrast between hard and soft ground.
    pub hardness: f32,
    /// The distance between hard and soft ground, in units.
    pub hardness_scale: f32,
    /// The distance by which the plane is bent, in units.
    pub bending: f32,
}

impl DrainageSettings {
    /// Resolves a recipe.
    pub fn new(recipe: &Recipe) -> Self {
        let spacing = (AREA / recipe.integer(IntegerKey::Attractors) as f32).sqrt();
        let spacings = |key| recipe.number(key) * spacing;
        let is_drainage = recipe.get::<GrowthMethod>() == GrowthMethod::Drainage;
        Self {
            seed: Seed::from_text(recipe.seed()),
            spacing,
            valleys: recipe.number(NumberKey::Valleys),
            valley_spacing: spacings(NumberKey::ValleySpacing),
            concavity: recipe.number(NumberKey::Concavity),
            captures: recipe.integer(IntegerKey::Captures),
            hardness: recipe.number(NumberKey::Hardness),
            hardness_scale: spacings(NumberKey::HardnessScale),
            // Attractors stay in their cells.
            bending: if is_drainage { spacings(NumberKey::Bending) } else { 0.0 },
        }
    }

    /// Fractal noise over the plane, from −1 to 1. `index` separates different uses.
    pub(super) fn noise(&self, index: u32, wavelength: f32, octaves: i32, gain: f32) -> FastNoiseLite {
        let mut noise = self.seed.noise(Purpose::Ground, index, 1.0 / wavelength, octaves);
        noise.set_fractal_gain(Some(gain));
        noise
    }
}
