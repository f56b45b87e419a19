//! Hills: on divides, where there is room for them; and where the relief is known, larger the higher the land is, mountains at last.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::divides::{Divide, Divides};
use super::free::{FROM_BANKS, FreeGround, discs_at};
use super::input::{Heights, SceneryInput};
use super::shapes::Feature;
use super::standing::Standing;
use crate::base::random::{ItemHash, Purpose};
use crate::base::sort;

/// Half of a hill's width at least, and of one on usual and on main divides at most, in units.
const LEAST: f32 = 5.4;
const MOST: f32 = 9.5;
const MOST_ON_MAIN: f32 = 12.5;
/// How wide a hill is beside its disc around the middle, in which there may be no water.
const REACH: f32 = 1.06;
/// What distance from rivers main divides count more, in units.
const MAIN_FIRST: f32 = 8.0;
/// How far middles of hills are apart, in sums of halves of their widths: they overlap a little, as in a range.
const SPACING: f32 = 0.8;
/// How far from the coast hills begin, and over how much more they become frequent, in units.
const FROM_COAST: f32 = 18.0;
const FADE: f32 = 40.0;
/// How far they keep from ridges, in units.
const FROM_RIDGES: f32 = 8.0;
/// Ranges and gaps between them: about how long they are, in units, and which share of divides are gaps.
const RANGE: f32 = 150.0;
/// Land as high as this has hills beside divides, and as high as that mountains, as shares of the highest.
const HIGH: f32 = 0.42;
const ALPINE: f32 = 0.62;

/// How far inland main divides have mountains in the middle of their ranges, where heights are not known, in units.
const FAR: f32 = 90.0;

/// A place where a hill might stand.
struct Candidate {
    number: u32,
    at: Vec2,
    half: f32,
    feature: Feature,
    rank: f32,
}

/// The hills of a map, those first that stand in the best places.
pub fn hills(input: &SceneryInput<'_>, points: &[Vec2], ground: &FreeGround, divides: &Divides) -> Vec<Standing> {
    let rules = Rules { input, ground, divides, chance: input.seed.item_hash(Purpose::Scenery), ranges: ranges(input) };
    let candidates: Vec<Candidate> =
        (0..).zip(points).filter_map(|(number, at)| rules.candidate(number, *at)).collect();
    let (mut spots, mut hills) = (ground.spots(), Vec::new());
    for i in sort::argsort(candidates.iter().map(|candidate| sort::key(-candidate.rank))) {
        let candidate = &candidates[i];
        let spot = (candidate.at, candidate.half * SPACING);
        let hill = if spots.is_free(spot) { rules.hill(candidate) } else { None };
        if let Some(hill) = hill {
            spots.add(spot);
            hills.push(hill);
        }
    }
    hills
}

/// Where ranges are, from -1 to 1.
fn ranges(input: &SceneryInput<'_>) -> FastNoiseLite {
    input.seed.noise(Purpose::Scenery, 2, 1.0 / RANGE, 2)
}

struct Rules<'a> {
    input: &'a SceneryInput<'a>,
    ground: &'a FreeGround,
    divides: &'a Divides,
    chance: ItemHash,
    ranges: FastNoiseLite,
}

impl Rules<'_> {
    fn candidate(&self, number: u32, at: Vec2) -> Option<Candidate> {
        let inland = self.input.coast.map_or(f32::MAX, |coast| coast.height(at)) - FROM_COAST;
        if inland <= 0.0 {
            return None;
        }
        let divide = self.divides.at(at);
        let high = self.input.heights.map(|heights| heights.share(at));
        if divide == Divide::No && high.is_none_or(|high| high < HIGH) {
            return None;
        }
        let is_main = divide == Divide::Main;
        // In ranges most places have a hill, between them few.
        let range = (0.55 + 1.4 * self.ranges.get_noise_2d(at.x, at.y)).clamp(0.12, 1.0);
        let often = match high {
            Some(high) => range * ((high - 0.1) * 3.0).clamp(0.0, 1.0),
            None if is_main => range.max(0.7),
            None => range * 0.9,
        };
        if self.chance.unit([number, 0, 1]) >= self.input.hills * often * (inland / FADE).min(1.0) {
            return None;
        }
        let room = self.ground.distance_to_bank(at, 2.0 * MOST_ON_MAIN);
        let most = match high {
            Some(high) => LEAST + (MOST_ON_MAIN - LEAST) * (high * 1.15).min(1.0),
            None if is_main => MOST_ON_MAIN,
            None => MOST,
        };
        let uneven = 0.86 + 0.14 * self.chance.unit([number, 1, 1]);
        let half = most.min((room - FROM_BANKS) / REACH) * uneven;
        let is_alpine = match high {
            Some(high) => high >= ALPINE,
            None => is_main && inland >= FAR && half >= MOST && range >= 1.0,
        };
        let feature = if is_alpine { Feature::Mountain } else { Feature::Hill };
        let rank = room + if is_main { MAIN_FIRST } else { 0.0 } + high.map_or(0.0, |high| high * 2.0 * MAIN_FIRST);
        (half >= LEAST).then_some(Candidate { number, at, half, feature, rank })
    }

    /// The hill of a candidate, if all of it is clear.
    fn hill(&self, candidate: &Candidate) -> Option<Standing> {
        let &Candidate { number, at, half, feature, .. } = candidate;
        // The middle of its height is where the room is.
        let foot = at + Vec2::new(0.0, 0.3 * half);
        let is_off_ridges = discs_at(feature, foot, half)
            .all(|(at, radius)| self.ground.distance_to_ridge(at, radius + FROM_RIDGES) >= radius + FROM_RIDGES);
        let is_clear = is_off_ridges && self.ground.is_clear(self.input, feature, foot, half);
        is_clear.then(|| Standing::new(feature, foot, half, number, self.chance.unit([number, 2, 1])))
    }
}

impl Heights<'_> {
    /// How high the land is at a place, as a share of the highest; 0 at sea.
    pub fn share(&self, at: Vec2) -> f32 {
        let rows = self.heights.len() / self.columns.max(1);
        let [column, row] = [(at.x, self.columns), (at.y, rows)]
            .map(|(x, count)| ((x / self.cell_size) as usize).min(count.max(1) - 1));
        let height = self.heights.get(row * self.columns + column).copied().unwrap_or(0.0);
        if self.highest > 0.0 { (height / self.highest).clamp(0.0, 1.0) } else { 0.0 }
    }
}
