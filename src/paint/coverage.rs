//! The coverage mask and its only brush, a capsule of varying width.
//!
//! A pixel has the coverage of the stroke that covers it most. Unlike with blending, the order of strokes does not
//! matter, and drawing a stroke twice changes nothing. Coverage never falls when a radius grows, rounding included, so
//! a river that is drawn again with a greater width looks as if it had been drawn once.

use glam::Vec2;
use tiny_skia::Mask;
use wide::f32x4;

use crate::base::rings::{sides, stretches_between};
use crate::base::sort;

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// The first column.
    pub left: u32,
    /// The first row.
    pub top: u32,
    /// The column after the last.
    pub right: u32,
    /// The row after the last.
    pub bottom: u32,
}

impl Rect {
    /// Returns the rectangle of the pixels between two corners of a picture; `None` if there are none. The first corner
    /// has the lower coordinates.
    pub(super) fn between([least, most]: [Vec2; 2], width: u32, height: u32) -> Option<Self> {
        // A conversion turns negative numbers into 0.
        let clamp = |x: f32, end: u32| (x as u32).min(end);
        let rect = Self {
            left: clamp(least.x, width),
            top: clamp(least.y, height),
            right: clamp(most.x + 1.0, width),
            bottom: clamp(most.y + 1.0, height),
        };
        (rect.left < rect.right && rect.top < rect.bottom).then_some(rect)
    }

    /// Returns the smallest rectangle around two.
    pub fn union(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }
}

/// An 8-bit mask that remembers which parts have been touched.
#[derive(Clone, Debug)]
pub struct Coverage {
    mask: Mask,
    touched: Touched,
    /// The greatest coverage of strokes, from 0 to 1.
    strength: f32,
}

/// The tiles of a picture that have been touched.
#[derive(Clone, Debug)]
struct Touched {
    columns: u32,
    tiles: Vec<bool>,
}

/// The side of a tile in pixels: small enough that a thin front of growth touches few tiles, and large enough that a
/// tile is worth a call.
const TILE: u32 = 32;

impl Coverage {
    /// Makes an empty mask; `None` if it would have no pixels.
    pub fn new(width: u32, height: u32) -> Option<Self> {
        let mask = Mask::new(width, height)?;
        let columns = width.div_ceil(TILE);
        let tiles = vec![false; (columns * height.div_ceil(TILE)) as usize];
        Some(Self { mask, touched: Touched { columns, tiles }, strength: 1.0 })
    }

    /// Returns the mask.
    pub fn mask(&self) -> &Mask {
        &self.mask
    }

    /// Returns the parts that were drawn on since the last call, as rectangles that do not overlap.
    pub fn take_touched(&mut self) -> Vec<Rect> {
        let bounds = self.bounds();
        let mut rects: Vec<Rect> = Vec::new();
        for (tile, touched) in (0..).zip(&mut self.touched.tiles) {
            if !std::mem::take(touched) {
                continue;
            }
            let (left, top) = (tile % self.touched.columns * TILE, tile / self.touched.columns * TILE);
            let (right, bottom) = ((left + TILE).min(bounds.right), (top + TILE).min(bounds.bottom));
            match rects.last_mut() {
                Some(run) if run.top == top && run.right == left => run.right = right,
                _ => rects.push(Rect { left, top, right, bottom }),
            }
        }
        rects
    }

    /// Reduces the coverage of pixels by shares in 255ths.
    pub fn take_away(&mut self, pixels: impl Iterator<Item = (usize, u8)>) {
        let mask = self.mask.data_mut();
        for (i, away) in pixels {
            let Some(pixel) = mask.get_mut(i) else { return };
            *pixel = ((u32::from(*pixel) * (255 - u32::from(away)) + 127) / 255) as u8;
        }
    }

    /// Reduces the coverage in a rectangle by shares, row by row.
    pub fn take_away_shares(&mut self, rect: Rect, rows: impl Iterator<Item = impl Iterator<Item = f32>>) {
        let width = self.mask.width() as usize;
        for (row, shares) in (rect.top as usize..).zip(rows) {
            let pixels = &mut self.mask.data_mut()[row * width + rect.left as usize..row * width + rect.right as usize];
            for (pixel, share) in pixels.iter_mut().zip(shares).filter(|(pixel, share)| **pixel > 0 && *share > 0.0) {
                *pixel = (f32::from(*pixel) * (1.0 - share) + 0.5) as u8;
            }
        }
    }

