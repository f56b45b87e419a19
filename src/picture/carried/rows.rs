//! Labels in whole numbers, and these as text.
//!
//! ```text
//! label:  0 and the number of the label in the step before that it is the same as; or its kind and 1, em, letters, lines, cleared lines
//! letter: number among its face's, x and y less where the letter before would have it, turn less that of the one before
//! line:   x and y of one end less those of the line before, the other end less the one, half its width less that of the line before
//! ```

use std::f32::consts::TAU;

use glam::Vec2;

use crate::annotate::glyph::Typeface;
use crate::annotate::place::{Kind, Label, LabelIn, PlacedIn, Stroke};
use crate::base::numbers::{Reader, Writer};
use crate::base::trigonometry::sine_and_cosine;

/// The number of steps to a unit: of places, of ems, and of half widths.
const PLACES: f32 = 32.0;
const EMS: f32 = 64.0;
const HALVES: f32 = 256.0;
/// The number of steps to a whole turn.
const TURNS: f32 = 4096.0;

/// The farthest place, the largest letters and the widest lines that are read: all of any map.
const FARTHEST: u32 = 8192 * PLACES as u32;
const LARGEST: u32 = 1024 * EMS as u32;
const WIDEST: u32 = 1024 * HALVES as u32;

/// A label in whole numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub kind: Kind,
    em: u32,
    pub letters: Vec<Letter>,
    lines: Vec<Line>,
    cleared: Vec<Line>,
}

/// A letter in whole numbers: its code, its place, and how far it is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Letter {
    pub code: u32,
    at: [i32; 2],
    turn: i32,
}

/// A line in whole numbers: its ends, and half its width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Line {
    ends: [[i32; 2]; 2],
    half: i32,
}

impl Row {
    /// Rounds a label.
    pub fn of(label: &Label) -> Self {
        let letter = |letter: &PlacedIn<'_>| Letter {
            code: letter.glyph.code,
            at: rounded(letter.at),
            turn: (libm::atan2f(letter.along.y, letter.along.x) * (TURNS / TAU)).round() as i32,
        };
        let lines = |lines: &[Stroke]| lines.iter().map(Line::of).collect();
        Self {
            kind: label.kind,
            em: (label.em * EMS).round() as u32,
            letters: label.letters.iter().map(letter).collect(),
            lines: lines(&label.strokes),
            cleared: lines(&label.cleared),
        }
    }

    /// Returns the label for those who paint it, without letters that the faces lack.
    pub fn label<'face>(&self, faces: [&'face Typeface; 2]) -> LabelIn<'face> {
        let face = faces[self.kind.face() as usize];
        let placed = |letter: &Letter| {
            let glyph = face.glyph(letter.code)?;
            Some(PlacedIn { glyph, at: place(letter.at), along: direction(letter.turn) })
        };
        let lines = |lines: &[Line]| lines.iter().map(Line::stroke).collect();
        let letters = self.letters.iter().filter_map(placed).collect();
        LabelIn {
            strokes: lines(&self.lines),
            cleared: lines(&self.cleared),
            ..LabelIn::new(self.kind, None, "", self.em as f32 / EMS, letters)
        }
    }

    /// Writes a label of a step after those of the step before.
    pub fn write(&self, writer: &mut Writer, before: &[Self], faces: &[Typeface; 2]) {
        if let Some(same) = before.iter().position(|label| label == self) {
            writer.whole(0);
            return writer.whole(same as u32);
        }
        writer.whole(self.kind as u32 + 1);
        writer.whole(self.em);
        let face = &faces[self.kind.face() as usize];
        let mut expected = Expected::default();
        writer.list(&self.letters, |writer, letter| {
            writer.whole(face.glyphs().partition_point(|glyph| glyph.code < letter.code) as u32);
            (0..2).for_each(|axis| writer.signed(letter.at[axis] - expected.at[axis]));
            writer.signed(letter.turn - expected.turn);
            expected.follow(letter, self, face);
        });
        write_lines(writer, &self.lines);
        write_lines(writer, &self.cleared);
    }

    /// Reads a label of a step after those of the step before; `None` if it cannot be one.
    pub fn read(reader: &mut Reader<'_>, before: &[Self], faces: &[Typeface; 2]) -> Option<Self> {
        let kind = match reader.whole() {
            0 => return before.get(reader.whole() as usize).cloned(),
            number => *Kind::ALL.get(number as usize - 1)?,
        };
        let em = Some(reader.whole()).filter(|em| (1..=LARGEST).contains(em))?;
        let face = &faces[kind.face() as usize];
        let mut this = Self { kind, em, letters: Vec::new(), lines: Vec::new(), cleared: Vec::new() };
        let mut expected = Expected::default();
        let letters = reader.list(|reader| {
            let code = face.glyphs().get(reader.whole() as usize)?.code;
            let at = expected.at.map(|at| at.wrapping_add(reader.signed()));
            let letter = Letter { code, at, turn: expected.turn.wrapping_add(reader.signed()) };
            let is_sound = is_near(at) && letter.turn.unsigned_abs() <= TURNS as u32 / 2;
            is_sound.then(|| expected.follow(&letter, &this, face)).map(|()| letter)
        });
        this.letters = letters.into_iter().collect::<Option<_>>()?;
        this.lines = read_lines(reader)?;
        this.cleared = read_lines(reader)?;
        Some(this)
    }
}

