//! Meanders: bends grow and travel in small rounds, necks are cut, and what is cut off stays as an oxbow lake.
//!
//! A survey measures how near lines come to each other, and necks are cut. Then bends move for `ROUNDS_A_SURVEY` rounds
//! by one of two models (`bend.rs`, `flow.rs`), each vertex as freely as its mobility says (`mobility.rs`) and as far
//! as the survey allows; sharp bends are eased (`fair.rs`), and vertices spaced evenly again. Vertices that come too
//! near another river stay where they are from then on.

mod bend;
mod cutoff;
mod fair;
mod flow;
mod lakes;
mod mobility;
mod past;
mod respace;
mod rest;

use std::sync::{Arc, OnceLock};

use glam::Vec2;

use super::clearance::{ClearanceGrid, NearbyPair};
use super::courses::Courses;
use super::evenly::divide;
use super::narrow::narrowed;
use super::ranking::simplified;
use super::settings::NetworkSettings;
use super::smooth::{SHARE_OF_CLEARANCE, has_room, limits, smooth};
use super::width::widen;
use super::{NONE, Network, River, Vertex};
use crate::base::geometry::{fast_max, fast_min, length};
use crate::domain::Domain;
use crate::land::Land;
use crate::recipe::{CourseShape, MeanderModel};

pub use mobility::Reach;
pub use past::{PastCourse, PastCourses, PastRound};

/// The distance up to which clearances are measured, in steps. Vertices move by less than a third of it in a round.
const CAP: f32 = 1.0;

/// The number of rounds that a survey serves. Moves use the clearance up, so that with more rounds bends would hardly move in the last.
const ROUNDS_A_SURVEY: u32 = 2;

/// The width from which on a river is wide, in spacings: it looks around, moving or not, as rivers that move near it rely on.
const WIDE: f32 = 0.6;

/// The least width that counts for necks, in spacings.
const NARROWEST: f32 = 0.5;

/// The distance that moving banks keep from the frame of the map, in units.
const OFF_FRAME: f32 = 8.0;

/// A network on its way from courses to meandering rivers, step by step.
#[derive(Clone, Debug)]
pub struct Meander {
    settings: NetworkSettings,
    /// The land; `None` if all of the domain is.
    land: Option<Arc<Land>>,
    network: Arc<Network>,
    /// The rivers as the last round has left them, while bends are eased and the next one is not over.
    shown: Option<Shown>,
    /// The network as it is drawn; empty until it is asked for.
    drawn: OnceLock<Arc<Network>>,
    guard: ClearanceGrid,
    /// The last survey, while it has rounds left to serve or bends are eased.
    survey: Option<Survey>,
    /// The bends that are eased at the end of a survey's rounds, if they are.
    easing: Option<fair::Easing>,
    /// The necks that the last step found, and the next one cuts.
    necks: Vec<cutoff::Cut>,
    round: u32,
    past: Arc<PastCourses>,
    reaches: Arc<[Reach]>,
    /// `true` if a vertex was stopped by the frame of the map since the last survey.
    has_stopped: bool,
}

/// Rivers with their past, as they are handed out.
#[derive(Clone, Debug)]
struct Shown {
    network: Arc<Network>,
    past: Arc<PastCourses>,
}

/// The limits on moves until the next survey.
#[derive(Clone, Debug)]
struct Survey {
    downstream: Vec<u32>,
    step_scale: Vec<f32>,
    /// A lower bound for the distance of each segment from the nearest other one, up to its cap, in units.
    clearance: Vec<f32>,
    /// The greatest distance that any vertex may have moved since, in units.
    drift: f32,
}

impl Meander {
    /// Begins with courses that are smooth and thinned out: sets their widths and mobility, and makes no round yet.
    pub(super) fn along(mut network: Network, land: Option<Arc<Land>>, settings: NetworkSettings) -> Self {
        widen(&mut network, &settings);
        let great = mobility::assign(&mut network, &settings);
        let reaches = mobility::reaches(&network, &great, &settings);
        Self { past: PastCourses::of(great).into(), reaches: reaches.into(), ..Self::of(network, land, settings) }
    }

