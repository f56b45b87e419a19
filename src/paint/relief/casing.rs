//! The surroundings of rivers: a light edge, or a glow.

use std::ops::Range;

use super::Sheet;
use crate::paint::coverage::{Coverage, Covered, Rect};
use crate::paint::ground::river_share;
use crate::paint::palette::{Casing, mix};
use crate::paint::view::{Rows, View};

/// The number of box blurs in sequence, enough to come close to a Gaussian.
const BOXES: u32 = 3;

/// A mask of rivers that were drawn at the width of their casing, blurred.
#[derive(Clone, Debug)]
pub(super) struct Blurred {
    /// The pixels of the mask.
    rect: Rect,
    mask: Vec<u8>,
}

impl Blurred {
    /// Blurs the mask of rivers. `None` if rivers cover no pixel, or if there is nothing to blur and the mask serves as
    /// it is.
    pub fn new(casing: &Casing, rivers: &mut Coverage, view: &View) -> Option<Self> {
        let radius = (casing.blur * view.scale).round() as usize;
        let touched = rivers.take_touched().into_iter().reduce(Rect::union).filter(|_| radius > 0)?;
        let rect = grown(touched, BOXES * radius as u32, rivers.bounds());
        let (width, height) = ((rect.right - rect.left) as usize, (rect.bottom - rect.top) as usize);
        let mut mask = Vec::with_capacity(width * height);
        for row in rect.top..rect.bottom {
            mask.extend_from_slice(&rivers.mask().data()[in_row(rect, row, view)]);
        }
        mask = blurred_and_turned(&mask, width, height, radius);
        mask = blurred_and_turned(&mask, height, width, radius);
        Some(Self { rect, mask })
    }
}

/// Lays a casing or a glow around the rivers of some rows.
pub(super) fn lay(casing: &Casing, blurred: Option<&Blurred>, sheet: &Sheet<'_>, rows: Rows, pixels: &mut [[u8; 4]]) {
    let first = sheet.view.range(rows.clone());
    let Some(Blurred { rect, mask }) = blurred else {
        return lay_mask(casing, 1.0, &sheet.rivers[first], pixels);
    };
    let width = (rect.right - rect.left) as usize;
    for row in rows.start.max(rect.top)..rows.end.min(rect.bottom) {
        let (from, here) = ((row - rect.top) as usize * width, in_row(*rect, row, sheet.view));
        // A blur spreads coverage and weakens it; the gain makes up for that.
        let pixels = &mut pixels[here.start - first.start..here.end - first.start];
        lay_mask(casing, casing.gain, &mask[from..from + width], pixels);
    }
}

fn lay_mask(casing: &Casing, gain: f32, mask: &[u8], pixels: &mut [[u8; 4]]) {
    for (i, covered) in Covered::by(mask) {
        let [r, g, b, ashore] = pixels[i];
        let seen = f32::from(river_share(ashore)) / 255.0;
        let share = (f32::from(covered) / 255.0 * gain).min(1.0) * casing.strength * seen;
        let [r, g, b] = mix([r, g, b], casing.colour, share);
        pixels[i] = [r, g, b, ashore];
    }
}

/// Returns the pixels of a rectangle that lie in a row.
fn in_row(rect: Rect, row: u32, view: &View) -> Range<usize> {
    let first = view.range(row..row + 1).start;
    first + rect.left as usize..first + rect.right as usize
}

/// Returns the pixels that the blur of a rectangle reaches.
fn grown(rect: Rect, reach: u32, bounds: Rect) -> Rect {
    Rect {
        left: rect.left.saturating_sub(reach),
        top: rect.top.saturating_sub(reach),
        right: (rect.right + reach).min(bounds.right),
        bottom: (rect.bottom + reach).min(bounds.bottom),
    }
}

/// Blurs each row and turns rows into columns.
fn blurred_and_turned(mask: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let mut turned = vec![0; mask.len()];
    // The lines have empty room on both sides.
    let [mut line, mut blurred] = [0, 0].map(|nothing| vec![nothing; width + 2 * radius]);
    for (y, row) in mask.chunks(width).enumerate().filter(|(_, row)| row.iter().any(|&covered| covered > 0)) {
        line[radius..][..width].copy_from_slice(row);
        for _ in 0..BOXES {
            blur(&line, radius, &mut blurred[radius..][..width]);
            std::mem::swap(&mut line, &mut blurred);
        }
        // Most of a row is empty.
        for (x, &covered) in line[radius..][..width].iter().enumerate().filter(|(_, covered)| **covered > 0) {
            turned[x * height + y] = covered;
        }
    }
    turned
}

/// Computes for each pixel of a row the mean of the pixels within a radius. `row` extends beyond both ends by a radius.
fn blur(row: &[u8], radius: usize, blurred: &mut [u8]) {
    let whole = (2 * radius + 1) as u32;
    // A multiplication in place of a division, for sums up to 255 times the divisor.
    let per_whole = (1 << 24) / whole + 1;
    let mut sum: u32 = row[..2 * radius].iter().map(|&value| u32::from(value)).sum();
    for ((blurred, &first), &last) in blurred.iter_mut().zip(row).zip(&row[2 * radius..]) {
        sum += u32::from(last);
        *blurred = (((sum + whole / 2) * per_whole) >> 24) as u8;
        sum -= u32::from(first);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::paint::coverage::Coverage;
    use crate::paint::view::View;
    use glam::Vec2;

    /// Returns the look of a white glow on black around two strokes, one at the edge, and their mask. Blurs the whole
    /// picture, or only the part that rivers touch.
    fn glow(side: u32, blurs_all: bool) -> (Vec<u8>, Vec<u8>) {
        let view = View::new(&Domain::with_aspect(1.0), side, side).unwrap();
        let mut mask = Coverage::new(side, side).unwrap();
        for (from, to) in [((420.0, 500.0), (520.0, 560.0)), ((300.0, -1.0), (340.0, 3.0))] {
            mask.capsule(view.pixel(Vec2::from(from)), 1.2, view.pixel(Vec2::from(to)), 0.9);
        }
        if blurs_all {
            mask.touch_all();
        }
        let casing = Casing { colour: [255; 3], strength: 1.0, margin: 0.0, blur: 2.0, gain: 2.5 };
        let blurred = Blurred::new(&casing, &mut mask, &view);
        let sheet = Sheet { view: &view, plain: [0; 3], land: &[], rivers: mask.mask().data() };
        let mut pixels = vec![[0, 0, 0, 255]; view.pixels()];
        for top in (0..side).step_by(100) {
            let rows = top..(top + 100).min(side);
            lay(&casing, blurred.as_ref(), &sheet, rows.clone(), &mut pixels[view.range(rows)]);
        }
        (pixels.iter().map(|pixel| pixel[0]).collect(), mask.mask().data().to_vec())
    }

    #[test]
    fn a_glow_is_blurred_where_it_is_as_in_the_whole_picture() {
        let ((part, mask), (whole, _)) = (glow(900, false), glow(900, true));
        assert!(part == whole);
        let count = |pixels: &[u8]| pixels.iter().filter(|&&light| light > 0).count();
        assert!(count(&part) > 2 * count(&mask), "{} pixels of {}", count(&part), count(&mask));
    }

    #[test]
    fn a_glow_too_small_to_be_blurred_is_no_stronger_than_its_mask() {
        let (light, mask) = glow(200, false);
        assert!(light == mask);
    }
}
