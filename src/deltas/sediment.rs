//! The sediment that rivers carry to the sea: one budget for the drowned valley that it fills and for the delta beyond.

use crate::base::random::{ItemHash, Purpose, Seed};
use crate::recipe::{NumberKey, Recipe};

/// The volume that a river of all the map's water carries at the middle of the parameter, in cubic units, and the range of
/// the parameter in powers of ten.
const VOLUME: f32 = 60_000.0;
const DECADES: f32 = 2.0;

/// The spread of sediment from river to river of the same discharge: the deviation of its logarithm.
const SPREAD: f32 = 0.5;

/// The number of rivers that carry sediment, the greatest first.
pub(crate) const RIVERS: usize = 12;

/// The sediment of a map's rivers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sediment {
    /// The volume that a river of all the map's water carries, in cubic units.
    whole: f32,
    chance: ItemHash,
}

impl Sediment {
    /// Reads the sediment of a recipe; `None` if its rivers carry none.
    pub fn of(recipe: &Recipe) -> Option<Self> {
        let deltas = recipe.number(NumberKey::Deltas);
        let whole = VOLUME * libm::expf((deltas - 0.5) * DECADES * std::f32::consts::LN_10);
        let chance = Seed::from_text(recipe.seed()).item_hash(Purpose::Deltas);
        (deltas > 0.0).then_some(Self { whole, chance })
    }

    /// Returns the volume that a river brings, in cubic units, by its share of all water and its identity.
    pub fn of_river(&self, share: f32, identity: u32) -> f32 {
        self.whole * share * libm::expf(SPREAD * self.chance.normal([identity, 0, 0]))
    }

    /// Returns the random numbers of branches.
    pub fn chance(&self) -> ItemHash {
        self.chance
    }
}

/// What a river has left of its sediment where its drowned valley ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Load {
    /// Its mouth, in units.
    pub at: glam::Vec2,
    /// The volume, in cubic units.
    pub left: f32,
}

/// The least volume, in cubic units, that builds a delta.
pub(super) const LEAST: f32 = 1_500.0;

/// Estimates the area of the deltas that rivers will build, in square units, before their branches are known.
pub(crate) fn expected_area(loads: &[Load]) -> f32 {
    const A_VOLUME: f32 = 0.2;
    const MOST: f32 = 3_000.0;
    loads.iter().filter(|load| load.left >= LEAST).map(|load| (A_VOLUME * load.left).min(MOST)).sum()
}
