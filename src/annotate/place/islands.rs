//! The names of islands: on them where they are large enough, else beside them on the water.

use glam::Vec2;

use super::background::{Background, LAKE, RIDGE};
use super::chosen::{Chosen, Shrinks, middle};
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Text};
use crate::annotate::names::{PlaceName, forms};
use crate::base::geometry::length;
use crate::land::{CoastDistance, Region, Run};

/// The lengths of the em, in units, by the least area of an island that has it, in square units.
const SIZES: [(f32, f32); 4] = [(20_000.0, 18.5), (5000.0, 16.0), (1000.0, 13.5), (0.0, 11.5)];
/// The size of smaller letters, which are tried if there is no room for those, over their size.
const SMALLER: f32 = 0.85;
/// The side of a square with the least area of an island that has a name, in ems.
const LEAST_SIDE: f32 = 0.8;

/// The least distance of an island's midst from its coast for a name on the island, and of letters from the coast there, in ems.
const ROOM: f32 = 3.0;
const FROM_COAST_INSIDE: f32 = 0.4;
/// The number of places that are tried to each side of the midst, and the distance between them, in ems.
const AROUND: i32 = 6;
const STEP: f32 = 0.7;
/// The widest river that may run under letters, in units.
const WIDEST_UNDER: f32 = 2.4;

/// The distances of letters from the island that are tried, and the least ones from the coast, the frame and other labels, in ems.
const GAPS: [f32; 3] = [0.4, 0.7, 1.1];
const FROM_COAST: f32 = 0.2;
const FROM_FRAME: f32 = 0.4;
const FROM_LABELS: f32 = 0.28;
/// The height of capitals over their line, the depth of letters under it, and the height of the middle of small ones, in ems.
const CAPITAL: f32 = 0.66;
const UNDER: f32 = 0.27;
const MIDDLE: f32 = 0.24;
/// The factor and the number of ems by which letters may be farther from their island than from the nearest coast, on average.
const NEARER: f32 = 1.3;
const NEARER_EM: f32 = 0.3;

/// Finds a place for the name of an island, off the boxes that are taken; `None` if there is no room.
pub fn island<G: Background>(
    input: &Input<'_>,
    background: &G,
    (place, region): (&PlaceName, &Region),
    taken: &[(u32, Box)],
) -> Option<Chosen> {
    let coast = input.map.coast()?;
    let (size, corners) = (region.area(), region.corners().unwrap_or([place.at; 2]));
    let usual = SIZES.iter().find(|(least, _)| size >= *least).map_or(0.0, |(_, em)| *em);
    let em = |usual: f32| input.em(usual, 1.0);
    let sizes = input.sizes(&[usual, SMALLER * usual], 1.0);
    let chosen = |usual: f32| {
        forms(&place.name).into_iter().find_map(|name| {
            let (text, em) = (Text::new(name, Kind::Island), em(usual));
            let search = Search { input, background, coast, midst: place.at, region, corners, taken, em, usual, text };
            let (kind, letters) = search.letters()?;
            let label = Label::new(kind, None, name, em, letters);
            let towards = |label: &Label| Shrinks::Towards(search.nearest(middle(label)));
            let shrinks = if kind == Kind::Offshore { towards(&label) } else { Shrinks::ToMiddle };
            Some(Chosen { label, text: search.text, usual, over_least: 1.0, shrinks })
        })
    };
    sizes.into_iter().filter(|&usual| size.sqrt() >= LEAST_SIDE * em(usual)).find_map(chosen)
}

struct Search<'a, G> {
    input: &'a Input<'a>,
    background: &'a G,
    coast: &'a CoastDistance,
    midst: Vec2,
    region: &'a Region,
    /// The corners of the box around the island.
    corners: [Vec2; 2],
    taken: &'a [(u32, Box)],
    em: f32,
    /// The usual em, in units.
    usual: f32,
    text: Text,
}

