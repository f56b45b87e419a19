//! Labels in places that are chosen once, and become smaller there.

use glam::Vec2;

use super::background::Background;
use super::baseline::{Line, is_upright};
use super::costs::Turns;
use super::input::Input;
use super::letters::{Box, Kind, Label, MIDDLE, Placed, Stroke, Text};
use super::search::belongs;

/// The least distance of letters from the coast, and of names of seas and lakes, in ems.
const FROM_COAST: f32 = 0.16;
const FROM_COAST_AT_SEA: f32 = 0.75;

/// A label whose place is chosen.
#[derive(Clone, Debug)]
pub struct Chosen {
    pub label: Label,
    /// Its text as it is set.
    pub text: Text,
    /// The usual length of its em, in units.
    pub usual: f32,
    /// The least size of its letters, over that of the smallest that can be read.
    pub over_least: f32,
    /// The way in which it becomes smaller.
    pub shrinks: Shrinks,
}

/// A way in which a label becomes smaller.
#[derive(Clone, Debug)]
pub enum Shrinks {
    /// Along the line that it stands on, about its middle.
    Along {
        line: Line,
        /// The width of its river there, in units.
        width: f32,
        /// The middle of the line that it stood on first. However often it draws nearer to its river, it stays by that.
        anchor: Vec2,
    },
    /// About the middle between its ends.
    ToMiddle,
    /// Towards the island, cape or lake that it stands beside.
    Towards(Vec2),
    /// Towards a point of its own edge, the one nearest to its river: it covers nothing then that it has not covered before.
    ToPoint(Vec2),
}

impl Shrinks {
    /// Makes a label shrink along a line beside a river of a width, or along a line beside none.
    pub fn along(line: Line, width: f32) -> Self {
        let anchor = line.middle();
        Self::Along { line, width, anchor }
    }
}

impl Chosen {
    /// Returns the length of its em for another size of pictures; never more than it is.
    pub fn em(&self, input: &Input<'_>) -> f32 {
        input.em(self.usual, self.over_least).min(self.label.em)
    }

    /// Returns the label with letters as small as they are on pictures of this size; unchanged where those would be in the way of its
    /// river.
    pub fn resized<G: Background>(&self, input: &Input<'_>, background: &G) -> Self {
        let em = self.em(input);
        let is_off_coast = |letters: &[Placed]| is_off_coast(self.label.kind, letters, em, input);
        let shrunk = |to: Vec2| Some(self.shrunk(to, em)).filter(|letters| is_off_coast(letters));
        let letters = match &self.shrinks {
            _ if em >= self.label.em => None,
            Shrinks::Along { line, width, .. } => {
                let is_clear = |letters: &[Placed]| self.is_clear(letters, em, background);
                let belongs = |letters: &[Placed]| {
                    self.label.river.is_none_or(|river| belongs(background, letters, em, river, *width))
                };
                self.along(line, em).find(|letters| is_clear(letters) && is_off_coast(letters) && belongs(letters))
            }
            Shrinks::ToMiddle => shrunk(self.middle()),
            Shrinks::ToPoint(place) => Some(self.shrunk(*place, em)),
            Shrinks::Towards(place) => shrunk(*place).or_else(|| shrunk(self.middle())),
        };
        let mut resized = self.clone();
        if let Some(letters) = letters {
            resized.label.strokes.iter_mut().for_each(|line| line.half *= em / self.label.em);
            (resized.label.em, resized.label.letters) = (em, letters);
        }
        resized
    }

    /// Returns its letters about the middle of its line, or a little before or behind that.
    fn along(&self, line: &Line, em: f32) -> impl Iterator<Item = Vec<Placed>> {
        const OFF: [f32; 7] = [0.0, -0.15, 0.15, -0.3, 0.3, -0.45, 0.45];
        let start = (line.length() - self.text.length * em) * 0.5;
        OFF.into_iter().filter_map(move |off| self.text.along(line, start + off * em, em))
    }

    /// Returns `true` if letters can be read, and none touches its river.
    fn is_clear<G: Background>(&self, letters: &[Placed], em: f32, background: &G) -> bool {
        let mut turns = Turns::default();
        let is_readable = |letter: &Placed| is_upright(letter.along) && turns.take(letter.along).is_some();
        let river = self.label.river.filter(|_| self.label.kind == Kind::River);
        let touches = |letter: &Placed| river.is_some_and(|river| background.meets(&letter.around(em), river));
        letters.iter().all(is_readable) && !letters.iter().any(touches)
    }

    /// Returns its letters, drawn together towards a place.
    fn shrunk(&self, to: Vec2, em: f32) -> Vec<Placed> {
        let share = em / self.label.em;
        let place = |letter: &Placed| Placed { at: to + (letter.at - to) * share, ..*letter };
        self.label.letters.iter().map(place).collect()
    }

    /// Returns the middle between its first letter and its last.
    pub fn middle(&self) -> Vec2 {
        middle(&self.label)
    }

    /// Returns the boxes of its letters and its hairline, with the number of its river.
    pub fn boxes(&self) -> impl Iterator<Item = (u32, Box)> + '_ {
        let river = self.label.river.unwrap_or(super::background::NONE);
        let letters = self.label.letters.iter().map(|letter| letter.around(self.label.em));
        letters.chain(self.label.strokes.iter().map(Stroke::box_along)).map(move |around| (river, around))
    }

    /// Returns `true` if another label names the same river or reach.
    pub fn is_of_same(&self, other: &Self) -> bool {
        self.label.river.is_some() && self.label.river == other.label.river && self.label.kind == other.label.kind
    }

    /// Returns the area that it covers, in square units.
    pub fn area(&self) -> f32 {
        self.text.length * self.label.em * self.label.em
    }
}

/// Returns the middle between a label's first letter and its last.
pub fn middle(label: &Label) -> Vec2 {
    let half = |letter: &Placed| letter.place(Vec2::new(letter.glyph.advance * 0.5, MIDDLE), label.em);
    let ends = [label.letters.first(), label.letters.last()].map(|letter| letter.map_or(Vec2::ZERO, half));
    (ends[0] + ends[1]) * 0.5
}

/// Returns `true` if letters are all on the water or all on land, as their kind is, and off the coast.
fn is_off_coast(kind: Kind, letters: &[Placed], em: f32, input: &Input<'_>) -> bool {
    let least = match kind {
        Kind::Water => FROM_COAST_AT_SEA * em,
        _ => FROM_COAST * em,
    };
    let is_off = |at: Vec2| match input.map.coast().map(|coast| coast.height(at)) {
        Some(height) if kind.is_afloat() => -height >= least,
        Some(height) => height >= least,
        None => true,
    };
    letters.iter().flat_map(|letter| letter.around(em).corners()).all(is_off)
}
