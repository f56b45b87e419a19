//! What growth needs to know, in domain units.

use crate::domain::{AREA, Domain};
use crate::random::Seed;
use crate::recipe::{Key, Recipe, Sides};

/// The parameters of growth, resolved: ratios turned into lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The rectangle.
    pub domain: Domain,
    /// How many rivers reach the sea.
    pub mouths: u32,
    /// On which sides.
    pub sides: Sides,
    /// How many attractors there are.
    pub attractors: u32,
    /// Whether each has a cell of a grid to itself.
    pub on_grid: bool,
    /// The mean distance between attractors, √(area / number): the unit of the three lengths below in a recipe.
    pub spacing: f32,
    /// How far an attractor pulls (the paper's distance of step 2).
    pub reach: f32,
    /// How near a river has to come for an attractor to be done with (step 5).
    pub kill: f32,
    /// How far a river grows in a tick (the unit length of step 4).
    pub step: f32,
    /// The paper's k: the share of the last direction that is taken from the new one.
    pub momentum: f32,
    /// The paper's θ_c, in radians.
    pub curl: f32,
    /// The paper's c: nodes in a stretch that curls to one side.
    pub stretch: u32,
}

impl Parameters {
    /// Resolves a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        let attractors = recipe.integer(Key::Attractors);
        let spacing = (AREA / attractors as f32).sqrt();
        let spacings = |key| recipe.number(key) * spacing;
        Self {
            seed: Seed::from_text(recipe.seed()),
            domain: Domain::with_aspect(recipe.number(Key::Aspect)),
            mouths: recipe.integer(Key::Mouths),
            sides: recipe.sides(Key::Sides),
            attractors,
            on_grid: recipe.choice(Key::Scatter) == 1,
            spacing,
            reach: spacings(Key::Reach),
            kill: spacings(Key::Kill),
            step: spacings(Key::Step),
            momentum: recipe.number(Key::Momentum),
            curl: recipe.number(Key::Curl),
            stretch: recipe.integer(Key::Stretch),
        }
    }
}
