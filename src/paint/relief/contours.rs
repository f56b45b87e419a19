//! Contours: thin lines of equal height, every fifth one stronger.
//!
//! Contours are not traced. The distance of a pixel from the nearest level follows from the height and the slope of the
//! surface there.

use glam::Vec2;

use super::field::{Field, Place, places};
use super::{Sheet, highest};
use crate::paint::palette::{Contours, mix};
use crate::paint::view::{Rows, View};
use crate::relief::Relief;

/// The number of times that heights are smoothed first: on valley floors lines would be sharper than any surveyor draws
/// them.
const TIMES: u32 = 4;

/// The number of contours from one index line to the next.
const INDEX: u32 = 5;

/// Returns the difference in height between contours, in units of height: a round number of metres. `highest` is the
/// height of the highest land, and `metres_up` the metres of a unit of height.
fn interval(highest: f32, metres_up: f32) -> f32 {
    const MOST: f32 = 26.0;
    const METRES_APART: [f32; 9] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0];
    let least = highest * metres_up / MOST;
    METRES_APART.into_iter().find(|apart| *apart >= least).unwrap_or(5000.0) / metres_up
}

/// A contour of a relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contour {
    /// The height, in units.
    pub height: f32,
    /// `true` for every fifth, which is drawn stronger.
    pub is_index: bool,
}

/// Lists the contours of a relief whose units of height are so many metres, the lowest first.
pub fn contours(relief: &Relief, metres_up: f32) -> Vec<Contour> {
    let top = relief.heights().iter().fold(0.0f32, |top, height| top.max(*height));
    let interval = interval(highest(relief), metres_up);
    let contour = |level: u32| Contour { height: level as f32 * interval, is_index: level.is_multiple_of(INDEX) };
    (1..=(top / interval) as u32).map(contour).collect()
}

/// Makes a field of the heights of a relief, in numbers of contours.
fn levels(relief: &Relief, highest: f32, metres_up: f32) -> Field {
    let interval = interval(highest, metres_up);
    Field::of(relief, |height| height / interval).smoothed(TIMES)
}

/// The contours of a relief in a picture, from north to south as far as they have been found.
#[derive(Clone, Debug)]
pub(super) struct ContourLines {
    look: Contours,
    metres_up: f32,
    /// The heights; `None` once all contours are found.
    levels: Option<Field>,
    places: Vec<Place>,
    lines: [Line; 2],
    /// Pixels on land that a line covers, with its coverage where there is no river.
    covered: Vec<(u32, f32)>,
    /// The number of pixels that have been looked at.
    found: usize,
}

impl ContourLines {
    pub fn new((look, metres_up): (Contours, f32), relief: &Relief, highest: f32, view: &View) -> Self {
        let line = |i: usize, apart| Line::new(look.widths[i] * view.scale, look.strengths[i], apart);
        Self {
            look,
            metres_up,
            levels: Some(levels(relief, highest, metres_up)),
            places: places(view, relief.grid()),
            lines: [line(0, 1.0), line(1, INDEX as f32)],
            covered: Vec::new(),
            found: 0,
        }
    }

    /// Returns `true` if they were made for this look, and for so many metres of a unit of height.
    pub fn are(&self, look: &Contours, metres_up: f32) -> bool {
        self.look == *look && self.metres_up == metres_up
    }

    /// Lays the lines over some rows of a ground, broken where rivers run.
    pub fn lay(&mut self, sheet: &Sheet<'_>, rows: Rows, pixels: &mut [[u8; 4]]) {
        let range = sheet.view.range(rows.clone());
        if self.found == range.start {
            rows.for_each(|y| self.find(sheet, y));
            self.found = range.end;
            self.levels.take_if(|_| range.end == sheet.view.pixels());
        }
        let first = self.covered.partition_point(|line| (line.0 as usize) < range.start);
        let here = self.covered[first..].iter().take_while(|line| (line.0 as usize) < range.end);
        for &(i, covered) in here {
            let i = i as usize;
            let open = f32::from(sheet.land[i]) * f32::from(255 - sheet.rivers[i]);
            let pixel = &mut pixels[i - range.start];
            let [r, g, b, rest] = *pixel;
            let [r, g, b] = mix([r, g, b], self.look.colour, covered * open / (255.0 * 255.0));
            *pixel = [r, g, b, rest];
        }
    }

    /// Finds the lines of a row.
    fn find(&mut self, sheet: &Sheet<'_>, y: u32) {
        let Some(field) = &self.levels else { return };
        let at = sheet.view.point(Vec2::splat(y as f32 + 0.5)).y;
        let (heights, rises) = (field.line(at, false), field.line(at, true));
        let (cell_px, range) = (field.grid.cell_size * sheet.view.scale, sheet.view.range(y..y + 1));
        for ((i, &land), &Place { column, along }) in range.clone().zip(&sheet.land[range]).zip(&self.places) {
            let height = heights[column].at(along);
            let level = (height + 0.5) as i32;
            if level <= 0 || land == 0 {
                continue;
            }
            let squared = Vec2::new(heights[column].rise(along), rises[column].at(along)).length_squared().max(1e-8);
            let line = &self.lines[usize::from(level.unsigned_abs().is_multiple_of(INDEX))];
            let (off, rim) = ((height - level as f32) * cell_px, line.half + 0.5);
            // Most pixels are on no line.
            if off * off > rim * rim * squared {
                continue;
            }
            let spacing = cell_px / squared.sqrt();
            let covered = line.coverage((height - level as f32).abs() * spacing, spacing);
            if covered > 0.0 {
                self.covered.push((i as u32, covered));
            }
        }
    }
}

/// One kind of line.
#[derive(Clone, Debug)]
struct Line {
    /// Half the width in pixels, and the coverage of a pixel in the middle of the line.
    half: f32,
    strength: f32,
    /// The number of levels between lines of this kind.
    apart: f32,
}

impl Line {
    fn new(width: f32, strength: f32, apart: f32) -> Self {
        /// The smallest width in pixels: a thinner line would look broken.
        const LEAST: f32 = 0.7;
        let width = width.max(LEAST);
        Self { half: width * 0.5, strength: strength * width.min(1.0), apart }
    }

    /// Returns the coverage of a pixel, given its distance from the line and the spacing of levels, both in pixels.
    /// Lines of one kind are left out where they would run together.
    #[inline]
    fn coverage(&self, distance: f32, spacing: f32) -> f32 {
        let room = (spacing * self.apart * 0.5 - self.half * 2.0).clamp(0.0, 1.0);
        (self.half + 0.5 - distance).clamp(0.0, 1.0) * self.strength * room
    }
}
