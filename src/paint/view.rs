//! The map from the domain to the pixels.

use std::ops::{Range, RangeInclusive};

use glam::Vec2;
use thiserror::Error;

use crate::domain::Domain;

/// The longest side of a picture, in pixels.
pub const LONGEST_SIDE: u32 = 8192;

/// The reason why a picture cannot be painted.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PaintError {
    /// A size that pictures cannot have.
    #[error("size: {width} x {height} pixels is not between 1 x 1 and {LONGEST_SIDE} x {LONGEST_SIDE}")]
    Size {
        /// The requested width.
        width: u32,
        /// The requested height.
        height: u32,
    },
    /// There was not enough memory.
    #[error("size: {width} x {height} pixels need about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// The requested width.
        width: u32,
        /// The requested height.
        height: u32,
        /// The approximate memory that is needed.
        megabytes: u32,
    },
}

/// A range of rows of a picture.
pub(super) type Rows = Range<u32>;

/// The part of a map that a picture shows, in widths of the map. It may extend beyond the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    left: f32,
    top: f32,
    across: f32,
    /// The depths that other things cover along the western, northern, eastern and southern edges. No letters are placed
    /// there.
    covered: [f32; 4],
}

impl Framing {
    /// The smallest and the greatest width of a picture, in widths of the map.
    pub const ACROSS: RangeInclusive<f32> = 0.05..=20.0;

    /// Makes a frame from the distances of the picture's western and northern edges from those of the map, to the east
    /// and to the south, and the picture's width. `None` if it is too large or too small, or if no map can be in it.
    pub fn new(left: f32, top: f32, across: f32) -> Option<Self> {
        const FARTHEST: f32 = 40.0;
        let is_near = left.abs() <= FARTHEST && top.abs() <= FARTHEST;
        (is_near && Self::ACROSS.contains(&across)).then_some(Self { left, top, across, covered: [0.0; 4] })
    }

    /// Makes a frame from three numbers, in the order of `new`, or from seven: the others are the depths that other
    /// things cover along its western, northern, eastern and southern edges. `None` for any other count.
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

/// A picture's size and the map from domain units to pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The width in pixels.
    pub width: u32,
    /// The height in pixels.
    pub height: u32,
    /// Pixels per unit.
    pub scale: f32,
    /// The position of the domain's north-western corner, in pixels.
    offset: Vec2,
    /// The part of any domain that it shows; `None` if the domain covers the picture.
    framing: Option<Framing>,
    /// The sides of the domain, in units.
    domain: Vec2,
}

impl View {
    /// Covers a picture with a domain. If their aspects differ, opposite edges of the domain are cut by the same
    /// amount.
    ///
    /// # Errors
    /// Fails if a side is 0 or greater than [`LONGEST_SIDE`].
    pub fn new(domain: &Domain, width: u32, height: u32) -> Result<Self, PaintError> {
        let allowed = 1..=LONGEST_SIDE;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(PaintError::Size { width, height });
        }
        Ok(Self { width, height, scale: 1.0, offset: Vec2::ZERO, framing: None, domain: domain.size }.of(domain))
    }

    /// Returns the view of another domain in the same picture.
    pub fn of(self, domain: &Domain) -> Self {
        let size = Vec2::new(self.width as f32, self.height as f32);
        match self.framing {
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

    /// Returns the view of a part of a domain in the same picture; for `None`, the domain covers it.
    #[must_use]
    pub fn framed(self, domain: &Domain, framing: Option<Framing>) -> Self {
        Self { framing, ..self }.of(domain)
    }

    /// Returns the height of a picture of this width that shows the whole domain.
    pub fn height_for(domain: &Domain, width: u32) -> u32 {
        ((width as f32 * domain.size.y / domain.size.x).round() as u32).max(1)
    }

    /// Returns the width of a picture of this height that shows the whole domain.
    pub fn width_for(domain: &Domain, height: u32) -> u32 {
        ((height as f32 * domain.size.x / domain.size.y).round() as u32).max(1)
    }

    /// Returns the width and height of a picture that shows the whole domain, given the longer of the two.
    pub fn sides_for(domain: &Domain, longer: u32) -> (u32, u32) {
        let height = Self::height_for(domain, longer);
        if height <= longer { (longer, height) } else { (Self::width_for(domain, longer), longer) }
    }

    /// Returns the north-western and the south-eastern corner of the visible part, in units. They may lie beyond the
    /// domain.
    pub fn frame(&self) -> [Vec2; 2] {
        [Vec2::ZERO, Vec2::new(self.width as f32, self.height as f32)].map(|corner| self.point(corner))
    }

    /// Returns the two corners of the part that is visible and not covered, where letters may be placed.
    pub fn uncovered(&self) -> [Vec2; 2] {
        let [least, most] = self.frame();
        let [west, north, east, south] = self.framing.map_or([0.0; 4], |framing| framing.covered);
        [least + Vec2::new(west, north) * self.domain.x, most - Vec2::new(east, south) * self.domain.x]
    }

    /// Returns `true` if it shows a chosen part of its domain.
    pub(crate) fn is_framed(&self) -> bool {
        self.framing.is_some()
    }

    /// Returns `true` if it shows anything beyond the domain.
    pub(super) fn shows_beyond(&self) -> bool {
        let [least, most] = self.frame();
        self.is_framed() && (least.min_element() < 0.0 || most.cmpgt(self.domain).any())
    }

    /// Returns the sides of the domain, in units.
    pub(crate) fn domain(&self) -> Vec2 {
        self.domain
    }

    /// Returns the point of the domain nearest to a point beyond it; `None` for a point within.
    pub(super) fn border_near(&self, point: Vec2) -> Option<Vec2> {
        let nearest = point.max(Vec2::ZERO).min(self.domain);
        (nearest != point).then_some(nearest)
    }

    /// Counts the pixels of the picture.
    pub(super) fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Returns the range of the pixels of some rows.
    pub(super) fn range(&self, rows: Rows) -> Range<usize> {
        let width = self.width as usize;
        rows.start as usize * width..rows.end as usize * width
    }

    /// Returns the rows to paint next, after a number of pixels: as many as fit into a few milliseconds, but always
    /// one.
    #[inline(never)]
    pub(super) fn next_rows(&self, painted: usize) -> Rows {
        const PIXELS: u32 = 1 << 16;
        let first = (painted / self.width as usize) as u32;
        first..(first + (PIXELS / self.width).max(1)).min(self.height)
    }

    /// Returns the position of a pixel in the domain.
    #[inline]
    pub fn point(&self, pixel: Vec2) -> Vec2 {
        (pixel - self.offset) / self.scale
    }

    /// Returns the position of a point of the domain, in pixels.
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
            // The domain leaves no gap and is cut by the same amount on both sides.
            let (first, last) = (view.pixel(Vec2::ZERO), view.pixel(domain.size));
            assert!(first.max_element() <= 0.0 && (last - size).min_element() >= 0.0, "{first} to {last}");
            assert_eq!(-first, last - size, "{width} x {height}");
        }
    }
}
