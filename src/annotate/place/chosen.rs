//! Labels in places that are chosen once, and become smaller there.

use glam::Vec2;

use super::baseline::{Line, walk_from};
use super::input::Input;
use super::letters::{Box, Label, MIDDLE, Placed, Text, between};
use crate::annotate::glyph::Letter;
use crate::land::CoastDistance;

/// How far letters on the water keep from the coast, in ems.
const FROM_COAST: f32 = 0.2;

/// A label whose place is chosen.
#[derive(Clone, Debug)]
pub struct Chosen {
    pub label: Label,
    /// Its text as it is set.
    pub text: Text,
    /// The usual length of its em, in units.
    pub usual: f32,
    /// How much larger its letters are at least than the smallest that can be read.
    pub over_least: f32,
    /// How it becomes smaller.
    pub shrinks: Shrinks,
}

/// How a label becomes smaller.
#[derive(Clone, Debug)]
pub enum Shrinks {
    /// Along the line that it stands on, about its middle.
    Along(Line),
    /// About the middle between its ends.
    ToMiddle,
    /// Towards what it stands beside, on the water.
    Towards(Vec2),
}

impl Chosen {
    /// The length of its em for another size of pictures; never more than it is.
    pub fn em(&self, input: &Input<'_>) -> f32 {
        let em = self.usual.max(self.over_least * input.least_em) * input.label_size;
        em.min(self.label.em)
    }

    /// The same with letters of another size around the same middle.
    pub fn resized(&self, em: f32, coast: Option<&CoastDistance>) -> Self {
        let is_afloat = |letters: &[Placed]| {
            let corners = |letter: &Placed| letter.around(em).corners();
            letters.iter().flat_map(corners).all(|at| coast.is_none_or(|coast| coast.height(at) <= -FROM_COAST * em))
        };
        let letters = match &self.shrinks {
            Shrinks::Along(line) => self.along(line, em),
            Shrinks::ToMiddle => self.shrunk(self.middle(), em),
            Shrinks::Towards(place) => {
                let nearer = self.shrunk(*place, em);
                if is_afloat(&nearer) { nearer } else { self.shrunk(self.middle(), em) }
            }
        };
        Self { label: Label { em, letters, ..self.label.clone() }, ..self.clone() }
    }

    /// Its letters about the middle of its line.
    fn along(&self, line: &Line, em: f32) -> Vec<Placed> {
        let start = (line.length() - self.text.length * em) * 0.5;
        let mut walk = walk_from(line, start);
        let place = |letter: &Letter| {
            let [from, to] = [letter.at, letter.at + letter.glyph.advance].map(|at| walk.at(start + at * em));
            between(letter, from, to, em)
        };
        self.text.letters.iter().filter_map(place).collect()
    }

    /// Its letters, nearer to a place.
    fn shrunk(&self, to: Vec2, em: f32) -> Vec<Placed> {
        let share = em / self.label.em;
        let place = |letter: &Placed| Placed { at: to + (letter.at - to) * share, ..*letter };
        self.label.letters.iter().map(place).collect()
    }

    /// The middle between its first letter and its last.
    pub fn middle(&self) -> Vec2 {
        middle(&self.label)
    }

    /// The boxes of its letters, with the number of its river.
    pub fn boxes(&self) -> impl Iterator<Item = (u32, Box)> + '_ {
        let river = self.label.river.unwrap_or(super::background::NONE);
        self.label.letters.iter().map(move |letter| (river, letter.around(self.label.em)))
    }

    /// What it covers, in square units.
    pub fn area(&self) -> f32 {
        self.text.length * self.label.em * self.label.em
    }
}

/// The middle between a label's first letter and its last.
pub fn middle(label: &Label) -> Vec2 {
    let half = |letter: &Placed| letter.place(Vec2::new(letter.glyph.advance * 0.5, MIDDLE), label.em);
    let ends = [label.letters.first(), label.letters.last()].map(|letter| letter.map_or(Vec2::ZERO, half));
    (ends[0] + ends[1]) * 0.5
}