    /// Begins with any network that has its widths and mobility already. None of its rivers counts as great.
    pub fn of(network: Network, land: Option<Arc<Land>>, settings: NetworkSettings) -> Self {
        let guard = ClearanceGrid::new(&settings.domain, settings.spacing);
        Self {
            settings,
            land,
            network: network.into(),
            shown: None,
            drawn: OnceLock::new(),
            guard,
            survey: None,
            easing: None,
            necks: Vec::new(),
            round: 0,
            past: Arc::default(),
            reaches: Arc::default(),
            has_stopped: false,
        }
    }

    /// Returns the network as it is drawn: narrower where a course turns so sharply, or comes back so near to itself,
    /// that banks would meet. Rivers as grown keep their full width.
    pub fn drawn(&self) -> &Arc<Network> {
        self.drawn.get_or_init(|| self.narrowed(self.network(), self.network().rivers.iter()))
    }

    /// Returns a network with some of its rivers as they are drawn.
    fn narrowed<'a>(&self, network: &'a Arc<Network>, rivers: impl Iterator<Item = &'a River>) -> Arc<Network> {
        let is_smooth = self.settings.courses == CourseShape::Smooth;
        let narrowed = if is_smooth { narrowed(network, rivers) } else { None };
        narrowed.map_or_else(|| network.clone(), Arc::new)
    }

    /// Returns the network with its full widths, as the last round has left it.
    pub fn network(&self) -> &Arc<Network> {
        self.shown.as_ref().map_or(&self.network, |shown| &shown.network)
    }

    /// Makes sure that the network and its past are not shared: copies them if need be.
    pub(in crate::network) fn unshare(&mut self) {
        Arc::make_mut(&mut self.network);
        Arc::make_mut(&mut self.past);
    }

    /// Returns the settings that rivers are made with.
    pub fn settings(&self) -> &NetworkSettings {
        &self.settings
    }

    /// Returns the courses that great rivers had in earlier rounds.
    pub fn past(&self) -> &Arc<PastCourses> {
        self.shown.as_ref().map_or(&self.past, |shown| &shown.past)
    }

    /// Returns the longest flat stretch of each great river, where it meanders fully.
    pub fn reaches(&self) -> &Arc<[Reach]> {
        &self.reaches
    }

    /// Returns the number of rounds that have been made.
    pub fn rounds(&self) -> u32 {
        self.round
    }

    /// Makes a round. Returns `true` if there is another one to make.
    pub fn round(&mut self) -> bool {
        let before = self.round;
        while self.step() && self.round == before {}
        !self.is_finished()
    }

    /// Makes a step: finds necks that are to be cut, moves bends, or eases some of them. Returns `true` if there is another step to
    /// make.
    pub fn step(&mut self) -> bool {
        if self.is_finished() {
            return false;
        }
        // Necks are cut and past courses kept before bends move, and none of it is shown before the round is over.
        let is_eased = self.easing.is_none() && self.ends_a_survey(self.round + 1);
        let before = is_eased.then(|| Shown { network: self.network.clone(), past: self.past.clone() });
        if let Some(survey) = self.survey.take().or_else(|| self.survey()) {
            match self.easing.take() {
                Some(easing) => self.ease_bends(survey, easing),
                None => self.move_on(survey, before),
            }
        }
        !self.is_finished()
    }

    /// Returns `true` if a round is the last one that a survey serves.
    fn ends_a_survey(&self, round: u32) -> bool {
        round.is_multiple_of(ROUNDS_A_SURVEY) || round == self.settings.rounds
    }

    /// Records the courses before a round if the past wants them.
    fn keep_courses(&mut self) {
        if self.past.wants(self.round, self.settings.rounds) {
            // Only great rivers are recorded, and to narrow all rivers takes longer than a round.
            let great = self.past.great_rivers().iter().map(|&river| &self.network.rivers[river as usize]);
            let drawn = self.narrowed(&self.network, great);
            Arc::make_mut(&mut self.past).keep(&drawn, self.round);
        }
    }

    /// Moves bends within the limits of a survey. That is a round, unless it is the last one of the survey: then bends are eased, and
    /// `before` is shown until they are.
    fn move_on(&mut self, mut survey: Survey, before: Option<Shown>) {
        self.keep_courses();
        let moved = self.move_bends(&survey);
        survey.drift += moved.iter().copied().fold(0.0, fast_max);
        if before.is_some() {
            self.easing = Some(fair::Easing::new(&self.network, &survey, self.passes(self.round + 1)));
            self.shown = before;
        } else {
            survey.use_up(&moved);
            self.end_round();
        }
        self.survey = Some(survey);
    }

    /// Counts a round that has been made, and shows it.
    fn end_round(&mut self) {
        self.round += 1;
        (self.shown, self.drawn) = (None, OnceLock::new());
        lakes::age(&mut Arc::make_mut(&mut self.network).oxbows, self.round, self.settings.oxbow_life);
    }

    /// Measures how near lines are to each other, and stops vertices that are too near. `None` if there are necks: the
    /// next step cuts them, and measures again.
    fn survey(&mut self) -> Option<Survey> {
        let has_cut = self.cut_necks();
        let (downstream, step_scale) = (self.network.downstream(), self.step_scale());
        let (clearance, near) = self.measure(&downstream, &step_scale);
        if !has_cut {
            self.necks = self.find_necks(&downstream, &near);
            if !self.necks.is_empty() {
                return None;
            }
        }
        self.erode_lakes(&downstream);
        if self.freeze(&near) || std::mem::take(&mut self.has_stopped) {
            mobility::ease_off(Arc::make_mut(&mut self.network), self.settings.spacing);
        }
        Some(Survey { downstream, step_scale, clearance, drift: 0.0 })
    }

    /// Returns `true` if there is no other round to make.
    pub fn is_finished(&self) -> bool {
        self.settings.model == MeanderModel::None || self.round >= self.settings.rounds
    }

    /// Returns the factor for the move of each vertex in the rounds of a survey. Rivers that meander only gently move
    /// after every third survey, three times as far: nobody sees it, and a round takes half the time.
    pub fn step_scale(&self) -> Vec<f32> {
        const SELDOM: u32 = 3;
        let mut step_scale = vec![0.0; self.network.vertices.len()];
        for (number, river) in (0..).zip(&self.network.rivers) {
            let own = &self.network.vertices[river.vertex_range()];
            let is_gentle = own.iter().all(|vertex| vertex.mobility * SELDOM as f32 <= 1.0);
            let times = match (is_gentle, (self.round / ROUNDS_A_SURVEY + number) % SELDOM) {
                (false, _) => 1.0,
                (true, 0) => SELDOM as f32,
                (true, _) => continue,
            };
            step_scale[river.vertex_range()]
                .iter_mut()
                .zip(own)
                .for_each(|(step_scale, vertex)| *step_scale = vertex.mobility * times);
        }
        rest::rest(&self.network, &mut step_scale, &self.settings);
        step_scale
    }

    /// Returns the search radius of each segment, in units: as far as banks could come too near each other, and at
    /// least its cap; 0 if the segment neither can move nor is wide.
    pub fn reach(&self, downstream: &[u32], step_scale: &[f32]) -> Vec<f32> {
        let NetworkSettings { spacing, min_clearance, neck, .. } = self.settings;
        let vertices = &self.network.vertices;
        let wide = WIDE * spacing;
        let near = |width: f32| {
            fast_max((width + fast_max(width, wide)) * 0.5 + min_clearance, neck * fast_max(width, NARROWEST * spacing))
        };
        vertices
            .iter()
            .zip(step_scale)
            .zip(downstream)
            .map(|((vertex, &moves), &lower)| {
                let Some(below) = vertices.get(lower as usize) else { return 0.0 };
                let width = fast_max(vertex.width(), below.width());
                let cap = CAP * self.settings.step(width);
                if moves > 0.0 || step_scale[lower as usize] > 0.0 {
                    fast_max(near(width), cap)
                } else if width > wide {
                    fast_max(width + min_clearance, cap)
                } else {
                    0.0
                }
            })
            .collect()
    }

    /// Returns the distance up to which the clearance of each segment matters to moves, in units.
    pub fn caps(&self) -> Vec<f32> {
        self.network.vertices.iter().map(|vertex| CAP * self.settings.step(vertex.width())).collect()
    }

    /// Measures the clearance of each segment, in units, and finds the pairs that are near each other.
    fn measure(&mut self, downstream: &[u32], step_scale: &[f32]) -> (Vec<f32>, Vec<NearbyPair>) {
        let reach = self.reach(downstream, step_scale);
        let mut near = Vec::new();
        let clearance = self.guard.measure(&self.network, downstream, &reach, self.caps(), &mut |pair| near.push(pair));
        (clearance, near)
    }

    /// Removes the parts of lakes that rivers of the last survey run over.
    fn erode_lakes(&mut self, downstream: &[u32]) {
        lakes::erode(Arc::make_mut(&mut self.network), downstream, &self.guard, &self.settings);
    }

    /// Finds the necks among some pairs through which rivers can break.
    fn find_necks(&self, downstream: &[u32], near: &[NearbyPair]) -> Vec<cutoff::Cut> {
        let mut necks = cutoff::necks(&self.network, near, &self.settings);
        necks.retain(|cut| {
            self.is_on_land(cut) && self.guard.is_free(&self.network, downstream, (cut.above, cut.below))
        });
        necks
    }

    /// Cuts the necks that the last step found. Returns `true` if there were any.
    fn cut_necks(&mut self) -> bool {
        let cuts = std::mem::take(&mut self.necks);
        if cuts.is_empty() {
            return false;
        }
        self.keep_courses();
        self.erode_lakes(&self.network.downstream());
        let round = self.round + 1;
        cutoff::cut(Arc::make_mut(&mut self.network), &cuts, round);
        Arc::make_mut(&mut self.past).keep_loops(&self.network, round);
        if self.settings.oxbow_life == 0.0 {
            Arc::make_mut(&mut self.network).oxbows.clear();
        }
        true
    }

    /// Returns `true` if a river that breaks through a neck stays on land: a loop may run round a bay, or round the end of a ridge.
    fn is_on_land(&self, cut: &cutoff::Cut) -> bool {
        let [above, below] = [cut.above, cut.below].map(|i| self.network.vertices[i as usize].at);
        self.land.as_ref().is_none_or(|land| land.allows(above, below))
    }

    /// Stops vertices that have come too near another river, or so near their own that the neck should have been cut.
    /// Returns `true` if any of them could move until now.
    fn freeze(&mut self, near: &[NearbyPair]) -> bool {
        let river_of = river_of(&self.network);
        let mut any = false;
        for pair in near {
            if self.is_too_near(pair, &river_of) {
                for upper in [pair.first, pair.second] {
                    let river = self.network.rivers[river_of[upper as usize] as usize];
                    let lower = if upper + 1 < river.end { upper + 1 } else { river.junction };
                    for vertex in [upper, lower] {
                        if let Some(vertex) = Arc::make_mut(&mut self.network).vertices.get_mut(vertex as usize) {
                            any |= vertex.mobility > 0.0;
                            vertex.mobility = 0.0;
                        }
                    }
                }
            }
        }
        any
    }

    fn is_too_near(&self, pair: &NearbyPair, river_of: &[u32]) -> bool {
        let NetworkSettings { min_clearance, .. } = self.settings;
        let [a, b] = [pair.first, pair.second].map(|i| (i, river_of[i as usize]));
        let width = |i: u32| self.network.vertices[i as usize].width();
        let apart = (width(a.0) + width(b.0)) * 0.5 + min_clearance;
        if a.1 == b.1 {
            return cutoff::is_neck(&self.network, pair, &self.settings);
        }
        pair.distance < apart && !self.is_about_to_join(a, b, apart) && !self.is_about_to_join(b, a, apart)
    }

    /// Returns `true` if a segment is near that of another river because its own river is about to join that.
    fn is_about_to_join(&self, (i, tributary): (u32, u32), (j, river): (u32, u32), apart: f32) -> bool {
        let tributary = &self.network.rivers[tributary as usize];
        let near = (2.0 * apart / self.settings.spacing) as u32 + 3;
        tributary.parent == river && tributary.end - i <= near && tributary.junction.abs_diff(j) <= near
    }

    /// Returns the greatest number of times that bends are eased after a round: most of all at first and after the last one.
    fn passes(&self, round: u32) -> u32 {
        const PASSES: u32 = ROUNDS_A_SURVEY;
        const MOST_PASSES: u32 = 32;
        let is_end = round <= ROUNDS_A_SURVEY || round == self.settings.rounds;
        if is_end { MOST_PASSES } else { PASSES }
    }

    /// Eases bends that are too sharp for their rivers, as far as one step goes. Once all are eased, spaces vertices evenly, which ends
    /// the rounds of the survey.
    fn ease_bends(&mut self, mut survey: Survey, mut easing: fair::Easing) {
        let network = Arc::make_mut(&mut self.network);
        let (guard, land) = (&mut self.guard, self.land.as_deref());
        let mut fairing =
            fair::Fairing { network, guard, land, settings: &self.settings, survey: &mut survey, easing: &mut easing };
        if fairing.step(fair::WORK_A_STEP) {
            (self.survey, self.easing) = (Some(survey), Some(easing));
        } else {
            respace::respace(network, &survey.clearance, &survey.step_scale, &self.settings);
            self.end_round();
        }
    }

    /// Moves bends. Returns the distance that each vertex has moved, in units.
    fn move_bends(&mut self, survey: &Survey) -> Vec<f32> {
        let moves = match self.settings.model {
            MeanderModel::Flow => flow::moves(&self.network, &survey.step_scale, &self.settings),
            _ => bend::moves(&self.network, &survey.step_scale, &self.settings),
        };
        let mut moved = limits(&survey.clearance, &survey.downstream);
        let (domain, land) = (&self.settings.domain, self.land.as_deref());
        for ((vertex, way), moved) in Arc::make_mut(&mut self.network).vertices.iter_mut().zip(moves).zip(&mut moved) {
            let limit = std::mem::take(moved);
            if way == Vec2::ZERO {
                continue;
            }
            let far = length(way);
            let to = vertex.at + way * (limit / fast_max(far, limit));
            // A segment may be one and a half spacings long, and both of its ends may move.
            let step = self.settings.step(vertex.width());
            if !keeps_off_frame(domain, vertex, to) {
                vertex.mobility = 0.0;
                self.has_stopped = true;
            } else if has_room(land, vertex.at, 2.0 * step) {
                *moved = fast_min(far, limit);
                vertex.at = to;
            } else {
                vertex.mobility = 0.0;
            }
        }
        moved
    }
}

