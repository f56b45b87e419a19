//! The cartouche: the map's title in a corner, with the seed's text in small letters under it, and a double line around both if it is framed.

use glam::Vec2;

use super::background::Background;
use super::corner::{self, Corner};
use super::input::{Cartouche, Input};
use super::letters::{Box, Kind, Label, Placed, Stroke, Text};
use crate::annotate::glyph::lacking;

/// Sizes of the title, the length of its em in units, and how much larger it is than the smallest letters that can be read.
const SIZES: [f32; 5] = [30.0, 26.0, 22.0, 19.0, 16.0];
const OVER_LEAST: f32 = 1.25;
const LEAST: f32 = 11.0;
/// The size that is taken where no corner is all sea, and by which share smaller ones have to be more so.
const ON_LAND: usize = 2;
const MORE_SEA: f32 = 0.1;
/// How large the seed's letters are, over those of the title.
const SEED: [f32; 3] = [0.56, 0.48, 0.4];
/// How much wider than the title the seed may be, or than a title of so many ems.
const WIDER: f32 = 1.25;
const SHORT: f32 = 8.0;

/// The most that it takes up of the map's width and height.
const MOST: Vec2 = Vec2::new(0.6, 0.4);
/// How far other labels keep from its letters, in ems.
const AROUND: f32 = 0.6;

/// How high capitals are, how deep letters reach under their line, and how far lines are apart, in ems.
const CAPITAL: f32 = 0.66;
const UNDER: f32 = 0.2;
const LINE: f32 = 1.15;
const TO_SEED: f32 = 1.2;

/// A cartouche in its place.
pub struct Set {
    pub labels: Vec<Label>,
    /// What other labels keep off.
    pub around: Box,
}

/// Puts the title into the corner with the most sea, and of those with the least ink. Smaller letters, and two lines, are tried where that keeps
/// it off land. `None` if there is no room.
pub fn set<G: Background>(input: &Input<'_>, background: &G, cartouche: &Cartouche) -> Option<Set> {
    let sizes = SIZES.map(|size| size.max(OVER_LEAST * input.least_em) * input.label_size);
    let blocks = sizes.into_iter().flat_map(|em| [1, 2].map(|lines| Block::new(input, cartouche, em, lines)));
    let mut blocks: Vec<Option<Block>> = blocks.collect();
    // Even where its letters are no larger than others on the map.
    let least = input.least_em.max(LEAST) * input.label_size;
    blocks.extend([1, 2].map(|lines| Block::new(input, cartouche, least, lines)));
    let at_sea = blocks.iter().flatten().find_map(|block| {
        let corner = block.corner(input, background)?;
        (corner.sea == 1.0).then_some((block, corner))
    });
    // Else smaller ones if that makes a difference.
    let mostly_at_sea = || {
        let placed =
            blocks[2 * ON_LAND..].iter().flatten().filter_map(|block| Some((block, block.corner(input, background)?)));
        placed.reduce(|best, next| if next.1.sea > best.1.sea + MORE_SEA { next } else { best })
    };
    let (block, corner) = at_sea.or_else(mostly_at_sea)?;
    Some(block.set(cartouche, &corner))
}

/// A line of type.
struct Line {
    kind: Kind,
    text: Text,
    em: f32,
    /// How far its baseline is below the block's upper side, in units.
    down: f32,
}

/// Lines of type, one under the other.
struct Block {
    em: f32,
    lines: Vec<Line>,
    /// Of the letters and of what is around them, in units.
    size: Vec2,
    is_framed: bool,
}

