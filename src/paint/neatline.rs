//! Neatlines: a map whose land runs off it ends at a thin line, with paper beyond, where an island lies in its endless sea.
//!
//! A picture of a whole map keeps its size: the line is drawn a little within its edges and covers the map's margin. A picture that
//! shows what lies beyond a map has the line around that. Two lines, a thin inner one and a wider outer one, are the custom of printed
//! maps.

use glam::Vec2;

use super::palette::{Colour, NeatlineLook};
use super::styles::{Scheme, palette};
use super::view::{Rows, View};
use crate::land::{Land, MARGIN, runs_off};
use crate::recipe::Shown;

/// The lines in the margin of a map: their distances from the map and their widths, in units.
pub(crate) const LINES: [(f32, f32); 2] = [(0.0, 0.7), (2.9, 1.5)];

/// The neatline of a picture, in whole pixels, so that it is sharp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Neatline {
    look: NeatlineLook,
    /// The first columns and rows of the map, and those behind its last.
    map: [[i32; 2]; 2],
    /// The first and the last pixel of each line, counted outwards from the map.
    lines: [[i32; 2]; 2],
}

impl Neatline {
    /// Returns the neatline of a map in a view; `None` if it has none there.
    pub fn of(view: &View, scheme: Scheme, land: Option<&Land>) -> Option<Self> {
        let look = palette(scheme).neatline?;
        if !(view.is_framed() || scheme.style.shows(Shown::Neatline)) || !runs_off(view.domain(), land) {
            return None;
        }
        let map = if view.is_framed() { around(view) } else { within(view) };
        Some(Self { look, map, lines: lines(view.scale) })
    }

    /// Paints what lies beyond the map in some rows of a ground. Nothing is land there, and no river is seen.
    pub fn lay(&self, view: &View, rows: Rows, pixels: &mut [[u8; 4]]) {
        self.for_each(view, rows, pixels, &mut |pixel, _, out| {
            let [r, g, b] = self.colour(out);
            *pixel = [r, g, b, 0];
        });
    }

    /// Puts back what lies beyond the map in some rows that have been painted over. `before` are the same rows.
    pub fn restore(&self, view: &View, rows: Rows, before: &[[u8; 4]], pixels: &mut [[u8; 4]]) {
        self.for_each(view, rows, pixels, &mut |pixel, i, _| *pixel = before[i]);
    }

    /// Calls `visit` for each pixel of some rows beyond the map, with its number in them and its distance from the map in pixels, from 1.
    #[inline(never)] // one copy
    fn for_each(
        &self,
        view: &View,
        rows: Rows,
        pixels: &mut [[u8; 4]],
        visit: &mut dyn FnMut(&mut [u8; 4], usize, i32),
    ) {
        let ([[left, top], [right, bottom]], width) = (self.map, view.width as usize);
        // Columns may lie beyond the picture.
        let inside = |column: i32| column.clamp(0, view.width as i32) as usize;
        for ((y, row), first) in rows.zip(pixels.chunks_mut(width)).zip((0..).step_by(width)) {
            let down = (top - y as i32).max(y as i32 - bottom + 1);
            let west = if down > 0 { width } else { inside(left) };
            for x in (0..west).chain(inside(right).max(west)..width) {
                let across = (left - x as i32).max(x as i32 - right + 1);
                visit(&mut row[x], first + x, across.max(down));
            }
        }
    }

    fn colour(&self, out: i32) -> Colour {
        let is_on_line = self.lines.iter().any(|&[first, last]| (first..=last).contains(&out));
        if is_on_line { self.look.line } else { self.look.paper }
    }
}

/// Returns the pixels of a map that lies in a picture.
fn around(view: &View) -> [[i32; 2]; 2] {
    [Vec2::ZERO, view.domain()].map(|corner| view.pixel(corner).round().to_array().map(|at| at as i32))
}

