//! Contours: thin lines of one height each, every fifth of them stronger.
//!
//! They are not traced. A pixel's distance from the nearest level follows from how high and how steep the surface is there.

use glam::Vec2;

use super::Sheet;
use super::field::{Field, Place, places};
use crate::paint::palette::{Contours, mix};
use crate::relief::{CELL_SIZE, METRES, Relief};

/// How often heights are smoothed before: at valley floors lines would be sharper than any surveyor draws them.
const TIMES: u32 = 4;

/// One line in so many is an index line.
pub(crate) const INDEX: u32 = 5;

/// How far apart contours are, in units of height: a round number of metres. `highest` is what has the colour of the highest land.
pub(crate) fn interval(highest: f32) -> f32 {
    const MOST: f32 = 26.0;
    const METRES_APART: [f32; 9] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0];
    let least = highest * METRES / MOST;
    METRES_APART.into_iter().find(|apart| *apart >= least).unwrap_or(5000.0) / METRES
}

/// The heights of a relief, counted in contours.
pub(super) fn levels(relief: &Relief, highest: f32) -> Field {
    let interval = interval(highest);
    Field::of(relief, |height| height / interval).smoothed(TIMES)
}

/// Lays the contours of a relief over the land of a ground, broken where rivers run.
pub(super) fn lay(look: &Contours, field: &Field, sheet: &Sheet<'_>, pixels: &mut [[u8; 4]]) {
    let (places, width) = (places(sheet.view, field.columns), sheet.view.width as usize);
    let cell_px = CELL_SIZE * sheet.view.scale;
    let lines = [0, 1].map(|i| Line::new(look.widths[i] * sheet.view.scale, look.strengths[i], [1.0, INDEX as f32][i]));
    let (mut heights, mut rises) = (Vec::new(), Vec::new());
    for (y, row) in pixels.chunks_mut(width).enumerate() {
        let at = sheet.view.point(Vec2::splat(y as f32 + 0.5)).y;
        field.line(at, false, &mut heights);
        field.line(at, true, &mut rises);
        let (land, rivers) = (&sheet.land[y * width..][..width], &sheet.rivers[y * width..][..width]);
        for ((pixel, &Place { column, along }), (&land, &rivers)) in
            row.iter_mut().zip(&places).zip(land.iter().zip(rivers))
        {
            let height = heights[column].at(along);
            let level = (height + 0.5) as u32;
            if level == 0 || land == 0 || rivers == 255 {
                continue;
            }
            let squared = Vec2::new(heights[column].rise(along), rises[column].at(along)).length_squared().max(1e-8);
            let line = &lines[usize::from(level.is_multiple_of(INDEX))];
            let (off, rim) = ((height - level as f32) * cell_px, line.half + 0.5);
            // Most pixels are on no line.
            if off * off > rim * rim * squared {
                continue;
            }
            let spacing = cell_px / squared.sqrt();
            let covered = line.coverage((height - level as f32).abs() * spacing, spacing);
            let open = f32::from(land) * f32::from(255 - rivers);
            let [r, g, b, rest] = *pixel;
            let [r, g, b] = mix([r, g, b], look.colour, covered * open / (255.0 * 255.0));
            *pixel = [r, g, b, rest];
        }
    }
}

/// One kind of line.
struct Line {
    /// Half of its width in pixels, and how much of a pixel in its middle it covers.
    half: f32,
    strength: f32,
    /// How many levels apart such lines are.
    apart: f32,
}

impl Line {
    fn new(width: f32, strength: f32, apart: f32) -> Self {
        /// In pixels: a thinner line would be broken.
        const LEAST: f32 = 0.7;
        let width = width.max(LEAST);
        Self { half: width * 0.5, strength: strength * width.min(1.0), apart }
    }

    /// How much it covers a pixel at a distance; `spacing` is that of the levels, both in pixels. Where lines of its kind would run
    /// together, they are left out.
    #[inline]
    fn coverage(&self, distance: f32, spacing: f32) -> f32 {
        let room = (spacing * self.apart * 0.5 - self.half * 2.0).clamp(0.0, 1.0);
        (self.half + 0.5 - distance).clamp(0.0, 1.0) * self.strength * room
    }
}
