//! The panel of a plate: its heading, and the type and lines that figures consist of.

use glam::Vec2;

use super::input::{Cartouche, Plate};
use super::letters::{Box, Kind, Label, Placed, Stroke, Text};
use crate::annotate::glyph::Letter;

/// The distance of its figure from the frame, in ems.
const AROUND: f32 = 1.0;

/// The greatest sizes of the title and of the lines under it, and the distance between lines, in ems.
const TITLE: f32 = 2.1;
const SUBJECT: f32 = 1.2;
const LINE: f32 = 1.25;

/// A panel with a figure, as far as it is drawn.
pub struct Panel {
    /// The length of its em, in units.
    pub em: f32,
    /// The room of the figure: its upper left and its lower right corner, in units.
    pub within: [Vec2; 2],
    /// The box of its heading.
    pub heading: Box,
    pub labels: Vec<Label>,
    pub strokes: Vec<Stroke>,
}

impl Panel {
    /// Makes a panel with its heading in the upper right corner.
    pub fn new(at: Vec2, size: Vec2, em: f32, cartouche: &Cartouche, plate: &Plate) -> Option<Self> {
        let within = [at + AROUND * em, at + size - AROUND * em];
        let heading = Box::level(within[0], within[0]);
        let mut this = Self { em, within, heading, labels: Vec::new(), strokes: Vec::new() };
        let widest = 0.66 * (within[1].x - within[0].x);
        let mut foot = within[0].y;
        let mut left = within[1].x;
        let subject = match plate {
            Plate::Lengths(_) => vec!["Comparative lengths of".to_owned(), "the principal rivers".to_owned()],
            Plate::Profile(profile) => vec![format!("Long profile: {}", profile.name)],
        };
        let title = (cartouche.title.trim(), Kind::Title, TITLE);
        let lines = subject.iter().map(|says| (says.as_str(), Kind::Plate, SUBJECT));
        for (says, kind, most) in [title].into_iter().chain(lines) {
            let text = Text::new(says, kind);
            if text.letters.is_empty() {
                continue;
            }
            let size = (widest / text.length).min(most * em);
            if size < 0.9 * em {
                return None;
            }
            let from =
                Vec2::new(within[1].x - text.length * size, foot + if kind == Kind::Title { 0.7 } else { 1.0 } * size);
            foot = from.y + (LINE - 1.0) * size;
            left = left.min(from.x);
            this.write(kind, says, &text, from, size);
        }
        this.heading = Box::level(Vec2::new(left - em, within[0].y), Vec2::new(within[1].x, foot + 0.4 * em));
        (!this.labels.is_empty()).then_some(this)
    }

    fn write(&mut self, kind: Kind, says: &str, text: &Text, from: Vec2, em: f32) {
        let letters = text.level(from, em);
        self.labels.push(Label::new(kind, None, says, em, letters));
    }

    /// Writes a number whose middle or end, by a share of its length, is at a place.
    pub fn number(&mut self, says: &str, at: Vec2, share: f32, size: f32) {
        let (text, em) = (Text::new(says, Kind::Plate), size * self.em);
        self.write(Kind::Plate, says, &text, at - Vec2::new(share * text.length * em, 0.0), em);
    }

    /// Writes upward from a place.
    pub fn upward(&mut self, river: Option<u32>, says: &str, text: &Text, from: Vec2, em: f32) {
        let placed = |letter: &Letter| Placed {
            glyph: letter.glyph,
            at: from - Vec2::new(0.0, letter.at * em),
            along: Vec2::NEG_Y,
        };
        self.labels.push(Label::new(Kind::Plate, river, says, em, text.letters.iter().map(placed).collect()));
    }

    pub fn line(&mut self, from: Vec2, to: Vec2, half: f32) {
        self.strokes.push(Stroke { ends: [from, to], half });
    }

    /// Returns the foot of the heading over a column, or the panel's upper side where the heading does not reach.
    pub fn ceiling(&self, x: f32) -> f32 {
        let [left, foot] = [self.heading.middle.x - self.heading.along.x, self.heading.middle.y + self.heading.down.y];
        if x < left { self.within[0].y } else { foot }
    }
}

/// Returns the least of 1, 2, 5, 10, 20, … that goes into a length at most `most` times.
pub fn step(length: f32, most: f32) -> f32 {
    let mut step = 1.0;
    // More than any map has.
    while step < 1e6 && length > step * most {
        let next = step * 2.0;
        let is_two = [2.0, 20.0, 200.0, 2_000.0, 20_000.0, 200_000.0].contains(&step);
        step = if is_two { step * 2.5 } else { next };
    }
    step
}