impl Block {
    /// Title and seed in letters of a size; `None` if the title has no such number of lines, or does not fit.
    fn new(input: &Input<'_>, cartouche: &Cartouche, em: f32, count: usize) -> Option<Self> {
        let titles = broken(&cartouche.title, count)?.into_iter().map(|line| Text::new(line, Kind::Title));
        let mut lines: Vec<Line> = Vec::new();
        for text in titles.filter(|text| !text.letters.is_empty()) {
            let down = if lines.is_empty() { CAPITAL } else { CAPITAL + LINE * lines.len() as f32 } * em;
            lines.push(Line { kind: Kind::Title, text, em, down });
        }
        let down = lines.last()?.down;
        let wide = lines.iter().map(|line| line.text.length * em).fold(SHORT * em, f32::max) * WIDER;
        lines.extend(seed(input, &cartouche.seed, em, wide).map(|(text, em_of_seed)| {
            let down = down + TO_SEED * em_of_seed + 0.25 * em;
            Line { kind: Kind::Seed, text, em: em_of_seed, down }
        }));
        let width = lines.iter().map(|line| line.text.length * line.em).fold(0.0, f32::max);
        let height = lines.last().map_or(0.0, |line| line.down + UNDER * line.em);
        let size = Vec2::new(width, height) + 2.0 * AROUND * em;
        let room = (input.frame[1] - input.frame[0]) * MOST;
        size.cmple(room).all().then_some(Self { em, lines, size, is_framed: cartouche.is_framed })
    }

    /// The best of the four corners.
    fn corner<G: Background>(&self, input: &Input<'_>, background: &G) -> Option<Corner> {
        corner::best(input, background, self.size, self.em, &[])
    }

    /// The block in its corner: a label for the title, and one for the seed.
    fn set(&self, cartouche: &Cartouche, corner: &Corner) -> Set {
        let mut labels: Vec<Label> = Vec::new();
        for line in &self.lines {
            let letters = self.letters(line, corner.at);
            match labels.last_mut() {
                Some(label) if label.kind == line.kind => label.letters.extend(letters),
                _ => {
                    let text = if line.kind == Kind::Title { &cartouche.title } else { &cartouche.seed };
                    labels.push(Label::new(line.kind, None, text, line.em, letters));
                }
            }
        }
        if let Some(title) = labels.first_mut() {
            title.strokes = if self.is_framed { corner::rules(corner.at, self.size, self.em) } else { Vec::new() };
            title.cleared = if corner.sea < 1.0 { self.cleared(corner.at) } else { Vec::new() };
        }
        Set { labels, around: Box::level(corner.at, corner.at + self.size) }
    }

    fn letters(&self, line: &Line, at: Vec2) -> Vec<Placed> {
        let from = Vec2::new(0.5 * (self.size.x - line.text.length * line.em), AROUND * self.em + line.down);
        line.text.letters.iter().map(|letter| Placed::level(letter, at + from, line.em)).collect()
    }

    /// What is cleared for it on land: all within its frame, or the lines of type.
    fn cleared(&self, at: Vec2) -> Vec<Stroke> {
        if self.is_framed {
            return corner::filled(at, self.size, 0.3 * self.em);
        }
        let of_line = |of: &Line| {
            let room = 0.5 * (self.size.x - of.text.length * of.em);
            let y = AROUND * self.em + of.down - 0.25 * of.em;
            let ends = [room, self.size.x - room].map(|x| at + Vec2::new(x, y));
            Stroke { ends, half: 0.5 * self.em }
        };
        self.lines.iter().map(of_line).collect()
    }
}

/// A title in as many lines, the longest of which is as short as may be; `None` if it has fewer words.
fn broken(title: &str, count: usize) -> Option<Vec<&str>> {
    let title = title.trim();
    if count == 1 {
        return Some(vec![title]);
    }
    let longest = |&(first, second): &(&str, &str)| first.chars().count().max(second.chars().count());
    let halves = title.match_indices(' ').map(|(at, _)| (&title[..at], &title[at + 1..]));
    halves.min_by_key(longest).map(|(first, second)| vec![first, second])
}

/// The seed in the largest letters that are not too wide; `None` if there are none, or it has letters that the type has not.
fn seed(input: &Input<'_>, seed: &str, em: f32, most: f32) -> Option<(Text, f32)> {
    let text = Text::new(seed, Kind::Seed);
    if text.letters.is_empty() || lacking(seed).next().is_some() {
        return None;
    }
    let least = input.least_em * input.label_size;
    let sizes = SEED.map(|share| (share * em).max(least.min(em)));
    sizes.into_iter().find(|em| text.length * em <= most).map(|em| (text, em))
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
