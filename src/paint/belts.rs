//! Flood plains, and belts of scars that are older than anything that a map knows of its rivers, as Fisk found several
//! beside each other along the Mississippi.
//!
//! Meandering starts from rivers without a past. So the scars under those of the kept rounds are invented: loops of
//! Langbein and Leopold (1966), whose direction follows a sine, along a smoothed course, each belt with loops elsewhere
//! and several positions while they grew.

use glam::Vec2;

use crate::base::geometry::{direction, distance};
use crate::base::random::{Purpose, Seed};
use crate::base::trigonometry::sine_and_cosine;
use crate::network::{Network, PastCourse, PastCourses, Place};

/// The flood plains of great rivers with their old scars.
#[derive(Clone, Debug, Default)]
pub(crate) struct Belts {
    pub plains: Vec<PastCourse>,
    /// The courses of all great rivers, position by position, the oldest first.
    pub scars: Vec<Vec<PastCourse>>,
}

/// The number of belts, and of positions in each.
const BELTS: u32 = 3;
const POSITIONS: u32 = 3;

/// The distance from one side of a plain to the other, in widths of the river.
const PLAIN: f32 = 11.0;

/// The least half width of a river with a plain, in units.
const LEAST: f32 = 0.7;

impl Belts {
    /// The number of scars over each other.
    pub const SCARS: usize = (BELTS * POSITIONS) as usize;

    /// Finds the plains and invents the scars, from the first courses that are kept. None if rivers do not meander.
    pub fn of(network: &Network, past: &PastCourses) -> Self {
        let Some(first) = past.rounds().first() else { return Self::default() };
        let chance = Seed::from_text("").item_hash(Purpose::Courses);
        let axes = first.courses.iter().filter_map(|course| {
            let identity = network.rivers.get(course.river as usize)?.identity;
            Some((course.river, Axis::of(&course.line)?, identity))
        });
        let axes: Vec<(u32, Axis, u32)> = axes.collect();
        let plains = axes.iter().map(|(river, axis, _)| PastCourse { river: *river, line: axis.plain() }).collect();
        let scars = (0..BELTS * POSITIONS).map(|i| {
            let (belt, grown) = (i / POSITIONS, 0.55 + 0.45 * (i % POSITIONS) as f32 / (POSITIONS - 1) as f32);
            let course = |(river, axis, identity): &(u32, Axis, u32)| {
                let chance = |loops: u32, of: u32| chance.unit([*identity, belt << 16 | loops, of]);
                PastCourse { river: *river, line: axis.scar(&chance, grown, belt) }
            };
            axes.iter().map(course).collect()
        });
        Self { plains, scars: scars.collect() }
    }
}

/// The smoothed course of a river, with its width, in even steps.
#[derive(Clone, Debug)]
struct Axis(Vec<Place>);

impl Axis {
    /// The length of a step, in units.
    const STEP: f32 = 6.0;

    /// Smooths a course from where it is wide enough; `None` if it is too short.
    fn of(line: &[Place]) -> Option<Self> {
        const ROUNDS: u32 = 30;
        let (mut even, mut ahead) = (Vec::new(), 0.0);
        for pair in line.windows(2).skip_while(|pair| pair[1].half < LEAST) {
            let length = distance(pair[0].at, pair[1].at);
            while ahead < length {
                even.push(between(pair[0], pair[1], ahead / length));
                ahead += Self::STEP;
            }
            ahead -= length;
        }
        for _ in 0..ROUNDS {
            let before = even.clone();
            for (place, around) in even.iter_mut().skip(1).zip(before.windows(3)) {
                *place = between(around[1], between(around[0], around[2], 0.5), 0.5);
            }
        }
        (even.len() > 3).then_some(Self(even))
    }

    /// Returns the place so many steps along the axis, and the way across.
    fn at(&self, steps: f32) -> (Place, Vec2) {
        let last = self.0.len() - 1;
        let i = (steps.max(0.0) as usize).min(last - 1);
        let across = |i: usize| direction(self.0[(i + 1).min(last)].at - self.0[i.saturating_sub(1)].at).perp();
        let share = steps - i as f32;
        (between(self.0[i], self.0[i + 1], share), across(i).lerp(across(i + 1), share))
    }

    /// Returns the plain: the axis as wide as loops reach, from a point at its head.
    fn plain(&self) -> Vec<Place> {
        const HEAD: f32 = 0.125;
        let place = |(i, place): (usize, &Place)| {
            let half = place.half * PLAIN * (i as f32 * HEAD).min(1.0);
            Place { half, ..*place }
        };
        self.0.iter().enumerate().map(place).collect()
    }

