//! The picture beyond the map: the sea continues, and land ends.

use glam::Vec2;

use super::palette::{Palette, mix};
use super::view::{Rows, View};
use crate::land::Land;

/// The distance over which the sea deepens beyond the map, in units: the same as from any coast.
pub(super) const WIDENED: f32 = 160.0;

/// Where the border lies farther than this from any coast, in units, the end of the map is not visible.
const FAR: f32 = 60.0;

/// Paints the area beyond the map in some rows of a ground. `land` is `None` if all of the map is land.
pub(super) fn lay(view: &View, land: Option<&Land>, palette: &Palette, rows: Rows, pixels: &mut [[u8; 4]]) {
    // Beside the map, all pixels of a row have the same nearest point of the border.
    let (mut nearest, mut share) = (Vec2::NAN, 0.0);
    for_each(view, rows, pixels, |pixel, border| {
        if border != nearest {
            let height = land.map_or(f32::MAX, |land| land.coast_distance().height(border));
            (nearest, share) = (border, (-height / FAR).clamp(0.0, 1.0));
        }
        let [r, g, b, _] = *pixel;
        let [r, g, b] = mix(palette.deep, [r, g, b], share);
        *pixel = [r, g, b, 0];
    });
}

/// Calls `end` for each pixel of some rows that lies beyond the map, with the nearest point of the map's border.
pub(super) fn for_each<Pixel>(view: &View, rows: Rows, pixels: &mut [Pixel], mut end: impl FnMut(&mut Pixel, Vec2)) {
    for (y, row) in rows.zip(pixels.chunks_mut(view.width as usize)) {
        let border_near = |x: usize| view.border_near(view.point(Vec2::new(x as f32, y as f32) + 0.5));
        // The pixels within the map are contiguous: first those on their left are visited, then those on their right.
        let (mut start, mut rest) = (0, row.len());
        while let Some(border) = (start < rest).then(|| border_near(start)).flatten() {
            end(&mut row[start], border);
            start += 1;
        }
        while let Some(border) = (start < rest).then(|| border_near(rest - 1)).flatten() {
            rest -= 1;
            end(&mut row[rest], border);
        }
    }
}