impl Survey {
    /// Subtracts from the clearance what moves may have used up: those of a segment's own ends, and the most that
    /// others may have moved.
    fn use_up(&mut self, moved: &[f32]) {
        for (i, clearance) in self.clearance.iter_mut().enumerate() {
            let lower = moved.get(self.downstream[i] as usize).copied().unwrap_or_default();
            let others = fast_min(*clearance * SHARE_OF_CLEARANCE, self.drift);
            *clearance = fast_max(*clearance - fast_max(moved[i], lower) - others, 0.0);
        }
    }
}

/// Simplifies and smooths courses; they have no widths yet.
pub(super) fn smooth_courses(courses: &Courses, land: Option<&Land>, settings: &NetworkSettings) -> Network {
    let coarse = simplified(&courses.network, &courses.ranking, settings.simplify);
    let (mut network, origin) = divide(&coarse, settings);
    smooth(&mut network, &coarse, &origin, land, settings);
    network
}

/// Removes vertices that lie closer than needed, half of them at a time. A Brownian tree has many, since simplification
/// removes hardly any. Returns `true` if there were so many that another pass is worth while.
pub(super) fn thin_out(network: &mut Network, settings: &NetworkSettings) -> bool {
    let downstream = network.downstream();
    let is_close = |(vertex, &below): (&Vertex, &u32)| {
        let next = network.vertices.get(below as usize);
        next.is_some_and(|next| vertex.at.distance_squared(next.at) < 0.25 * settings.spacing * settings.spacing)
    };
    let close = network.vertices.iter().zip(&downstream).filter(|pair| is_close(*pair)).count();
    if close * 8 < downstream.len() {
        return false;
    }
    let reach = vec![settings.spacing; downstream.len()];
    let mut guard = ClearanceGrid::new(&settings.domain, settings.spacing);
    let clearance = guard.measure(network, &downstream, &reach, reach.clone(), &mut |_| {});
    let everywhere = vec![1.0; downstream.len()];
    respace::respace(network, &clearance, &everywhere, settings);
    true
}

