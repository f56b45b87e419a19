//! Fairing: no wide river bends more sharply than its width allows.
//!
//! A vertex of a bend whose radius is too small is drawn toward the mean of the course within a width of it, again and
//! again until the bend is wide enough. It moves only if the segments that end there cross no others, come no nearer to
//! the banks of other rivers and stay on land. Tributaries that end in it move with it: the part of them that lies
//! under the river's own water is drawn straight to the junction.

use glam::Vec2;

mod curve;
mod plan;

use self::curve::Bend;
use self::plan::Plan;
use super::super::clearance::ClearanceGrid;
use super::super::settings::NetworkSettings;
use super::super::smooth::LEAST_CLEARANCE;
use super::super::{NONE, Network, Vertex};
use super::{CAP, Survey, keeps_off_frame};
use crate::base::geometry::{Segment, distance, fast_max, fast_min, gap, length, meet};
use crate::base::work;
use crate::land::Land;

/// The mobility above which narrow rivers are eased too, as if they were as wide as vertices are apart.
const FULLY: f32 = 0.5;

/// The work after which a step ends with the river that is at hand, in elementary steps. What becomes of the river does not depend on it.
pub(super) const WORK_A_STEP: u64 = 600_000;

/// The least distance between segments, in units, so that lines stay apart.
const NEAREST: f32 = 2.0 * LEAST_CLEARANCE;

/// The least move that is a reason for another pass, in widths.
const STILL: f32 = 0.01;

/// The state of a network whose bends are being eased, between two steps.
#[derive(Clone, Debug)]
pub(super) struct Easing {
    plan: Plan,
    /// The rivers that this pass has yet to ease, the last one first, and those in which it has moved vertices.
    waiting: Vec<u32>,
    restless: Vec<u32>,
    /// The number of passes left after this one.
    passes: u32,
    /// `true` once the ends of tributaries are straight.
    has_begun: bool,
    /// The positions of the vertices when easing began or the grid was entered again, and the greatest distance that any had moved
    /// by then.
    places: Vec<Vec2>,
    drift: f32,
}

impl Easing {
    /// Plans at most so many passes over all rivers, after a survey.
    pub fn new(network: &Network, survey: &Survey, passes: u32) -> Self {
        Self {
            plan: Plan::of(network),
            waiting: Vec::new(),
            restless: (0..network.rivers.len() as u32).collect(),
            passes,
            has_begun: false,
            places: network.vertices.iter().map(|vertex| vertex.at).collect(),
            drift: survey.drift,
        }
    }
}

/// A network while its bends are eased.
pub(super) struct Fairing<'a> {
    pub network: &'a mut Network,
    /// The grid of the survey, or one entered since.
    pub guard: &'a mut ClearanceGrid,
    pub land: Option<&'a Land>,
    pub settings: &'a NetworkSettings,
    /// The survey, which is kept up to date.
    pub survey: &'a mut Survey,
    pub easing: &'a mut Easing,
}