    /// Makes a scar: loops to both sides in turn, grown to a share. `chance` gives each loop its random numbers.
    fn scar(&self, chance: &dyn Fn(u32, u32) -> f32, grown: f32, belt: u32) -> Vec<Place> {
        /// Points of a loop, its length in widths of the river, and its direction where it begins, in radians.
        const POINTS: u8 = 6;
        const LENGTH: [f32; 2] = [4.2, 6.4];
        const ANGLE: [f32; 2] = [1.05, 1.55];
        /// The farthest of a belt from the axis, in widths.
        const ASIDE: f32 = 1.0;
        /// The width of a scar, in widths of the river: silt has narrowed it.
        const NARROWED: f32 = 0.8;
        let (mut line, mut along, mut loops) = (Vec::new(), 0.0, belt);
        let end = (self.0.len() - 1) as f32;
        let among = |[least, most]: [f32; 2], of: u32, loops: u32| least + (most - least) * chance(loops, of);
        while along < end {
            let width = 2.0 * self.at(along).0.half;
            let length = (among(LENGTH, 0, loops) * width / Self::STEP).max(0.5).min(end - along + 0.01);
            // Scars begin and end in the river.
            let open = (along * 0.2).min((end - along) * 0.1).min(1.0);
            let angle = among(ANGLE, 1, loops) * grown * open;
            let aside = [loops, loops + 1].map(|loops| among([-ASIDE, ASIDE], 2, loops) * width * open);
            let side = if loops.is_multiple_of(2) { length } else { -length } * Self::STEP;
            for (i, [way, off]) in arc(angle, POINTS).into_iter().enumerate() {
                let (place, across) = self.at(along + way * length);
                let drift = aside[0] + (aside[1] - aside[0]) * f32::from(i as u8) / f32::from(POINTS);
                let at = place.at + across * (off * side + drift);
                line.push(Place { at, half: place.half * NARROWED });
            }
            (along, loops) = (along + length, loops + 1);
        }
        line.extend(self.0.last());
        line
    }
}

/// Returns the points of a loop that begins and ends on its axis, as shares of the way along: along and off it. Its
/// direction turns from an angle to the opposite one as a cosine does.
fn arc(angle: f32, points: u8) -> Vec<[f32; 2]> {
    let mut at = Vec2::ZERO;
    let mut line = vec![at];
    for i in 0..points {
        let (_, turned) = sine_and_cosine(std::f32::consts::PI * (f32::from(i) + 0.5) / f32::from(points));
        let (sine, cosine) = sine_and_cosine(angle * turned);
        at += Vec2::new(cosine, sine);
        line.push(at);
    }
    line.pop();
    line.into_iter().map(|point| (point / at.x).to_array()).collect()
}

fn between(from: Place, to: Place, share: f32) -> Place {
    Place { at: from.at.lerp(to.at, share), half: from.half + (to.half - from.half) * share }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::geometry::meet;
    use crate::network::{NONE, PastRound, River};

    const HALF: f32 = 2.0;

    /// Makes the belts of a river 600 units long, meandering or not.
    fn belts(meanders: bool) -> Belts {
        let river = River { start: 0, end: 0, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: 7 };
        let network = Network { rivers: vec![river], ..Network::default() };
        let place = |i: u8| Place { at: Vec2::new(f32::from(i) * 5.0, 300.0), half: HALF };
        let course = PastCourse { river: 0, line: (0..120).map(place).collect() };
        let round = PastRound { round: 0, courses: vec![course], loops: Vec::new() };
        let rounds = if meanders { vec![round] } else { Vec::new() };
        Belts::of(&network, &PastCourses::of_rounds(vec![0], rounds))
    }

    fn crossings(a: &[Place], b: &[Place]) -> usize {
        let pairs = a.windows(2).flat_map(|a| b.windows(2).map(move |b| (a, b)));
        pairs.filter(|(a, b)| meet((a[0].at, a[1].at), (b[0].at, b[1].at))).count()
    }

    #[test]
    fn belts_cross_each_other_within_the_plain() {
        let belts = belts(true);
        assert_eq!((belts.plains.len(), belts.scars.len()), (1, Belts::SCARS));
        let line = |position: usize| &belts.scars[position][0].line;
        let grown = POSITIONS as usize;
        assert!(crossings(line(grown - 1), line(2 * grown - 1)) > 10, "{}", crossings(line(2), line(5)));
        let off = |place: &Place| (place.at.y - 300.0).abs();
        let widest = belts.scars.iter().flatten().flat_map(|scar| &scar.line).map(off).fold(0.0, f32::max);
        assert!((4.0 * HALF..PLAIN * HALF).contains(&widest), "{widest}");
    }

    #[test]
    fn positions_of_a_belt_grow() {
        let belts = belts(true);
        let length = |i: usize| belts.scars[i][0].line.windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum();
        let lengths: [f32; 3] = [0, 1, 2].map(length);
        assert!(lengths[0] > 600.0 && lengths[1] > lengths[0] * 1.1 && lengths[2] > lengths[1] * 1.1, "{lengths:?}");
    }

    #[test]
    fn rivers_that_do_not_meander_have_no_belts() {
        let belts = belts(false);
        assert!(belts.plains.is_empty() && belts.scars.is_empty());
    }
}