/// Returns `true` if a vertex may move to a point by its distance from the frame of the map, along which a river would
/// run like a gutter. Vertices that have grown there may move away from it.
fn keeps_off_frame(domain: &Domain, vertex: &Vertex, to: Vec2) -> bool {
    let off = |at: Vec2| at.min(domain.size - at).min_element();
    off(to) >= OFF_FRAME + vertex.width() * 0.5 || off(to) > off(vertex.at) && domain.contains(to)
}

/// Returns the river of each vertex.
fn river_of(network: &Network) -> Vec<u32> {
    let mut river_of = vec![NONE; network.vertices.len()];
    for (number, river) in network.rivers.iter().enumerate() {
        river_of[river.vertex_range()].fill(number as u32);
    }
    river_of
}

#[cfg(test)]
mod tests {
    use super::super::samples::{places, river, settings, sine_generated, sinuosity, straight};
    use super::*;

    /// Makes a river of gentle bends, and lets it meander for some rounds.
    fn meandered(model: MeanderModel, rounds: u32) -> Network {
        let line = sine_generated(0.3, 44.0, 8, 44);
        let mut meander = Meander::of(
            river(&line, 4.0),
            None,
            NetworkSettings { model, rounds, strength: 0.6, neck: 4.0, oxbow_life: f32::INFINITY, ..settings() },
        );
        while meander.round() {}
        assert_eq!(meander.rounds(), if model == MeanderModel::None { 0 } else { rounds });
        Network::clone(meander.network())
    }

