//! The cartouche: the map's title, with a line in small letters under it, where the sea is free; a frame around both if it is framed; and with
//! it a scale bar and a compass rose. Or a plate, which the title is the heading of.

use glam::Vec2;

use super::anchor::{self, Anchor};
use super::background::Background;
use super::corner;
use super::input::{Cartouche, Input, NorthPoint};
use super::letters::{Box, Kind, Label, Placed, Text};
use super::{compass_rose, frames, neat_line, plate, scale_bar};
use crate::annotate::glyph::lacking;

/// The lengths of the title's em that are tried, in units; the first of those on land; and the first of those on land if the title is no
/// wider than a share of the map's width.
const SIZES: [f32; 15] = [58.0, 51.0, 45.0, 39.5, 35.0, 31.0, 27.5, 24.5, 21.5, 19.0, 17.0, 15.0, 13.5, 12.0, 11.0];
const ON_LAND: usize = 5;
const ON_LAND_IF_SHORT: usize = 2;
const SHORT_ON_LAND: f32 = 0.18;
/// A place at sea with less room than this, in units, is none where the title may stand on land in this size.
const LEAST_AT_SEA: f32 = 19.0;
/// The least size of the title, over that of the smallest letters that can be read, if there is room.
const OVER_LEAST: f32 = 1.3;
/// The share of their size on other pictures down to which letters count as equally large.
const AS_LARGE: f32 = 0.8;
/// The size of the line under the title, over that of the title, and its greatest where the title itself is small.
pub(super) const UNDER_TITLE: f32 = 0.4;
const MOST_UNDER_TITLE: f32 = 0.85;
/// The least size of the line under the title, in units. It can be read on screens, so it has one size on these and in print.
const LEAST_UNDER_TITLE: f32 = 9.8;
/// The greatest width of the line under the title, over that of the title, or of a title of so many ems.
const WIDER: f32 = 1.25;
const SHORT: f32 = 6.0;

/// The greatest shares of the map's width and height that the cartouche takes up.
const MOST: Vec2 = Vec2::new(0.6, 0.4);
/// The distance that other labels keep from the title's letters, in ems, and that of those from the coast.
const AROUND: f32 = 0.5;
const FROM_COAST: f32 = 0.3;
/// The distance that names of seas keep from both ends of its lines, in ems.
const BESIDE: f32 = 6.0;

/// The greatest em by which the ground on land is cleared, in units: its corners are round.
const CLEARED: f32 = 12.0;

/// The height of capitals, the depth of letters under their line, and the distance between lines, in ems.
pub(super) const CAPITAL: f32 = 0.66;
pub(super) const UNDER: f32 = 0.22;
pub(super) const LINE: f32 = 1.08;
pub(super) const TO_SEED: f32 = 1.25;

/// A cartouche in its place.
#[derive(Default)]
pub struct Set {
    pub labels: Vec<Label>,
    /// The boxes that other labels keep off.
    pub around: Vec<Box>,
    /// The box that names of seas keep off besides, so that none stands on one line with the title.
    pub beside: Option<Box>,
}

/// Sets the title and what stands with it. The title has the place along the frame where the sea has the most room for it, on land that with
/// the most sea and the least ink; the same on pictures of all sizes, of which small ones leave out the line under it, or break it in two.
/// `None` if there is no title, or no room for it.
pub fn set<G: Background>(input: &Input<'_>, background: &G, cartouche: &Cartouche) -> Option<Set> {
    // A frame that lies beside the map.
    if input.label_size <= 0.0 {
        return None;
    }
    let plate = cartouche.plate.as_ref().and_then(|plate| plate::set(input, background, cartouche, plate));
    let (mut set, title) = match plate {
        Some(plate) => (Set { labels: plate.labels, around: vec![plate.around], beside: None }, None),
        None => title(input, background, cartouche).map(|(set, place)| (set, Some(place)))?,
    };
    let mut others: Vec<Anchor> = title.into_iter().collect();
    if cartouche.has_scale
        && let Some((labels, around, place)) = scale_bar::set(input, background, cartouche, title, &set.around)
    {
        others.push(place);
        set.labels.extend(labels);
        set.around.push(around);
    }
    if cartouche.north == Some(NorthPoint::Rose)
        && let Some((label, around)) = compass_rose::set(input, &others, &set.around)
    {
        set.labels.push(label);
        set.around.push(around);
    }
    set.labels.extend(cartouche.sheet.map(neat_line::label));
    Some(set)
}

