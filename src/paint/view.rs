//! How the domain lies on the pixels.

use std::ops::{Range, RangeInclusive};

use glam::Vec2;
use thiserror::Error;

use crate::domain::Domain;

/// The longest side of a picture, in pixels.
pub const LONGEST_SIDE: u32 = 8192;

/// Why a picture cannot be painted.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PaintError {
    /// A side that is no number of pixels that a picture can have.
    #[error("size: {width} x {height} pixels is not between 1 x 1 and {LONGEST_SIDE} x {LONGEST_SIDE}")]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// There was not enough memory.
    #[error("size: {width} x {height} pixels need about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
        /// About how much is needed.
        megabytes: u32,
    },
}

/// Some rows of a picture, which lie one below the other.
pub(super) type Rows = Range<u32>;

/// Whether anybody frames pictures: where not, what that takes is left out of the program.
const IS_FRAMED: bool = cfg!(any(feature = "controls", feature = "names"));

/// What part of a map a picture shows, and how much of what lies beyond it, in widths of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    left: f32,
    top: f32,
    across: f32,
    /// What is covered by other things along its western, northern, eastern and southern edges: no letters stand there.
    covered: [f32; 4],
}

impl Framing {
    /// The least and the most that a picture is across, in widths of the map.
    pub const ACROSS: RangeInclusive<f32> = 0.05..=20.0;

    /// How far the picture's western edge lies east of the map's, how far its northern edge lies south of the map's, and how wide the picture
    /// is. `None` if it is too large or too small, or no part of it can be on a map.
    pub fn new(left: f32, top: f32, across: f32) -> Option<Self> {
        const FARTHEST: f32 = 40.0;
        let is_near = left.abs() <= FARTHEST && top.abs() <= FARTHEST;
        (is_near && Self::ACROSS.contains(&across)).then_some(Self { left, top, across, covered: [0.0; 4] })
    }

    /// Of three numbers, in the order of `new`, and perhaps four more: how much other things cover of its western, northern, eastern and southern
    /// edge. `None` if it is another number of them.
    pub fn of(numbers: &[f32]) -> Option<Self> {
        match *numbers {
            [left, top, across] => Self::new(left, top, across),
            [left, top, across, ref covered @ ..] => {
                let covered = <[f32; 4]>::try_from(covered).ok()?;
                let is_less = covered.iter().all(|depth| (0.0..=across).contains(depth));
                Self::new(left, top, across).filter(|_| is_less).map(|this| Self { covered, ..this })
            }
            _ => None,
        }
    }
}

/// A picture's size, and the map from domain units to pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Pixels to a unit.
    pub scale: f32,
    /// Where the domain's north-western corner lies, in pixels.
    offset: Vec2,
    /// What it shows of any domain; `None` if it covers itself with it.
    framing: Option<Framing>,
    /// The domain's sides, in units.
    domain: Vec2,
}