    #[test]
    fn bends_grow_until_necks_are_cut() {
        for model in [MeanderModel::Bend, MeanderModel::Flow] {
            let sinuosity = |rounds| sinuosity(&places(&meandered(model, rounds)));
            let [young, grown] = [sinuosity(0), sinuosity(20)];
            assert!(young < 1.03 && grown > 1.05, "{model:?}: {young}, then {grown}");
        }
        let old = meandered(MeanderModel::Bend, 400);
        assert!(!old.oxbows.is_empty());
        assert!(sinuosity(&places(&old)) < 6.0);
    }

    #[test]
    fn without_a_model_nothing_moves() {
        assert_eq!(places(&meandered(MeanderModel::None, 9)), sine_generated(0.3, 44.0, 8, 44));
    }

    #[test]
    fn rivers_stop_short_of_each_other() {
        // Another river runs right beside the bends.
        let beside = straight((60.0, 394.0), (330.0, 394.0), 270);
        let network = river(&sine_generated(0.3, 44.0, 8, 44), 4.0).with_arm(&beside, 340, 20);
        let mut meander = Meander::of(network, None, NetworkSettings { rounds: 60, strength: 1.0, ..settings() });
        while meander.round() {}
        let network = meander.network();
        let [main, other] = [0, 1].map(|river| &network.vertices[network.rivers[river].vertex_range()]);
        let near = main[..main.len() - 20].iter().flat_map(|a| other.iter().map(move |b| a.at.distance(b.at)));
        let nearest = near.fold(f32::INFINITY, f32::min);
        assert!(nearest > 0.3, "{nearest}");
    }

