//! What rivers are drawn on: paper, and where there is a sea, its tint, rings along the coast and the coast itself.

use glam::Vec2;

use super::coverage::Coverage;
use super::view::View;
use crate::land::Land;

/// Bare paper, which is land.
pub(super) const PAPER: [u8; 3] = [0xf6, 0xf0, 0xe2];
const SEA: [u8; 3] = [0xdd, 0xe6, 0xe4];
const COAST: [u8; 3] = [0x4a, 0x62, 0x78];
const RIDGE: [u8; 3] = [0xa8, 0x93, 0x78];

/// Distances from the coast of the rings that old engravers drew, in units, each fainter than the one before.
const RINGS: [(f32, f32); 3] = [(7.0, 0.34), (16.0, 0.2), (28.0, 0.1)];
const RING_WIDTH: f32 = 1.1;
/// No line lies farther out at sea than this, in units.
const OUTERMOST: f32 = RINGS[RINGS.len() - 1].0 + RING_WIDTH;
const COAST_WIDTH: f32 = 1.8;
const RIDGE_WIDTH: f32 = 3.0;

/// Paints the ground of a picture, row by row, opaque.
pub(super) fn ground(view: &View, land: &Land) -> Vec<[u8; 4]> {
    let ridges = ridges(view, land);
    let (width, height) = (view.width as usize, view.height as usize);
    let mut pixels = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            let at = view.point(Vec2::new(x as f32, y as f32) + 0.5);
            let colour = shore(view.scale, land.relief().height(at));
            let ridge = ridges.as_ref().map_or(0, |ridges| ridges.mask().data()[y * width + x]);
            let [r, g, b] = mix(colour, RIDGE, f32::from(ridge) / 255.0);
            pixels.push([r, g, b, 255]);
        }
    }
    pixels
}

/// The colour at a distance from the coast, in units, land being positive.
fn shore(scale: f32, distance: f32) -> [u8; 3] {
    // Most of a map lies beyond all lines, where the colour is plain.
    let blur = 1.0 / scale;
    if distance > COAST_WIDTH + blur {
        return PAPER;
    }
    if distance < -(OUTERMOST + blur) {
        return SEA;
    }
    let line = |centre: f32, width: f32| line(scale, distance - centre, width);
    let land = ((distance * scale) + 0.5).max(0.0).min(1.0);
    let mut colour = mix(SEA, PAPER, land);
    for (at, strength) in RINGS {
        colour = mix(colour, COAST, line(-at, RING_WIDTH) * strength);
    }
    mix(colour, COAST, line(0.0, COAST_WIDTH))
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