    /// Raises the coverage in a rectangle to shares of a strength, row by row, where it is lower.
    pub fn add_shares(&mut self, rect: Rect, rows: impl Iterator<Item = impl Iterator<Item = f32>>, strength: f32) {
        let width = self.mask.width() as usize;
        for (row, shares) in (rect.top as usize..).zip(rows) {
            let pixels = &mut self.mask.data_mut()[row * width + rect.left as usize..row * width + rect.right as usize];
            for (pixel, share) in pixels.iter_mut().zip(shares).filter(|(_, share)| *share > 0.0) {
                *pixel = (*pixel).max((share * strength * 255.0 + 0.5) as u8);
            }
        }
    }

    /// Raises the coverage of pixels to that in another mask of the same size, where it is lower.
    pub fn add(&mut self, other: &Self) {
        let mask = self.mask.data_mut();
        for (i, share) in Covered::by(other.mask.data()) {
            let Some(pixel) = mask.get_mut(i) else { return };
            *pixel = (*pixel).max(share);
        }
    }

    /// Marks everything as touched.
    pub fn touch_all(&mut self) {
        self.touched.tiles.fill(true);
    }

    /// Returns the rectangle of the whole mask.
    pub fn bounds(&self) -> Rect {
        Rect { left: 0, top: 0, right: self.mask.width(), bottom: self.mask.height() }
    }

    /// Empties the mask. The caller keeps track of the parts that were touched.
    pub fn clear(&mut self) {
        self.mask.clear();
    }

    /// Sets the greatest coverage of further strokes, from 0 to 1: lower for things that have faded.
    pub fn set_strength(&mut self, strength: f32) {
        self.strength = strength;
    }

    /// Draws a line from `a` to `b` with round ends. Its radius runs from `radius_a` to `radius_b`, in pixels.
    ///
    /// A line thinner than a pixel is drawn one pixel wide and paler.
    pub fn capsule(&mut self, a: Vec2, radius_a: f32, b: Vec2, radius_b: f32) {
        if radius_a <= 0.0 && radius_b <= 0.0 {
            return;
        }
        let margin = rim(larger(radius_a, radius_b));
        let Some(rect) = Rect::between([a.min(b) - margin, a.max(b) + margin], self.mask.width(), self.mask.height())
        else {
            return;
        };
        self.touch(rect);
        let stroke = Stroke::new(a, radius_a, b, radius_b, self.strength);
        let width = self.mask.width() as usize;
        for y in rect.top..rect.bottom {
            let start = y as usize * width;
            let row = &mut self.mask.data_mut()[start + rect.left as usize..start + rect.right as usize];
            stroke.cover(row, rect.left as f32 - a.x, y as f32 + HALF - a.y);
        }
    }

    /// Fills the area within an odd number of rings, whose points are in pixels.
    pub fn fill(&mut self, rings: &[Vec<Vec2>]) {
        /// The number of lines across each row of pixels on which the area is measured.
        const LINES: u8 = 8;
        let corners = || rings.iter().flatten().copied();
        let least = corners().fold(Vec2::MAX, Vec2::min);
        let most = corners().fold(Vec2::MIN, Vec2::max);
        let Some(rect) = Rect::between([least, most], self.mask.width(), self.mask.height()) else { return };
        self.touch(rect);
        let mut shares = vec![0.0; (rect.right - rect.left) as usize];
        let upper = |[a, b]: &[Vec2; 2]| if a.y < b.y { a.y } else { b.y };
        let lower = |[a, b]: &[Vec2; 2]| larger(a.y, b.y);
        let all: Vec<[Vec2; 2]> = sides(rings).collect();
        // The sides that begin in rows to come, the next ones last, and those that have begun and not ended.
        let (mut waiting, mut near) = (sort::sorted_by(&all, |side| sort::key(-upper(side))), Vec::new());
        for row in rect.top..rect.bottom {
            shares.fill(0.0);
            near.retain(|side| lower(side) > row as f32);
            while let Some(side) = waiting.pop_if(|side| upper(side) < (row + 1) as f32) {
                near.push(side);
            }
            for line in 0..LINES {
                let y = row as f32 + (f32::from(line) + HALF) / f32::from(LINES);
                for [from, to] in stretches_between(near.iter().copied(), y) {
                    cover(&mut shares, from - rect.left as f32, to - rect.left as f32, 1.0 / f32::from(LINES));
                }
            }
            let row = Rect { top: row, bottom: row + 1, ..rect };
            self.add_shares(row, std::iter::once(shares.iter().map(|share| share.min(1.0))), self.strength);
        }
    }