    #[test]
    fn gentle_rivers_take_turns_and_move_three_times_as_far() {
        let line = straight((20.0, 500.0), (80.0, 500.0), 60);
        let mut network = river(&line, 4.0);
        for arm in 0..5 {
            network = network.with_arm(&straight((20.0, 400.0), (40.0, 490.0), 60), 20 + arm, 20);
        }
        let gentle = |river: usize| river > 0;
        for (number, river) in network.rivers.clone().iter().enumerate() {
            let mobility = if gentle(number) { 0.3 } else { 1.0 };
            network.vertices[river.vertex_range()].iter_mut().for_each(|vertex| vertex.mobility = mobility);
        }
        let mut meander = Meander::of(network, None, settings());
        let mut moves = Vec::new();
        for round in 0..3 {
            meander.round = round * ROUNDS_A_SURVEY;
            let step_scale = meander.step_scale();
            let rivers = &meander.network().rivers;
            moves.push(rivers.iter().map(|river| step_scale[river.end as usize - 1]).collect::<Vec<f32>>());
        }
        for river in 0..6 {
            let paces: Vec<f32> = moves.iter().map(|paces: &Vec<f32>| paces[river]).collect();
            let resting = paces.iter().filter(|step_scale| **step_scale == 0.0).count();
            if gentle(river) {
                assert_eq!(resting, 2, "river {river} moves in one round of three: {paces:?}");
                assert!((paces.iter().sum::<f32>() - 3.0 * 0.3).abs() < 1e-6, "three times as far: {paces:?}");
            } else {
                assert_eq!(paces[..], [1.0; 3], "a great river moves in each round");
            }
        }
        let at_work: Vec<usize> =
            moves.iter().map(|paces| paces.iter().filter(|step_scale| **step_scale > 0.0).count()).collect();
        assert!(at_work.iter().all(|rivers| (2..=3).contains(rivers)), "gentle rivers share the rounds: {at_work:?}");
    }
}
