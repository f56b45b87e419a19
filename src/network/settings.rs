//! The settings of the network stage, in domain units.

use fastnoise_lite::FastNoiseLite;

use crate::base::geometry::{fast_max, fast_min};
use crate::base::random::{Purpose, Seed};
use crate::domain::Domain;
use crate::recipe::{CourseShape, IntegerKey, MeanderModel, NumberKey, Recipe};

/// The settings of the network stage, resolved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NetworkSettings {
    /// The seed's 64 bits.
    pub seed: Seed,
    /// The rectangle of the map.
    pub domain: Domain,
    /// The approximate distance between the vertices of a course, in units.
    pub spacing: f32,
    /// The discharge of a river that would drain the whole map.
    pub total_discharge: u32,
    /// The least width of a stream, in units: thin, but visible; less where streams lie close together.
    pub hairline: f32,
    /// The width of a river that would drain the whole map, in units.
    pub max_width: f32,
    /// The lines that rivers follow.
    pub courses: CourseShape,
    /// The share that simplification removes of the vertices that it may remove, from 0 to 1.
    pub simplify: f32,
    /// The greatest variation of a bank's distance from the middle, as a share of that distance.
    pub bank_variation: f32,
    /// The model by which rivers meander; none if courses are as grown.
    pub model: MeanderModel,
    /// The number of rounds of meandering.
    pub rounds: u32,
    /// The strength with which bends move in a round, from 0 to 1.
    pub strength: f32,
    /// The share of a bend's move that is sideways, from 0 to 1; the rest is downstream.
    pub mix: f32,
    /// The mobility of all rivers but the great ones, at most, from 0 to 1.
    pub meander_elsewhere: f32,
    /// The number of great rivers, which meander fully where they are flat.
    pub great_rivers: u32,
    /// The share of all courses that counts as flat.
    pub flat_share: f32,
    /// The distance between two limbs of a river at which it cuts through, in widths.
    pub neck: f32,
    /// The time in which silt fills an oxbow lake, as a multiple of the default: 0 leaves no lakes, infinity all of them.
    pub oxbow_life: f32,
    /// The least distance between the banks of two rivers, in units.
    pub min_clearance: f32,
    /// The distance from sources, mouths and junctions over which meandering sets in, in widths.
    pub taper: f32,
}

impl NetworkSettings {
    /// Resolves the settings of a recipe for a tree: `stream_spacing` is the distance between its streams,
    /// in units, and `total_discharge` the discharge of a river that would drain the whole map.
    pub fn new(recipe: &Recipe, stream_spacing: f32, total_discharge: u32) -> Self {
        Self {
            seed: Seed::from_text(recipe.seed()),
            domain: Domain::of(recipe),
            spacing: (stream_spacing * SPACING).clamp(LEAST_SPACING, MOST_SPACING),
            total_discharge: total_discharge.max(1),
            hairline: fast_min(HAIRLINE, stream_spacing * HAIRLINE_SHARE),
            max_width: recipe.number(NumberKey::Width),
            courses: recipe.get(),
            simplify: recipe.number(NumberKey::Simplify) / 100.0,
            bank_variation: recipe.number(NumberKey::BankVariation),
            model: match recipe.get() {
                CourseShape::Grown => MeanderModel::None,
                CourseShape::Smooth => recipe.get(),
            },
            rounds: recipe.integer(IntegerKey::MeanderRounds),
            strength: recipe.number(NumberKey::MeanderStrength),
            mix: recipe.number(NumberKey::MeanderMix),
            meander_elsewhere: recipe.number(NumberKey::MeanderElsewhere),
            great_rivers: recipe.integer(IntegerKey::GreatRivers),
            flat_share: recipe.number(NumberKey::FlatShare),
            neck: recipe.number(NumberKey::Neck),
            oxbow_life: oxbow_life(recipe.number(NumberKey::Oxbows)),
            min_clearance: recipe.number(NumberKey::Clearance) * stream_spacing,
            taper: recipe.number(NumberKey::Taper),
        }
    }

    /// Returns the distance between the vertices of a river of a given width, in units: a wide river's bends need no more vertices.
    #[inline]
    pub fn step(&self, width: f32) -> f32 {
        const A_WIDTH: f32 = 0.25;
        fast_max(self.spacing, width * A_WIDTH)
    }

    /// Returns half the width of a river of a given discharge, in units, before its banks vary.
    pub fn half_width(&self, discharge: u32) -> f32 {
        let share = discharge as f32 / self.total_discharge as f32;
        fast_max(self.max_width * share.sqrt(), self.hairline) * 0.5
    }

    /// Returns noise along courses, from -1 to 1.
    pub(super) fn width_noise(&self) -> FastNoiseLite {
        self.noise(0, 1.0, 2)
    }

    /// Returns noise over the map, which tells where rivers meander gently.
    pub(super) fn gentle_noise(&self) -> FastNoiseLite {
        const BUMPS: f32 = 3.0;
        self.noise(1, BUMPS / self.domain.size.min_element(), 2)
    }

    fn noise(&self, index: u32, frequency: f32, octaves: i32) -> FastNoiseLite {
        self.seed.noise(Purpose::Courses, index, frequency, octaves)
    }
}

/// Converts the recipe's share to the life of oxbow lakes: 0 at 0, the default 1 at a half, infinite at 1.
fn oxbow_life(share: f32) -> f32 {
    share / (1.0 - share)
}

/// The least width of a stream, in units, and as a share of the distance between streams.
const HAIRLINE: f32 = 0.6;
const HAIRLINE_SHARE: f32 = 0.1;

/// The distance between vertices as a share of that between streams, fine enough for bends narrower than that; and its limits, in units.
const SPACING: f32 = 0.32;
const LEAST_SPACING: f32 = 0.25;
const MOST_SPACING: f32 = 5.0;
