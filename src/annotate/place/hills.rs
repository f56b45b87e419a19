//! Hills: on divides, where there is room for them; and where the relief is known, larger the higher the land is, mountains at last. They
//! stand in rows, one before the other, so that the nearer hide the feet of the farther, and become ranges.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::free::{FROM_BANKS, FreeGround, Spots};
use super::input::{Heights, SceneryInput};
use super::pen::Feature;
use super::standing::Standing;
use crate::annotate::divides::{Divide, Divides};
use crate::base::random::{ItemHash, Purpose};
use crate::base::sort;

/// The least and the greatest half of a hill's width, and of a mountain's, in units.
const LEAST: f32 = 3.5;
const MOST: f32 = 9.0;
const LEAST_MOUNTAIN: f32 = 3.7;
const MOST_MOUNTAIN: f32 = 17.0;
/// The width of a hill over that of the disc around its middle in which there may be no water.
const REACH: f32 = 1.06;
/// The distance of banks that leaves room for the largest mountain, and the steps by which roomier places are looked for, in units.
const ENOUGH: f32 = MOST_MOUNTAIN * REACH + FROM_BANKS;
const STEPS: [f32; 2] = [2.8, 1.4];
/// The number of sizes in which a hill is tried, and each size over the one before.
const TRIES: u8 = 4;
const SMALLER: f32 = 0.84;
/// The additional distance from rivers that main divides count for, in units.
const MAIN_FIRST: f32 = 8.0;
/// The distance between the middles of hills and of mountains, in sums of halves of their widths: they overlap, as in a range.
const SPACING: f32 = 0.8;
const SPACING_IN_RANGES: f32 = 0.56;
/// The factor by which they stand closer one before the other than side by side.
const BEFORE: f32 = 1.7;
/// The distance from the coast at which hills begin, and the further one over which they become frequent, in units.
const FROM_COAST: f32 = 14.0;
const FADE: f32 = 30.0;
/// The share of the points of a range at which a hill is tried, on maps with as many hills as there can be.
const TAKEN: f32 = 0.95;
/// The least distance of hills from ridges, in units.
const FROM_RIDGES: f32 = 8.0;
/// The approximate length of ranges and of the gaps between them, in units.
const RANGE: f32 = 150.0;
/// The heights from which on land has hills beside divides, and mountains, as shares of the highest.
pub const HIGH: f32 = 0.26;
pub const ALPINE: f32 = 0.45;
/// The distance from the coast at which main divides have mountains in the middle of their ranges, where heights are not known, in units.
const FAR: f32 = 70.0;

/// A place where a hill might stand.
struct Candidate {
    number: u32,
    at: Vec2,
    divide: Divide,
    range: f32,
    rank: f32,
}

/// A hill before its size is known.
struct Plan {
    at: Vec2,
    /// Half of its width, if nothing but water is in its way.
    half: f32,
    feature: Feature,
    /// Its height among its kind, from 0 to 1.
    rise: f32,
}

/// Places the hills of a map, those in the best places first.
pub fn hills(input: &SceneryInput<'_>, points: &[Vec2], ground: &FreeGround, divides: &Divides) -> Vec<Standing> {
    let rules = Rules { input, ground, divides, chance: input.seed.item_hash(Purpose::Scenery), ranges: ranges(input) };
    let candidates: Vec<Candidate> =
        (0..).zip(points).filter_map(|(number, at)| rules.candidate(number, *at)).collect();
    let (mut spots, mut hills) = (ground.spots(BEFORE), Vec::new());
    for i in sort::argsort(candidates.iter().map(|candidate| sort::key(-candidate.rank))) {
        if let Some((hill, spot)) = rules.hill(&candidates[i], &spots) {
            spots.add(spot);
            hills.push(hill);
        }
    }
    hills
}

