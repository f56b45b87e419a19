//! How the domain lies on the pixels.

use std::ops::Range;

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
        Ok(Self { width, height, scale: 1.0, offset: Vec2::ZERO }.of(domain))
    }

    /// Covers the same picture with another domain.
    pub fn of(self, domain: &Domain) -> Self {
        let size = Vec2::new(self.width as f32, self.height as f32);
        let scale = (size / domain.size).max_element();
        Self { scale, offset: (size - domain.size * scale) / 2.0, ..self }
    }

    /// The height that a picture of this width has if it shows the domain whole.
    pub fn height_for(domain: &Domain, width: u32) -> u32 {
        ((width as f32 * domain.size.y / domain.size.x).round() as u32).max(1)
    }

    /// The width that a picture of this height has if it shows the domain whole.
    pub fn width_for(domain: &Domain, height: u32) -> u32 {
        ((height as f32 * domain.size.x / domain.size.y).round() as u32).max(1)
    }

    /// The part of the domain that is seen: its north-western and its south-eastern corner.
    pub fn frame(&self) -> [Vec2; 2] {
        [Vec2::ZERO, Vec2::new(self.width as f32, self.height as f32)].map(|corner| self.point(corner))
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
