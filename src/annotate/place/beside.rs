//! The names of rivers that have no room for a line along them: level beside the river in two lines, or farther off with a hairline that leads
//! to it, best at its mouth.

use glam::Vec2;

use super::background::{Background, LAKE, RIDGE};
use super::chosen::Shrinks;
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Stroke, Text};
use super::search::belongs;
use crate::base::geometry::{direction, distance};
use crate::network::Place;

/// The distance between two lines, the height of capitals over theirs and the depth of letters under it, in ems.
const LEADING: f32 = 1.0;
const CAPITAL: f32 = 0.66;
const UNDER: f32 = 0.27;

/// The gap between a river and two lines beside it, and the gaps that a hairline bridges, in ems.
const BESIDE: [f32; 2] = [0.45, 0.8];
const BRIDGED: [f32; 5] = [1.0, 1.5, 2.2, 3.2, 4.5];
/// Half the width of a hairline, and how far it stays off letters and other labels, in ems.
const HAIR: f32 = 0.03;
const FROM_LINE: f32 = 0.2;

/// The number of places along the river that are tried, and what it costs to be a share of its length away from the mouth.
const PLACES: usize = 24;
const OFF_MOUTH: f32 = 4.0;

/// The least distances of letters from the frame, the coast, other labels and other labels of the same river, in ems; and the widest river
/// that may run under them, in units.
const FROM_FRAME: f32 = 0.4;
const FROM_COAST: f32 = 0.2;
const FROM_LABELS: f32 = 0.28;
const FROM_OWN_LABELS: f32 = 1.6;
const WIDEST_UNDER: f32 = 2.4;

/// The directions in which a name may lie from its river, with what they cost.
const DIRECTIONS: [(Vec2, f32); 16] = [
    (Vec2::new(1.0, 0.0), 0.0),
    (Vec2::new(0.92, -0.38), 0.0),
    (Vec2::new(0.92, 0.38), 0.1),
    (Vec2::new(0.71, -0.71), 0.2),
    (Vec2::new(0.71, 0.71), 0.2),
    (Vec2::new(-1.0, 0.0), 0.3),
    (Vec2::new(-0.92, -0.38), 0.3),
    (Vec2::new(-0.92, 0.38), 0.4),
    (Vec2::new(-0.71, -0.71), 0.4),
    (Vec2::new(-0.71, 0.71), 0.4),
    (Vec2::new(0.38, -0.92), 0.5),
    (Vec2::new(0.38, 0.92), 0.5),
    (Vec2::new(-0.38, -0.92), 0.6),
    (Vec2::new(-0.38, 0.92), 0.6),
    (Vec2::new(0.0, -1.0), 0.7),
    (Vec2::new(0.0, 1.0), 0.7),
];

/// The search for a level place beside one river.
pub struct Beside<'a, G> {
    pub input: &'a Input<'a>,
    pub background: &'a G,
    /// The boxes of the labels so far, with the numbers of their rivers.
    pub taken: &'a [(u32, Box)],
    pub river: u32,
    pub em: f32,
}

/// Lines of type, one under the other, about one middle.
struct Lines {
    texts: Vec<Text>,
    /// Half their width and height, in units.
    half: Vec2,
}

/// A place for lines, with its letters and the end of its hairline at them.
struct Found {
    cost: f32,
    letters: Vec<Placed>,
    at: Vec2,
    hairline: Option<Stroke>,
}

