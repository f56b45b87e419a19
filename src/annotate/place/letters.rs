//! Letters along a line, and the boxes around them.

use glam::Vec2;

use super::baseline::{Line, walk_from};
use crate::annotate::glyph::{Face, Glyph, Letter, capitals, line_of};
use crate::base::geometry::{distance, gap, length};
use crate::network::Place;

/// The subject of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A river.
    River,
    /// A stretch on which one winds.
    Reach,
    /// The sea or a lake.
    Water,
    /// A bay or a strait.
    Inlet,
    /// An island, on it.
    Island,
    /// An island, on the water beside it.
    Offshore,
    /// A cape, on the water before it.
    Cape,
    /// The main land or a range of mountains, in capitals far apart.
    Region,
    /// The map.
    Title,
    /// The line under the title, such as the word that the map has grown from.
    Seed,
    /// A line or a name on a plate, under the title.
    Plate,
    /// The numbers of the scale bar, and the letter over a north point.
    Margin,
    /// A line of the legend.
    Legend,
    /// The height of a summit or a saddle, beside it.
    SpotHeight,
    /// The letter of a column or the number of a row of the grid, in the map's margin.
    GridLetter,
    /// The margin, and the lines of the grid as far as they are drawn.
    Grid,
    /// The seal: letters that are left out of a square.
    Seal,
    /// A lake, on the land beside it.
    Tarn,
}

/// A group of labels that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Group {
    /// Names on the map.
    Names,
    Cartouche,
    Legend,
    /// Marks of a style besides names, in an ink of their own.
    Marks,
}

/// The type of labels of a kind. Lengths are ems.
#[derive(Clone, Copy, Debug)]
struct Setting {
    group: Group,
    face: Face,
    /// The space between letters besides their advance.
    tracking: f32,
    /// The reach of its halo around outlines.
    halo: f32,
    /// `true` if rivers are left as they are around its letters: it stands on open water, or has its own areas to be cleared.
    is_afloat: bool,
}

impl Kind {
    /// All kinds, in their order.
    pub const ALL: [Self; 18] = [
        Self::River,
        Self::Reach,
        Self::Water,
        Self::Inlet,
        Self::Island,
        Self::Offshore,
        Self::Cape,
        Self::Region,
        Self::Title,
        Self::Seed,
        Self::Plate,
        Self::Margin,
        Self::Legend,
        Self::SpotHeight,
        Self::GridLetter,
        Self::Grid,
        Self::Seal,
        Self::Tarn,
    ];

    /// Returns the row of a kind in the table of kinds.
    fn setting(self) -> Setting {
        let set = |group, face, tracking, halo, is_afloat| Setting { group, face, tracking, halo, is_afloat };
        let (italic, roman) = (Face::Italic, Face::Roman);
        match self {
            Self::River => set(Group::Names, italic, 0.08, 0.13, false),
            Self::Reach => set(Group::Names, italic, 0.16, 0.2, false),
            Self::Water => set(Group::Names, italic, 0.3, 0.13, true),
            Self::Tarn => set(Group::Names, italic, 0.05, 0.13, false),
            Self::Inlet => set(Group::Names, italic, 0.1, 0.13, true),
            Self::Island => set(Group::Names, roman, 0.05, 0.13, false),
            Self::Offshore | Self::Cape => set(Group::Names, roman, 0.05, 0.13, true),
            Self::Region => set(Group::Names, roman, 0.35, 0.13, false),
            Self::Title => set(Group::Cartouche, roman, 0.05, 0.13, true),
            Self::Seed => set(Group::Cartouche, italic, 0.08, 0.13, true),
            Self::Plate => set(Group::Cartouche, italic, 0.03, 0.13, true),
            Self::Margin => set(Group::Cartouche, roman, 0.03, 0.13, true),
            Self::Legend => set(Group::Legend, roman, 0.05, 0.13, true),
            Self::SpotHeight => set(Group::Marks, roman, 0.03, 0.13, false),
            Self::GridLetter | Self::Grid | Self::Seal => set(Group::Marks, roman, 0.03, 0.13, true),
        }
    }

