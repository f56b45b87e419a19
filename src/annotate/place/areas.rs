//! The names of seas and lakes: large and wide, level or nearly so, on open water.

use std::ops::Range;

use glam::Vec2;

use super::chosen::{Chosen, Shrinks};
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Text, between};
use crate::annotate::names::{PlaceKind, PlaceName, forms};
use crate::base::geometry::distance;
use crate::land::{CoastDistance, Region};

/// Lengths of the em that are tried, in units, the first that fits; the last for lakes alone.
const SIZES: [f32; 5] = [34.0, 27.0, 21.0, 16.0, 13.0];
const SIZES_OF_SEAS: usize = 4;
/// The least size of letters, over that of the smallest that can be read.
const OVER_LEAST: f32 = 1.3;
/// The distances between the middles that are tried, and the least ones of letters from the coast, the frame and other labels, in ems.
const STEP: f32 = 0.8;
const FROM_COAST: f32 = 0.75;
const FROM_FRAME: f32 = 0.6;
const FROM_LABELS: f32 = 0.5;
/// The distance from the coast beyond which more open water around letters is no better, in ems.
const WIDE: f32 = 4.0;

/// The directions of chords, each with the degrees of its tilt and the greatest height of an arc over its chord, as a share of the chord.
/// No letter then climbs by more than 20 degrees.
const TILTS: [(Vec2, f32, f32); 5] = [
    (Vec2::new(1.0, 0.0), 0.0, 0.09),
    (Vec2::new(0.992_546_2, -0.121_869_34), 7.0, 0.057),
    (Vec2::new(0.992_546_2, 0.121_869_34), 7.0, 0.057),
    (Vec2::new(0.970_295_7, -0.241_921_9), 14.0, 0.026),
    (Vec2::new(0.970_295_7, 0.241_921_9), 14.0, 0.026),
];
/// The forms of arcs: straight, rising and falling.
const ARCS: [f32; 3] = [0.0, 1.0, -1.0];

/// Finds a place for the name of a sea or a lake, off the boxes that are taken; `None` if there is no room.
pub fn water(input: &Input<'_>, place: &PlaceName, region: &Region, taken: &[(u32, Box)]) -> Option<Chosen> {
    let coast = input.map.coast()?;
    let sizes = if place.kind == PlaceKind::Lake { &SIZES[..] } else { &SIZES[..SIZES_OF_SEAS] };
    let (em, sizes) = (|usual: f32| input.em(usual, OVER_LEAST), input.sizes(sizes, OVER_LEAST));
    let chosen = |usual: f32| {
        let search = |name: &str| {
            let text = Text::new(name, Kind::Water);
            let search = Search { input, coast, place, region, taken, em: em(usual), text };
            let label = search.label(name)?;
            Some(Chosen { label, text: search.text, usual, over_least: OVER_LEAST, shrinks: Shrinks::ToMiddle })
        };
        forms(&place.name).into_iter().filter(|text| !text.is_empty()).find_map(search)
    };
    sizes.into_iter().find_map(chosen)
}

struct Search<'a> {
    input: &'a Input<'a>,
    coast: &'a CoastDistance,
    place: &'a PlaceName,
    region: &'a Region,
    taken: &'a [(u32, Box)],
    em: f32,
    text: Text,
}

/// A candidate for a label: the middle of its chord, its direction and its height.
#[derive(Clone, Copy)]
struct Arc {
    middle: Vec2,
    along: Vec2,
    rise: f32,
}

impl Search<'_> {
    /// Returns the label with the most water around it, level and curved if that makes no great difference.
    fn label(&self, text: &str) -> Option<Label> {
        if self.text.letters.is_empty() {
            return None;
        }
        let (step, [least, most]) = (STEP * self.em, self.input.frame);
        let [columns, rows] = self.lattice(step)?;
        let middles =
            rows.flat_map(|row| columns.clone().map(move |column| Vec2::new(column as f32, row as f32) * step));
        let (mut best, mut letters) = (None, Vec::new());
        // A lake is named in its midst, a sea in that of the map.
        let (centre, per_off) =
            if self.place.kind == PlaceKind::Lake { (self.place.at, 0.004) } else { ((least + most) * 0.5, 0.002) };
        for middle in middles.map(|middle| least + middle).filter(|&middle| self.is_open(middle)) {
            let off = distance(middle, centre);
            for (along, tilt, highest) in TILTS {
                for rise in ARCS.map(|share| share * highest) {
                    let cost = |clearance: f32| {
                        0.04 * tilt + per_off * off - 1.2 * clearance - if rise == 0.0 { 0.0 } else { 0.35 }
                    };
                    let is_best = |cost: f32| best.is_none_or(|(least, _)| cost < least);
                    // Even in the midst of open water it would not be.
                    if !is_best(cost(WIDE)) {
                        continue;
                    }
                    let arc = Arc { middle, along, rise };
                    let Some(clearance) = self.lay(arc, &mut letters) else { continue };
                    if is_best(cost(clearance)) && self.is_free(&letters) {
                        best = Some((cost(clearance), arc));
                    }
                }
            }
        }
        self.lay(best?.1, &mut letters)?;
        Some(Label::new(Kind::Water, None, text, self.em, letters))
    }

    /// Returns the columns and rows of a lattice over the frame, so many units apart, between which all corners in the region lie; `None` if
    /// it has no cells.
    fn lattice(&self, step: f32) -> Option<[Range<u32>; 2]> {
        let ([least, most], region) = (self.input.frame, self.region.corners()?);
        let range = |least: f32, most: f32, [first, last]: [f32; 2]| {
            // A conversion makes 0 of what is below. One more at each end makes up for rounding.
            let [first, last] = [first, last].map(|end| ((end - least) / step) as u32);
            first.saturating_sub(1).max(1)..(((most - least) / step) as u32).min(last + 2)
        };
        let [from, to] = region;
        Some([range(least.x, most.x, [from.x, to.x]), range(least.y, most.y, [from.y, to.y])])
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
        // Letters this far from any coast are in the water that their neighbours are in, but for straits narrower than a space.
        let ends = [letters.first()?, letters.last()?].map(|letter| letter.around(self.em).middle);
        ends.into_iter().all(|end| self.region.holds(end)).then_some(least)
    }

    /// Returns `true` if there is water of this sea or lake around a point.
    fn is_open(&self, middle: Vec2) -> bool {
        self.clearance(middle) >= FROM_COAST && self.region.holds(middle)
    }

    /// Returns `true` if no letter comes too near to another label.
    fn is_free(&self, letters: &[Placed]) -> bool {
        are_off(self.taken, letters, self.em, &|_| FROM_LABELS * self.em)
    }

    /// Returns the point of an arc at a distance from its beginning, in ems.
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
        self.input.is_in_frame(at, FROM_FRAME * self.em)
    }
}
