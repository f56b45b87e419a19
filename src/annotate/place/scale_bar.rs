//! The scale bar: a round number of kilometres in four parts, with a needle to the north where a style wants one.

use glam::Vec2;

use super::anchor::{self, Anchor};
use super::background::Background;
use super::corner::{self, filled};
use super::frames::along;
use super::input::{Cartouche, Input, NorthPoint};
use super::letters::{Box, Kind, Label, Stroke, Text};
use crate::scale::{MapScale, figures, round_length};

/// The length of the em of its letters, in units.
const EM: f32 = 11.5;
/// The least distance of the scale bar from the coast, and from other blocks, in ems.
const FROM_COAST: f32 = 0.5;
const FROM_BLOCKS: f32 = 0.8;
/// The greatest length of the bar, in units, and the number of its parts.
const LONGEST: f32 = 210.0;
const PARTS: u32 = 4;
/// The height of the bar, the width of its lines, and the height of its letters with the space under them, in ems.
const HEIGHT: f32 = 0.3;
const THIN: f32 = 0.026;
const LETTERS: f32 = 1.05;
/// The width and the height of the needle with what is around it, in ems.
const NEEDLE: Vec2 = Vec2::new(1.7, 3.1);

/// The place of the number between those at the ends, as a share of the length.
const BETWEEN: f32 = 0.5;
/// The least distance between the middles of two numbers, in ems.
const APART: f32 = 2.2;

/// Puts it into a place at sea that the title leaves free, with the box around it; `None` if there is no room. Which place that is does not
/// depend on the size of the picture.
pub fn set<G: Background>(
    input: &Input<'_>,
    background: &G,
    cartouche: &Cartouche,
    title: Option<Anchor>,
    taken: &[Box],
) -> Option<(Vec<Label>, Box, Anchor)> {
    let bar = Bar::new(&input.map.scale, cartouche.north == Some(NorthPoint::Arrow));
    let usual = EM * input.whole_size;
    let frame = input.frame;
    let is_free = |place: &Anchor| title.is_none_or(|title| *place != title && !place.is_beside(title));
    let mut best: Option<(corner::Corner, Anchor)> = None;
    // Rather below than above, as is the custom.
    for place in [2, 3, 5, 0, 1, 4].map(|i| Anchor::ALL[i]).into_iter().filter(is_free) {
        let size = bar.size(usual);
        let at = place.place(frame, size);
        if !anchor::is_open(input, at, size, FROM_COAST * usual) || meets(at, size, usual, taken) {
            continue;
        }
        let judged = corner::judged(input, background, at, size, usual);
        if best.as_ref().is_none_or(|(best, _)| judged.is_better_than(best)) {
            best = Some((judged, place));
        }
    }
    let (_, place) = best?;
    let em = (EM * input.label_size).max(input.least());
    let size = bar.size(em);
    let at = place.place(input.inner_frame(), size);
    let is_free = anchor::is_open(input, at, size, FROM_COAST * em) && !meets(at, size, em, taken);
    is_free.then(|| (set_at(at, em, &bar), Box::level(at, at + size), place))
}

fn meets(at: Vec2, size: Vec2, em: f32, taken: &[Box]) -> bool {
    taken.iter().any(|other| Box::level(at, at + size).meets(other, FROM_BLOCKS * em))
}

/// A bar, whatever the size of its letters.
struct Bar {
    /// Its length in kilometres, and in units.
    kilometres: f32,
    length: f32,
    has_needle: bool,
}

impl Bar {
    fn new(scale: &MapScale, has_needle: bool) -> Self {
        let kilometres = round_length(scale.kilometres(LONGEST));
        Self { kilometres, length: scale.units(kilometres), has_needle }
    }

    /// Returns its size with all that stands with it, in units.
    fn size(&self, em: f32) -> Vec2 {
        let needle = if self.has_needle { NEEDLE * em } else { Vec2::ZERO };
        let ends = Text::new(&self.says(1.0), Kind::Margin).length;
        Vec2::new(needle.x + self.length + (0.4 + ends) * em, ((LETTERS + HEIGHT) * em).max(needle.y))
    }

    /// Writes the number at a share of its length; that at its end has the unit.
    fn says(&self, share: f32) -> String {
        let number = figures(self.kilometres * share);
        if share == 1.0 { format!("{number} km") } else { number }
    }
}

/// Sets a label for each number, the first with all strokes.
fn set_at(at: Vec2, em: f32, bar: &Bar) -> Vec<Label> {
    let size = bar.size(em);
    let left = at.x + 0.3 * em + if bar.has_needle { NEEDLE.x * em } else { 0.0 };
    let (foot, thin) = (at.y + size.y - THIN * em, THIN * em);
    let top = foot - HEIGHT * em;
    let x = |share: f32| left + share * bar.length;
    let part = |part: u32| x(part as f32 / PARTS as f32);
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut line = |from: [f32; 2], to: [f32; 2]| strokes.push(Stroke { ends: [from.into(), to.into()], half: thin });
    let right = x(1.0);
    line([left, top], [right, top]);
    line([left, foot], [right, foot]);
    for here in (0..=PARTS).map(part) {
        line([here, top], [here, foot]);
    }
    for i in (0..PARTS).step_by(2) {
        let size = Vec2::new(bar.length / PARTS as f32, foot - top);
        strokes.extend(filled(Vec2::new(part(i), top), size, thin * 1.5));
    }
    let number = |share: f32| {
        let says = bar.says(share);
        // The unit stands behind its number.
        let digits = Text::new(says.trim_end_matches(" km"), Kind::Margin);
        written(&says, Vec2::new(x(share) - 0.5 * digits.length * em, top - 0.28 * em), em)
    };
    // Large letters leave no room for the number between.
    let has_room = |share: &f32| *share != BETWEEN || APART * em <= BETWEEN * bar.length;
    let mut labels: Vec<Label> = [0.0, BETWEEN, 1.0].into_iter().filter(has_room).map(number).collect();
    if bar.has_needle {
        let tip = Vec2::new(at.x + 0.6 * em, at.y + 0.75 * em);
        strokes.extend(needle(tip, Vec2::new(tip.x, at.y + size.y), em));
        labels.push(north(tip, em));
    }
    labels.iter_mut().take(1).for_each(|first| first.strokes = std::mem::take(&mut strokes));
    labels
}

fn written(says: &str, from: Vec2, em: f32) -> Label {
    let text = Text::new(says, Kind::Margin);
    let letters = text.level(from, em);
    Label::new(Kind::Margin, None, says, em, letters)
}

/// Draws a line with half an arrowhead.
fn needle(tip: Vec2, foot: Vec2, em: f32) -> Vec<Stroke> {
    let mut strokes = vec![Stroke { ends: [tip, foot], half: 1.4 * THIN * em }];
    for i in 0..=5 {
        let to = tip + Vec2::new(-0.3, 0.75) * em;
        let from = tip.lerp(tip + Vec2::new(0.0, 0.6) * em, i as f32 / 5.0);
        strokes.push(Stroke { ends: [from, to], half: THIN * em });
    }
    strokes.extend(along(&[foot + Vec2::new(-0.3, -0.55) * em, foot + Vec2::new(0.3, -0.55) * em], THIN * em));
    strokes
}

/// Sets an N over a tip.
pub fn north(tip: Vec2, em: f32) -> Label {
    let half = 0.5 * Text::new("N", Kind::Margin).length;
    written("N", tip - Vec2::new(half, 0.12) * em, em)
}