    /// Returns the space between letters that is added to their advance, in ems.
    pub fn tracking(self) -> f32 {
        self.setting().tracking
    }

    /// Returns the face of its letters: italic on water, upright on land.
    pub fn face(self) -> Face {
        self.setting().face
    }

    /// Returns `true` if its letters are all capitals.
    pub fn is_in_capitals(self) -> bool {
        self == Self::Region
    }

    /// Returns `true` if rivers are left as they are around its letters: it stands on open water, or says itself what is cleared.
    pub fn is_afloat(self) -> bool {
        self.setting().is_afloat
    }

    /// Returns `true` if it is a part of the cartouche.
    pub fn is_of_cartouche(self) -> bool {
        self.setting().group == Group::Cartouche
    }

    /// Returns `true` if it is a part of a block of lines in a corner: the cartouche or the legend.
    pub fn is_block(self) -> bool {
        matches!(self.setting().group, Group::Cartouche | Group::Legend)
    }

    /// Returns `true` if it is a mark, in an ink of its own.
    pub fn is_mark(self) -> bool {
        self.setting().group == Group::Marks
    }

    /// Returns the reach of its halo around outlines, in ems.
    pub fn halo(self) -> f32 {
        self.setting().halo
    }
}

/// The depth of the middle of a small letter below its baseline, in ems.
pub const MIDDLE: f32 = -0.2;

/// A letter in its place.
pub type Placed = PlacedIn<'static>;

/// A letter in its place, of a typeface that is there for so long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedIn<'face> {
    /// What it looks like.
    pub glyph: &'face Glyph,
    /// Its outline and its advance.
    /// The place of its origin, in units.
    pub at: Vec2,
    /// The unit vector along its baseline.
    pub along: Vec2,
}

/// A label in its place.
pub type Label = LabelIn<'static>;

/// A label in its place, in typefaces that are there for so long.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelIn<'face> {
    /// The kind of thing that it names.
    pub kind: Kind,
    /// The number of its river; `None` if it names none.
    pub river: Option<u32>,
    /// Its text.
    pub text: String,
    /// The length of its em, in units.
    pub em: f32,
    /// Its letters; spaces are left out.
    pub letters: Vec<PlacedIn<'face>>,
    /// Lines that belong to it, in its colour.
    pub strokes: Vec<Stroke>,
    /// Lines under it that rivers are taken away from, all of one width.
    pub cleared: Vec<Stroke>,
}

/// A straight line with round ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its ends, in units.
    pub ends: [Vec2; 2],
    /// Half its width, in units.
    pub half: f32,
}

impl Stroke {
    /// Returns the box around it, if it is level or upright.
    pub fn around(&self) -> Box {
        Box::level(self.ends[0].min(self.ends[1]) - self.half, self.ends[0].max(self.ends[1]) + self.half)
    }

    /// Returns the box around it that is turned as it is.
    pub fn box_along(&self) -> Box {
        let (middle, along) = ((self.ends[0] + self.ends[1]) * 0.5, (self.ends[1] - self.ends[0]) * 0.5);
        Box { middle, along, down: crate::base::geometry::direction(along).perp() * self.half }
    }
}

impl<'face> LabelIn<'face> {
    /// Makes a label of letters alone.
    pub fn new(kind: Kind, river: Option<u32>, text: &str, em: f32, letters: Vec<PlacedIn<'face>>) -> Self {
        Self { kind, river, text: text.into(), em, letters, strokes: Vec::new(), cleared: Vec::new() }
    }
}

impl LabelIn<'_> {
    /// Returns the spaces between its words, each from the middle of one letter to that of the next, in units; none where letters stand so
    /// far apart that what shows between them cannot be taken for a hyphen.
    pub fn spaces(&self) -> impl Iterator<Item = [Vec2; 2]> + '_ {
        /// The least space between words, in ems: more than there is between the letters of a word.
        const LEAST: f32 = 0.28;
        let space = |pair: &[PlacedIn<'_>]| {
            let end = Vec2::new(pair[0].glyph.advance, MIDDLE);
            [pair[0].place(end, self.em), pair[1].place(Vec2::new(0.0, MIDDLE), self.em)]
        };
        let is_wide = |ends: &[Vec2; 2]| distance(ends[0], ends[1]) > LEAST * self.em;
        let is_together = self.kind != Kind::Region;
        // From a line to the next one there is none.
        let is_onward = |pair: &&[PlacedIn<'_>]| (pair[1].at - pair[0].at).dot(pair[0].along) > 0.0;
        self.letters.windows(2).filter(move |_| is_together).filter(is_onward).map(space).filter(is_wide)
    }
}