/// Sets the title in its place.
fn title<G: Background>(input: &Input<'_>, background: &G, cartouche: &Cartouche) -> Option<(Set, Anchor)> {
    let Place { anchor, size, is_at_sea } = Place::of(input, background, cartouche)?;
    // On land it has a ground of its own, and that has edges.
    let is_framed = cartouche.is_framed || !is_at_sea;
    let first =
        if is_at_sea { 0 } else { SIZES.iter().position(|from| from * input.whole_size <= size).unwrap_or(ON_LAND) };
    let sizes = sizes(&SIZES[first..], input);
    let least = input.least().max(LEAST_UNDER_TITLE * input.label_size);
    let wanted = (AS_LARGE * size * input.shrink).max(OVER_LEAST * input.least()).min(sizes[0]);
    let mut best: Option<(Vec2, Block)> = None;
    for form in &FORMS {
        let blocks = Block::all(input, (cartouche, is_framed), &sizes, least, form);
        let fit = blocks.into_iter().find_map(|block| {
            let at = anchor.place(input.inner_frame(), block.size);
            (!is_at_sea || block.is_open(input, at)).then_some((at, block))
        });
        // The first that is large enough, else the largest.
        let is_better = |block: &Block| best.as_ref().is_none_or(|(_, best)| block.em > best.em && best.em < wanted);
        best = fit.filter(|(_, block)| is_better(block)).or(best);
    }
    let (at, block) = best?;
    Some((block.set(cartouche, at, is_at_sea), anchor))
}

/// Returns the lengths of the em that are tried in a picture, the longest first: as in other pictures, and down to the smallest that can be
/// read.
fn sizes(sizes: &[f32], input: &Input<'_>) -> Vec<f32> {
    let least = input.least();
    let mut sizes: Vec<f32> = sizes.iter().map(|size| size * input.label_size).collect();
    if let Some(first) = sizes.first_mut() {
        *first = first.max(OVER_LEAST * least);
    }
    sizes.retain(|size| *size >= least);
    sizes.push(least);
    sizes
}

/// A form of a title: the number of its lines, with or without another line under it.
struct Form {
    lines: usize,
    has_seed: bool,
    /// The share of the size of its letters that counts in comparisons with the first form.
    worth: f32,
}

/// The forms of a title, the best first.
const FORMS: [Form; 4] = [
    Form { lines: 1, has_seed: true, worth: 1.0 },
    Form { lines: 2, has_seed: true, worth: 0.8 },
    Form { lines: 1, has_seed: false, worth: 0.7 },
    Form { lines: 2, has_seed: false, worth: 0.6 },
];

/// A place for the title of a map, with its size there in pictures that are large enough.
struct Place {
    anchor: Anchor,
    size: f32,
    is_at_sea: bool,
}

impl Place {
    /// Finds the place with the most room. It depends on the map alone.
    fn of<G: Background>(input: &Input<'_>, background: &G, cartouche: &Cartouche) -> Option<Self> {
        let (sizes, least) = (SIZES.map(|size| size * input.whole_size), LEAST_UNDER_TITLE * input.whole_size);
        let blocks =
            FORMS.each_ref().map(|form| Block::all(input, (cartouche, cartouche.is_framed), &sizes, least, form));
        let mut best: Option<(f32, corner::Corner, Self)> = None;
        for &anchor in &Anchor::ALL {
            let Some((worth, at, block)) = roomiest(input, anchor, &blocks) else { continue };
            let judged = corner::judged(input, background, at, block.size, block.em);
            let is_better = best
                .as_ref()
                .is_none_or(|(most, corner, _)| worth > *most || worth == *most && judged.is_better_than(corner));
            if is_better {
                best = Some((worth, judged, Self { anchor, size: block.em, is_at_sea: true }));
            }
        }
        let on_land = block_on_land(input, cartouche, &sizes, least);
        let least = on_land.as_ref().map_or(0.0, |block| block.em).min(LEAST_AT_SEA * input.whole_size);
        let at_sea = best.filter(|(_, _, place)| place.size >= least).map(|(_, _, place)| place);
        at_sea.or_else(|| Self::on_land(input, background, on_land.as_ref()?))
    }

