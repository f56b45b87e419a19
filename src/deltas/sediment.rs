//! The sediment that rivers carry to the sea: one budget for the drowned valley that it fills and for the delta beyond.

use crate::base::random::{ItemHash, Purpose, Seed};
use crate::recipe::{NumberKey, Recipe};

/// The volume that a river of all the map's water carries at the middle of the parameter, in cubic units, and the range of
/// the parameter in powers of ten.
const VOLUME: f32 = 150_000.0;
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

/// The sediment that a river has left where its drowned valley ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Load {
    /// Its mouth, in units.
    pub at: glam::Vec2,
    /// The width that room is left for, and the volume, in units.
    pub width: f32,
    pub left: f32,
}

/// The least volume, in cubic units, that builds a delta.
pub(super) const LEAST: f32 = 500.0;

/// Returns the length of the first branches of a delta, in units: some widths, as far as a volume of sediment lasts.
pub(super) fn reach(width: f32, volume: f32) -> f32 {
    /// The least and greatest length in widths; and, since the widest rivers would fill seas, in units and widths.
    const WIDTHS: (f32, f32) = (4.0, 7.0);
    const FAR: (f32, f32) = (30.0, 2.2);
    /// The volume that a delta takes, in widths times lengths.
    const TAKEN: f32 = 30.0;
    let most = (WIDTHS.1 * width).min(FAR.0 + FAR.1 * width);
    (volume / (TAKEN * width.max(0.1))).clamp((WIDTHS.0 * width).min(most), most)
}

/// Estimates the area of the deltas that rivers will build, in square units, before their branches are known.
pub(crate) fn expected_area(loads: &[Load]) -> f32 {
    const A_SQUARE: f32 = 0.8;
    /// The share of sea stays within a hundredth of the one asked for, even if none of this room is used.
    const MOST: f32 = 8_000.0;
    let area = |load: &Load| {
        let reach = reach(load.width, load.left);
        A_SQUARE * reach * reach
    };
    loads.iter().filter(|load| load.left >= LEAST).map(area).sum::<f32>().min(MOST)
}