/// A text to be placed, in ems.
#[derive(Clone, Debug)]
pub struct Text {
    pub letters: Vec<Letter>,
    pub length: f32,
}

impl Text {
    pub fn new(text: &str, kind: Kind) -> Self {
        Self::spaced(text, kind, kind.tracking())
    }

    /// Sets a text with some space between its letters, in ems.
    pub fn spaced(text: &str, kind: Kind, tracking: f32) -> Self {
        let capital = kind.is_in_capitals().then(|| capitals(text));
        let (mut letters, length) = line_of(capital.as_deref().unwrap_or(text), kind.face(), tracking);
        letters.retain(|letter| !letter.glyph.contours.is_empty());
        Self { letters, length }
    }
}

impl Text {
    /// Places its letters on a line, from a distance along it on; `None` if the line is too short to have a direction.
    pub fn along(&self, line: &Line, start: f32, em: f32) -> Option<Vec<Placed>> {
        let mut walk = walk_from(line, start);
        let place = |letter: &Letter| {
            let [from, to] = [letter.at, letter.at + letter.glyph.advance].map(|at| walk.at(start + at * em));
            between(letter, from, to, em)
        };
        self.letters.iter().map(place).collect()
    }

    /// Places its letters on a level line that begins at a place.
    pub fn level(&self, from: Vec2, em: f32) -> Vec<Placed> {
        self.letters.iter().map(|letter| Placed::level(letter, from, em)).collect()
    }
}

/// A letter's box, turned as the letter is.
#[derive(Clone, Copy, Debug)]
pub struct Box {
    /// Its middle, in units.
    pub middle: Vec2,
    /// The way from its middle along the baseline to the middle of its side, in units.
    pub along: Vec2,
    /// The way from its middle to the middle of its lower side, in units.
    pub down: Vec2,
}

impl PlacedIn<'_> {
    /// Returns the place of a point of the letter, in units.
    #[inline]
    pub fn place(&self, point: Vec2, em: f32) -> Vec2 {
        self.at + (self.along * point.x + self.along.perp() * point.y) * em
    }

    /// Places a letter of a level line that begins at a place.
    /// Returns the box around the letter.
    #[inline]
    pub fn around(&self, em: f32) -> Box {
        let (least, most) = (self.glyph.least, self.glyph.most);
        let half = (most - least) * (0.5 * em);
        let middle = self.place((least + most) * 0.5, em);
        Box { middle, along: self.along * half.x, down: self.along.perp() * half.y }
    }
}

impl Placed {
    /// A letter of a level line that begins at a place.
    pub fn level(letter: &Letter, from: Vec2, em: f32) -> Self {
        Self { glyph: letter.glyph, at: from + Vec2::new(letter.at * em, 0.0), along: Vec2::X }
    }
}

impl Box {
    /// Makes the box from a north-western corner to a south-eastern one.
    pub fn level(least: Vec2, most: Vec2) -> Self {
        let half = (most - least) * 0.5;
        Self { middle: least + half, along: Vec2::new(half.x, 0.0), down: Vec2::new(0.0, half.y) }
    }

    /// Returns its corners, one after the other around it.
    pub fn corners(&self) -> [Vec2; 4] {
        let Self { middle, along, down } = *self;
        [middle - along - down, middle + along - down, middle + along + down, middle - along + down]
    }

