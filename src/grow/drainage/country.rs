//! The country that water crosses: its fall and its grain, which set the price of each way beside length and hardness.
//!
//! Cost of an edge = length · e^hardness · e^grain · e^(−φ t·g), where t is the direction in which water runs and g that
//! in which the land falls. The grain is the same for both ways along an edge; the fall is not, so an edge has two
//! costs. A pattern of drainage (Twidale 2004) is a choice of both.

use glam::Vec2;

use super::fall::Fall;
use super::grain::Grain;
use crate::base::geometry::direction;
use crate::grow::GrowthSettings;

/// The fall and the grain of a country.
pub(super) struct Country<'a> {
    fall: Option<Fall<'a>>,
    grain: Option<Grain>,
}

impl<'a> Country<'a> {
    /// Resolves the country of some settings.
    pub fn new(settings: &'a GrowthSettings) -> Self {
        let has_fall = settings.drainage.fall > 0.0;
        Self { fall: has_fall.then(|| Fall::new(settings)), grain: Grain::new(settings) }
    }

    /// Returns the logarithm of the hardness that the grain adds to the ground at a place.
    pub fn hardness(&self, at: Vec2) -> f32 {
        self.grain.as_ref().map_or(0.0, |grain| grain.hardness(at))
    }

    /// Returns the costs of an edge, forward and back, from what it would cost in level country without grain.
    pub fn costs(&self, from: Vec2, to: Vec2, cost: f32) -> [f32; 2] {
        let (middle, along) = (0.5 * (from + to), direction(to - from));
        let cost = self.grain.as_ref().map_or(cost, |grain| cost * libm::expf(grain.resistance(middle, along)));
        let Some(fall) = &self.fall else { return [cost; 2] };
        let gain = libm::expf(fall.at(middle).dot(along));
        [cost / gain, cost * gain]
    }
}
