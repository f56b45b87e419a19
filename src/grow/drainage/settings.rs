//! The settings of drainage, in domain units.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use crate::base::random::{Purpose, Seed};
use crate::base::trigonometry::sine_and_cosine;
use crate::domain::{given_center, parcel_spacing};
use crate::recipe::{GrowthMethod, IntegerKey, NumberKey, Pattern, Recipe};

/// The settings of drainage, with spacings turned into lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct DrainageSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The mean distance between parcels. The land leaves parcels out but does not move any.
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
    /// The variation of bending from place to place: the deviation of its logarithm.
    pub bending_variation: f32,
    /// φ: the logarithm of the price of running against the fall of the land, or of the gain of running with it.
    pub fall: f32,
    /// The pattern of drainage; dendritic where growth is not by drainage.
    pub pattern: Pattern,
    /// The direction of folded beds and of joints: a unit vector.
    pub strike: Vec2,
    /// The place of a dome or hollow, as shares of the domain's size; 0 stands for any that the seed chooses.
    pub center: Vec2,
}

impl DrainageSettings {
    /// The drained area from which on a river is great, in square units: it meets other great ones inland.
    pub(crate) const GREAT: f32 = 4000.0;

    /// Resolves a recipe.
    pub fn new(recipe: &Recipe) -> Self {
        let spacing = parcel_spacing(recipe);
        let spacings = |key| recipe.number(key) * spacing;
        let is_drainage = recipe.get::<GrowthMethod>() == GrowthMethod::Drainage;
        let seed = Seed::from_text(recipe.seed());
        let pattern = if is_drainage { recipe.get() } else { Pattern::Dendritic };
        let plain = Self {
            seed,
            spacing,
            valleys: recipe.number(NumberKey::Valleys),
            valley_spacing: spacings(NumberKey::ValleySpacing),
            concavity: recipe.number(NumberKey::Concavity),
            captures: recipe.integer(IntegerKey::Captures),
            hardness: recipe.number(NumberKey::Hardness),
            hardness_scale: spacings(NumberKey::HardnessScale),
            // Attractors stay in their cells.
            bending: if is_drainage { spacings(NumberKey::Bending) } else { 0.0 },
            bending_variation: recipe.number(NumberKey::BendingVariation),
            fall: recipe.number(NumberKey::Fall),
            pattern,
            strike: strike(seed, recipe.integer(IntegerKey::Strike)),
            center: given_center(recipe),
        };
        plain.with_pattern()
    }

    /// Adapts the other settings to the pattern, so that each of them still does something in every pattern where it
    /// can.
    fn with_pattern(self) -> Self {
        let Self { fall, hardness, captures, bending, spacing, hardness_scale, .. } = self;
        match self.pattern {
            Pattern::Dendritic => self,
            Pattern::Rectangular => Self { bending: 0.6 * bending, ..self },
            Pattern::Parallel => {
                Self { fall: fall + 1.8, hardness: 0.4 * hardness, valleys: 0.0, bending: 0.3 * bending, ..self }
            }
            Pattern::Trellis => Self { fall: 0.1 * fall, bending: 0.1 * bending, ..self },
            Pattern::Annular => Self { fall: 0.3 * fall + 0.16, bending: 0.3 * bending, ..self },
            Pattern::Radial | Pattern::Centripetal => Self { fall: fall + 1.2, bending: 0.3 * bending, ..self },
            Pattern::Deranged => Self {
                hardness: 2.2 * hardness,
                hardness_scale: hardness_scale.min(9.0 * spacing),
                valleys: 1.0,
                captures: captures.min(1),
                ..self
            },
        }
    }

    /// Returns noise of hard and soft ground over the plane, from −1 to 1, hard where it is high.
    pub(crate) fn rock(&self) -> FastNoiseLite {
        self.seed.rock(self.hardness_scale)
    }

    /// Returns a bound for the distance by which bends move a place, in units; measured, not proved.
    pub(super) fn farthest_bend(&self) -> f32 {
        self.bending * (2.1 + 2.3 * self.bending_variation).min(5.0) / (1.0 + 0.05 * self.bending / self.spacing)
    }

    /// Returns fractal noise over the plane, from −1 to 1, of a wavelength in units. `index` separates different uses.
    #[inline(never)] // each copy weighs three hundred bytes
    pub(super) fn noise(&self, index: u32, wavelength: f32, octaves: i32, gain: f32) -> FastNoiseLite {
        let mut noise = self.seed.noise(Purpose::Ground, index, 1.0 / wavelength, octaves);
        noise.set_fractal_gain(Some(gain));
        noise
    }
}

/// Returns the direction of beds and joints, a unit vector, from degrees east of north as geologists give it; 0 stands
/// for any that the seed chooses.
fn strike(seed: Seed, degrees: u32) -> Vec2 {
    let chosen = 180.0 * seed.item_hash(Purpose::Country).unit([2, 0, 0]);
    let degrees = if degrees == 0 { chosen } else { degrees as f32 };
    let (sine, cosine) = sine_and_cosine(degrees.to_radians());
    Vec2::new(sine, -cosine)
}
