//! The names of parts of a coast: of bays in their water, of straits along theirs, of capes on the water before them.

use glam::Vec2;

use super::baseline::{Line, is_upright, smoothed};
use super::chosen::{Chosen, Shrinks};
use super::costs::Turns;
use super::crowd::are_off;
use super::input::Input;
use super::letters::{Box, Kind, Label, Placed, Text};
use crate::annotate::names::{PlaceKind, PlaceName, forms};
use crate::land::CoastDistance;

/// Lengths of the em that are tried, in units.
const SIZES: &[f32] = &[21.0, 17.0, 14.0, 12.5, 11.0];
/// The number of the first sizes that only wide bays have, and the least width of such bays, in units.
const WIDE_SIZES: usize = 2;
const WIDE: f32 = 120.0;
/// The least distances of letters from the coast, the frame and other labels, in ems.
const FROM_COAST: f32 = 0.25;
const FROM_FRAME: f32 = 0.4;
const FROM_LABELS: f32 = 0.35;
/// The greatest em, in units, or as a share of the size of a place.
const MOST_EM: f32 = 20.0;
const MOST_SHARE: f32 = 0.2;
/// The reach around a bay's midst within which its name is tried, in ems and in widths of the bay, and the distance between tries, in ems.
const AROUND: f32 = 1.0;
const WIDTHS: f32 = 0.45;
const STEP: f32 = 0.7;
/// The distances of a cape's name from its tip that are tried, in ems.
const GAPS: [f32; 3] = [0.5, 0.8, 1.2];
/// The height of the middle of type over its line, in ems.
const MIDDLE: f32 = 0.24;
/// The smoothness of the line of a strait, as a share of its length.
const SMOOTHED: f32 = 0.1;

/// Finds a place for the name of a bay, a strait or a cape, off the boxes that are taken; `None` if there is no room.
pub fn inlet(input: &Input<'_>, place: &PlaceName, taken: &[(u32, Box)]) -> Option<Chosen> {
    let coast = input.map.coast()?;
    let kind = if place.kind == PlaceKind::Cape { Kind::Cape } else { Kind::Inlet };
    let em = |usual: f32| input.em(usual, 1.0);
    // On small pictures only wide bays have names.
    let most = MOST_EM.max(MOST_SHARE * place.size);
    let is_wide = matches!(place.kind, PlaceKind::Gulf | PlaceKind::Bay) && place.size >= WIDE;
    let sizes = input.sizes(if is_wide { SIZES } else { &SIZES[WIDE_SIZES..] }, 1.0);
    let names = || forms(&place.name).into_iter().filter(|name| !name.is_empty());
    sizes
        .into_iter()
        .filter(|usual| em(*usual) <= most)
        .flat_map(|usual| names().map(move |name| (usual, name)))
        .find_map(|(usual, name)| {
            let text = Text::new(name, kind);
            let search = Search { input, coast, taken, place, em: em(usual), text };
            let (letters, shrinks) = match place.kind {
                PlaceKind::Strait => search.along()?,
                PlaceKind::Cape => (search.before_the_cape()?, Shrinks::Towards(place.at)),
                _ => (search.in_the_bay()?, Shrinks::ToMiddle),
            };
            let label = Label::new(kind, None, name, search.em, letters);
            Some(Chosen { label, text: search.text, usual, over_least: 1.0, shrinks })
        })
}

struct Search<'a> {
    input: &'a Input<'a>,
    coast: &'a CoastDistance,
    taken: &'a [(u32, Box)],
    place: &'a PlaceName,
    em: f32,
    text: Text,
}

