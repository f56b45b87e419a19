//! What rivers are drawn on where there is a sea: land and water by their distance from the coast, rings, the coast
//! itself, ridges.

use glam::Vec2;

use super::coverage::Coverage;
use super::palette::{Colour, Palette, mix};
use super::view::View;
use crate::land::{Land, Relief};

/// Widths of lines, in units.
pub(crate) const RING_WIDTH: f32 = 1.1;
pub(crate) const COAST_WIDTH: f32 = 1.8;
pub(crate) const RIDGE_WIDTH: f32 = 3.0;
const RIDGE_PIECE: f32 = 6.0;

/// Paints the ground of a picture, row by row, opaque.
pub(super) fn ground(view: &View, land: &Land, palette: &Palette) -> Vec<[u8; 4]> {
    let shades = Shades::new(view.scale, palette);
    let mut pixels = vec![opaque(palette.plain); view.width as usize * view.height as usize];
    for (y, row) in pixels.chunks_mut(view.width as usize).enumerate() {
        paint_row(view, land.relief(), &shades, y, row);
    }
    if let Some(ridges) = ridges(view, land) {
        for (pixel, &covered) in pixels.iter_mut().zip(ridges.mask().data()).filter(|(_, covered)| **covered > 0) {
            let [r, g, b, _] = *pixel;
            *pixel = opaque(mix([r, g, b], palette.ridge, f32::from(covered) / 255.0));
        }
    }
    pixels
}

/// Paints a row. Along it the height is linear from one column of the relief's lattice to the next, and far from the
/// coast one colour will do.
fn paint_row(view: &View, relief: &Relief, shades: &Shades, y: usize, row: &mut [[u8; 4]]) {
    let place = |x: usize| view.point(Vec2::new(x as f32, y as f32) + 0.5);
    let mut start = 0;
    while start < row.len() {
        let from = place(start);
        // The pixels whose middles lie before the lattice's next column, and before the picture's end.
        let border = ((from.x / Relief::SPACING).floor() + 1.0) * Relief::SPACING;
        let count = (((border - from.x) * view.scale).ceil().max(1.0) as usize).min(row.len() - start);
        let stretch = &mut row[start..start + count];
        let (left, right) = (relief.height(from), relief.height(place(start + count - 1)));
        match shades.even(left, right) {
            Some(colour) => stretch.fill(colour),
            None => {
                let step = (right - left) / (count - 1).max(1) as f32;
                let mut height = left;
                for pixel in stretch {
                    *pixel = shades.at(height);
                    height += step;
                }
            }
        }
        start += count;
    }
}

/// The colours along the coast by their distance from it, looked up.
struct Shades {
    colours: Vec<[u8; 4]>,
    /// The distance of the first, in units.
    first: f32,
    per_unit: f32,
}

impl Shades {
    fn new(scale: f32, palette: &Palette) -> Self {
        const PER_PIXEL: f32 = 16.0;
        let past = (COAST_WIDTH + 2.0 / scale).max(RING_WIDTH);
        let outermost = palette.rings.last().map_or(0.0, |ring| ring.0);
        let first = -palette.fade.max(outermost + past);
        let last = palette.fade.max(past);
        let per_unit = PER_PIXEL * scale;
        let count = ((last - first) * per_unit) as usize + 1;
        let colours = (0..count).map(|i| opaque(shore(scale, palette, first + (i as f32 + 0.5) / per_unit))).collect();
        Self { colours, first, per_unit }
    }

    fn at(&self, height: f32) -> [u8; 4] {
        let index = ((height - self.first) * self.per_unit).max(0.0) as usize;
        self.colours[index.min(self.colours.len() - 1)]
    }

    /// The one colour between two heights, if there is only one.
    fn even(&self, a: f32, b: f32) -> Option<[u8; 4]> {
        let last = self.first + self.colours.len() as f32 / self.per_unit;
        if a.min(b) >= last {
            return self.colours.last().copied();
        }
        if a.max(b) <= self.first { self.colours.first().copied() } else { None }
    }
}

/// The colour at a distance from the coast, in units, land being positive.
fn shore(scale: f32, palette: &Palette, distance: f32) -> Colour {
    let far = if palette.fade > 0.0 { (distance.abs() / palette.fade).min(1.0) } else { 1.0 };
    let (water, land) = (mix(palette.shallows, palette.deep, far), mix(palette.lowland, palette.inland, far));
    let mut colour = mix(water, land, (distance * scale + 0.5).clamp(0.0, 1.0));
    for (at, strength) in palette.rings {
        colour = mix(colour, palette.coast, line(scale, distance + at, RING_WIDTH) * strength);
    }
    mix(colour, palette.coast, line(scale, distance, COAST_WIDTH))
}

fn opaque([r, g, b]: Colour) -> [u8; 4] {
    [r, g, b, 255]
}

/// How much a line of a width (both in units) covers a pixel at a distance from it.
fn line(scale: f32, distance: f32, width: f32) -> f32 {
    let half_width_px = width * scale * 0.5 + 0.25;
    (half_width_px + 0.5 - distance.abs() * scale).clamp(0.0, 1.0) * (half_width_px * 2.0).min(1.0)
}

fn ridges(view: &View, land: &Land) -> Option<Coverage> {
    if land.ridges().is_empty() {
        return None;
    }
    let mut coverage = Coverage::new(view.width, view.height)?;
    let radius = RIDGE_WIDTH * view.scale * 0.5;
    for pair in land.ridges().iter().flat_map(|ridge| ridge.windows(2)) {
        // A ridge may run out to sea and back: there it is not shown.
        let pieces = (pair[0].distance(pair[1]) / RIDGE_PIECE).ceil().max(1.0);
        for piece in 0..pieces as u32 {
            let at = |end: u32| pair[0].lerp(pair[1], (piece + end) as f32 / pieces);
            if land.relief().height((at(0) + at(1)) * 0.5) > 0.0 {
                coverage.capsule(view.pixel(at(0)), radius, view.pixel(at(1)), radius);
            }
        }
    }
    Some(coverage)
}