/// The cheapest place so far, and its cost.
type Best = Option<(f32, Vec<Placed>)>;

impl<G: Background> Search<'_, G> {
    /// Returns the letters on the island, or beside it.
    fn letters(&self) -> Option<(Kind, Vec<Placed>)> {
        if self.text.letters.is_empty() {
            return None;
        }
        let inside = self.inside().map(|letters| (Kind::Island, letters));
        // One that has room for its name on larger pictures has none beside it on smaller ones.
        let is_wide = self.coast.height(self.midst) >= ROOM * self.usual * self.input.whole_size;
        inside.or_else(|| {
            if is_wide && self.em > self.usual * self.input.label_size {
                None
            } else {
                Some((Kind::Offshore, self.beside()?))
            }
        })
    }

    /// Returns the letters near the island's midst, where the least ink is under them.
    fn inside(&self) -> Option<Vec<Placed>> {
        if self.coast.height(self.midst) < ROOM * self.em {
            return None;
        }
        let half = Vec2::new(-0.5 * self.text.length, MIDDLE) * self.em;
        let mut best: Best = None;
        for (row, column) in (-AROUND..=AROUND).flat_map(|row| (-AROUND..=AROUND).map(move |column| (row, column))) {
            let off = Vec2::new(column as f32, row as f32) * (STEP * self.em);
            let letters = self.level(self.midst + half + off);
            let cost = self.ink(&letters).map(|ink| 0.25 * length(off) / self.em + ink);
            self.take_better(&mut best, letters, cost);
        }
        best.map(|(_, letters)| letters)
    }

    /// Returns the cost of the ink under letters on land; `None` if there is too much of it, or if they are not all on land.
    fn ink(&self, letters: &[Placed]) -> Option<f32> {
        let (mut hits, mut samples) = (0.0, 0.0);
        for letter in letters {
            let around = letter.around(self.em);
            let is_ashore = |at: Vec2| self.coast.height(at) >= FROM_COAST_INSIDE * self.em;
            if !around.corners().into_iter().all(is_ashore) || !self.region.holds(around.middle) {
                return None;
            }
            for sample in around.samples() {
                let under = self.background.ink(sample);
                if under.river == RIDGE || under.river == LAKE || under.width > WIDEST_UNDER {
                    return None;
                }
                samples += 1.0;
                hits += if under.width > 0.0 { 0.5 + under.width } else { 0.0 };
            }
        }
        Some(4.0 * hits / samples)
    }

    /// Returns the letters on the water: right of the island if they can be, else left, above or below.
    fn beside(&self) -> Option<Vec<Placed>> {
        let (em, long) = (self.em, self.text.length * self.em);
        let middle = (self.corners[0] + self.corners[1]) * 0.5;
        let mut best: Best = None;
        for gap in GAPS {
            for aside in [0.0, -0.5, 0.5, -1.0, 1.0, -1.6, 1.6] {
                let line = middle.y + (aside + MIDDLE) * em;
                let Some([left, right]) = self.across([line - CAPITAL * em, line + UNDER * em]) else { continue };
                for (x, side) in [(right + gap * em, 0.0), (left - gap * em - long, 0.3)] {
                    let letters = self.level(Vec2::new(x, line));
                    let cost = side + 0.3 * f32::abs(aside) + 0.8 * (gap - GAPS[0]);
                    let cost = self.apart(&letters).map(|apart| apart + cost);
                    self.take_better(&mut best, letters, cost);
                }
            }
            for aside in [0.0, -0.8, 0.8, -1.6, 1.6, -2.4, 2.4, -3.2, 3.2] {
                let left = middle.x + aside * em - 0.5 * long;
                let Some([top, bottom]) = self.down([left, left + long]) else { continue };
                for (y, side) in [(top - (gap + UNDER) * em, 0.45), (bottom + (gap + CAPITAL) * em, 0.6)] {
                    let letters = self.level(Vec2::new(left, y));
                    let cost = side + 0.15 * f32::abs(aside) + 0.8 * (gap - GAPS[0]);
                    let cost = self.apart(&letters).map(|apart| apart + cost);
                    self.take_better(&mut best, letters, cost);
                }
            }
        }
        best.map(|(_, letters)| letters)
    }

    /// Returns the western and the eastern end of the island in some rows; `None` if it has nothing there.
    fn across(&self, [top, bottom]: [f32; 2]) -> Option<[f32; 2]> {
        self.extent(|[least, most]| least.y < bottom && most.y > top).map(|corners| corners.map(|corner| corner.x))
    }

    /// Returns the northern and the southern end of the island between two sides; `None` if it has nothing there.
    fn down(&self, [left, right]: [f32; 2]) -> Option<[f32; 2]> {
        self.extent(|[least, most]| least.x < right && most.x > left).map(|corners| corners.map(|corner| corner.y))
    }

    /// Returns the corners of the box around some of the island's runs of cells; `None` if there are none.
    fn extent(&self, is_one: impl Fn([Vec2; 2]) -> bool) -> Option<[Vec2; 2]> {
        let mut extent: Option<[Vec2; 2]> = None;
        for [least, most] in self.region.runs.iter().map(Run::corners) {
            if is_one([least, most]) {
                let [all_least, all_most] = extent.unwrap_or([least, most]);
                extent = Some([all_least.min(least), all_most.max(most)]);
            }
        }
        extent
    }

    /// Returns the cost of other land near letters on the water; `None` if they touch land, or would seem to name another island.
    fn apart(&self, letters: &[Placed]) -> Option<f32> {
        let (mut own, mut any) = (0.0, 0.0);
        for letter in letters {
            let around = letter.around(self.em);
            if around.corners().into_iter().any(|at| -self.coast.height(at) < FROM_COAST * self.em) {
                return None;
            }
            own += self.away(around.middle);
            any += -self.coast.height(around.middle);
        }
        let [own, any] = [own, any].map(|sum| sum / (letters.len() as f32 * self.em));
        (own <= NEARER * any + NEARER_EM).then_some(0.8 * (own - any).max(0.0))
    }

    /// Returns the distance of a place from the island, in units.
    fn away(&self, at: Vec2) -> f32 {
        let off = |run: &Run| within(run, at).distance_squared(at);
        self.region.runs.iter().map(off).fold(f32::MAX, f32::min).sqrt()
    }

    /// Returns the place of the island that is nearest to a point.
    fn nearest(&self, at: Vec2) -> Vec2 {
        let places = self.region.runs.iter().map(|run| within(run, at));
        let nearer = |a: Vec2, b: Vec2| if b.distance_squared(at) < a.distance_squared(at) { b } else { a };
        places.reduce(nearer).unwrap_or(at)
    }

    /// Returns the letters of a level line that begins at a place.
    fn level(&self, from: Vec2) -> Vec<Placed> {
        self.text.level(from, self.em)
    }

    /// Takes a place that costs less than the best so far, if it is in the frame and off other labels.
    fn take_better(&self, best: &mut Best, letters: Vec<Placed>, cost: Option<f32>) {
        let cheaper = cost.filter(|cost| best.as_ref().is_none_or(|(least, _)| cost < least));
        if let Some(cost) = cheaper.filter(|_| self.is_free(&letters)) {
            *best = Some((cost, letters));
        }
    }

    fn is_free(&self, letters: &[Placed]) -> bool {
        let is_in_frame = |at: Vec2| self.input.is_in_frame(at, FROM_FRAME * self.em);
        letters.iter().flat_map(|letter| letter.around(self.em).corners()).all(is_in_frame)
            && are_off(self.taken, letters, self.em, &|_| FROM_LABELS * self.em)
    }
}

/// Returns the point of a run of cells that is nearest to a point.
fn within(run: &Run, at: Vec2) -> Vec2 {
    let [least, most] = run.corners();
    at.max(least).min(most)
}