impl Fairing<'_> {
    /// Makes a step: eases rivers until that has taken so many elementary steps. Returns `true` if there is another step to make.
    pub fn step(&mut self, work: u64) -> bool {
        let begin = work::steps();
        if !std::mem::replace(&mut self.easing.has_begun, true) {
            self.straighten_ends();
        }
        while work::steps() - begin < work {
            let Some(river) = self.next_river() else { return false };
            if self.ease_river(river) {
                self.easing.restless.push(river);
            }
        }
        true
    }

    /// Takes the next river of this pass, or the first one of the next pass. `None` if nothing is left to ease.
    fn next_river(&mut self) -> Option<u32> {
        let Easing { waiting, restless, passes, .. } = &mut *self.easing;
        if waiting.is_empty() && *passes > 0 && !restless.is_empty() {
            *passes -= 1;
            waiting.extend(restless.drain(..).rev());
            self.enter_again();
        }
        self.easing.waiting.pop()
    }

    /// Enters the segments in the grid where they are now, if they may have moved so far that it has to be searched much wider.
    fn enter_again(&mut self) {
        if self.survey.drift > self.settings.spacing {
            self.guard.enter(self.network, &self.survey.downstream, &vec![0.0; self.network.vertices.len()]);
            self.easing.places = self.network.vertices.iter().map(|vertex| vertex.at).collect();
            (self.easing.drift, self.survey.drift) = (0.0, 0.0);
        }
    }

    /// Straightens the ends of tributaries that run past their junctions and come back.
    fn straighten_ends(&mut self) {
        for own in self.network.rivers.clone() {
            if own.junction == NONE || own.end <= own.start {
                continue;
            }
            let (junction, last) = (own.junction, own.end - 1);
            let at = self.network.vertices[junction as usize].at;
            let parent = self.network.rivers[self.easing.plan.river_of[junction as usize] as usize];
            let is_end = junction == parent.start || self.survey.downstream[junction as usize] == NONE;
            if last > own.start && !is_end && self.turns_back(last, at) {
                self.try_to_move(junction, at);
            }
        }
    }

    /// Returns `true` if a river turns back at a vertex in order to reach its junction.
    fn turns_back(&self, i: u32, junction: Vec2) -> bool {
        let [above, at] = [i - 1, i].map(|i| self.network.vertices[i as usize].at);
        (junction - at).dot(at - above) < 0.0
    }

    /// Makes a pass over a river. Returns `true` if vertices have moved.
    fn ease_river(&mut self, river: u32) -> bool {
        let own = self.network.rivers[river as usize];
        let mut any = false;
        for i in own.start + 1..own.end {
            let vertex = self.network.vertices[i as usize];
            let below = self.survey.downstream[i as usize];
            if below == NONE {
                continue;
            }
            if let Some(to) = self.without_spike(i, below) {
                self.try_to_move(i, to);
                continue;
            }
            let width = fast_max(vertex.width(), self.settings.spacing);
            if vertex.width() < width && vertex.mobility <= FULLY {
                continue;
            }
            let Some(bend) = Bend::at(self.network, &own, i, width) else { continue };
            let to = vertex.at.lerp(bend.mean, bend.ease);
            any |= distance(vertex.at, to) > STILL * width && self.try_to_move(i, to);
        }
        any
    }

    /// Returns the midpoint of the neighbours of a vertex at which its river turns almost straight back; `None` for other vertices.
    fn without_spike(&self, i: u32, below: u32) -> Option<Vec2> {
        /// The cosine of a turn of 160°.
        const SPIKE: f32 = -0.94;
        let [above, at, below] = [i - 1, i, below].map(|i| self.network.vertices[i as usize].at);
        let (before, after) = (at - above, below - at);
        let is_spike = before.dot(after) < SPIKE * length(before) * length(after);
        is_spike.then(|| (above + below) * 0.5)
    }

    /// Moves a vertex if nothing is in the way of the segments that end in it. Returns `true` if it has moved.
    fn try_to_move(&mut self, i: u32, to: Vec2) -> bool {
        let vertex = self.network.vertices[i as usize];
        if !keeps_off_frame(&self.settings.domain, &vertex, to) {
            return false;
        }
        let arms: Vec<Arm> = self.easing.plan.arms(i).map(|last| self.arm(last, to, &vertex)).collect();
        let ends = [(i - 1, i - 1), (i, self.survey.downstream[i as usize])];
        let mut moved = Moved { i, to, arms: &arms, gaps: Vec::with_capacity(32) };
        let are_free = ends.into_iter().chain(arms.iter().map(|arm| (arm.last, arm.first))).all(|(segment, end)| {
            let is_on_land = |land: &Land| land.allows(self.network.vertices[end as usize].at, to);
            self.land.is_none_or(is_on_land) && self.is_free(&mut moved, segment, end)
        });
        if !are_free {
            return false;
        }
        for (segment, other, gap) in moved.gaps {
            for segment in [segment, other] {
                let clearance = &mut self.survey.clearance[segment as usize];
                *clearance = fast_min(*clearance, gap);
            }
        }
        self.network.vertices[i as usize].at = to;
        arms.iter().for_each(|arm| arm.straighten(self.network, &mut self.survey.clearance, to));
        let moved = std::iter::once(i).chain(arms.iter().flat_map(|arm| arm.first..=arm.last)).map(|i| i as usize);
        let farthest = moved.map(|i| distance(self.easing.places[i], self.network.vertices[i].at)).fold(0.0, fast_max);
        self.survey.drift = fast_max(self.survey.drift, self.easing.drift + farthest);
        true
    }

    /// Finds the part of a tributary that lies under the water of the river that it joins, once the junction has moved.
    fn arm(&self, last: u32, junction: Vec2, vertex: &Vertex) -> Arm {
        let plan = &self.easing.plan;
        let cover = fast_min(vertex.left, vertex.right);
        let start = self.network.rivers[plan.river_of[last as usize] as usize].start;
        let is_lost =
            |i: u32| distance(self.network.vertices[i as usize].at, junction) < cover || self.turns_back(i, junction);
        let mut first = last;
        while first > start + 1 && !plan.is_junction[first as usize] && is_lost(first) {
            first -= 1;
        }
        Arm { first, last }
    }

    /// Returns `true` if a segment from the vertex `end` could end where the moved one goes. Notes its distances from others there.
    fn is_free(&self, moved: &mut Moved<'_>, segment: u32, end: u32) -> bool {
        let vertices = &self.network.vertices;
        let (i, to) = (moved.i, moved.to);
        let (from, old) = (vertices[end as usize].at, vertices[i as usize].at);
        let around = ((from + to) * 0.5, distance(from, to) * 0.5 + self.survey.drift);
        let sight = |other: u32| self.sight(segment, other);
        self.guard.all_near(around, self.longest_sight(segment), sight, |other, sight| {
            let below = self.survey.downstream[other as usize];
            if [i, end].contains(&other) || [i, end].contains(&below) || moved.arms.iter().any(|arm| arm.holds(other)) {
                return true;
            }
            let beside = (vertices[other as usize].at, vertices[below as usize].at);
            let far = gap((from, to), beside);
            if far >= sight {
                return true;
            }
            moved.gaps.push((segment, other, far));
            let is_apart = far >= NEAREST && !meet((from, to), beside);
            is_apart && self.keeps_its_distance(segment, other, far, ((from, old), beside))
        })
    }

    /// Returns `true` if two segments are far enough apart for the banks of two rivers, or at least no nearer than before.
    fn keeps_its_distance(&self, a: u32, b: u32, far: f32, before: (Segment, Segment)) -> bool {
        self.easing.plan.are_joined(a, b) || far >= self.apart(a, b) || far >= gap(before.0, before.1)
    }

    /// Returns the distance within which one segment matters to another, by the caps of their clearances and by the banks of two
    /// rivers, in units.
    #[inline]
    fn sight(&self, a: u32, b: u32) -> f32 {
        let [own, other] = [a, b].map(|segment| self.network.vertices[segment as usize].width());
        let cap = self.cap(fast_max(own, other));
        if self.easing.plan.are_joined(a, b) { cap } else { fast_max(cap, self.apart(a, b)) }
    }

    /// Returns the greatest distance within which any segment matters to a given one, in units.
    fn longest_sight(&self, segment: u32) -> f32 {
        let width = self.network.vertices[segment as usize].width();
        let apart = self.easing.plan.widest_apart(segment);
        fast_max(self.cap(self.easing.plan.widest), (width + apart) * 0.5 + self.settings.min_clearance)
    }

    /// Returns the distance up to which clearances are known of segments that are at most so wide, in units.
    fn cap(&self, width: f32) -> f32 {
        fast_max(CAP * self.settings.step(width), NEAREST)
    }

    /// Returns the distance between two segments at which the banks of their rivers keep theirs, in units.
    fn apart(&self, a: u32, b: u32) -> f32 {
        let [a, b] = [a, b].map(|i| self.network.vertices[i as usize].width());
        (a + b) * 0.5 + self.settings.min_clearance
    }
}

