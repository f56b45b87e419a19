//! Woods: trees where noise is high and no water, letter or hill is near. Each of the points of the map has a tree or none for itself, so
//! what moves takes away the trees in its way and moves no other.

use glam::Vec2;

use super::free::{FOOT_FROM_BANKS, FreeGround, Spots, discs_at};
use super::input::SceneryInput;
use super::shapes::Feature;
use super::standing::Standing;
use crate::base::random::Purpose;

/// How large woods and their glades are, at most, in units, and in how many sizes, each half as large as the one before.
const SIZE: f32 = 150.0;
const OCTAVES: i32 = 3;
/// The noise from which on there are woods, where next to all land is wooded and where next to none is; and how soon they are dense beyond.
const NONE: f32 = 0.56;
const ALL: f32 = -0.6;
const EDGE: f32 = 6.0;
/// How much more noise it takes for conifers.
const CONIFERS: f32 = 0.2;
/// How far from the coast woods begin, and over how much more they become dense, in units.
const FROM_COAST: f32 = 10.0;
const FADE: f32 = 14.0;
/// How high trees are, in units: the lowest, and how much higher others are.
const LEAST: f32 = 6.2;
const MORE: f32 = 2.6;
/// The tree line, where the relief is known: from which height on trees become rare, and over how much more, as shares of the highest.
const TREE_LINE: f32 = 0.5;
const RARER: f32 = 0.2;

/// The trees of a map, in the order of its points.
pub fn woods(input: &SceneryInput<'_>, points: &[Vec2], ground: &FreeGround, hills: &[Standing]) -> Vec<Standing> {
    let (chance, noise) =
        (input.seed.item_hash(Purpose::Scenery), input.seed.noise(Purpose::Scenery, 1, 1.0 / SIZE, OCTAVES));
    let mut taken = ground.spots();
    hills.iter().flat_map(|hill| discs_at(hill.feature(), hill.foot, hill.size)).for_each(|disc| taken.add(disc));
    let least = NONE + (ALL - NONE) * input.woods;
    let tree = |(number, &at): (u32, &Vec2)| {
        let inland = input.coast.map_or(f32::MAX, |coast| coast.height(at)) - FROM_COAST;
        if inland <= 0.0 {
            return None;
        }
        let over = noise.get_noise_2d(at.x, at.y) - least;
        let often = (over * EDGE).clamp(0.0, 1.0) * (inland / FADE).min(1.0);
        let above = input.heights.map_or(0.0, |heights| heights.share(at) - TREE_LINE);
        if chance.unit([number, 0, 2]) >= often * (1.0 - above / RARER).clamp(0.0, 1.0) {
            return None;
        }
        let is_conifer = noise.get_noise_2d(at.x + 0.5 * SIZE, at.y) > CONIFERS;
        let feature = if is_conifer { Feature::Conifer } else { Feature::Broadleaf };
        let size = LEAST + MORE * chance.unit([number, 1, 2]);
        is_free(input, ground, &taken, (feature, at, size))
            .then(|| Standing::new(feature, at, size, number, chance.unit([number, 2, 2])))
    };
    (0..).zip(points).filter_map(tree).collect()
}

fn is_free(input: &SceneryInput<'_>, ground: &FreeGround, taken: &Spots, tree: (Feature, Vec2, f32)) -> bool {
    let (feature, foot, size) = tree;
    ground.distance_to_bank(foot, FOOT_FROM_BANKS) >= FOOT_FROM_BANKS
        && discs_at(feature, foot, size).all(|disc| taken.is_free(disc))
        && ground.is_clear(input, feature, foot, size)
}
