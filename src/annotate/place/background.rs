//! The background of letters, as placement asks about it.

use glam::Vec2;

use super::input::Input;
use super::letters::Box;
use crate::base::geometry::nearest;
use crate::network::{Network, Place};

/// The number of no river.
pub const NONE: u32 = u32::MAX;
/// The number of ridges, which are in the way of every label.
pub const RIDGE: u32 = u32::MAX - 1;
/// The number of lakes.
pub const LAKE: u32 = u32::MAX - 2;

/// The side of the cells that samples are taken by, in units.
pub const CELL: f32 = 2.0;
/// The distance from their banks within which rivers still count as ink, in units.
const MARGIN: f32 = 1.0;

/// The widest river over a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// Its number; `u32::MAX` where there is none.
    pub river: u32,
    /// Its width there, in units; 0 where there is none.
    pub width: f32,
}

impl Ink {
    /// No ink.
    pub const NOTHING: Self = Self { river: NONE, width: 0.0 };
}

/// The ground that letters stand on, with its rivers, lakes and ridges.
pub trait Background {
    /// `true` if candidates that cannot be the best any more are left alone.
    const STOPS_EARLY: bool;

    /// Returns the ink of the widest piece that reaches the middle of a place's cell; the first of equals.
    fn ink(&self, at: Vec2) -> Ink;

    /// Returns the distances of a place from the banks of one river, and from those of all others that are at least `least_width` wide; at
    /// most `reach`.
    fn distances(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> [f32; 2];

    /// Returns `true` if a box meets a river, which is as wide as the wider end of each of its pieces there.
    fn meets(&self, around: &Box, river: u32) -> bool;
}

/// A straight piece of a river, a lake or a ridge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The river's number, or that of lakes or ridges.
    pub river: u32,
    /// Its ends.
    pub ends: [Place; 2],
}

impl Piece {
    /// Returns all pieces of a map: those of rivers, river by river, of lakes and of ridges.
    pub fn all(input: &Input<'_>) -> Vec<Self> {
        let mut pieces = Vec::new();
        for (number, course) in (0..).zip(&input.map.courses) {
            pieces.extend(Self::along(number, course));
        }
        pieces.extend(Self::of_lines(LAKE, &input.map.lakes));
        pieces.extend(Self::of_lines(RIDGE, &input.map.ridges));
        pieces
    }

    /// Returns the pieces of the rivers of a network, river by river.
    pub(super) fn of_rivers(network: &Network) -> Vec<Self> {
        let mut pieces = Vec::new();
        for (number, river) in (0..).zip(&network.rivers) {
            pieces.extend(Self::along(number, &network.middle(river)));
        }
        pieces
    }

    /// Returns the pieces of some lines, which are all lakes or all ridges.
    pub(super) fn of_lines(kind: u32, lines: &[Vec<Place>]) -> Vec<Self> {
        lines.iter().flat_map(|line| Self::along(kind, line)).collect()
    }

    /// Returns the pieces of a line.
    pub(super) fn along(river: u32, line: &[Place]) -> impl Iterator<Item = Self> + '_ {
        line.windows(2).map(move |pair| Self { river, ends: [pair[0], pair[1]] })
    }

    /// Returns the distance of a point from the middle line, and half the piece's width there.
    #[inline]
    pub fn nearest(&self, point: Vec2) -> (f32, f32) {
        let [from, to] = self.ends;
        let (distance, t) = nearest(point, (from.at, to.at));
        (distance, from.half + (to.half - from.half) * t)
    }

    /// Returns its ink at a point; `None` if that is bare.
    #[inline]
    pub fn ink(&self, point: Vec2) -> Option<Ink> {
        let (distance, half) = self.nearest(point);
        let width = match self.river {
            RIDGE => f32::MAX,
            LAKE => f32::MAX / 2.0,
            _ => 2.0 * half,
        };
        (distance <= half + MARGIN).then_some(Ink { river: self.river, width })
    }

    /// Returns `true` if it belongs to a river.
    #[inline]
    pub fn is_river(&self) -> bool {
        self.river < LAKE
    }

    /// Returns the distance of its bank from a point; less than 0 in the river.
    #[inline]
    pub fn distance(&self, point: Vec2) -> f32 {
        let (distance, half) = self.nearest(point);
        distance - half
    }

    /// Returns `true` if it is as wide as this anywhere.
    #[inline]
    pub fn is_as_wide_as(&self, width: f32) -> bool {
        self.widest() >= width
    }

    /// Returns its greatest width.
    #[inline]
    pub fn widest(&self) -> f32 {
        2.0 * self.ends[0].half.max(self.ends[1].half)
    }

    /// Returns the corners of a box around its ink. The box is at least as large as the ink.
    pub fn corners(&self) -> [Vec2; 2] {
        let [from, to] = self.ends;
        let margin = from.half.max(to.half) + MARGIN;
        [from.at.min(to.at) - margin, from.at.max(to.at) + margin]
    }
}

/// Returns the middle of a place's cell.
#[inline]
pub fn cell_middle(at: Vec2) -> Vec2 {
    ((at / CELL).floor() + 0.5) * CELL
}
