//! Fairing: no wide river bends more sharply than its width allows.
//!
//! A vertex of a bend whose radius is too small is drawn toward the mean of the course within a width of it, again and
//! again until the bend is wide enough. It moves only if the segments that end there cross no others, come no nearer to
//! the banks of other rivers and stay on land. Tributaries that end in it move with it: the part of them that lies
//! under the river's own water is drawn straight to the junction.

use glam::Vec2;

use super::super::clearance::ClearanceGrid;
use super::super::curvature::curvature;
use super::super::settings::NetworkSettings;
use super::super::smooth::LEAST_CLEARANCE;
use super::super::{NONE, Network, River, Vertex};
use super::{CAP, Survey, keeps_off_frame, river_of};
use crate::base::geometry::{Segment, distance, fast_max, fast_min, gap, length, meet, smooth_step};
use crate::base::sort::argsort;
use crate::base::work;
use crate::land::Land;

/// The least radius of a wide river's bends, in widths: that of the circle through points a width apart.
const LEAST_RADIUS: f32 = 1.5;

/// The radius from which down bends are eased, in widths, so that they rarely come to the least.
const EASED_RADIUS: f32 = 2.0;

/// The mobility above which narrow rivers are eased too, as if they were as wide as vertices are apart.
const FULLY: f32 = 0.5;

/// The work that all passes may take, in elementary steps, and what is added for each unit of the total discharge. Few maps need it.
const LEAST_WORK: u64 = 2_000_000;
const WORK: u64 = 60;

/// The least distance between segments, in units, so that lines stay apart.
const NEAREST: f32 = 2.0 * LEAST_CLEARANCE;

/// The least move that is a reason for another pass, in widths.
const STILL: f32 = 0.01;

/// A network whose bends are being eased, after a survey.
pub(super) struct Fairing<'a> {
    network: &'a mut Network,
    /// The grid of the survey, or one entered since.
    guard: &'a mut ClearanceGrid,
    land: Option<&'a Land>,
    settings: &'a NetworkSettings,
    /// The survey, which is kept up to date.
    survey: &'a mut Survey,
    /// The positions of the vertices when easing began or the grid was entered again, and the greatest distance that any had moved
    /// by then.
    places: Vec<Vec2>,
    drift: f32,
    /// The greatest width of any river, in units; and for each river, that of all which neither join it nor are joined by it.
    widest: f32,
    widest_apart: Vec<f32>,
}

impl<'a> Fairing<'a> {
    pub fn new(
        network: &'a mut Network,
        guard: &'a mut ClearanceGrid,
        land: Option<&'a Land>,
        settings: &'a NetworkSettings,
        survey: &'a mut Survey,
    ) -> Self {
        let places = network.vertices.iter().map(|vertex| vertex.at).collect();
        let widest = widths(network);
        let widest_apart = widest_apart(&parents(network), &widest);
        let (widest, drift) = (widest.into_iter().fold(0.0, fast_max), survey.drift);
        Self { network, guard, land, settings, survey, places, drift, widest, widest_apart }
    }

    /// Eases bends in at most `passes` passes, fewer if they take long.
    pub fn ease(mut self, passes: u32) {
        let end = work::steps() + LEAST_WORK + WORK * u64::from(self.settings.total_discharge);
        let plan = Plan::of(self.network);
        self.straighten_ends(&plan);
        let mut restless: Vec<u32> = (0..self.network.rivers.len() as u32).collect();
        for _ in 0..passes {
            self.enter_again();
            restless.retain(|&river| work::steps() <= end && self.ease_river(river, &plan));
            if restless.is_empty() {
                break;
            }
        }
    }

    /// Enters the segments in the grid where they are now, if they may have moved so far that it has to be searched much wider.
    fn enter_again(&mut self) {
        if self.survey.drift > self.settings.spacing {
            self.guard.enter(self.network, &self.survey.downstream, &vec![0.0; self.network.vertices.len()]);
            self.places = self.network.vertices.iter().map(|vertex| vertex.at).collect();
            (self.drift, self.survey.drift) = (0.0, 0.0);
        }
    }

    /// Straightens the ends of tributaries that run past their junctions and come back.
    fn straighten_ends(&mut self, plan: &Plan) {
        for own in self.network.rivers.clone() {
            if own.junction == NONE || own.end <= own.start {
                continue;
            }
            let (junction, last) = (own.junction, own.end - 1);
            let at = self.network.vertices[junction as usize].at;
            let parent = self.network.rivers[plan.river_of[junction as usize] as usize];
            let is_end = junction == parent.start || self.survey.downstream[junction as usize] == NONE;
            if last > own.start && !is_end && self.turns_back(last, at) {
                self.try_to_move(junction, at, plan);
            }
        }
    }

    /// Returns `true` if a river turns back at a vertex in order to reach its junction.
    fn turns_back(&self, i: u32, junction: Vec2) -> bool {
        let [above, at] = [i - 1, i].map(|i| self.network.vertices[i as usize].at);
        (junction - at).dot(at - above) < 0.0
    }