/// Where a letter is expected: behind the one before.
#[derive(Default)]
struct Expected {
    at: [i32; 2],
    turn: i32,
}

impl Expected {
    fn follow(&mut self, letter: &Letter, row: &Row, face: &Typeface) {
        let advance = face.glyph(letter.code).map_or(0.0, |glyph| glyph.advance) + row.kind.tracking();
        let next = place(letter.at) + direction(letter.turn) * (advance * row.em as f32 / EMS);
        *self = Self { at: rounded(next), turn: letter.turn };
    }
}

impl Line {
    fn of(stroke: &Stroke) -> Self {
        Self { ends: stroke.ends.map(rounded), half: (stroke.half * HALVES).round() as i32 }
    }

    fn stroke(&self) -> Stroke {
        Stroke { ends: self.ends.map(place), half: self.half as f32 / HALVES }
    }
}

fn write_lines(writer: &mut Writer, lines: &[Line]) {
    let mut before = Line::default();
    writer.list(lines, |writer, line| {
        let [from, to] = line.ends;
        for axis in 0..2 {
            writer.signed(from[axis] - before.ends[0][axis]);
            writer.signed(to[axis] - from[axis]);
        }
        writer.signed(line.half - before.half);
        before = *line;
    });
}

fn read_lines(reader: &mut Reader<'_>) -> Option<Vec<Line>> {
    let mut line = Line::default();
    let lines = reader.list(|reader| {
        for axis in 0..2 {
            line.ends[0][axis] = line.ends[0][axis].wrapping_add(reader.signed());
            line.ends[1][axis] = line.ends[0][axis].wrapping_add(reader.signed());
        }
        line.half = line.half.wrapping_add(reader.signed());
        (line.ends.into_iter().all(is_near) && line.half >= 0 && line.half as u32 <= WIDEST).then_some(line)
    });
    lines.into_iter().collect()
}

fn rounded(at: Vec2) -> [i32; 2] {
    (at * PLACES).round().to_array().map(|at| at as i32)
}

fn place(at: [i32; 2]) -> Vec2 {
    Vec2::from(at.map(|at| at as f32)) / PLACES
}

fn is_near(at: [i32; 2]) -> bool {
    at.iter().all(|at| at.unsigned_abs() <= FARTHEST)
}

fn direction(turn: i32) -> Vec2 {
    let (sine, cosine) = sine_and_cosine(turn as f32 * (TAU / TURNS));
    Vec2::new(cosine, sine)
}