impl<G: Background> Beside<'_, G> {
    /// Returns the label, in two lines close to the river or with a hairline to it, its text in one line, and how it becomes smaller; `None`
    /// if there is no room.
    pub fn label(&self, name: &str, is_bridged: bool) -> Option<(Label, Text, Shrinks)> {
        let layouts = [self.lines(&halves(name)), self.lines(&[name])];
        let found = self.found(if is_bridged { &layouts } else { &layouts[..1] }, is_bridged)?;
        let mut label = Label::new(Kind::River, Some(self.river), name, self.em, found.letters);
        label.strokes.extend(found.hairline);
        Some((label, Text::new(name, Kind::River), Shrinks::ToPoint(found.at)))
    }

    /// Finds the best place for one of the layouts: close to the river, or farther off with a hairline to it.
    fn found(&self, layouts: &[Lines], is_bridged: bool) -> Option<Found> {
        let gaps: &[f32] = if is_bridged { &BRIDGED } else { &BESIDE };
        let mut best = None;
        for (place, off_mouth) in self.places() {
            for (gap, (towards, cost)) in gaps.iter().flat_map(|gap| DIRECTIONS.map(|towards| (gap, towards))) {
                for (number, lines) in (0..).zip(layouts) {
                    let Some(mut found) = self.placed(lines, &place, towards, *gap) else { continue };
                    found.cost += cost + gap;
                    let is_its_own = if is_bridged {
                        let Some((hairline, crossed)) = self.hairline(&place, &found) else { continue };
                        found.cost += OFF_MOUTH * off_mouth + 2.0 * crossed + 0.3 * number as f32;
                        found.hairline = Some(hairline);
                        true
                    } else {
                        belongs(self.background, &found.letters, self.em, self.river, 2.0 * place.half)
                    };
                    take_cheaper(&mut best, found, is_its_own);
                }
            }
        }
        best
    }

    /// Returns places of the river, with the share of it between them and its mouth.
    fn places(&self) -> impl Iterator<Item = (Place, f32)> + '_ {
        let course = &self.input.map.courses[self.river as usize];
        let last = course.len().saturating_sub(1);
        let shares = (0..PLACES).map(|i| i as f32 / PLACES as f32);
        shares.filter_map(move |share| Some((*course.get(last - (share * last as f32) as usize)?, share)))
    }

    /// Sets lines of type in letters of this size.
    #[inline(never)] // one copy
    fn lines(&self, texts: &[&str]) -> Lines {
        let texts: Vec<Text> = texts.iter().map(|text| Text::new(text, Kind::River)).collect();
        let width = texts.iter().map(|text| text.length).fold(0.0, f32::max);
        let height = CAPITAL + UNDER + LEADING * texts.len().saturating_sub(1) as f32;
        Lines { texts, half: Vec2::new(width, height) * (0.5 * self.em) }
    }

    /// Puts lines so far from the river in a direction; `None` if something forbids that.
    #[inline(never)] // one copy
    fn placed(&self, lines: &Lines, place: &Place, towards: Vec2, gap: f32) -> Option<Found> {
        let at = place.at + towards * (place.half + gap * self.em);
        let middle = at + lines.half * towards / towards.abs().max_element();
        let mut letters = Vec::new();
        for (number, text) in (0..).zip(&lines.texts) {
            let down = (CAPITAL + LEADING * number as f32) * self.em - lines.half.y;
            letters.extend(text.level(middle + Vec2::new(-0.5 * text.length * self.em, down), self.em));
        }
        let cost = self.cost(&letters)?;
        self.is_free(&letters).then_some(Found { cost, letters, at, hairline: None })
    }

    /// Returns the cost of the ink under letters; `None` if there is too much of it, if they leave the frame, or if they are neither all on
    /// land nor all at sea.
    fn cost(&self, letters: &[Placed]) -> Option<f32> {
        let height = |at: Vec2| self.input.map.coast().map_or(f32::MAX, |coast| coast.height(at));
        let is_ashore = height(letters.first()?.at) > 0.0;
        let (mut hits, mut samples) = (0.0, 0.0);
        for around in letters.iter().map(|letter| letter.around(self.em)) {
            let is_there = |at: Vec2| {
                let room = if is_ashore { height(at) } else { -height(at) };
                room >= FROM_COAST * self.em && self.input.is_in_frame(at, FROM_FRAME * self.em)
            };
            if !around.corners().into_iter().all(is_there) {
                return None;
            }
            for under in around.samples().map(|sample| self.background.ink(sample)) {
                if under.river == RIDGE
                    || under.river == LAKE
                    || under.river == self.river
                    || under.width > WIDEST_UNDER
                {
                    return None;
                }
                samples += 1.0;
                hits += if under.width > 0.0 { 0.5 + under.width } else { 0.0 };
            }
        }
        Some(4.0 * hits / samples)
    }

    /// Returns `true` if no letter touches the river or comes too near to another label.
    fn is_free(&self, letters: &[Placed]) -> bool {
        let margin = |river: u32| self.em * if river == self.river { FROM_OWN_LABELS } else { FROM_LABELS };
        let touches = |letter: &Placed| self.background.meets(&letter.around(self.em), self.river);
        are_off(self.taken, letters, self.em, &margin) && !letters.iter().any(touches)
    }

    /// Draws a hairline from the bank to letters, and counts the places where it crosses other rivers; `None` if a label is in its way.
    fn hairline(&self, place: &Place, found: &Found) -> Option<(Stroke, f32)> {
        let along = direction(found.at - place.at);
        let ends = [place.at + along * place.half, found.at - along * (FROM_LINE * self.em)];
        let line = Stroke { ends, half: HAIR * self.em };
        let around = line.box_along();
        if self.taken.iter().any(|(_, other)| around.meets(other, FROM_LINE * self.em)) {
            return None;
        }
        let samples = (distance(ends[0], ends[1]) / (0.25 * self.em)) as usize;
        let at = |i: usize| ends[0] + (ends[1] - ends[0]) * ((i + 1) as f32 / (samples + 1) as f32);
        let is_crossed = |under: super::background::Ink| under.width > 0.0 && under.river != self.river;
        Some((line, (0..samples).filter(|&i| is_crossed(self.background.ink(at(i)))).count() as f32))
    }
}

/// Keeps the cheaper of two places, the earlier of equals.
fn take_cheaper(best: &mut Option<Found>, found: Found, is_good: bool) {
    if is_good && best.as_ref().is_none_or(|best| found.cost < best.cost) {
        *best = Some(found);
    }
}

/// Divides a name at the space that makes its longer part the shortest; all of it if there is none.
fn halves(name: &str) -> Vec<&str> {
    let spaces = name.match_indices(' ').filter_map(|(at, _)| Some((name.get(..at)?, name.get(at + 1..)?)));
    let shortest = spaces.min_by_key(|(first, second)| first.chars().count().max(second.chars().count()));
    shortest.map_or_else(|| vec![name], |(first, second)| vec![first, second])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_divided_into_parts_that_are_as_even_as_can_be() {
        assert_eq!(halves("The Long Grey"), ["The Long", "Grey"]);
        assert_eq!(halves("Thessaly Water"), ["Thessaly", "Water"]);
        assert_eq!(halves("Silverrun"), ["Silverrun"]);
    }
}