/// A vertex on its way to another place.
struct Moved<'a> {
    i: u32,
    to: Vec2,
    arms: &'a [Arm],
    /// Segments that end in the vertex, others near them, and their distances once it has moved.
    gaps: Vec<(u32, u32, f32)>,
}

/// The end of a tributary: its vertices from the last one outside the water of the river that it joins.
struct Arm {
    first: u32,
    last: u32,
}

impl Arm {
    fn holds(&self, segment: u32) -> bool {
        (self.first..=self.last).contains(&segment)
    }

    /// Leads the end straight to the junction.
    fn straighten(&self, network: &mut Network, clearance: &mut [f32], junction: Vec2) {
        let from = network.vertices[self.first as usize].at;
        let pieces = (self.last - self.first + 1) as f32;
        let nearest = clearance[self.last as usize];
        for i in self.first..=self.last {
            let share = (i - self.first) as f32 / pieces;
            network.vertices[i as usize].at = from.lerp(junction, share);
            clearance[i as usize] = fast_min(clearance[i as usize], nearest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::curvature::curvature;
    use super::super::super::samples::{places, river, settings, straight};
    use super::curve::{LEAST_RADIUS, Side};
    use super::*;
    use crate::base::geometry::fast_max;

    const WIDTH: f32 = 4.0;

    /// Returns a network with its bends eased in a number of passes.
    fn eased(network: Network, passes: u32) -> Network {
        eased_in_steps(network, passes, WORK_A_STEP).0
    }

    /// Returns a network with its bends eased in steps of so much work, and the number of steps.
    fn eased_in_steps(mut network: Network, passes: u32, work: u64) -> (Network, u32) {
        let settings = NetworkSettings { min_clearance: 0.5, ..settings() };
        let downstream = network.downstream();
        let mut guard = ClearanceGrid::new(&settings.domain, settings.spacing);
        let reach = vec![WIDTH; downstream.len()];
        let clearance = guard.measure(&network, &downstream, &reach, reach.clone(), &mut |_| {});
        let mut survey = Survey { downstream, step_scale: Vec::new(), clearance, drift: 0.0 };
        let mut easing = Easing::new(&network, &survey, passes);
        let mut fairing = Fairing {
            network: &mut network,
            guard: &mut guard,
            land: None,
            settings: &settings,
            survey: &mut survey,
            easing: &mut easing,
        };
        let mut steps = 1;
        while fairing.step(work) {
            steps += 1;
        }
        (network, steps)
    }

    /// Returns a course east, then south, with a right-angled corner.
    fn corner() -> Vec<Vec2> {
        [straight((100.0, 400.0), (140.0, 400.0), 40), straight((140.0, 401.0), (140.0, 440.0), 39)].concat()
    }

    /// Returns the least radius of a river's bends, in widths.
    fn least_radius(network: &Network) -> f32 {
        let own = network.rivers[0];
        let sharpest = |i: u32| {
            let at = |k: u32| network.vertices[k as usize].at;
            let side = |others: Vec<u32>| Side::of(at(i), WIDTH, others.into_iter().map(at)).unwrap().end;
            let (upper, lower) = (side((own.start..i).rev().collect()), side((i + 1..own.end).collect()));
            curvature(upper, at(i), lower).abs() * WIDTH
        };
        1.0 / (own.start + 5..own.end - 5).map(sharpest).fold(0.0, fast_max)
    }

    #[test]
    fn a_corner_becomes_a_bend_as_wide_as_the_river_asks() {
        let network = river(&corner(), WIDTH);
        assert!(least_radius(&network) < 0.8);
        let eased = eased(network.clone(), 40);
        assert!(least_radius(&eased) >= LEAST_RADIUS, "{}", least_radius(&eased));
        assert_eq!(eased.vertices[0], network.vertices[0]);
        assert_eq!(eased.vertices[79], network.vertices[79]);
    }

    #[test]
    fn brooks_and_wide_bends_stay() {
        let mut brook = river(&corner(), 0.5);
        brook.vertices.iter_mut().for_each(|vertex| vertex.mobility = 0.3);
        assert_eq!(places(&eased(brook.clone(), 9)), places(&brook), "a brook keeps its corners");
        let wide: Vec<Vec2> =
            (0..90).map(|i| Vec2::new(300.0, 300.0) + Vec2::from_angle(i as f32 / 45.0) * (WIDTH * 3.0)).collect();
        let wide = river(&wide, WIDTH);
        assert_eq!(places(&eased(wide.clone(), 9)), places(&wide));
    }

    #[test]
    fn a_tributary_rides_along_and_runs_straight_under_the_water() {
        let arm = straight((150.0, 380.0), (140.5, 399.0), 19);
        let network = river(&corner(), WIDTH).with_arm(&arm, 40, 10);
        let eased = eased(network.clone(), 40);
        let junction = eased.vertices[eased.rivers[1].junction as usize].at;
        assert!(junction.distance(network.vertices[40].at) > 0.5, "the junction moves");
        let own = eased.rivers[1].vertex_range();
        let first = own.clone().rev().find(|&i| eased.vertices[i].at.distance(junction) >= WIDTH / 2.0).unwrap();
        for i in first + 1..own.end {
            let off = crate::base::geometry::height(eased.vertices[i].at, eased.vertices[first].at, junction);
            assert!(off < 1e-3, "{i}: {off}");
        }
    }

    #[test]
    fn what_becomes_of_rivers_does_not_depend_on_where_steps_end() {
        let arm = straight((150.0, 380.0), (140.5, 399.0), 19);
        let network = river(&corner(), WIDTH).with_arm(&arm, 40, 10);
        let [(little, steps), (much, step)] = [1, u64::MAX].map(|work| eased_in_steps(network.clone(), 40, work));
        assert_eq!(step, 1);
        assert!(steps > 5, "{steps}");
        assert_eq!(places(&little), places(&much));
    }

    #[test]
    fn no_vertex_moves_across_another_river() {
        // Another river runs within the corner, where the bend would come to lie.
        let beside = straight((128.0, 440.0), (138.5, 401.5), 40);
        let network = river(&corner(), WIDTH).with_arm(&beside, 79, 10);
        let eased = eased(network, 40);
        let lines = [0, 1].map(|river: usize| places(&eased)[eased.rivers[river].vertex_range()].to_vec());
        let crosses = |a: &[Vec2]| lines[1].windows(2).any(|b| meet((a[0], a[1]), (b[0], b[1])));
        assert!(!lines[0].windows(2).any(crosses));
    }
}
