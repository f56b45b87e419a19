//! What lies around rivers: a light edge, or a glow.

use super::Sheet;
use crate::paint::coverage::Rect;
use crate::paint::palette::{Casing, mix};

/// So many boxes are nearly a bell.
const BOXES: u32 = 3;

/// Lays a casing or a glow around rivers, which were drawn as wide as it begins.
pub(super) fn lay(casing: &Casing, sheet: &Sheet<'_>, pixels: &mut [[u8; 4]]) {
    let radius = (casing.blur * sheet.view.scale).round() as u32;
    let Some(rect) = sheet.touched.map(|rect| grown(rect, BOXES * radius, sheet)) else { return };
    let (columns, stride) = (rect.left as usize..rect.right as usize, sheet.view.width as usize);
    let (width, height) = (columns.len(), (rect.bottom - rect.top) as usize);
    let rows = |row: u32| row as usize * stride + columns.start..row as usize * stride + columns.end;
    let mut mask = Vec::with_capacity(width * height);
    (rect.top..rect.bottom).for_each(|row| mask.extend_from_slice(&sheet.rivers[rows(row)]));
    if radius > 0 {
        mask = blurred_and_turned(&mask, width, height, radius as usize);
        mask = blurred_and_turned(&mask, height, width, radius as usize);
    }
    // A blur spreads what it takes, which is made up for.
    let gain = if radius > 0 { casing.gain } else { 1.0 };
    for (row, mask) in (rect.top..rect.bottom).zip(mask.chunks(width)) {
        for (pixel, &covered) in pixels[rows(row)].iter_mut().zip(mask).filter(|(_, covered)| **covered > 0) {
            let [r, g, b, open] = *pixel;
            let share = (f32::from(covered) / 255.0 * gain).min(1.0) * casing.strength * f32::from(open) / 255.0;
            let [r, g, b] = mix([r, g, b], casing.colour, share);
            *pixel = [r, g, b, open];
        }
    }
}

/// The pixels that a blur of what is touched reaches.
fn grown(rect: Rect, reach: u32, sheet: &Sheet<'_>) -> Rect {
    Rect {
        left: rect.left.saturating_sub(reach),
        top: rect.top.saturating_sub(reach),
        right: (rect.right + reach).min(sheet.view.width),
        bottom: (rect.bottom + reach).min(sheet.view.height),
    }
}

/// Each row blurred, rows become columns.
fn blurred_and_turned(mask: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let mut turned = vec![0; mask.len()];
    // With room for nothing on both sides.
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

/// The mean of the pixels that are no farther than a radius, of each in a row that has a radius more on both sides.
fn blur(row: &[u8], radius: usize, blurred: &mut [u8]) {
    let whole = (2 * radius + 1) as u32;
    // A multiplication for a division, of at most 255 times that.
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

    /// What a white glow on black looks like around two strokes, one at the edge, if it is laid within some pixels; and their mask.
    fn glow(side: u32, within: impl Fn(&mut Coverage) -> Rect) -> (Vec<u8>, Vec<u8>) {
        let view = View::new(&Domain::with_aspect(1.0), side, side).unwrap();
        let mut mask = Coverage::new(side, side).unwrap();
        for (from, to) in [((420.0, 500.0), (520.0, 560.0)), ((300.0, -1.0), (340.0, 3.0))] {
            mask.capsule(view.pixel(Vec2::from(from)), 1.2, view.pixel(Vec2::from(to)), 0.9);
        }
        let touched = Some(within(&mut mask));
        let sheet = Sheet { view: &view, plain: [0; 3], land: &[], rivers: mask.mask().data(), touched };
        let casing = Casing { colour: [255; 3], strength: 1.0, margin: 0.0, blur: 2.0, gain: 2.5 };
        let mut pixels = vec![[0, 0, 0, 255]; view.pixels()];
        lay(&casing, &sheet, &mut pixels);
        (pixels.iter().map(|pixel| pixel[0]).collect(), mask.mask().data().to_vec())
    }

    #[test]
    fn a_glow_is_blurred_where_it_is_as_in_the_whole_picture() {
        // No pixel larger than it must be: tiles have room to spare.
        let touched = |mask: &mut Coverage| {
            let covered = mask.mask().data().iter().enumerate().filter(|(_, covered)| **covered > 0);
            let pixels = covered.map(|(i, _)| ((i % 900) as u32, (i / 900) as u32));
            let rects = pixels.map(|(x, y)| Rect { left: x, top: y, right: x + 1, bottom: y + 1 });
            rects.reduce(Rect::union).unwrap()
        };
        let ((part, mask), (whole, _)) = (glow(900, touched), glow(900, |mask| mask.bounds()));
        assert!(part == whole);
        let count = |pixels: &[u8]| pixels.iter().filter(|&&light| light > 0).count();
        assert!(count(&part) > 2 * count(&mask), "{} pixels of {}", count(&part), count(&mask));
    }

    #[test]
    fn a_glow_too_small_to_be_blurred_is_no_stronger_than_its_mask() {
        let (light, mask) = glow(200, |mask| mask.bounds());
        assert!(light == mask);
    }
}
