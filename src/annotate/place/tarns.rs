//! The names of lakes that are too small for them: beside them on the land.

use glam::Vec2;

use super::background::{Background, LAKE, RIDGE};
use super::chosen::{Chosen, Shrinks};
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Text};
use crate::annotate::names::{PlaceName, forms};
use crate::land::{CELL_SIZE, CoastDistance, Region};

/// The lengths of the em, in units, by the least area of a lake that has it, in square units.
const SIZES: [(f32, f32); 3] = [(2000.0, 14.0), (700.0, 12.5), (0.0, 11.0)];

/// The distances of letters from the lake that are tried, and the least ones from all shores, the frame and other labels, in ems.
const GAPS: [f32; 3] = [0.35, 0.6, 1.0];
const FROM_SHORE: f32 = 0.18;
const FROM_FRAME: f32 = 0.4;
const FROM_LABELS: f32 = 0.3;

/// The height of the middle of small letters over their line, and how far a line above or below keeps off the lake, in ems.
const MIDDLE: f32 = 0.24;
const OVER: f32 = 0.55;

/// The widest river that may run under letters, in units, and the greatest share of them with any under it.
const WIDEST_UNDER: f32 = 1.6;
const MOST_UNDER: f32 = 0.2;

/// The side of a square as large as the least lake that has a name, in ems: what is smaller than its letters is hardly seen.
const LEAST_SIDE: f32 = 0.8;

/// Finds a place for the name of a lake on the land beside it, off the boxes that are taken; `None` if there is no room,
/// or if the lake is too small for a name.
pub fn beside<G: Background>(
    input: &Input<'_>,
    background: &G,
    (place, region): (&PlaceName, &Region),
    taken: &[(u32, Box)],
) -> Option<Chosen> {
    let coast = input.map.coast()?;
    let usual = SIZES.iter().find(|(least, _)| region.area() >= *least).map_or(0.0, |(_, em)| *em);
    let (em, corners) = (input.em(usual, 1.0), region.corners()?);
    if region.area().sqrt() < LEAST_SIDE * em {
        return None;
    }
    forms(&place.name).into_iter().filter(|name| !name.is_empty()).find_map(|name| {
        let text = Text::new(name, Kind::Tarn);
        let search = Search { input, background, coast, region, corners, taken, em, text };
        let (letters, to) = search.best()?;
        let label = Label::new(Kind::Tarn, None, name, em, letters);
        Some(Chosen { label, text: search.text, usual, over_least: 1.0, shrinks: Shrinks::Towards(to) })
    })
}

struct Search<'a, G> {
    input: &'a Input<'a>,
    background: &'a G,
    coast: &'a CoastDistance,
    region: &'a Region,
    /// The corners of the box around the lake.
    corners: [Vec2; 2],
    taken: &'a [(u32, Box)],
    em: f32,
    text: Text,
}

impl<G: Background> Search<'_, G> {
    /// Returns the letters in the best place, with the place on the shore that they stand beside.
    fn best(&self) -> Option<(Vec<Placed>, Vec2)> {
        let mut best: Option<(f32, Vec<Placed>, Vec2)> = None;
        for (base, from, to) in self.tries() {
            if best.as_ref().is_some_and(|(least, ..)| base >= *least) {
                continue;
            }
            let letters = self.text.level(from, self.em);
            let cost = self.under(&letters).map(|under| base + under);
            if let Some(cost) = cost.filter(|cost| best.as_ref().is_none_or(|(least, ..)| cost < least)) {
                best = Some((cost, letters, to));
            }
        }
        best.map(|(_, letters, to)| (letters, to))
    }

    /// Lists where a name may begin, each with its cost and the place on the shore that it stands beside: to the right of the lake or
    /// the left, then above or below.
    fn tries(&self) -> Vec<(f32, Vec2, Vec2)> {
        let ([least, most], em, long) = (self.corners, self.em, self.text.length * self.em);
        let (middle, size) = ((least + most) * 0.5, most - least);
        let mut tries = Vec::new();
        for gap in GAPS {
            for aside in [0.0, -0.2, 0.2, -0.4, 0.4_f32] {
                let at = middle + size * aside;
                let mut add = |to: Option<Vec2>, cost: f32, from: &dyn Fn(Vec2) -> Vec2| {
                    tries.extend(to.map(|to| (gap + aside.abs() + cost, from(to), to)));
                };
                let [left, right] = self.across(at.y);
                add(right, 0.0, &|to| to + Vec2::new(gap, MIDDLE) * em);
                add(left, 0.2, &|to| to + Vec2::new(-gap, MIDDLE) * em - Vec2::X * long);
                let [above, below] = self.down(at.x);
                add(above, 0.5, &|to| to + Vec2::Y * (MIDDLE - OVER - gap) * em - Vec2::X * 0.5 * long);
                add(below, 0.6, &|to| to + Vec2::Y * (MIDDLE + OVER + gap) * em - Vec2::X * 0.5 * long);
            }
        }
        tries
    }

    /// Returns the western and the eastern shore at a y.
    fn across(&self, y: f32) -> [Option<Vec2>; 2] {
        let row = (y / CELL_SIZE) as u32;
        let runs = || self.region.runs.iter().filter(move |run| run.row == row);
        let shore = |column: Option<u32>| column.map(|column| Vec2::new(column as f32 * CELL_SIZE, y));
        [shore(runs().map(|run| run.start).min()), shore(runs().map(|run| run.end).max())]
    }

    /// Returns the northern and the southern shore at an x.
    fn down(&self, x: f32) -> [Option<Vec2>; 2] {
        let column = (x / CELL_SIZE) as u32;
        let mut rows = self.region.runs.iter().filter(|run| (run.start..run.end).contains(&column)).map(|run| run.row);
        let north = rows.next();
        let south = rows.next_back().or(north).map(|row| row + 1);
        [north, south].map(|row| row.map(|row| Vec2::new(x, row as f32 * CELL_SIZE)))
    }

    /// Returns the cost of what lies under letters; `None` if they cannot stand there.
    fn under(&self, letters: &[Placed]) -> Option<f32> {
        let (mut hits, mut samples) = (0.0, 0.0);
        for letter in letters {
            let around = letter.around(self.em);
            let is_fit = |at: Vec2| {
                self.input.is_in_frame(at, FROM_FRAME * self.em) && self.coast.height(at) >= FROM_SHORE * self.em
            };
            if !around.corners().into_iter().all(is_fit) {
                return None;
            }
            for sample in around.samples() {
                let under = self.background.ink(sample);
                if under.river == RIDGE || under.river == LAKE || under.width > WIDEST_UNDER {
                    return None;
                }
                samples += 1.0;
                hits += if under.width > 0.0 { 1.0 } else { 0.0 };
            }
        }
        let is_free = hits <= MOST_UNDER * samples && are_off(self.taken, letters, self.em, &|_| FROM_LABELS * self.em);
        is_free.then(|| 4.0 * hits / f32::max(samples, 1.0))
    }
}