    /// Finds the place with the most sea, and the least ink.
    fn on_land<G: Background>(input: &Input<'_>, background: &G, block: &Block) -> Option<Self> {
        let frame = input.frame;
        let mut best: Option<(corner::Corner, Anchor)> = None;
        for anchor in Anchor::ALL {
            let judged = corner::judged(input, background, anchor.place(frame, block.size), block.size, block.em);
            if best.as_ref().is_none_or(|(best, _)| judged.is_better_than(best)) {
                best = Some((judged, anchor));
            }
        }
        best.map(|(_, anchor)| Self { anchor, size: block.em, is_at_sea: false })
    }
}

/// Returns the block of a form that has the most room at sea at an anchor, with its worth and its place; the first of equals.
fn roomiest<'a>(input: &Input<'_>, anchor: Anchor, blocks: &'a [Vec<Block>; 4]) -> Option<(f32, Vec2, &'a Block)> {
    let mut best: Option<(f32, Vec2, &Block)> = None;
    for (blocks, form) in blocks.iter().zip(&FORMS) {
        let place = |block: &Block| anchor.place(input.frame, block.size);
        let Some(block) = blocks.iter().find(|block| block.is_open(input, place(block))) else { continue };
        let worth = block.em * form.worth;
        if best.is_none_or(|(most, ..)| worth > most) {
            best = Some((worth, place(block), block));
        }
    }
    best
}

/// Returns the largest framed block that may stand on land, of the first form that has one.
fn block_on_land(input: &Input<'_>, cartouche: &Cartouche, sizes: &[f32], least: f32) -> Option<Block> {
    let widest = SHORT_ON_LAND * (input.frame[1] - input.frame[0]).x;
    FORMS.iter().find_map(|form| {
        let blocks = Block::all(input, (cartouche, true), &sizes[ON_LAND_IF_SHORT..], least, form);
        blocks.into_iter().find(|block| block.em <= sizes[ON_LAND] || block.size.x <= widest)
    })
}

/// A line of type.
struct Line {
    kind: Kind,
    text: Text,
    em: f32,
    /// The distance of its baseline below the block's upper side, in units.
    down: f32,
}

/// Lines of type, one under the other.
struct Block {
    is_framed: bool,
    em: f32,
    lines: Vec<Line>,
    /// The size of the letters and of what is around them, in units.
    size: Vec2,
}

impl Block {
    /// Sets a title in letters of some sizes, with or without a frame, and the line under it in none smaller than `least`. Leaves out sizes in
    /// which it has no such form, or does not fit.
    fn all(input: &Input<'_>, design: (&Cartouche, bool), sizes: &[f32], least: f32, form: &Form) -> Vec<Self> {
        let mut blocks = Vec::new();
        for &em in sizes {
            blocks.extend(Self::new(input, design, em, least, form));
        }
        blocks
    }

