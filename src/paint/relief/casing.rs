//! What lies around rivers: a light edge, or a glow.

use crate::paint::palette::{Casing, mix};
use crate::paint::view::View;

/// Lays a casing or a glow around rivers, which were drawn as wide as it begins.
pub(super) fn lay(view: &View, mut mask: Vec<u8>, casing: &Casing, pixels: &mut [[u8; 4]]) {
    let (width, height) = (view.width as usize, view.height as usize);
    let radius = (casing.blur * view.scale).round() as usize;
    if radius > 0 {
        // Three boxes are nearly a bell.
        for _ in 0..3 {
            mask = blurred_and_turned(&mask, width, height, radius);
            mask = blurred_and_turned(&mask, height, width, radius);
        }
    }
    for (pixel, &covered) in pixels.iter_mut().zip(&mask).filter(|(_, covered)| **covered > 0) {
        let [r, g, b, open] = *pixel;
        let share = (f32::from(covered) / 255.0 * casing.gain).min(1.0) * casing.strength * f32::from(open) / 255.0;
        let [r, g, b] = mix([r, g, b], casing.colour, share);
        *pixel = [r, g, b, open];
    }
}

/// The mean of the pixels of each row that are no farther than a radius, rows become columns.
fn blurred_and_turned(mask: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let mut turned = vec![0; mask.len()];
    let whole = (2 * radius + 1) as u32;
    for y in 0..height {
        let row = &mask[y * width..][..width];
        let mut sum: u32 = row.iter().take(radius).map(|&value| u32::from(value)).sum();
        for x in 0..width {
            sum += row.get(x + radius).map_or(0, |&value| u32::from(value));
            turned[x * height + y] = ((sum + whole / 2) / whole) as u8;
            sum -= if x >= radius { u32::from(row[x - radius]) } else { 0 };
        }
    }
    turned
}
