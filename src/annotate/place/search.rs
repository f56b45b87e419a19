//! The search for a label's place: of many candidates the cheapest that nothing forbids.

use glam::Vec2;

use super::background::{Background, LAKE, RIDGE};
use super::baseline::{Line, Walk, is_upright, walk_from};
use super::costs::{Turns, Under, steepness};
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, MIDDLE, Placed, Text, between};
use crate::base::geometry::direction;
use crate::base::sort;

/// The distance between candidates along their line, in ems, and that between the best and further ones that are tried around them; and the
/// number of the best.
const STEP: f32 = 1.5;
const REFINED: f32 = 0.5;
const BEST: usize = 3;

/// The cost that no candidate may reach, and in pictures so small that letters are larger than their usual size: what is chosen there is kept for
/// all others.
pub const MOST_COST: f32 = 5.5;
pub const MOST_COST_SMALL: f32 = 4.0;

/// The em of large letters of usual size, in units.
const USUAL: f32 = 18.5;

/// The cosine of 55 degrees, the most between a letter and its label.
const COS_LETTER: f32 = 0.573_576_4;

/// The least distances of letters from the frame, the coast and other labels, in ems.
const FROM_FRAME: f32 = 0.4;
const FROM_COAST: f32 = 0.15;
const FROM_LABELS: f32 = 0.28;
/// The least distance of letters from other labels of the same river, with which they would read as one, in ems.
const FROM_OWN_LABELS: f32 = 1.6;

/// The greatest distance of letters from the bank on average, in ems, and of any of them.
const MOST_MEAN: f32 = 1.35;
const FARTHEST: f32 = 2.0;
/// The least width of a rival, which could be taken for the label's river, over the width of that; and the factor by which a label is
/// nearer to its own river.
const RIVAL: f32 = 0.4;
const NEARER: f32 = 1.15;
/// The distance from rivals that costs nothing, in ems.
const RIVALS_AWAY: f32 = 1.6;

/// The search for a place for one text along one river.
pub struct Search<'a, G> {
    pub input: &'a Input<'a>,
    pub background: &'a G,
    /// The boxes of the labels so far, with the numbers of their rivers.
    pub taken: &'a [(u32, Box)],
    pub river: u32,
    pub kind: Kind,
    /// The greatest width of the river, in units.
    pub thick: f32,
    pub lines: &'a [Line],
    pub text: Text,
    pub em: f32,
    /// Places that the label's middle keeps away from, and how far, in units.
    pub away: &'a [(Vec2, f32)],
    /// A place that the label's middle keeps to, and how near, in units.
    pub near: Option<(Vec2, f32)>,
    /// The cost that no candidate may reach.
    pub most_cost: f32,
    /// Returns `true` if any place that can be read will do: farther from the bank, on thicker brooks, near to others.
    pub is_lenient: bool,
}

/// Where a label might begin.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    cost: f32,
    line: usize,
    /// The distance from the line's beginning, in units.
    start: f32,
}