    fn touch(&mut self, rect: Rect) {
        for row in rect.top / TILE..=(rect.bottom - 1) / TILE {
            for column in rect.left / TILE..=(rect.right - 1) / TILE {
                self.touched.tiles[(row * self.touched.columns + column) as usize] = true;
            }
        }
    }
}

/// Adds a weight to the pixels of a row between two places, as far as they lie between them.
fn cover(shares: &mut [f32], from: f32, to: f32, weight: f32) {
    let (from, to) = (from.max(0.0), to.min(shares.len() as f32));
    for (i, share) in shares.iter_mut().enumerate().take(to.ceil() as usize).skip(from as usize) {
        let (left, right) = (i as f32, i as f32 + 1.0);
        *share += weight * (to.min(right) - from.max(left)).max(0.0);
    }
}

/// The pixels that a mask covers, each with its index and coverage. Most masks are mostly empty, so many pixels are
/// skipped at a time.
pub(super) struct Covered<'a> {
    mask: &'a [u8],
    next: usize,
}

impl<'a> Covered<'a> {
    pub fn by(mask: &'a [u8]) -> Self {
        Self { mask, next: 0 }
    }
}

impl Iterator for Covered<'_> {
    type Item = (usize, u8);

    #[inline(never)]
    fn next(&mut self) -> Option<(usize, u8)> {
        const MANY: usize = 16;
        while let Some((&covered, _)) = self.mask.get(self.next..).and_then(<[u8]>::split_first) {
            if self.mask[self.next..].starts_with(&[0; MANY]) {
                self.next += MANY;
                continue;
            }
            self.next += 1;
            if covered > 0 {
                return Some((self.next - 1, covered));
            }
        }
        None
    }
}

const HALF: f32 = 0.5;

/// Returns the distance from its middle line at which a stroke of a radius ends.
fn rim(radius: f32) -> f32 {
    larger(radius, HALF) + HALF
}

/// Returns the greater of two numbers. `f32::max` also handles NaN and compiles to several jumps in wasm.
fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// A capsule, prepared for four pixels at a time. Values are fields where possible, not constants in the inner loop: V8
/// would compute those again for every four pixels.
struct Stroke {
    along_x: f32x4,
    along_y: f32x4,
    per_squared_length: f32x4,
    /// The distances from the middle line at which coverage ends, at both ends.
    rim_a: f32x4,
    rim_b: f32x4,
    /// The square of the greater one.
    squared_rim: f32x4,
    /// The greatest coverage at both ends, in 255ths.
    most_a: f32x4,
    most_b: f32x4,
}

impl Stroke {
    fn new(a: Vec2, radius_a: f32, b: Vec2, radius_b: f32, strength: f32) -> Self {
        let along = b - a;
        let squared = along.x * along.x + along.y * along.y;
        let most = |radius: f32| f32x4::splat(strength * if radius > HALF { 255.0 } else { radius * 510.0 });
        let (rim_a, rim_b) = (rim(radius_a), rim(radius_b));
        let rim = larger(rim_a, rim_b);
        Self {
            along_x: f32x4::splat(along.x),
            along_y: f32x4::splat(along.y),
            per_squared_length: f32x4::splat(if squared > 0.0 { 1.0 / squared } else { 0.0 }),
            rim_a: f32x4::splat(rim_a),
            rim_b: f32x4::splat(rim_b),
            squared_rim: f32x4::splat(rim * rim),
            most_a: most(radius_a),
            most_b: most(radius_b),
        }
    }

    /// Raises the pixels of a row to this stroke's coverage. The row starts at column `left`.
    #[inline]
    fn cover(&self, row: &mut [u8], left: f32, dy: f32) {
        /// Adding this to a small number leaves the nearest whole number in the lowest bits.
        const ALL_FRACTION: f32 = 8_388_608.0;
        let dy = f32x4::splat(dy);
        let mut dx = f32x4::new([0.5, 1.5, 2.5, 3.5]) + f32x4::splat(left);
        for pixels in row.chunks_mut(4) {
            let (t, squared_distance) = self.nearest(dx, dy);
            dx += f32x4::splat(4.0);
            // Most of the box around a slanted line is empty.
            if squared_distance.simd_lt(self.squared_rim).none() {
                continue;
            }
            let coverage = (self.coverage(t, squared_distance.sqrt()) + f32x4::splat(ALL_FRACTION)).to_array();
            for (pixel, coverage) in pixels.iter_mut().zip(coverage) {
                *pixel = (*pixel).max(coverage.to_bits() as u8);
            }
        }
    }

