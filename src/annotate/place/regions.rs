//! The names of regions, in capitals that stand far apart: of the main land across it, of ranges of mountains along their crests.

use glam::Vec2;

use super::background::{Background, LAKE, RIDGE};
use super::baseline::{Line, is_upright, smoothed, walk_from};
use super::chosen::{Chosen, Shrinks};
use super::costs::COS_TURN;
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Text};
use crate::annotate::names::{PlaceKind, PlaceName, forms};

/// The lengths of the em that are tried, in units: for the main land, and for ranges.
const SIZES: [[f32; 3]; 2] = [[30.0, 24.0, 19.0], [15.0, 13.0, 11.0]];
/// The least size of letters, over that of the smallest that can be read.
const OVER_LEAST: f32 = 1.1;
/// The space between letters, in ems, the widest first that fits.
const TRACKING: [f32; 6] = [2.2, 1.6, 1.1, 0.75, 0.5, 0.3];
/// The greatest share of its line that a name takes up, of the main land and of a range.
const SHARE: [f32; 2] = [0.72, 1.0];
/// The smoothness of lines, as a share of their length: those of ranges are smooth, and run where no river does.
const SMOOTHED: [f32; 2] = [0.15, 0.0];
/// The distances from the line and along it at which names are tried, in ems. Those of ranges keep to their lines.
const ASIDE: [f32; 7] = [0.0, -1.2, 1.2, -2.4, 2.4, -3.6, 3.6];
const STEP: f32 = 0.8;
/// The least distances of letters from the coast, the frame and other labels, in ems.
const FROM_COAST: f32 = 0.3;
const FROM_FRAME: f32 = 0.4;
const FROM_LABELS: f32 = 0.4;
/// The widest river that may run under letters, in units.
const WIDEST_UNDER: f32 = 2.4;
/// The height of capitals, in ems.
const CAPITAL: f32 = 0.65;

/// Finds a place for the name of the main land or of a range, off the boxes that are taken; `None` if there is no room.
pub fn region<G: Background>(
    input: &Input<'_>,
    background: &G,
    place: &PlaceName,
    taken: &[(u32, Box)],
) -> Option<Chosen> {
    let is_range = place.kind == PlaceKind::Range;
    let (line, [_, name]) = (upright(&place.line, SMOOTHED[usize::from(is_range)])?, forms(&place.name));
    let em = |usual: f32| input.em(usual, OVER_LEAST);
    let sizes = input.sizes(&SIZES[usize::from(is_range)], OVER_LEAST);
    let tries = sizes.into_iter().flat_map(|usual| TRACKING.map(|tracking| (usual, tracking)));
    tries.filter(|_| !name.is_empty()).find_map(|(usual, tracking)| {
        let text = Text::spaced(name, Kind::Region, tracking);
        let search = Search { input, background, taken, line: &line, em: em(usual), text, is_range };
        let (letters, on) = search.best()?;
        let label = Label::new(Kind::Region, None, name, search.em, letters);
        Some(Chosen { label, text: search.text, usual, over_least: OVER_LEAST, shrinks: Shrinks::along(on, 0.0) })
    })
}

/// Smooths a line so that its bends are gone, and turns it to the direction in which it is read; `None` if it has no length.
fn upright(line: &[Vec2], smoothness: f32) -> Option<Line> {
    let (first, last) = (*line.first()?, *line.last()?);
    let mut line = line.to_vec();
    if !is_upright(last - first) {
        line.reverse();
    }
    /// The number of points that stand for a line.
    const POINTS: usize = 64;
    let whole = Line::through(line);
    let length = whole.length();
    let mut walk = walk_from(&whole, 0.0);
    let even: Vec<Vec2> = (0..=POINTS).map(|i| walk.at(length * i as f32 / POINTS as f32)).collect();
    let line = Line::through(smoothed(&even, (smoothness * POINTS as f32) as usize));
    (length > 0.0).then_some(line)
}

struct Search<'a, G> {
    input: &'a Input<'a>,
    background: &'a G,
    taken: &'a [(u32, Box)],
    line: &'a Line,
    em: f32,
    text: Text,
    is_range: bool,
}

impl<G: Background> Search<'_, G> {
    /// Returns the letters in the best place, and the line that they stand on; `None` if there is none.
    fn best(&self) -> Option<(Vec<Placed>, Line)> {
        let (length, step) = (self.text.length * self.em, STEP * self.em);
        let room = self.line.length() - length;
        if self.text.letters.is_empty() || length > SHARE[usize::from(self.is_range)] * self.line.length() {
            return None;
        }
        let aside = if self.is_range { &ASIDE[..1] } else { &ASIDE[..] };
        let mut best: Option<(f32, Vec<Placed>, Line)> = None;
        for &aside in aside {
            let line = self.shifted(aside);
            let starts = (0..=(room / step) as u32).map(|i| i as f32 * step);
            for start in starts.filter(|start| start + length <= line.length()) {
                let off = 2.0 * ((start + 0.5 * length) / self.line.length() - 0.5).abs();
                let base = 1.5 * off + 0.15 * aside.abs();
                if best.as_ref().is_some_and(|(least, ..)| base >= *least) {
                    continue;
                }
                let Some((cost, letters)) = self.lay(&line, start) else { continue };
                if best.as_ref().is_none_or(|(least, ..)| base + cost < *least) {
                    best = Some((base + cost, letters, line.part(start, length)));
                }
            }
        }
        best.map(|(_, letters, line)| (letters, line))
    }

    /// Moves the line to its right, by some ems, for letters whose middle stands on it.
    fn shifted(&self, aside: f32) -> Line {
        let at = &self.line.at;
        let last = at.len() - 1;
        let down = |i: usize| {
            let way = at[(i + 1).min(last)] - at[i.saturating_sub(1)];
            at[i] + way.normalize_or_zero().perp() * ((aside + 0.5 * CAPITAL) * self.em)
        };
        Line::through((0..=last).map(down).collect())
    }

    /// Places the letters from a place of a line on. Returns them with the cost of the ink under them; `None` if they cannot stand there.
    fn lay(&self, line: &Line, start: f32) -> Option<(f32, Vec<Placed>)> {
        let letters = self.text.along(line, start, self.em)?;
        let turns = |pair: &[Placed]| pair[0].along.dot(pair[1].along) < COS_TURN;
        if letters.windows(2).any(turns) || !letters.iter().all(|letter| is_upright(letter.along)) {
            return None;
        }
        let mut hits = 0.0;
        for letter in &letters {
            hits += self.ink(&letter.around(self.em))?;
        }
        let is_free = are_off(self.taken, &letters, self.em, &|_| FROM_LABELS * self.em);
        is_free.then(|| (3.0 * hits / letters.len() as f32, letters))
    }

    /// Returns the share of a letter that has ink under it; `None` if it cannot stand there.
    fn ink(&self, around: &Box) -> Option<f32> {
        let is_in_frame = |at: Vec2| self.input.is_in_frame(at, FROM_FRAME * self.em);
        let is_ashore = |at: Vec2| self.input.map.coast().is_none_or(|coast| coast.height(at) >= FROM_COAST * self.em);
        if !around.corners().into_iter().all(|at| is_in_frame(at) && is_ashore(at)) {
            return None;
        }
        let mut hits = 0.0;
        for sample in around.samples() {
            let under = self.background.ink(sample);
            if under.river == RIDGE || under.river == LAKE || under.width > WIDEST_UNDER {
                return None;
            }
            hits += if under.width > 0.0 { 1.0 } else { 0.0 };
        }
        Some(hits / around.samples().count() as f32)
    }
}
