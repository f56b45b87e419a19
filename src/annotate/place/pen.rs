//! The parts of a glyph: a silhouette and the strokes of a pen. They lie around its foot, the middle of its base, in sizes of the glyph: a
//! tree's size is its height, that of a hill or marsh half of its width.

use glam::Vec2;

use crate::annotate::glyph::Curve;
use crate::base::random::{ItemHash, Purpose, Seed};

/// The subject of a glyph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// A tree with a round crown that stands alone.
    Broadleaf,
    /// A round crown in a closed wood.
    Canopy,
    /// A small tree of a row along a river.
    Willow,
    /// A tree with a pointed crown.
    Conifer,
    /// A tuft of reeds over lines of water.
    Marsh,
    /// A hill.
    Hill,
    /// A mountain.
    Mountain,
}

impl Feature {
    /// All of them, in the order of their glyphs.
    pub const ALL: [Self; 7] =
        [Self::Broadleaf, Self::Canopy, Self::Willow, Self::Conifer, Self::Marsh, Self::Hill, Self::Mountain];

    /// Returns `true` if it grows: a tree or a marsh, no hill.
    pub fn is_plant(self) -> bool {
        !matches!(self, Self::Hill | Self::Mountain)
    }

    /// Returns `true` if it is a round crown, which merges with others that it touches.
    pub fn is_leafy(self) -> bool {
        matches!(self, Self::Broadleaf | Self::Canopy | Self::Willow)
    }

    /// Returns the numbers of its glyphs.
    pub fn shapes(self) -> std::ops::Range<u8> {
        match self {
            Self::Broadleaf => 0..5,
            Self::Canopy => 5..13,
            Self::Willow => 13..16,
            Self::Conifer => 16..22,
            Self::Marsh => 22..26,
            Self::Hill => 26..34,
            Self::Mountain => 34..54,
        }
    }
}

/// A line of a pen.
#[derive(Clone, Debug)]
pub struct PenStroke {
    /// The place where it begins.
    pub start: Vec2,
    /// The curves along which it runs from there.
    pub curves: Vec<Curve>,
    /// Half of its width at its start and at its end.
    pub halves: [f32; 2],
}

/// A glyph.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Its subject.
    pub feature: Feature,
    /// The edge of the area that hides others: closed from its end to its start by a straight line.
    pub silhouette: PenStroke,
    /// Its dark flank, likewise closed, under a faint wash.
    pub wash: Option<PenStroke>,
    /// Its outline.
    pub outline: Vec<PenStroke>,
    /// Fainter strokes, on its dark side.
    pub shade: Vec<PenStroke>,
    /// Discs that all of it lies within: their middles and radii.
    pub discs: Vec<(Vec2, f32)>,
}

/// The hand that draws a glyph, a little different each time.
pub(super) struct Hand {
    chance: ItemHash,
    /// The number of the glyph.
    pub number: u8,
    strokes: u32,
}

impl Hand {
    /// Makes the hand that draws the glyph of a number.
    pub fn of(number: u8) -> Self {
        Self { chance: Seed::from_text("glyphs").item_hash(Purpose::Scenery), number, strokes: 0 }
    }

    /// Returns a number between two.
    pub fn between(&mut self, least: f32, most: f32) -> f32 {
        self.strokes += 1;
        least + (most - least) * self.chance.unit([u32::from(self.number), self.strokes, 4])
    }

    /// Returns a number that is at most this far from 0, to either side.
    pub fn swing(&mut self, most: f32) -> f32 {
        self.between(-most, most)
    }

    /// Draws a line through points, which wavers a little between them.
    pub fn line(&mut self, points: &[Vec2], halves: [f32; 2]) -> PenStroke {
        let start = points.first().copied().unwrap_or_default();
        let mut from = start;
        let mut curve = |to: &Vec2| {
            let control = (from + *to) * 0.5 + (*to - from).perp() * self.swing(0.12);
            from = *to;
            [control, *to]
        };
        let curves = points.iter().skip(1).map(&mut curve).collect();
        PenStroke { start, curves, halves }
    }
}

impl PenStroke {
    /// Draws one curve.
    pub(super) fn dash(start: Vec2, control: Vec2, end: Vec2, halves: [f32; 2]) -> Self {
        Self { start, curves: vec![[control, end]], halves }
    }

    /// Returns points along it, close to each other.
    pub(super) fn points(&self) -> impl Iterator<Item = Vec2> {
        const PIECES: u8 = 6;
        let starts = std::iter::once(self.start).chain(self.curves.iter().map(|curve| curve[1]));
        std::iter::once(self.start).chain(starts.zip(&self.curves).flat_map(|(from, &[control, to])| {
            (1..=PIECES).map(move |i| {
                let t = f32::from(i) / f32::from(PIECES);
                from * ((1.0 - t) * (1.0 - t)) + control * (2.0 * t * (1.0 - t)) + to * (t * t)
            })
        }))
    }
}

impl Shape {
    /// Adds the smallest discs around some middles that hold its strokes and all between them.
    pub(super) fn within(mut self, middles: &[Vec2]) -> Self {
        /// The greatest distance between points one of which lies in one disc and one in the next.
        const SLACK: f32 = 0.03;
        let edge: Vec<Vec2> = self.silhouette.points().collect();
        let least = edge.iter().fold(f32::MAX, |least, at| least.min(at.x));
        let inside = edge.windows(2).flat_map(|pair| {
            let base = Vec2::new(pair[1].x.max(least), 0.0);
            (0..=8u8).map(move |i| pair[1].lerp(base, f32::from(i) / 8.0))
        });
        let strokes = self.outline.iter().chain(&self.shade).flat_map(PenStroke::points);
        let mut discs: Vec<(Vec2, f32)> = middles.iter().map(|middle| (*middle, 0.0)).collect();
        for at in inside.chain(strokes) {
            let apart = |disc: &(Vec2, f32)| at.distance(disc.0) - disc.1;
            let nearest = discs.iter_mut().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            if let Some((middle, radius)) = nearest {
                *radius = radius.max(at.distance(*middle) + SLACK);
            }
        }
        self.discs = discs;
        self
    }
}