impl<G: Background> Search<'_, G> {
    /// Returns the label in the best place, with the line that it stands on and the width of the river there; `None` if there is none.
    pub fn label(&self, text: &str) -> Option<(Label, Line, f32)> {
        let candidate = self.best()?;
        let mut letters = Vec::new();
        self.lay(candidate.line, candidate.start, &mut letters)?;
        let (line, length) = (&self.lines[candidate.line], self.text.length * self.em);
        let width = line.width[walk_from(line, candidate.start + length * 0.5).place()];
        let label = Label::new(self.kind, Some(self.river), text, self.em, letters);
        Some((label, line.part(candidate.start, length), width))
    }

    /// Returns the cheapest candidate that nothing forbids; the earlier of equals.
    fn best(&self) -> Option<Candidate> {
        let mut letters = Vec::with_capacity(self.text.letters.len());
        let mut best: Vec<Candidate> = Vec::with_capacity(BEST + 1);
        for candidate in self.candidates() {
            let limit = if best.len() < BEST { self.most_cost } else { best[BEST - 1].cost };
            if candidate.cost >= limit && G::STOPS_EARLY {
                break;
            }
            if let Some(found) = self.judged(candidate, limit, &mut letters) {
                let place = best.partition_point(|other| other.cost <= found.cost);
                best.insert(place, found);
                best.truncate(BEST);
            }
        }
        let around = |&Candidate { line, start, .. }: &Candidate| {
            [-REFINED, REFINED].map(|by| Candidate { cost: 0.0, line, start: start + by * self.em })
        };
        let refined: Vec<Candidate> = best.iter().flat_map(around).collect();
        let mut best = *best.first()?;
        for candidate in refined {
            let found = self.judged(candidate, best.cost, &mut letters);
            best = found.filter(|found| found.cost < best.cost).unwrap_or(best);
        }
        Some(best)
    }

    /// Returns all candidates whose letters can be read, with the costs of their shapes, the cheapest first.
    fn candidates(&self) -> Vec<Candidate> {
        // Near one place few candidates are left: they lie closer.
        let step = if self.near.is_some() { REFINED } else { STEP } * self.em;
        let length = self.text.length * self.em;
        let (mut all, mut letters) = (Vec::new(), Vec::with_capacity(self.text.letters.len()));
        for (number, line) in self.lines.iter().enumerate() {
            let room = line.length() - length;
            let (mut start, mut walks) = (0.0, [0.0, length].map(|along| walk_from(line, along)));
            while start <= room {
                walks[0].go(start);
                walks[1].go(start + length);
                if let Some(cost) = self.lay_on(line, start, walks, &mut letters).filter(|&cost| cost < self.most_cost)
                {
                    all.push(Candidate { cost, line: number, start });
                }
                start += step;
            }
        }
        sort::sorted_by(&all, |candidate| sort::key(candidate.cost))
    }

    /// Returns a candidate with all of its cost, if that is less than the limit and nothing forbids it.
    fn judged(&self, candidate: Candidate, limit: f32, letters: &mut Vec<Placed>) -> Option<Candidate> {
        let Candidate { line, start, .. } = candidate;
        let shape = self.lay(line, start, letters)?;
        let middle = walk_from(&self.lines[line], start + self.text.length * self.em * 0.5).place();
        let width = self.lines[line].width[middle];
        let inked = shape + self.ink(letters, width)?;
        if inked >= limit && G::STOPS_EARLY {
            return None;
        }
        let cost = inked + self.distances(letters, width)?;
        (cost < limit && self.is_free(letters)).then_some(Candidate { cost, ..candidate })
    }

    /// Puts the letters along a line, and says what their shape costs; `None` if they could not be read there, or leave the land.
    fn lay(&self, line: usize, start: f32, letters: &mut Vec<Placed>) -> Option<f32> {
        let (line, end) = (&self.lines[line], start + self.text.length * self.em);
        self.lay_on(line, start, [start, end].map(|along| walk_from(line, along)), letters)
    }

    /// Puts the letters along a line between two walks, likewise.
    fn lay_on(
        &self,
        line: &Line,
        start: f32,
        [mut walk, mut end]: [Walk<'_>; 2],
        letters: &mut Vec<Placed>,
    ) -> Option<f32> {
        let (em, length) = (self.em, self.text.length * self.em);
        if start < 0.0 || start + length > line.length() {
            return None;
        }
        let ends = [walk.at(start), end.at(start + length)];
        let is_near = |(at, most): (Vec2, f32)| (ends[0] + ends[1]).distance_squared(at * 2.0) < most * most * 4.0;
        if self.near.is_some_and(|near| !is_near(near)) || self.away.iter().copied().any(is_near) {
            return None;
        }
        let along = direction(ends[1] - ends[0]);
        if !is_upright(along) || !self.is_in_frame(ends[0]) || !self.is_in_frame(ends[1]) {
            return None;
        }
        letters.clear();
        let mut turns = Turns::default();
        for letter in &self.text.letters {
            let from = walk.at(start + letter.at * em);
            let to = walk.at(start + (letter.at + letter.glyph.advance) * em);
            let placed = between(letter, from, to, em)?;
            if placed.along.dot(along) < COS_LETTER || !is_upright(placed.along) {
                return None;
            }
            turns.take(placed.along)?;
            letters.push(placed);
        }
        let middle = walk_from(line, start + length * 0.5).place();
        let off_middle = line.area[middle] - 0.5;
        let thin = (1.0 - line.width[middle] / (0.55 * self.thick)).max(0.0);
        let below = if line.is_above { 0.0 } else { 0.35 };
        Some(match self.kind {
            Kind::River => turns.cost() + 1.6 * steepness(along) + 2.6 * off_middle * off_middle + 0.9 * thin + below,
            _ => 1.1 * turns.sum + 1.6 * steepness(along) + 3.0 * off_middle.abs(),
        })
    }

    fn is_in_frame(&self, at: Vec2) -> bool {
        self.input.is_in_frame(at, FROM_FRAME * self.em)
    }

    /// Returns the cost of the ink under the letters; `None` if there is too much of it, or sea.
    fn ink(&self, letters: &[Placed], width: f32) -> Option<f32> {
        // Large letters stand over wider rivers as well as small ones do over narrow ones.
        let larger = (self.em / USUAL).max(1.0);
        let most = larger.sqrt()
            * match self.kind {
                Kind::River if self.is_lenient => width.max(3.2),
                Kind::River => (0.55 * width).clamp(1.6, 3.2),
                _ => (0.8 * self.thick).clamp(1.6, 3.2),
            };
        let (mut others, mut own) = (Under::default(), Under::default());
        for letter in letters {
            let around = letter.around(self.em);
            if !self.is_on_land(&around) {
                return None;
            }
            for sample in around.samples() {
                let under = self.background.ink(sample);
                let is_own = under.river == self.river || under.river == LAKE;
                if under.river == RIDGE || (is_own && self.kind == Kind::River) || (!is_own && under.width > most) {
                    return None;
                }
                let width = if under.river == LAKE { self.thick } else { under.width };
                if is_own { own.take(width) } else { others.take(width) }
            }
        }
        let samples = (others.samples + own.samples).max(1.0);
        Some(match self.kind {
            Kind::River => 1.5 * (1.5 * others.hits + others.width / larger) / samples,
            _ => (1.2 * (0.5 * others.hits + others.width) + 4.0 * own.width / self.thick + 1.1 * own.hits) / samples,
        })
    }

    fn is_on_land(&self, around: &Box) -> bool {
        let is_ashore = |at: Vec2| self.input.map.coast().is_none_or(|coast| coast.height(at) >= FROM_COAST * self.em);
        around.corners().into_iter().all(|at| self.is_in_frame(at) && is_ashore(at))
    }

    /// Returns the cost of the distances from the river and from others; `None` if the label would not seem to belong to its river.
    fn distances(&self, letters: &[Placed], width: f32) -> Option<f32> {
        let (mut own_sum, mut squares, mut rival_sum, mut missing) = (0.0, 0.0, 0.0, 0.0);
        for letter in letters {
            let [own, rival] = distances(self.background, letter, self.em, self.river, width);
            if own >= FARTHEST && self.kind == Kind::River && !self.is_lenient {
                return None;
            }
            own_sum += own;
            squares += own * own;
            rival_sum += rival;
            missing += (RIVALS_AWAY - rival).max(0.0);
        }
        let count = letters.len() as f32;
        let mean = own_sum / count;
        if count == 0.0 || !is_nearer(own_sum, rival_sum) {
            return None;
        }
        if self.kind == Kind::Reach {
            return Some(0.5 * mean.max(0.0));
        }
        if mean > MOST_MEAN && !self.is_lenient {
            return None;
        }
        let deviation = (squares / count - mean * mean).max(0.0).sqrt();
        Some(1.2 * mean.max(0.0) + 0.6 * deviation + 0.8 * missing / count)
    }

    /// Returns `true` if no letter touches its own river or comes too near to another label. The test is exact.
    fn is_free(&self, letters: &[Placed]) -> bool {
        let margin = |river: u32| self.em * if river == self.river { FROM_OWN_LABELS } else { FROM_LABELS };
        let touches = |letter: &Placed| self.background.meets(&letter.around(self.em), self.river);
        are_off(self.taken, letters, self.em, &margin) && (self.kind == Kind::Reach || !letters.iter().any(touches))
    }
}

/// Returns the distances of a letter from the banks of its river, which has this width there, and from those of the nearest river that
/// could be taken for it, in ems.
fn distances<G: Background>(background: &G, letter: &Placed, em: f32, river: u32, width: f32) -> [f32; 2] {
    let middle = letter.place(Vec2::new(letter.glyph.advance * 0.5, MIDDLE), em);
    background.distances(middle, river, RIVAL * width, FARTHEST * em).map(|distance| distance / em)
}

/// Returns `true` if the sum of distances from a label's river is enough below that from rivals.
fn is_nearer(own: f32, rival: f32) -> bool {
    own * NEARER <= rival
}

/// Returns `true` if letters, of an em in units, are nearer to their river, which is so wide there, than to any that could be taken for it.
pub fn belongs<G: Background>(background: &G, letters: &[Placed], em: f32, river: u32, width: f32) -> bool {
    let both = letters.iter().map(|letter| distances(background, letter, em, river, width));
    let [own, rival] = both.fold([0.0; 2], |sums, [own, rival]| [sums[0] + own, sums[1] + rival]);
    is_nearer(own, rival)
}
