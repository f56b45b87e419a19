//! The skeleton: white lines, one pixel wide, on black, as in the patterns of the paper's user study (figure 6.1).
//! Coasts are dim.
//!
//! Thinning at one place can depend on any other place, so only the finished picture is thinned. Before, lines are
//! shown as they were drawn, a pixel or two wide.

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Rect};
use super::ground::river_share;
use super::palette::opaque;
use crate::base::skeletonize::{IS_SET, thin};

/// The width of rivers before thinning: enough that no line has a gap.
pub(super) const WIDTH_PX: f32 = 1.5;

/// Shows a rectangle of the mask without thinning.
pub(super) fn compose(pixmap: &mut Pixmap, coverage: &Coverage, ground: Option<&[[u8; 4]]>, rect: Rect) {
    let width = pixmap.width() as usize;
    for row in rect.top as usize..rect.bottom as usize {
        let (start, end) = (row * width + rect.left as usize, row * width + rect.right as usize);
        let ground = ground.map(|ground| &ground[start..end]);
        show(&mut pixmap.data_mut()[start * 4..end * 4], &coverage.mask().data()[start..end], ground);
    }
}

/// Shows the whole mask, thinned.
pub(super) fn compose_thinned(pixmap: &mut Pixmap, coverage: &Coverage, ground: Option<&[[u8; 4]]>) {
    let mut mask = coverage.mask().data().to_vec();
    thin(&mut mask, coverage.mask().width() as usize);
    show(pixmap.data_mut(), &mask, ground);
}

fn show(pixels: &mut [u8], mask: &[u8], ground: Option<&[[u8; 4]]>) {
    for (i, (pixel, &mask)) in pixels.chunks_exact_mut(4).zip(mask).enumerate() {
        let beneath = ground.map_or([0, 0, 0, 255], |ground| ground[i]);
        // There are no rivers at sea.
        let is_river = mask >= IS_SET && river_share(beneath[3]) >= IS_SET;
        pixel.copy_from_slice(&if is_river { [255; 4] } else { opaque(beneath) });
    }
}