/// Makes the noise that says where ranges are, from -1 to 1.
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
        let inland = self.input.coast().map_or(f32::MAX, |coast| coast.height(at)) - FROM_COAST;
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
            // Mountains are where the land is high, whatever the noise says.
            Some(high) if high >= ALPINE => 1.0,
            Some(high) => TAKEN * range * ((high - 0.1) * 3.0).clamp(0.0, 1.0),
            None if is_main => TAKEN * range.max(0.7),
            None => TAKEN * range * 0.9,
        };
        if self.chance.unit([number, 0, 1]) >= self.input.hills * often * (inland / FADE).min(1.0) {
            return None;
        }
        let room = self.divides.distance_to_river(at).min(2.0 * MOST_MOUNTAIN);
        let rank = room + if is_main { MAIN_FIRST } else { 0.0 } + high.map_or(0.0, |high| high * 2.0 * MAIN_FIRST);
        Some(Candidate { number, at, divide, range, rank })
    }

    /// Plans the largest hill that a candidate has room for beside water.
    fn plan(&self, candidate: &Candidate) -> Plan {
        let (at, room) = self.roomiest(candidate.at);
        let high = self.input.heights.map(|heights| heights.share(at));
        let is_alpine = match high {
            Some(high) => high >= ALPINE,
            None => {
                let inland = self.input.coast().map_or(f32::MAX, |coast| coast.height(at)) - FROM_COAST;
                candidate.divide == Divide::Main && inland >= FAR && candidate.range >= 0.8
            }
        };
        let rise = match high {
            Some(high) if is_alpine => (high - ALPINE) / (1.0 - ALPINE),
            Some(high) => high / ALPINE,
            None => candidate.range,
        };
        let (feature, [least, most]) = match is_alpine {
            true => (Feature::Mountain, [LEAST_MOUNTAIN, MOST_MOUNTAIN]),
            false => (Feature::Hill, [LEAST, MOST]),
        };
        let uneven = 0.8 + 0.2 * self.chance.unit([candidate.number, 1, 1]);
        let largest = (least + (most - least) * (0.35 + 0.65 * rise)) * uneven;
        Plan { at, half: largest.min((room - FROM_BANKS) / REACH), feature, rise }
    }

    /// Looks for the place with the most room that a few steps lead to. Returns it with its distance from banks.
    fn roomiest(&self, at: Vec2) -> (Vec2, f32) {
        let mut best = (at, self.ground.distance_to_bank(at, ENOUGH));
        for step in STEPS {
            for there in [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].map(|way| best.0 + way * step) {
                // It cannot be more by more than the step.
                let room = self.ground.distance_to_bank(there, (best.1 + step).min(ENOUGH));
                if room > best.1 {
                    best = (there, room);
                }
            }
        }
        best
    }

    /// Returns the hill of a candidate, as large as there is room for, and the spot that it takes; `None` if there is room for none.
    fn hill(&self, candidate: &Candidate, spots: &Spots) -> Option<(Standing, (Vec2, f32))> {
        // Most candidates stand where there is a hill by now.
        if !spots.is_free((candidate.at * Vec2::new(1.0, BEFORE), 0.0)) {
            return None;
        }
        let plan = self.plan(candidate);
        let mut half = plan.half;
        for _ in 0..TRIES {
            if half < LEAST {
                return None;
            }
            // A mountain that would be too small is a hill.
            let feature = if half < LEAST_MOUNTAIN { Feature::Hill } else { plan.feature };
            let spacing = if feature == Feature::Mountain { SPACING_IN_RANGES } else { SPACING };
            let spot = (plan.at * Vec2::new(1.0, BEFORE), half * spacing);
            let hill = self.standing(candidate.number, &plan, feature, half);
            if spots.is_free(spot) && self.is_clear(&hill) {
                return Some((hill, spot));
            }
            half *= SMALLER;
        }
        None
    }

    fn standing(&self, number: u32, plan: &Plan, feature: Feature, half: f32) -> Standing {
        // The middle of its height is where the room is.
        let foot = plan.at + Vec2::new(0.0, if feature == Feature::Hill { 0.3 } else { 0.5 } * half);
        let shape = 0.72 * plan.rise.min(1.0) + 0.28 * self.chance.unit([number, 2, 1]);
        Standing::new(feature, foot, half, number, shape)
    }

    fn is_clear(&self, hill: &Standing) -> bool {
        let is_off_ridges =
            |(at, radius): (Vec2, f32)| self.ground.distance_to_ridge(at, radius + FROM_RIDGES) >= radius + FROM_RIDGES;
        hill.discs().all(is_off_ridges) && self.ground.is_clear(self.input, hill)
    }
}

impl Heights<'_> {
    /// Returns the height of the land at a place, as a share of the highest; 0 at sea.
    pub fn share(&self, at: Vec2) -> f32 {
        let rows = self.heights.len() / self.columns.max(1);
        let [column, row] = [(at.x, self.columns), (at.y, rows)]
            .map(|(x, count)| ((x / self.cell_size) as usize).min(count.max(1) - 1));
        let height = self.heights.get(row * self.columns + column).copied().unwrap_or(0.0);
        if self.highest > 0.0 { (height / self.highest).clamp(0.0, 1.0) } else { 0.0 }
    }
}
