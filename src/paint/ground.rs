//! What rivers are drawn on: paper, and where there is a sea, its tint, rings along the coast and the coast itself.

use glam::Vec2;

use super::coverage::Coverage;
use super::view::View;
use crate::land::{Land, Relief};

/// Bare paper, which is land.
pub(super) const PAPER: [u8; 3] = [0xf6, 0xf0, 0xe2];
const PAPER_PIXEL: [u8; 4] = [PAPER[0], PAPER[1], PAPER[2], 255];
const SEA: [u8; 3] = [0xdd, 0xe6, 0xe4];
const COAST: [u8; 3] = [0x4a, 0x62, 0x78];
const RIDGE: [u8; 3] = [0xa8, 0x93, 0x78];

/// Distances from the coast of the rings that old engravers drew, in units, each fainter than the one before.
const RINGS: [(f32, f32); 3] = [(7.0, 0.34), (16.0, 0.2), (28.0, 0.1)];
const RING_WIDTH: f32 = 1.1;
/// No line lies farther out at sea than this, in units.
const COAST_WIDTH: f32 = 1.8;
const RIDGE_WIDTH: f32 = 3.0;

/// Paints the ground of a picture, row by row, opaque.
pub(super) fn ground(view: &View, land: &Land) -> Vec<[u8; 4]> {
    let shades = Shades::new(view.scale);
    let mut pixels = vec![PAPER_PIXEL; view.width as usize * view.height as usize];
    for (y, row) in pixels.chunks_mut(view.width as usize).enumerate() {
        paint_row(view, land.relief(), &shades, y, row);
    }
    if let Some(ridges) = ridges(view, land) {
        for (pixel, &covered) in pixels.iter_mut().zip(ridges.mask().data()).filter(|(_, covered)| **covered > 0) {
            let [r, g, b, _] = *pixel;
            *pixel = opaque(mix([r, g, b], RIDGE, f32::from(covered) / 255.0));
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
    fn new(scale: f32) -> Self {
        const PER_PIXEL: f32 = 16.0;
        let past = (COAST_WIDTH + 2.0 / scale).max(RING_WIDTH);
        let first = -RINGS[RINGS.len() - 1].0 - past;
        let per_unit = PER_PIXEL * scale;
        let count = ((past - first) * per_unit) as usize + 1;
        let colours = (0..count).map(|i| opaque(shore(scale, first + (i as f32 + 0.5) / per_unit))).collect();
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
fn shore(scale: f32, distance: f32) -> [u8; 3] {
    let land = ((distance * scale) + 0.5).clamp(0.0, 1.0);
    let mut colour = mix(SEA, PAPER, land);
    for (at, strength) in RINGS {
        colour = mix(colour, COAST, line(scale, distance + at, RING_WIDTH) * strength);
    }
    mix(colour, COAST, line(scale, distance, COAST_WIDTH))
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, 255]
}

/// How much a line of a width (both in units) covers a pixel at a distance from it.
fn line(scale: f32, distance: f32, width: f32) -> f32 {
    let half_width_px = width * scale * 0.5 + 0.25;
    (half_width_px + 0.5 - distance.abs() * scale).max(0.0).min(1.0) * (half_width_px * 2.0).min(1.0)
}

fn ridges(view: &View, land: &Land) -> Option<Coverage> {
    if land.ridges().is_empty() {
        return None;
    }
    let mut coverage = Coverage::new(view.width, view.height)?;
    let radius = RIDGE_WIDTH * view.scale * 0.5;
    for pair in land.ridges().iter().flat_map(|ridge| ridge.windows(2)) {
        if land.relief().height(pair[0]) > 0.0 {
            coverage.capsule(view.pixel(pair[0]), radius, view.pixel(pair[1]), radius);
        }
    }
    Some(coverage)
}

fn mix(from: [u8; 3], to: [u8; 3], share: f32) -> [u8; 3] {
    std::array::from_fn(|i| (f32::from(from[i]) + (f32::from(to[i]) - f32::from(from[i])) * share + 0.5) as u8)
}