/// Returns the pixels of a picture within its margin.
fn within(view: &View) -> [[i32; 2]; 2] {
    /// The least margin, in pixels, and the most, as a share of the shorter side.
    const LEAST: f32 = 3.0;
    const MOST: f32 = 0.1;
    let (width, height) = (view.width as i32, view.height as i32);
    let most = width.min(height) as f32 * MOST;
    let margin = (MARGIN * view.scale).round().max(LEAST).min(most) as i32;
    [[margin; 2], [width - margin, height - margin]]
}

/// Returns the first and the last pixel of each line. Where there is no room between them for paper, there is only the
/// inner.
fn lines(scale: f32) -> [[i32; 2]; 2] {
    let [inner, outer] = LINES.map(|(at, width)| {
        let first = (at * scale).round() as i32 + 1;
        [first, first + ((width * scale).round() as i32).max(1) - 1]
    });
    if outer[0] > inner[1] + 1 { [inner, outer] } else { [inner; 2] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::recipe::{Choice, Recipe, Style, link};
    use std::sync::Arc;

    fn recipe_and_land(text: &str) -> (Recipe, Option<Arc<Land>>) {
        let recipe = link::read(text).unwrap();
        let land = Land::of(&recipe);
        (recipe, land)
    }

    /// Returns the rows of a picture that is all grey but for its neatline.
    fn framed(text: &str, style: Style, width: u32, height: u32) -> Option<Vec<Vec<[u8; 4]>>> {
        let (recipe, land) = recipe_and_land(text);
        let domain = Domain::of(&recipe);
        let view = View::new(&domain, width, height).unwrap();
        let mut pixels = vec![[128, 128, 128, 255]; view.pixels()];
        Neatline::of(&view, style.into(), land.as_deref())?.lay(&view, 0..height, &mut pixels);
        Some(pixels.chunks(width as usize).map(<[_]>::to_vec).collect())
    }

    #[test]
    fn land_that_runs_off_the_map_ends_at_a_line_on_paper() {
        for text in ["land=rectangle&aspect=1.5", "land=continent&aspect=1.5&seed=kauri", "land=valley&aspect=1.5"] {
            let rows = framed(text, Style::Atlas, 1200, 800).unwrap();
            let look = palette(Style::Atlas.into()).neatline.unwrap();
            let opaque = |[r, g, b]: Colour| [r, g, b, 0];
            for row in [&rows[400], &rows.iter().map(|row| row[600]).collect()] {
                let margin = row.iter().position(|pixel| pixel[3] > 0).unwrap();
                assert!((7..=11).contains(&margin), "{text}: {margin}");
                assert_eq!(row[margin - 1], opaque(look.line), "{text}: the map ends at a line");
                assert_eq!((row[0], row[row.len() - 1]), (opaque(look.paper), opaque(look.paper)), "{text}");
                let (lined, mirrored) = (row.iter().filter(|&&p| p == opaque(look.line)).count(), row.iter().rev());
                assert!((4..=8).contains(&lined) && row.iter().eq(mirrored), "{text}: {lined}");
            }
        }
    }

    #[test]
    fn an_island_has_no_line_around_it() {
        for seed in ["kauri", "tay", "mara"] {
            assert!(framed(&format!("land=island&seed={seed}"), Style::Atlas, 300, 200).is_none());
        }
    }

    #[test]
    fn every_picture_has_room_for_its_map() {
        for (width, height) in [(1, 1), (2, 300), (40, 20), (300, 7)] {
            let rows = framed("land=rectangle", Style::Atlas, width, height).unwrap();
            let left = rows.iter().flatten().filter(|pixel| pixel[3] > 0).count();
            assert!(left * 2 >= rows.len() * rows[0].len(), "{width} x {height}: {left}");
        }
    }

    #[test]
    fn papers_of_line_styles_keep_their_pictures() {
        for &style in Style::ALL {
            let is_framed = framed("land=rectangle", style, 300, 200).is_some();
            assert!(!is_framed || style.has_relief(), "{style:?}");
        }
        assert!(palette(Style::Skeleton.into()).neatline.is_none());
    }
}
