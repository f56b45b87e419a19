//! The skeleton: white lines, one pixel wide, on black, as the paper's user study showed its patterns (figure 6.1).

use tiny_skia::Pixmap;

use super::coverage::Coverage;
use super::thin::thin;

/// The width that rivers are drawn with before they are thinned: enough that no line has a gap.
pub(super) const WIDTH_PX: f32 = 1.5;

/// Thins the mask and shows it. The whole picture at once: thinning at one place can depend on any other.
pub(super) fn compose(pixmap: &mut Pixmap, coverage: &Coverage) {
    let mut mask = coverage.mask().data().to_vec();
    thin(&mut mask, coverage.mask().width() as usize);
    for (pixel, &mask) in pixmap.data_mut().chunks_exact_mut(4).zip(&mask) {
        pixel.copy_from_slice(&[mask, mask, mask, 255]);
    }
}
