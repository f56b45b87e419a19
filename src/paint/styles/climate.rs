//! The colours of a style from climate to climate.
//!
//! A style's file gives its colours in a temperate climate and, if they change with the climate, those in four others. Between the five
//! they are mixed: by rain, then towards those of the cold.

use crate::paint::palette::{Colour, Tints, mix};
use crate::recipe::GroundKind;

/// A climate, and the ground that it falls on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Climate {
    /// The warmth and the rain, from 0 over the temperate 0.5 to 1.
    pub warmth: f32,
    pub rain: f32,
    pub ground: GroundKind,
}

impl Climate {
    /// The climate in which every style has the colours that its file gives first.
    pub const TEMPERATE: Self = Self { warmth: 0.5, rain: 0.5, ground: GroundKind::Soil };
}

/// What a style has in four climates other than the temperate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Four<T> {
    pub wet: T,
    pub dry: T,
    pub cold: T,
    /// Ground of dark volcanic rock.
    pub lava: T,
}

/// What the climate does to the colours of a style.
#[derive(Clone, Copy, Debug)]
pub(super) enum Climates {
    /// Nothing.
    Alike,
    /// Each climate has colours of its own.
    Ramps(&'static Four<Ramp>),
    /// The land has a tinge of another colour in each.
    Tinges(Four<Tinge>),
}

/// All colours of a style that the climate changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ramp {
    /// The tints, at the heights that the style has in all climates.
    pub tints: [Colour; Tints::STOPS],
    pub shadow: Colour,
    pub light: Colour,
    /// The land without relief.
    pub land: Colour,
    pub lowland: Colour,
    pub blotch: Colour,
    pub water: Colour,
    pub shallows: Colour,
    pub coast: Colour,
    pub river: Colour,
    pub casing: Colour,
    /// The strength of the casing.
    pub cased: f32,
    pub letters: Colour,
    pub halo: Colour,
    pub trees: Colour,
}

/// A colour that the land takes on, and its shares in the lowest land and in the highest.
pub(super) type Tinge = (Colour, [f32; 2]);

/// Makes a colour of its six hexadecimal digits.
pub(super) const fn hex(digits: u32) -> Colour {
    let [_, red, green, blue] = digits.to_be_bytes();
    [red, green, blue]
}

/// Makes the tints of a ramp; the last comes again where there are fewer than there can be.
pub(super) const fn tints(digits: &[u32]) -> [Colour; Tints::STOPS] {
    let (mut tints, mut i) = ([hex(digits[digits.len() - 1]); Tints::STOPS], 0);
    while i < digits.len() {
        tints[i] = hex(digits[i]);
        i += 1;
    }
    tints
}

impl Ramp {
    /// Mixes two ramps; `share` is that of the second.
    fn mixed(&self, to: &Self, share: f32) -> Self {
        let colour = |of: fn(&Self) -> Colour| mix(of(self), of(to), share);
        Self {
            tints: std::array::from_fn(|i| mix(self.tints[i], to.tints[i], share)),
            shadow: colour(|ramp| ramp.shadow),
            light: colour(|ramp| ramp.light),
            land: colour(|ramp| ramp.land),
            lowland: colour(|ramp| ramp.lowland),
            blotch: colour(|ramp| ramp.blotch),
            water: colour(|ramp| ramp.water),
            shallows: colour(|ramp| ramp.shallows),
            coast: colour(|ramp| ramp.coast),
            river: colour(|ramp| ramp.river),
            casing: colour(|ramp| ramp.casing),
            cased: self.cased + (to.cased - self.cased) * share,
            letters: colour(|ramp| ramp.letters),
            halo: colour(|ramp| ramp.halo),
            trees: colour(|ramp| ramp.trees),
        }
    }

    /// Gives the land a tinge, where the tints have these heights.
    pub fn tinged(&self, (colour, [low, high]): Tinge, heights: [f32; Tints::STOPS]) -> Self {
        let at = |metres: f32| low + (high - low) * Tints::place_of(metres);
        let [land, lowland, halo] = [self.land, self.lowland, self.halo].map(|ground| mix(ground, colour, low));
        let tints = std::array::from_fn(|i| mix(self.tints[i], colour, at(heights[i])));
        Self { tints, land, lowland, halo, ..*self }
    }
}

impl<T: Copy> Four<T> {
    pub fn map<U>(self, to: impl Fn(T) -> U) -> Four<U> {
        Four { wet: to(self.wet), dry: to(self.dry), cold: to(self.cold), lava: to(self.lava) }
    }
}

/// Mixes the ramps of a style as a climate has them: all dry at no rain and all wet at the most, then all cold at no warmth.
pub(super) fn mixed(temperate: Ramp, four: Four<Ramp>, Climate { warmth, rain, ground }: Climate) -> Ramp {
    /// The influence of rain on lava, where little grows.
    const ON_LAVA: f32 = 0.4;
    let (bare, influence) = match ground {
        GroundKind::Soil => (temperate, 1.0),
        GroundKind::Lava => (four.lava, ON_LAVA),
    };
    let towards = if rain < 0.5 { four.dry } else { four.wet };
    let rained = bare.mixed(&towards, (rain - 0.5).abs() * 2.0 * influence);
    rained.mixed(&four.cold, (1.0 - 2.0 * warmth).max(0.0))
}
