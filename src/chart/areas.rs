//! The name of the sea, or of the lake where there is no sea: large and wide, level or nearly so, on open water.

use glam::Vec2;

use super::input::Input;
use super::letters::{Kind, Label, Placed, Text, between};
use crate::geometry::distance;
use crate::land::CoastDistance;

/// Lengths of the em that are tried, in units, the first that fits.
const SIZES: [f32; 4] = [34.0, 27.0, 21.0, 16.0];
/// How far middles lie apart that are tried, and how far letters keep from coast and frame, in ems.
const STEP: f32 = 0.8;
const FROM_COAST: f32 = 0.75;
const FROM_FRAME: f32 = 0.6;
/// More than this many ems of open water around letters are no better.
const WIDE: f32 = 4.0;

/// Directions with how many degrees they are tilted by.
const TILTS: [(Vec2, f32); 5] = [
    (Vec2::new(1.0, 0.0), 0.0),
    (Vec2::new(0.992_546_2, -0.121_869_34), 7.0),
    (Vec2::new(0.992_546_2, 0.121_869_34), 7.0),
    (Vec2::new(0.970_295_7, -0.241_921_9), 14.0),
    (Vec2::new(0.970_295_7, 0.241_921_9), 14.0),
];
/// How high arcs rise over their chords, as shares of these.
const ARCS: [f32; 3] = [0.0, 0.09, -0.09];

/// The label of the water; `None` if there is none, or no room.
pub fn water(input: &Input<'_>) -> Option<Label> {
    let (coast, name) = (input.coast?, input.water.as_ref()?);
    let sizes = SIZES.map(|size| size.max(1.3 * input.least_em) * input.label_size);
    let label = |em: f32| {
        name.iter().filter(|text| !text.is_empty()).find_map(|text| Search::new(input, coast, em, text).label(text))
    };
    sizes.into_iter().find_map(label)
}

struct Search<'a> {
    input: &'a Input<'a>,
    coast: &'a CoastDistance,
    em: f32,
    text: Text,
}

/// Where a label might stand: the middle of its chord, its direction and how high it rises.
#[derive(Clone, Copy)]
struct Arc {
    middle: Vec2,
    along: Vec2,
    rise: f32,
}

impl<'a> Search<'a> {
    fn new(input: &'a Input<'a>, coast: &'a CoastDistance, em: f32, text: &str) -> Self {
        Self { input, coast, em, text: Text::new(text, Kind::Water) }
    }

    /// The label with the most water around it, level and curved if that makes no great difference.
    fn label(&self, text: &str) -> Option<Label> {
        if self.text.letters.is_empty() {
            return None;
        }
        let (step, [least, most]) = (STEP * self.em, self.input.frame);
        let [columns, rows] = [most.x - least.x, most.y - least.y].map(|length| (length / step) as u32);
        let middles =
            (1..rows).flat_map(|row| (1..columns).map(move |column| Vec2::new(column as f32, row as f32) * step));
        let (mut best, mut letters) = (None, Vec::new());
        let centre = (least + most) * 0.5;
        for middle in middles.map(|middle| least + middle).filter(|middle| self.clearance(*middle) >= FROM_COAST) {
            let off = distance(middle, centre);
            for (along, tilt) in TILTS {
                for rise in ARCS {
                    let arc = Arc { middle, along, rise };
                    let Some(clearance) = self.lay(arc, &mut letters) else { continue };
                    let cost = 0.04 * tilt + 0.002 * off - 1.2 * clearance - if rise == 0.0 { 0.0 } else { 0.35 };
                    if best.is_none_or(|(least, _)| cost < least) {
                        best = Some((cost, arc));
                    }
                }
            }
        }
        self.lay(best?.1, &mut letters)?;
        Some(Label { kind: Kind::Water, river: None, text: text.into(), em: self.em, letters })
    }

    /// Puts letters along an arc. Returns how far the nearest is from the coast, in ems; `None` if that is too near.
    fn lay(&self, arc: Arc, letters: &mut Vec<Placed>) -> Option<f32> {
        letters.clear();
        let mut least = WIDE;
        for letter in &self.text.letters {
            let ends = [letter.at, letter.at + letter.glyph.advance].map(|at| self.at(arc, at));
            let placed = between(letter, ends[0], ends[1], self.em)?;
            for corner in placed.around(self.em).corners() {
                least = least.min(self.clearance(corner));
                if least < FROM_COAST || !self.is_in_frame(corner) {
                    return None;
                }
            }
            letters.push(placed);
        }
        Some(least)
    }

    /// The point of an arc at a distance from its beginning, in ems.
    fn at(&self, arc: Arc, at: f32) -> Vec2 {
        let length = self.text.length;
        let (off, rest) = (at - 0.5 * length, at / length);
        let up = arc.rise * length * (4.0 * rest * (1.0 - rest) - 0.5);
        arc.middle + (arc.along * off - arc.along.perp() * up) * self.em
    }

    fn clearance(&self, at: Vec2) -> f32 {
        -self.coast.height(at) / self.em
    }

    fn is_in_frame(&self, at: Vec2) -> bool {
        let ([least, most], margin) = (self.input.frame, FROM_FRAME * self.em);
        at.cmpge(least + margin).all() && at.cmple(most - margin).all()
    }
}
