//! What rivers are drawn on where there is a sea: land and water by their distance from the coast, rings, the coast
//! itself, ridges.

use glam::Vec2;

use super::coverage::{Coverage, Rect};
use super::palette::{Colour, Palette, mix};
use super::view::View;
use crate::land::{Across, Column, Land, Relief};

/// Widths of lines, in units.
pub(crate) const RING_WIDTH: f32 = 1.1;
pub(crate) const COAST_WIDTH: f32 = 1.8;
pub(crate) const RIDGE_WIDTH: f32 = 3.0;
const RIDGE_PIECE: f32 = 6.0;

/// Paints the ground of a picture, row by row, opaque.
pub(super) fn ground(view: &View, land: &Land, palette: &Palette) -> Vec<[u8; 4]> {
    let (relief, shades) = (land.relief(), Shades::new(view.scale, palette));
    let (stretches, mut spans, mut spanned) = (stretches(view, relief), Vec::new(), None);
    let mut pixels = Vec::with_capacity(view.width as usize * view.height as usize);
    for y in 0..view.height {
        let across = relief.across(view.point(Vec2::splat(y as f32 + 0.5)).y);
        // Some rows lie between the same corners.
        if spanned.replace(across.row) != Some(across.row) {
            spans = shades.spans(&stretches, &across);
        }
        for span in &spans {
            match span {
                Span::Even(colour, count) => pixels.resize(pixels.len() + count, *colour),
                Span::Uneven(stretch) => shades.paint(stretch, &across, &mut pixels),
            }
        }
    }
    lay_ridges(view, land, palette, &mut pixels);
    pixels
}

/// Pixels of a row between two columns of the relief's lattice: the height along them is linear.
#[derive(Clone, Copy)]
struct Stretch {
    count: usize,
    /// From the first pixel to the last.
    steps: f32,
    /// Where the middles of the first and the last lie.
    first: Column,
    last: Column,
}

/// The stretches that make a row.
fn stretches(view: &View, relief: &Relief) -> Vec<Stretch> {
    let place = |x: usize| view.point(Vec2::splat(x as f32 + 0.5)).x;
    let (width, mut start) = (view.width as usize, 0);
    let mut stretches = Vec::new();
    while start < width {
        let from = place(start);
        // The pixels whose middles lie before the lattice's next column, and before the picture's end.
        let border = ((from / Relief::SPACING).floor() + 1.0) * Relief::SPACING;
        let count = (((border - from) * view.scale).ceil().max(1.0) as usize).min(width - start);
        let last = relief.column(place(start + count - 1));
        stretches.push(Stretch { count, steps: (count - 1).max(1) as f32, first: relief.column(from), last });
        start += count;
    }
    stretches
}

/// Pixels of a row that are painted together.
enum Span {
    /// So many of one colour: most of a picture is far from any coast.
    Even([u8; 4], usize),
    /// A stretch whose colours have to be looked up.
    Uneven(Stretch),
}

/// The colours along the coast by their distance from it, looked up.
struct Shades {
    colours: Vec<[u8; 4]>,
    /// The distances of the first and past the last, in units.
    first: f32,
    end: f32,
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
        let colour = |i: usize| opaque(shore(scale, palette, first + (i as f32 + 0.5) / per_unit));
        let end = first + count as f32 / per_unit;
        Self { colours: (0..count).map(colour).collect(), first, end, per_unit }
    }

    /// The spans of all rows that lie between two rows of corners.
    fn spans(&self, stretches: &[Stretch], across: &Across<'_>) -> Vec<Span> {
        let mut spans = Vec::new();
        for stretch in stretches {
            match (self.even(across.corners(stretch.first, stretch.last)), spans.last_mut()) {
                (Some(colour), Some(Span::Even(same, count))) if colour == *same => *count += stretch.count,
                (Some(colour), _) => spans.push(Span::Even(colour, stretch.count)),
                (None, _) => spans.push(Span::Uneven(*stretch)),
            }
        }
        spans
    }

    /// Adds the pixels of a stretch.
    fn paint(&self, stretch: &Stretch, across: &Across<'_>, pixels: &mut Vec<[u8; 4]>) {
        let (left, right) = (across.height(stretch.first), across.height(stretch.last));
        if let Some(colour) = self.even([left, right].into_iter()) {
            return pixels.resize(pixels.len() + stretch.count, colour);
        }
        let step = (right - left) / stretch.steps;
        let mut height = left;
        pixels.extend((0..stretch.count).map(|_| {
            let colour = self.at(height);
            height += step;
            colour
        }));
    }

    fn at(&self, height: f32) -> [u8; 4] {
        // What is less than 0 becomes 0.
        let index = ((height - self.first) * self.per_unit) as usize;
        self.colours[index.min(self.colours.len() - 1)]
    }

    /// The one colour between some heights, if there is only one.
    fn even(&self, mut heights: impl Iterator<Item = f32> + Clone) -> Option<[u8; 4]> {
        if heights.clone().all(|height| height >= self.end) {
            return self.colours.last().copied();
        }
        if heights.all(|height| height <= self.first) { self.colours.first().copied() } else { None }
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

/// Paints the ridges over the ground.
fn lay_ridges(view: &View, land: &Land, palette: &Palette, pixels: &mut [[u8; 4]]) {
    let Some(mut ridges) = ridges(view, land) else { return };
    for Rect { left, top, right, bottom } in ridges.take_touched() {
        for row in top..bottom {
            let first = row as usize * view.width as usize;
            let columns = first + left as usize..first + right as usize;
            let covered = &ridges.mask().data()[columns.clone()];
            for (pixel, &covered) in pixels[columns].iter_mut().zip(covered).filter(|(_, covered)| **covered > 0) {
                let [r, g, b, _] = *pixel;
                *pixel = opaque(mix([r, g, b], palette.ridge, f32::from(covered) / 255.0));
            }
        }
    }
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