    /// Returns three by five points from corner to corner.
    pub fn samples(&self) -> impl Iterator<Item = Vec2> + '_ {
        /// How far each lies along and down, over the way to the middle of a side.
        const SAMPLES: [(f32, f32); 15] = {
            let mut samples = [(0.0, 0.0); 15];
            let mut i = 0;
            while i < samples.len() {
                samples[i] = ((i % 3) as f32 - 1.0, ((i / 3) as f32 - 2.0) * 0.5);
                i += 1;
            }
            samples
        };
        SAMPLES.iter().map(|&(along, down)| self.middle + self.along * along + self.down * down)
    }

    /// Returns the distance of its corners from its middle.
    pub fn radius(&self) -> f32 {
        (self.along.length_squared() + self.down.length_squared()).sqrt()
    }

    /// Returns its distance from a straight piece; 0 if they meet.
    pub fn gap(&self, ends: [Vec2; 2]) -> f32 {
        let corners = self.corners();
        let sides = [0, 1, 2, 3].map(|i| (corners[i], corners[(i + 1) % 4]));
        let is_within = |at: Vec2| {
            let off = at - self.middle;
            let within = |half: Vec2| off.dot(half).abs() <= half.length_squared();
            within(self.along) && within(self.down)
        };
        if is_within(ends[0]) || sides.iter().any(|&side| crate::base::geometry::meet(side, (ends[0], ends[1]))) {
            return 0.0;
        }
        sides.iter().map(|&side| gap(side, (ends[0], ends[1]))).fold(f32::MAX, f32::min)
    }

    /// Returns `true` if it meets a river with these places.
    pub fn meets_river(&self, pair: &[Place]) -> bool {
        let half = pair[0].half.max(pair[1].half);
        let reach = self.radius() + half;
        let far = |at: Vec2, by: f32| distance(at, self.middle) > by;
        let length = distance(pair[0].at, pair[1].at);
        !far(pair[0].at, reach + length) && self.gap([pair[0].at, pair[1].at]) <= half
    }

    /// Returns `true` if it comes nearer to another box than a margin.
    pub fn meets(&self, other: &Self, margin: f32) -> bool {
        if distance(self.middle, other.middle) > self.radius() + other.radius() + margin {
            return false;
        }
        let corners = other.corners();
        let is_around = |outer: &Self, at: Vec2| outer.gap([at, at]) == 0.0;
        (0..4).any(|i| self.gap([corners[i], corners[(i + 1) % 4]]) <= margin) || is_around(other, self.middle)
    }
}

/// Places a letter between two points of its line.
#[inline]
pub fn between(letter: &Letter, from: Vec2, to: Vec2, em: f32) -> Option<Placed> {
    let way = to - from;
    let long = length(way);
    if long <= 0.0 {
        return None;
    }
    let along = way / long;
    let at = (from + to) * 0.5 - along * (0.5 * em * letter.glyph.advance);
    Some(Placed { glyph: letter.glyph, at, along })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f32, y: f32, half: f32) -> Box {
        Box { middle: Vec2::new(x, y), along: Vec2::new(half, 0.0), down: Vec2::new(0.0, half) }
    }

    #[test]
    fn boxes_meet_if_they_overlap_or_one_holds_the_other_or_they_come_near() {
        let one = square(0.0, 0.0, 5.0);
        assert!(one.meets(&square(9.0, 0.0, 5.0), 0.0) && !one.meets(&square(11.0, 0.0, 5.0), 0.5));
        assert!(one.meets(&square(11.0, 0.0, 5.0), 1.5));
        assert!(one.meets(&square(1.0, 1.0, 1.0), 0.0) && square(1.0, 1.0, 1.0).meets(&one, 0.0));
        // The corner of one that is turned by 45 degrees.
        let turned = Box { middle: Vec2::new(11.0, 0.0), along: Vec2::new(5.0, 5.0), down: Vec2::new(-5.0, 5.0) };
        assert!(one.meets(&turned, 0.0) && !one.meets(&Box { middle: Vec2::new(16.0, 0.0), ..turned }, 0.5));
    }

    #[test]
    fn a_box_meets_a_river_that_is_as_near_as_its_banks() {
        let river = |y: f32, half: f32| [-40.0, 40.0].map(|x| Place { at: Vec2::new(x, y), half });
        let one = square(0.0, 0.0, 5.0);
        assert!(one.meets_river(&river(0.0, 0.1)) && one.meets_river(&river(8.0, 3.1)));
        assert!(!one.meets_river(&river(8.0, 2.9)));
    }
}