impl Search<'_> {
    /// Returns letters in the water of a bay, near its midst and off its coast.
    fn in_the_bay(&self) -> Option<Vec<Placed>> {
        let reach = AROUND * self.em + WIDTHS * self.place.size;
        let steps = (reach / (STEP * self.em)) as i32;
        let around = (-steps..=steps).flat_map(|row| (-steps..=steps).map(move |column| (row, column)));
        let places = around.map(|(row, column)| {
            let off = Vec2::new(column as f32, row as f32) * (STEP * self.em);
            (off.length() / reach, self.place.at + off)
        });
        self.cheapest(places.map(|(cost, middle)| (cost, self.level(middle, 0.5))))
    }

    /// Returns letters on the water beside the tip of a cape: to its right or left, above or below.
    fn before_the_cape(&self) -> Option<Vec<Placed>> {
        let places = GAPS.into_iter().flat_map(|gap| {
            let sides = [(1.0, 0.0), (1.0, -0.6), (1.0, 0.6), (-1.0, 0.0), (-1.0, -0.6), (-1.0, 0.6)];
            let beside = sides.map(|(side, down)| {
                let from = if side > 0.0 { 0.0 } else { 1.0 };
                (0.3 * f32::abs(down) + 0.2 * from, Vec2::new(side * gap, down * (0.5 + gap)), from)
            });
            let over = [-1.0, 1.0].map(|down: f32| (0.5 + 0.1 * down, Vec2::new(0.0, down * (0.5 + gap)), 0.5));
            beside.into_iter().chain(over).map(move |(cost, off, from)| (cost + gap, off, from))
        });
        let letters = |(cost, off, from): (f32, Vec2, f32)| (cost, self.level(self.place.at + off * self.em, from));
        self.cheapest(places.map(letters))
    }

    /// Returns letters along a strait, and the line that they stand on.
    fn along(&self) -> Option<(Vec<Placed>, Shrinks)> {
        let mut line = smoothed(&self.place.line, (SMOOTHED * self.place.line.len() as f32) as usize);
        if !is_upright(*line.last()? - *line.first()?) {
            line.reverse();
        }
        let last = line.len() - 1;
        let down = |i: usize| {
            let way = line[(i + 1).min(last)] - line[i.saturating_sub(1)];
            line[i] + way.normalize_or_zero().perp() * (MIDDLE * self.em)
        };
        let line = Line::through((0..=last).map(down).collect());
        let length = self.text.length * self.em;
        let steps = ((line.length() - length) / (STEP * self.em)).max(-1.0);
        let starts = (0..=steps as i32).filter(|_| steps >= 0.0).map(|i| i as f32 * STEP * self.em);
        let tries = starts.filter_map(|start| {
            let off = ((start + 0.5 * length) / line.length() - 0.5).abs();
            Some((off, start, self.lay(&line, start)?))
        });
        let best = tries.filter(|(.., letters)| self.is_free(letters)).reduce(|a, b| if b.0 < a.0 { b } else { a });
        best.map(|(_, start, letters)| (letters, Shrinks::along(line.part(start, length), 0.0)))
    }

    fn lay(&self, line: &Line, start: f32) -> Option<Vec<Placed>> {
        let mut turns = Turns::default();
        let is_readable = |letter: &Placed| is_upright(letter.along) && turns.take(letter.along).is_some();
        self.text.along(line, start, self.em).filter(|letters| letters.iter().all(is_readable))
    }

    /// Returns the cheapest of some places that is free; the first of equals.
    fn cheapest(&self, places: impl Iterator<Item = (f32, Vec<Placed>)>) -> Option<Vec<Placed>> {
        let mut best: Option<(f32, Vec<Placed>)> = None;
        for (cost, letters) in places {
            if best.as_ref().is_none_or(|(least, _)| cost < *least) && self.is_free(&letters) {
                best = Some((cost, letters));
            }
        }
        best.map(|(_, letters)| letters).filter(|letters| !letters.is_empty())
    }

    /// Returns the letters of a level line of which a share lies before a point.
    fn level(&self, at: Vec2, share: f32) -> Vec<Placed> {
        let from = at + Vec2::new(-share * self.text.length, MIDDLE) * self.em;
        self.text.level(from, self.em)
    }

    /// Returns `true` if letters are all on the water, in the frame, and off other labels.
    fn is_free(&self, letters: &[Placed]) -> bool {
        let is_in_frame = |at: Vec2| self.input.is_in_frame(at, FROM_FRAME * self.em);
        let is_afloat = |at: Vec2| -self.coast.height(at) >= FROM_COAST * self.em;
        let mut corners = letters.iter().flat_map(|letter| letter.around(self.em).corners());
        corners.all(|at| is_in_frame(at) && is_afloat(at))
            && are_off(self.taken, letters, self.em, &|_| FROM_LABELS * self.em)
    }
}