    /// Makes a pass over a river. Returns `true` if vertices have moved.
    fn ease_river(&mut self, river: u32, plan: &Plan) -> bool {
        let own = self.network.rivers[river as usize];
        let mut any = false;
        for i in own.start + 1..own.end {
            let vertex = self.network.vertices[i as usize];
            let below = self.survey.downstream[i as usize];
            if below == NONE {
                continue;
            }
            if let Some(to) = self.without_spike(i, below) {
                self.try_to_move(i, to, plan);
                continue;
            }
            let width = fast_max(vertex.width(), self.settings.spacing);
            if vertex.width() < width && vertex.mobility <= FULLY {
                continue;
            }
            let Some(bend) = Bend::at(self.network, &own, i, width) else { continue };
            let to = vertex.at.lerp(bend.mean, bend.ease);
            any |= distance(vertex.at, to) > STILL * width && self.try_to_move(i, to, plan);
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
    fn try_to_move(&mut self, i: u32, to: Vec2, plan: &Plan) -> bool {
        let vertex = self.network.vertices[i as usize];
        if !keeps_off_frame(&self.settings.domain, &vertex, to) {
            return false;
        }
        let arms: Vec<Arm> = plan.arms(i).map(|last| self.arm(last, to, &vertex, plan)).collect();
        let ends = [(i - 1, i - 1), (i, self.survey.downstream[i as usize])];
        let mut moved = Moved { i, to, arms: &arms, gaps: Vec::with_capacity(32) };
        let are_free = ends.into_iter().chain(arms.iter().map(|arm| (arm.last, arm.first))).all(|(segment, end)| {
            let is_on_land = |land: &Land| land.allows(self.network.vertices[end as usize].at, to);
            self.land.is_none_or(is_on_land) && self.is_free(&mut moved, segment, end, plan)
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
        let farthest = moved.map(|i| distance(self.places[i], self.network.vertices[i].at)).fold(0.0, fast_max);
        self.survey.drift = fast_max(self.survey.drift, self.drift + farthest);
        true
    }

    /// Finds the part of a tributary that lies under the water of the river that it joins, once the junction has moved.
    fn arm(&self, last: u32, junction: Vec2, vertex: &Vertex, plan: &Plan) -> Arm {
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
    fn is_free(&self, moved: &mut Moved<'_>, segment: u32, end: u32, plan: &Plan) -> bool {
        let vertices = &self.network.vertices;
        let (i, to) = (moved.i, moved.to);
        let (from, old) = (vertices[end as usize].at, vertices[i as usize].at);
        let around = ((from + to) * 0.5, distance(from, to) * 0.5 + self.survey.drift);
        let sight = |other: u32| self.sight(segment, other, plan);
        self.guard.all_near(around, self.longest_sight(segment, plan), sight, |other, sight| {
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
            is_apart && self.keeps_its_distance(segment, other, far, ((from, old), beside), plan)
        })
    }

    /// Returns `true` if two segments are far enough apart for the banks of two rivers, or at least no nearer than before.
    fn keeps_its_distance(&self, a: u32, b: u32, far: f32, before: (Segment, Segment), plan: &Plan) -> bool {
        plan.are_joined(a, b) || far >= self.apart(a, b) || far >= gap(before.0, before.1)
    }

    /// Returns the distance within which one segment matters to another, by the caps of their clearances and by the banks of two
    /// rivers, in units.
    #[inline]
    fn sight(&self, a: u32, b: u32, plan: &Plan) -> f32 {
        let [own, other] = [a, b].map(|segment| self.network.vertices[segment as usize].width());
        let cap = self.cap(fast_max(own, other));
        if plan.are_joined(a, b) { cap } else { fast_max(cap, self.apart(a, b)) }
    }

    /// Returns the greatest distance within which any segment matters to a given one, in units.
    fn longest_sight(&self, segment: u32, plan: &Plan) -> f32 {
        let width = self.network.vertices[segment as usize].width();
        let apart = self.widest_apart[plan.river_of[segment as usize] as usize];
        fast_max(self.cap(self.widest), (width + apart) * 0.5 + self.settings.min_clearance)
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

/// Returns the greatest width of each river, in units.
fn widths(network: &Network) -> Vec<f32> {
    let widest = |river: &River| network.vertices[river.vertex_range()].iter().map(Vertex::width).fold(0.0, fast_max);
    network.rivers.iter().map(widest).collect()
}

/// Returns for each river the greatest width, in units, of all that neither join it nor are joined by it.
fn widest_apart(parents: &[u32], widths: &[f32]) -> Vec<f32> {
    let by_width = argsort(widths.iter().map(|width| u32::MAX - width.to_bits()));
    let apart = |river: u32| by_width.iter().find(|&&other| !are_joined(parents, river, other as u32));
    (0..parents.len() as u32).map(|river| apart(river).map_or(0.0, |&other| widths[other])).collect()
}

/// Returns the river that each river joins, if any.
fn parents(network: &Network) -> Vec<u32> {
    network.rivers.iter().map(|river| river.parent).collect()
}

/// Returns `true` if two rivers are one, or one joins the other.
#[inline]
fn are_joined(parents: &[u32], a: u32, b: u32) -> bool {
    a == b || parents[a as usize] == b || parents[b as usize] == a
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

/// The bend of a course at a vertex.
struct Bend {
    /// The mean of the course within a width, weighted by nearness.
    mean: Vec2,
    /// The share of the way to the mean that the vertex moves, from 0 to 1.
    ease: f32,
}

impl Bend {
    /// Measures a bend. `None` at the river's ends.
    fn at(network: &Network, river: &River, i: u32, width: f32) -> Option<Self> {
        let course = |k: u32| {
            let k = if k < river.end { k } else { river.junction };
            network.vertices.get(k as usize).map(|vertex| vertex.at)
        };
        let at = course(i)?;
        let upper = Side::of(at, width, (river.start..i).rev().map_while(course))?;
        let lower = Side::of(at, width, (i + 1..=river.end).map_while(course))?;
        // A zigzag finer than a width shows only in the nearest vertices.
        let sharpest =
            fast_max(curvature(upper.end, at, lower.end).abs(), curvature(course(i - 1)?, at, course(i + 1)?).abs());
        let [from, to] = [EASED_RADIUS, LEAST_RADIUS].map(|radius| 1.0 / radius);
        let ease = smooth_step((sharpest * width - from) / (to - from));
        Some(Self { mean: (upper.mean + lower.mean) * 0.375 + at * 0.25, ease })
    }
}

/// The part of a course within a width of a vertex, on one side of it.
struct Side {
    /// The point a width away along the course.
    end: Vec2,
    mean: Vec2,
}

impl Side {
    /// Measures a course from a vertex on, shorter than a width if it ends before. `None` if it ends at the vertex itself.
    fn of(at: Vec2, width: f32, others: impl Iterator<Item = Vec2>) -> Option<Self> {
        let (mut from, mut along, mut sum, mut weight) = (at, 0.0, Vec2::ZERO, 0.0);
        for next in others {
            let far = distance(from, next);
            if along + far >= width {
                let end = from.lerp(next, (width - along) / far);
                let mean = if weight > 0.0 { sum / weight } else { (at + end) * 0.5 };
                return Some(Self { end, mean });
            }
            along += far;
            let share = (width - along) * far;
            (sum, weight) = (sum + next * share, weight + share);
            from = next;
        }
        (weight > 0.0).then(|| Self { end: from, mean: sum / weight })
    }
}

/// The river of each vertex, and the tributaries that end in it.
struct Plan {
    river_of: Vec<u32>,
    /// The river that each river joins, if any.
    parents: Vec<u32>,
    is_junction: Vec<bool>,
    /// For each vertex, the last vertex of a tributary that ends there; and for each last vertex, that of the next such tributary.
    arms: Vec<u32>,
    next: Vec<u32>,
}

impl Plan {
    fn of(network: &Network) -> Self {
        let none = vec![NONE; network.vertices.len()];
        let mut plan = Self {
            river_of: river_of(network),
            parents: parents(network),
            is_junction: network.junctions(),
            arms: none.clone(),
            next: none,
        };
        // In reverse, so that the first tributary comes first in its list.
        for river in network.rivers.iter().rev().filter(|river| river.junction != NONE && river.end > river.start) {
            let last = river.end - 1;
            plan.next[last as usize] = std::mem::replace(&mut plan.arms[river.junction as usize], last);
        }
        plan
    }

    /// Returns `true` if two segments belong to one river, or to two of which one joins the other.
    #[inline]
    fn are_joined(&self, a: u32, b: u32) -> bool {
        are_joined(&self.parents, self.river_of[a as usize], self.river_of[b as usize])
    }

    /// Iterates over the last vertices of the rivers that join at a vertex.
    fn arms(&self, junction: u32) -> impl Iterator<Item = u32> {
        let some = |i: u32| (i != NONE).then_some(i);
        std::iter::successors(some(self.arms[junction as usize]), move |&last| some(self.next[last as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{places, river, settings, straight};
    use super::*;

    const WIDTH: f32 = 4.0;

    /// Returns a network with its bends eased in a number of passes.
    fn eased(mut network: Network, passes: u32) -> Network {
        let settings = NetworkSettings { min_clearance: 0.5, ..settings() };
        let downstream = network.downstream();
        let mut guard = ClearanceGrid::new(&settings.domain, settings.spacing);
        let reach = vec![WIDTH; downstream.len()];
        let clearance = guard.measure(&network, &downstream, &reach, reach.clone(), &mut |_| {});
        let mut survey = Survey { downstream, step_scale: Vec::new(), clearance, drift: 0.0 };
        Fairing::new(&mut network, &mut guard, None, &settings, &mut survey).ease(passes);
        network
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