    /// Sets a title in letters of one size; `None` if it has no such form, or does not fit.
    fn new(
        input: &Input<'_>,
        (cartouche, is_framed): (&Cartouche, bool),
        em: f32,
        least: f32,
        form: &Form,
    ) -> Option<Self> {
        let around = AROUND * em + if is_framed { frames::width(cartouche.frame, em) } else { 0.0 };
        let (mut lines, mut width, mut down): (Vec<Line>, f32, f32) = (Vec::new(), 0.0, 0.0);
        for title in broken(&cartouche.title, form.lines)? {
            let text = Text::new(title, Kind::Title);
            if !text.letters.is_empty() {
                down = around + (CAPITAL + LINE * lines.len() as f32) * em;
                width = width.max(text.length * em);
                lines.push(Line { kind: Kind::Title, text, em, down });
            }
        }
        let mut height = down + UNDER * lines.last()?.em;
        if form.has_seed {
            let (text, em_of_seed) = seed(&cartouche.seed, em, least, (SHORT * em).max(width) * WIDER)?;
            let down = down + TO_SEED * em_of_seed + 0.12 * em;
            (width, height) = (width.max(text.length * em_of_seed), down + UNDER * em_of_seed);
            lines.push(Line { kind: Kind::Seed, text, em: em_of_seed, down });
        }
        let size = Vec2::new(width + 2.0 * around, height + around);
        let room = (input.frame[1] - input.frame[0]) * MOST;
        size.cmple(room).all().then_some(Self { is_framed, em, lines, size })
    }

    /// Returns `true` if all of it is at sea in a place.
    fn is_open(&self, input: &Input<'_>, at: Vec2) -> bool {
        anchor::is_open(input, at, self.size, FROM_COAST * self.em)
    }

    /// Puts the block into its place: a label for the title, and one for the line under it.
    fn set(&self, cartouche: &Cartouche, at: Vec2, is_at_sea: bool) -> Set {
        let mut labels: Vec<Label> = Vec::new();
        for line in &self.lines {
            let letters = self.letters(line, at);
            match labels.last_mut() {
                Some(label) if label.kind == line.kind => label.letters.extend(letters),
                _ => {
                    let text = if line.kind == Kind::Title { &cartouche.title } else { &cartouche.seed };
                    labels.push(Label::new(line.kind, None, text, line.em, letters));
                }
            }
        }
        if let Some(title) = labels.first_mut() {
            if self.is_framed {
                title.strokes = frames::strokes(cartouche.frame, at, self.size, self.em);
            }
            if !is_at_sea {
                title.cleared = corner::filled(at, self.size, 0.3 * self.em.min(CLEARED));
            }
        }
        let by = Vec2::new(BESIDE * self.em, 0.0);
        let beside = is_at_sea.then(|| Box::level(at - by, at + self.size + by));
        Set { labels, around: vec![Box::level(at, at + self.size)], beside }
    }

    fn letters(&self, line: &Line, at: Vec2) -> Vec<Placed> {
        let from = Vec2::new(0.5 * (self.size.x - line.text.length * line.em), line.down);
        line.text.level(at + from, line.em)
    }
}

/// Breaks a title into lines, the longest of which is as short as possible; `None` if it has fewer words.
pub(super) fn broken(title: &str, count: usize) -> Option<Vec<&str>> {
    let title = title.trim();
    if count == 1 {
        return Some(vec![title]);
    }
    let longest = |&(first, second): &(&str, &str)| first.chars().count().max(second.chars().count());
    let halves = title.match_indices(' ').map(|(at, _)| (&title[..at], &title[at + 1..]));
    halves.min_by_key(longest).map(|(first, second)| vec![first, second])
}

/// Sets the line under a title in letters that make it no wider than `most` and are no smaller than `least`. `None` if there are no such
/// letters, or if the line is empty or has some that the type lacks.
fn seed(seed: &str, em: f32, least: f32, most: f32) -> Option<(Text, f32)> {
    let text = Text::new(seed, Kind::Seed);
    if text.letters.is_empty() || lacking(seed).next().is_some() {
        return None;
    }
    let size = (UNDER_TITLE * em).max(least).min(most / text.length);
    let smallest = least.max(0.6 * UNDER_TITLE * em);
    (size >= smallest && size <= MOST_UNDER_TITLE * em).then_some((text, size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_broken_where_its_lines_are_as_short_as_may_be() {
        assert_eq!(broken("The Rivers of Dellen", 2), Some(vec!["The Rivers", "of Dellen"]));
        assert_eq!(broken("Dellen and its Waters", 2), Some(vec!["Dellen and", "its Waters"]));
        assert_eq!(broken("Dellen", 2), None);
        assert_eq!(broken(" Dellen ", 1), Some(vec!["Dellen"]));
    }
}