    /// Returns for four pixels at (dx, dy) from `a` the position of the nearest point on the middle line, from 0 at `a`
    /// to 1 at `b`, and the squared distance to it.
    #[inline]
    fn nearest(&self, dx: f32x4, dy: f32x4) -> (f32x4, f32x4) {
        let t = (dx * self.along_x + dy * self.along_y) * self.per_squared_length;
        let t = t.fast_max(f32x4::ZERO).fast_min(f32x4::ONE);
        let (off_x, off_y) = (dx - self.along_x * t, dy - self.along_y * t);
        (t, off_x * off_x + off_y * off_y)
    }

    /// Computes the coverage of four pixels in 255ths.
    #[inline]
    fn coverage(&self, t: f32x4, distance: f32x4) -> f32x4 {
        // Two products instead of a + (b − a)·t, so that the result cannot fall when a radius grows.
        let rest = f32x4::ONE - t;
        let rim = self.rim_a * rest + self.rim_b * t;
        let most = self.most_a * rest + self.most_b * t;
        (rim - distance).fast_max(f32x4::ZERO).fast_min(f32x4::ONE) * most
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Vec2> {
        (-10.0f32..50.0, -10.0f32..50.0).prop_map(Vec2::from)
    }

    fn drawn(strokes: &[(Vec2, f32, Vec2, f32)]) -> Vec<u8> {
        let mut coverage = Coverage::new(40, 30).unwrap();
        strokes.iter().for_each(|&(a, ra, b, rb)| coverage.capsule(a, ra, b, rb));
        coverage.mask().data().to_vec()
    }

    #[test]
    fn wide_line_is_full_inside_and_empty_outside() {
        let mask = drawn(&[(Vec2::new(10.0, 15.0), 4.0, Vec2::new(30.0, 15.0), 4.0)]);
        assert_eq!((mask[15 * 40 + 20], mask[12 * 40 + 20], mask[5 * 40 + 20], mask[15 * 40 + 3]), (255, 255, 0, 0));
    }

    #[test]
    fn hairline_pales_with_its_width() {
        let sum = |radius| {
            drawn(&[(Vec2::new(5.0, 15.3), radius, Vec2::new(35.0, 15.3), radius)])
                .iter()
                .map(|&c| f64::from(c))
                .sum::<f64>()
        };
        assert!((sum(0.5) / sum(0.125) - 4.0).abs() < 0.1);
        assert!(sum(0.0) == 0.0);
    }

    #[test]
    fn what_has_faded_covers_less_and_hides_nothing() {
        let (a, b) = (Vec2::new(10.0, 15.0), Vec2::new(30.0, 15.0));
        let drawn = |strengths: &[f32]| {
            let mut coverage = Coverage::new(40, 30).unwrap();
            for &strength in strengths {
                coverage.set_strength(strength);
                coverage.capsule(a, 4.0, b, 4.0);
            }
            coverage.mask().data()[15 * 40 + 20]
        };
        assert_eq!([drawn(&[0.4]), drawn(&[1.0, 0.4]), drawn(&[0.4, 1.0])], [102, 255, 255]);
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn order_does_not_matter(a in point(), b in point(), c in point(), r in 0.0f32..6.0, s in 0.0f32..6.0) {
            let (first, second) = ((a, r, b, s), (b, s, c, r));
            prop_assert_eq!(drawn(&[first, second]), drawn(&[second, first, second]));
        }

        #[test]
        fn wider_stroke_covers_all_that_a_narrower_one_did(
            a in point(), b in point(), r in 0u8..80, s in 0u8..80, more_r in 0u8..20, more_s in 0u8..20,
        ) {
            let sixteenths = |n: u8| f32::from(n) / 16.0;
            let narrow = (a, sixteenths(r), b, sixteenths(s));
            let wide = (a, sixteenths(r + more_r), b, sixteenths(s + more_s));
            prop_assert_eq!(drawn(&[narrow, wide]), drawn(&[wide]));
        }

        #[test]
        fn everything_drawn_is_touched(a in point(), b in point(), r in 0.0f32..6.0) {
            let mut coverage = Coverage::new(40, 30).unwrap();
            coverage.capsule(a, r, b, r);
            let touched = coverage.take_touched();
            for (i, &pixel) in coverage.mask().data().iter().enumerate() {
                let (x, y) = (i as u32 % 40, i as u32 / 40);
                let inside = touched.iter().any(|t| (t.left..t.right).contains(&x) && (t.top..t.bottom).contains(&y));
                prop_assert!(pixel == 0 || inside);
            }
        }
    }
}
