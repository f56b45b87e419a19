//! Woods: trees where noise is high and no water, letter or hill is near. Each of the points of the map has a tree or none for itself, so
//! what moves takes away the trees in its way and moves no other. Woods are closed up to their edge; beyond it trees stand alone.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::free::{FOOT_FROM_BANKS, FreeGround, Spots};
use super::input::SceneryInput;
use super::pen::Feature;
use super::standing::Standing;
use super::wetlands::Wetlands;
use crate::base::random::{ItemHash, Purpose};

/// The greatest size of woods and their glades, in units, and the number of sizes, each half as large as the one before.
const SIZE: f32 = 150.0;
const OCTAVES: i32 = 3;
/// The noise from which on there are woods, where next to all land is wooded and where next to none is.
const NONE: f32 = 0.54;
const ALL: f32 = -0.6;
/// The lower noise that trees that stand alone need, and the share of the points there that have one.
const FRINGE: f32 = 0.16;
const ALONE: f32 = 0.1;
/// The distance from the coast at which woods begin, and the further one over which they need more noise, with the greatest addition, in
/// units.
const FROM_COAST: f32 = 10.0;
const SHORE: f32 = 16.0;
const MORE_AT_THE_SHORE: f32 = 0.25;
/// The tree line, where the relief is known: from which height on it takes more noise for trees, as a share of the highest, and how much
/// more at the highest.
const TREE_LINE: f32 = 0.4;
const MORE_AT_THE_TOP: f32 = 3.2;
/// How much higher the tree line lies where it is warmest than in a temperate climate, and lower where it is coldest.
const HIGHER_WHERE_WARM: f32 = 0.25;
/// How much less noise it takes for trees where so much more rain falls than elsewhere on the map, and for conifers where it is coldest.
const LESS_IN_THE_RAIN: f32 = 1.2;
const LESS_IN_THE_COLD: f32 = 0.8;
/// The second noise that conifers need on the lowest land, and by how much less on the highest.
const CONIFERS: f32 = 0.75;
const FEWER_BELOW: f32 = 3.0;
/// The distance from the coast that counts for half of the greatest height, where heights are not known, in units.
const HALFWAY_UP: f32 = 150.0;
/// The heights of trees, in units: of the lowest, and the difference to the highest.
const ROUND: [f32; 2] = [7.2, 2.0];
const POINTED: [f32; 2] = [5.6, 2.6];

/// Places the trees and marshes of a map, in the order of its points.
pub fn woods(input: &SceneryInput<'_>, points: &[Vec2], ground: &FreeGround, hills: &[Standing]) -> Vec<Standing> {
    let mut taken = ground.spots(1.0);
    hills.iter().flat_map(Standing::discs).for_each(|disc| taken.add(disc));
    let trees = Trees::new(input);
    let wetlands = Wetlands::new(input, ground);
    let has_room = |one: &Standing| is_free(input, ground, &taken, one);
    let plant = |(number, &at): (u32, &Vec2)| {
        let inland = input.coast().map_or(f32::MAX, |coast| coast.height(at)) - FROM_COAST;
        // Most points are at sea or beside a brook, which is told sooner than what noise there is.
        if inland <= 0.0 || ground.distance_to_bank(at, FOOT_FROM_BANKS) < FOOT_FROM_BANKS {
            return None;
        }
        let tree = trees.at(number, at, inland).filter(has_room);
        tree.or_else(|| wetlands.at(number, at, inland).filter(has_room))
    };
    (0..).zip(points).filter_map(plant).collect()
}

fn is_free(input: &SceneryInput<'_>, ground: &FreeGround, taken: &Spots, one: &Standing) -> bool {
    one.discs().all(|disc| taken.is_free(disc)) && ground.is_clear(input, one)
}

/// The trees that a map would have without water, letters and hills.
struct Trees<'a> {
    input: &'a SceneryInput<'a>,
    chance: ItemHash,
    noise: FastNoiseLite,
}

impl<'a> Trees<'a> {
    fn new(input: &'a SceneryInput<'a>) -> Self {
        let noise = input.seed.noise(Purpose::Scenery, 1, 1.0 / SIZE, OCTAVES);
        Self { input, chance: input.seed.item_hash(Purpose::Scenery), noise }
    }

    /// Returns the tree of a point, if it has one.
    fn at(&self, number: u32, at: Vec2, inland: f32) -> Option<Standing> {
        let share = self.input.heights.map_or((0.5 * inland / HALFWAY_UP).min(0.5), |heights| heights.share(at));
        let weather = &self.input.weather;
        let warmer = 2.0 * weather.warmth - 1.0;
        let tree_line = TREE_LINE + HIGHER_WHERE_WARM * warmer;
        let above = (self.input.heights.map_or(0.0, |_| share) - tree_line).max(0.0);
        let shore = MORE_AT_THE_SHORE * (1.0 - inland / SHORE).max(0.0);
        let dry = -LESS_IN_THE_RAIN * weather.more_rain(at);
        let least = NONE + (ALL - NONE) * self.input.woods + shore + MORE_AT_THE_TOP * above + dry;
        let over = self.noise.get_noise_2d(at.x, at.y) - least;
        let is_closed = over >= 0.0;
        if over < -FRINGE || !is_closed && self.chance.unit([number, 0, 2]) >= ALONE {
            return None;
        }
        let is_conifer = self.noise.get_noise_2d(at.x + 0.5 * SIZE, at.y)
            > CONIFERS + LESS_IN_THE_COLD * warmer - FEWER_BELOW * share;
        let (feature, [low, more]) = match (is_conifer, is_closed) {
            (true, _) => (Feature::Conifer, POINTED),
            (false, true) => (Feature::Canopy, ROUND),
            (false, false) => (Feature::Broadleaf, ROUND),
        };
        let size = low + more * self.chance.unit([number, 1, 2]);
        Some(Standing::new(feature, at, size, number, self.chance.unit([number, 2, 2])))
    }
}
