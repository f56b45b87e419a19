//! Rivers over their ground.
//!
//! On plain land a pixel's colour depends on its coverage alone, so there are 256 of them: laying them down is a look-up,
//! several times as fast as a blend through a mask. Either way repeating it changes nothing.

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Rect};
use super::palette::{Palette, blend};

/// Colours a rectangle of the picture: rivers on a ground, or on plain land.
pub(super) fn compose(
    pixmap: &mut Pixmap,
    coverage: &Coverage,
    ground: Option<&[[u8; 4]]>,
    palette: &Palette,
    rect: Rect,
) {
    let width = pixmap.width() as usize;
    for row in rect.top as usize..rect.bottom as usize {
        let (start, end) = (row * width + rect.left as usize, row * width + rect.right as usize);
        let pixels = &mut pixmap.data_mut()[start * 4..end * 4];
        let coverage = &coverage.mask().data()[start..end];
        match ground {
            None => on_plain_land(pixels, coverage, palette),
            Some(ground) => on_ground(pixels, coverage, palette, &ground[start..end]),
        }
    }
}

fn on_plain_land(pixels: &mut [u8], coverage: &[u8], palette: &Palette) {
    for (pixel, &coverage) in pixels.chunks_exact_mut(4).zip(coverage) {
        pixel.copy_from_slice(&palette.ramp[coverage as usize]);
    }
}

/// Most of a map has no river: the ground is copied, and many pixels at a time are left at that.
fn on_ground(pixels: &mut [u8], coverage: &[u8], palette: &Palette, ground: &[[u8; 4]]) {
    const MANY: usize = 16;
    pixels.copy_from_slice(ground.as_flattened());
    for ((pixels, coverage), ground) in pixels.chunks_mut(MANY * 4).zip(coverage.chunks(MANY)).zip(ground.chunks(MANY))
    {
        if coverage.iter().fold(0, |any, &coverage| any | coverage) == 0 {
            continue;
        }
        for ((pixel, &coverage), ground) in pixels.chunks_exact_mut(4).zip(coverage).zip(ground) {
            pixel.copy_from_slice(&over(*ground, palette, coverage));
        }
    }
}

/// River of some coverage over a colour.
#[inline]
fn over(ground: [u8; 4], palette: &Palette, coverage: u8) -> [u8; 4] {
    if coverage == 0 {
        return ground;
    }
    let [red, green, blue] = palette.river;
    let over = |from, to| blend(from, to, u32::from(coverage));
    [over(ground[0], red), over(ground[1], green), over(ground[2], blue), 255]
}
