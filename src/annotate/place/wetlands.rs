//! Marshes on flat ground beside great rivers and low by the sea, and rows of small trees along great rivers. They go where their river goes.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::free::FreeGround;
use super::input::SceneryInput;
use super::pen::Feature;
use super::standing::Standing;
use crate::base::random::{ItemHash, Purpose};

/// The greatest distance of rows of trees from banks, in units, and the share of the points there that have a tree.
const ROW: f32 = 8.5;
const IN_ROWS: f32 = 0.85;
/// The greatest distance of marshes from banks, in units.
pub const MARSH: f32 = 30.0;
/// The greatest height of marshes, as a share of the highest land, and their greatest distance from the coast, in units, where heights are
/// not known.
pub const LOW: f32 = 0.09;
const NEAR_THE_SEA: f32 = 70.0;
/// The greatest rise or fall of the land around marshes, as a share of the highest, over a distance to each side, in units.
pub const LEVEL: f32 = 0.05;
pub const AROUND: f32 = 8.0;
/// The size of marshes and of the gaps between them, in units.
const SIZE: f32 = 70.0;
/// The noise from which on there are marshes, in a map with few woods, and how much less it takes with all.
const FEW: f32 = 0.34;
const LESS: f32 = 0.5;
/// How much less it takes where so much more rain falls than in a temperate climate.
const LESS_IN_THE_RAIN: f32 = 0.8;

/// The marshes and rows of a map.
pub struct Wetlands<'a> {
    input: &'a SceneryInput<'a>,
    ground: &'a FreeGround,
    chance: ItemHash,
    noise: FastNoiseLite,
}

impl<'a> Wetlands<'a> {
    /// Prepares the placement of marshes and rows of trees on a map.
    pub fn new(input: &'a SceneryInput<'a>, ground: &'a FreeGround) -> Self {
        let noise = input.seed.noise(Purpose::Scenery, 3, 1.0 / SIZE, 2);
        Self { input, ground, chance: input.seed.item_hash(Purpose::Scenery), noise }
    }

    /// Returns the marsh or the tree of a row at a point, if it has one.
    pub fn at(&self, number: u32, at: Vec2, inland: f32) -> Option<Standing> {
        let away = self.ground.distance_to_great_bank(at, MARSH);
        if away >= MARSH {
            return None;
        }
        let [likely, size, shape] = [0, 1, 2].map(|use_of| self.chance.unit([number, use_of, 3]));
        let weather = &self.input.weather;
        let wet = self.noise.get_noise_2d(at.x, at.y) - FEW
            + LESS * self.input.woods
            + LESS_IN_THE_RAIN * (weather.rain - 0.5 + weather.more_rain(at));
        if wet > 0.0 && self.is_low(at, inland) {
            return Some(Standing::new(Feature::Marsh, at, 2.3 + 0.5 * size, number, shape));
        }
        let is_row = away < ROW && likely < IN_ROWS * (self.input.woods * 2.0).min(1.0);
        is_row.then(|| Standing::new(Feature::Willow, at, 4.2 + 1.4 * size, number, shape))
    }

    /// Returns `true` if the land lies low and level.
    fn is_low(&self, at: Vec2, inland: f32) -> bool {
        let Some(heights) = self.input.heights else { return inland < NEAR_THE_SEA };
        let here = heights.share(at);
        let ways = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y];
        here <= LOW && ways.into_iter().all(|way| (heights.share(at + way * AROUND) - here).abs() <= LEVEL)
    }
}
