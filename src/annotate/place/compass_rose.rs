//! The compass rose of old maps: a star of eight points, each with a light and a dark side, in a ring.

use glam::Vec2;

use super::anchor::{self, Anchor};
use super::frames::along;
use super::input::Input;
use super::letters::{Box, Label, Stroke};
use super::scale_bar::north;

/// The radius of the rose, and the height of the letter over it, in units.
const RADIUS: f32 = 34.0;
const EM: f32 = 13.0;
/// The radii of its ring and of the notches between its points, as shares of its own, and its distance from coast and blocks.
const RING: f32 = 0.62;
const NOTCH: f32 = 0.2;
const FROM_COAST: f32 = 8.0;
/// Half the width of its lines, in units, and the number of lines that fill the dark side of a point.
const HALF: f32 = 0.3;
const DARK: u32 = 9;
/// Parts of a turn.
const EIGHTH: Vec2 = Vec2::new(0.707_106_77, 0.707_106_77);
const THIRTY_SECOND: Vec2 = Vec2::new(0.980_785_3, 0.195_090_32);
const SIXTEENTH: Vec2 = Vec2::new(0.923_879_5, 0.382_683_4);

/// Puts it into a place at sea that title and scale bar leave free, with the box around it; `None` if there is no room. Which place that is
/// does not depend on the size of the picture.
pub fn set(input: &Input<'_>, others: &[Anchor], taken: &[Box]) -> Option<(Label, Box)> {
    let size = |radius: f32, em: f32| Vec2::new(2.0 * radius, 2.0 * radius + em);
    let whole = size(RADIUS * input.whole_size, EM * input.whole_size);
    let is_fit = |at: Vec2, size: Vec2| {
        let around = Box::level(at, at + size);
        anchor::is_open(input, at, size, FROM_COAST) && !taken.iter().any(|other| around.meets(other, FROM_COAST))
    };
    let frame = input.frame;
    let is_free = |place: &&Anchor| !others.iter().any(|other| other == *place || other.is_beside(**place));
    let place = Anchor::ALL.iter().filter(is_free).find(|place| is_fit(place.place(frame, whole), whole))?;
    let (radius, em) = (RADIUS * input.label_size, (EM * input.label_size).max(input.least()));
    let size = size(radius, em);
    let at = place.place(input.inner_frame(), size);
    let middle = at + Vec2::new(radius, radius + em);
    let strokes = star(middle, radius, HALF * input.label_size);
    let label = Label { strokes, ..north(middle - Vec2::new(0.0, radius), em) };
    is_fit(at, size).then(|| (label, Box::level(at, at + size)))
}

fn star(middle: Vec2, radius: f32, half: f32) -> Vec<Stroke> {
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut ahead = Vec2::NEG_Y;
    for point in 0..8 {
        let (length, notch) = if point % 2 == 0 { (1.0, NOTCH) } else { (RING - 0.04, NOTCH) };
        let tip = middle + ahead * (length * radius);
        let [left, right] =
            [Vec2::new(EIGHTH.x, -EIGHTH.y), EIGHTH].map(|turn| middle + ahead.rotate(turn) * (notch * radius));
        // The four winds lie over the others.
        if point % 2 == 0 {
            strokes.extend(along(&[left, tip, right], half));
            strokes
                .extend((0..=DARK).map(|i| Stroke { ends: [tip, middle.lerp(right, i as f32 / DARK as f32)], half }));
        } else {
            let base = [Vec2::new(SIXTEENTH.x, -SIXTEENTH.y), SIXTEENTH];
            let [left, right] = base.map(|turn| middle + ahead.rotate(turn) * (0.34 * radius));
            strokes.extend(along(&[left, tip, right], half));
            let foot = middle + ahead * (0.3 * radius);
            strokes.extend(
                (0..=DARK / 2).map(|i| Stroke { ends: [tip, foot.lerp(right, 2.0 * i as f32 / DARK as f32)], half }),
            );
        }
        ahead = ahead.rotate(EIGHTH);
    }
    for share in [RING, RING + 0.06] {
        let mut out = Vec2::X * (share * radius);
        let mut ring = vec![middle + out];
        for _ in 0..32 {
            out = out.rotate(THIRTY_SECOND);
            ring.push(middle + out);
        }
        strokes.extend(along(&ring, half));
    }
    strokes
}
