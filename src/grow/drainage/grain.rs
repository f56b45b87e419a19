//! The grain of the land: folded beds that crop out in stripes or rings, and joints that cross at right angles. Water
//! prefers to run along soft beds, straight across hard ones, and along joints.

use std::f32::consts::{FRAC_1_SQRT_2, TAU};

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::fall::center;
use crate::base::geometry::{direction, length};
use crate::base::trigonometry::sine_and_cosine;
use crate::grow::GrowthSettings;
use crate::recipe::Pattern;

/// The grain of a country, with lengths in units.
pub(super) struct Grain {
    form: Form,
    spacing: f32,
}

enum Form {
    /// Parallel beds that strike in a direction.
    Beds { strike: Vec2 },
    /// Beds around a dome.
    Rings { center: Vec2 },
    /// Two sets of joints, one along a direction and one across it.
    Joints { strike: Vec2, noise: FastNoiseLite },
}

/// The distance between hard beds, in spacings.
const BEDS: f32 = 10.0;

/// The logarithm of the hardness of the hardest beds, and that of the softest as a share of it.
const HARDEST: f32 = 2.4;
const SOFTEST: f32 = -0.2;

/// The logarithm by which a bed resists water that runs the wrong way.
const BEDDING: f32 = 2.5;

/// The length of joints compared with their distance, and that distance in spacings.
const SLENDER: f32 = 10.0;
const JOINTS: f32 = 4.0;

/// The logarithm of the hardness that a joint takes from the ground, and of its resistance to water that runs at 45° to
/// all joints.
const OPEN: f32 = 1.1;
const JOINTING: f32 = 2.2;

impl Grain {
    /// Returns the grain of some settings; `None` if the pattern has none.
    pub fn new(settings: &GrowthSettings) -> Option<Self> {
        let drainage = &settings.drainage;
        let strike = drainage.strike;
        let form = match drainage.pattern {
            Pattern::Trellis => Form::Beds { strike },
            Pattern::Annular => Form::Rings { center: center(settings) },
            Pattern::Rectangular => {
                Form::Joints { strike, noise: drainage.noise(5, JOINTS * drainage.spacing, 1, 0.5) }
            }
            _ => return None,
        };
        Some(Self { form, spacing: drainage.spacing })
    }

    /// Returns the logarithm of the hardness at a place.
    pub fn hardness(&self, at: Vec2) -> f32 {
        match &self.form {
            Form::Beds { .. } | Form::Rings { .. } => HARDEST * self.bed(at).0.max(SOFTEST),
            Form::Joints { strike, noise } => {
                let (along, across) = (strike.dot(at), strike.perp_dot(at));
                let one = noise.get_noise_2d(along / SLENDER, across);
                let other = noise.get_noise_2d(along, across / SLENDER + 1e4);
                -OPEN * 2.0 * one.max(other)
            }
        }
    }

    /// Returns the logarithm of the resistance to water that runs in a direction, a unit vector, or against it.
    pub fn resistance(&self, at: Vec2, along: Vec2) -> f32 {
        match &self.form {
            Form::Beds { .. } | Form::Rings { .. } => {
                let (hardness, strike) = self.bed(at);
                let cosine = strike.dot(along);
                // cos 2α = 2 cos² α − 1
                BEDDING * (2.0 * hardness).clamp(-1.0, 1.0) * (2.0 * cosine * cosine - 1.0)
            }
            Form::Joints { strike, .. } => {
                let nearest = strike.dot(along).abs().max(strike.perp_dot(along).abs());
                JOINTING * (1.0 - nearest) / (1.0 - FRAC_1_SQRT_2)
            }
        }
    }

    /// Returns the bed at a place: its hardness from −1 to 1, and its strike.
    fn bed(&self, at: Vec2) -> (f32, Vec2) {
        let (strike, across) = match self.form {
            Form::Beds { strike } | Form::Joints { strike, .. } => (strike, strike.perp_dot(at)),
            Form::Rings { center } => (direction(at - center).perp(), length(at - center)),
        };
        let beds = across / (BEDS * self.spacing);
        (sine_and_cosine(TAU * (beds - beds.round())).0, strike)
    }
}