impl View {
    /// Covers a picture with a domain: where their aspects differ, the domain's edges are cut, evenly.
    ///
    /// # Errors
    /// If a side is 0 or over [`LONGEST_SIDE`].
    pub fn new(domain: &Domain, width: u32, height: u32) -> Result<Self, PaintError> {
        let allowed = 1..=LONGEST_SIDE;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(PaintError::Size { width, height });
        }
        Ok(Self { width, height, scale: 1.0, offset: Vec2::ZERO, framing: None, domain: domain.size }.of(domain))
    }

    /// The same picture of another domain.
    pub fn of(self, domain: &Domain) -> Self {
        let size = Vec2::new(self.width as f32, self.height as f32);
        match self.framing.filter(|_| IS_FRAMED) {
            None => {
                let scale = (size / domain.size).max_element();
                Self { scale, offset: (size - domain.size * scale) / 2.0, domain: domain.size, ..self }
            }
            Some(Framing { left, top, across, .. }) => {
                let scale = size.x / (across * domain.size.x);
                Self { scale, offset: Vec2::new(left, top) * (-domain.size.x * scale), domain: domain.size, ..self }
            }
        }
    }

    /// The same picture with a part of a domain; with all that covers it, if no part is named.
    #[must_use]
    pub fn framed(self, domain: &Domain, framing: Option<Framing>) -> Self {
        Self { framing, ..self }.of(domain)
    }

    /// The height that a picture of this width has if it shows the domain whole.
    pub fn height_for(domain: &Domain, width: u32) -> u32 {
        ((width as f32 * domain.size.y / domain.size.x).round() as u32).max(1)
    }

    /// The width that a picture of this height has if it shows the domain whole.
    pub fn width_for(domain: &Domain, height: u32) -> u32 {
        ((height as f32 * domain.size.x / domain.size.y).round() as u32).max(1)
    }

    /// The width and the height of a picture that shows the domain whole, the longer of which is given.
    #[cfg(feature = "files")]
    pub fn sides_for(domain: &Domain, longer: u32) -> (u32, u32) {
        let height = Self::height_for(domain, longer);
        if height <= longer { (longer, height) } else { (Self::width_for(domain, longer), longer) }
    }

    /// What is seen: the north-western and the south-eastern corner, in units. They may lie beyond the domain.
    pub fn frame(&self) -> [Vec2; 2] {
        [Vec2::ZERO, Vec2::new(self.width as f32, self.height as f32)].map(|corner| self.point(corner))
    }

    /// What is seen and not covered, likewise: where letters may stand.
    #[cfg(feature = "names")]
    pub fn uncovered(&self) -> [Vec2; 2] {
        let [least, most] = self.frame();
        let [west, north, east, south] = self.framing.map_or([0.0; 4], |framing| framing.covered);
        [least + Vec2::new(west, north) * self.domain.x, most - Vec2::new(east, south) * self.domain.x]
    }

    /// Whether it shows a part of its domain that somebody named.
    pub(super) fn is_framed(&self) -> bool {
        IS_FRAMED && self.framing.is_some()
    }

    /// Whether it shows anything beyond the domain.
    pub(super) fn shows_beyond(&self) -> bool {
        let [least, most] = self.frame();
        self.is_framed() && (least.min_element() < 0.0 || most.cmpgt(self.domain).any())
    }

    /// The point of the domain that is nearest to a point beyond it; `None` for one of its own.
    pub(super) fn border_near(&self, point: Vec2) -> Option<Vec2> {
        let nearest = point.max(Vec2::ZERO).min(self.domain);
        (nearest != point).then_some(nearest)
    }

    /// How many pixels it has.
    pub(super) fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The pixels of some rows.
    pub(super) fn range(&self, rows: Rows) -> Range<usize> {
        let width = self.width as usize;
        rows.start as usize * width..rows.end as usize * width
    }

    /// The rows that are painted next, when so many pixels have been: as many as take a few milliseconds at most, and one at least.
    #[inline(never)]
    pub(super) fn next_rows(&self, painted: usize) -> Rows {
        const PIXELS: u32 = 1 << 16;
        let first = (painted / self.width as usize) as u32;
        first..(first + (PIXELS / self.width).max(1)).min(self.height)
    }

    /// A pixel's place in the domain.
    #[inline]
    pub fn point(&self, pixel: Vec2) -> Vec2 {
        (pixel - self.offset) / self.scale
    }

    /// A point of the domain, in pixels.
    #[inline]
    pub fn pixel(&self, point: Vec2) -> Vec2 {
        point * self.scale + self.offset
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_shows_the_middle_of_its_domain_in_its_middle() {
        let domain = Domain::with_aspect(1.0);
        for (width, height) in [(400, 400), (400, 100), (100, 400)] {
            let view = View::new(&domain, width, height).unwrap();
            let size = Vec2::new(width as f32, height as f32);
            assert_eq!(view.pixel(domain.size * 0.5), size * 0.5, "{width} x {height}");
            assert_eq!(view.point(size * 0.5), domain.size * 0.5, "{width} x {height}");
            // Nothing is left bare, and what is cut off is the same on both sides.
            let (first, last) = (view.pixel(Vec2::ZERO), view.pixel(domain.size));
            assert!(first.max_element() <= 0.0 && (last - size).min_element() >= 0.0, "{first} to {last}");
            assert_eq!(-first, last - size, "{width} x {height}");
        }
    }
}
