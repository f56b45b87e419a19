//! Ink on paper.

use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Transform};

use super::coverage::{Coverage, Rect};

const PAPER: [u8; 3] = [0xf6, 0xf0, 0xe2];
const INK: [u8; 3] = [0x1f, 0x3f, 0x66];

/// Lays paper and ink on a rectangle of the picture.
pub(super) fn compose(pixmap: &mut Pixmap, coverage: &Coverage, rect: Rect) {
    fill(pixmap, rect, PAPER, None);
    fill(pixmap, rect, INK, Some(coverage));
}

/// Fills a rectangle with a colour, through a mask if there is one.
pub(super) fn fill(pixmap: &mut Pixmap, rect: Rect, [r, g, b]: [u8; 3], through: Option<&Coverage>) {
    let mut paint = Paint { anti_alias: false, ..Paint::default() };
    paint.set_color(Color::from_rgba8(r, g, b, 255));
    let side = |from: u32, to: u32| (from as f32, to as f32);
    let ((left, right), (top, bottom)) = (side(rect.left, rect.right), side(rect.top, rect.bottom));
    if let Some(rect) = tiny_skia::Rect::from_ltrb(left, top, right, bottom) {
        let path = PathBuilder::from_rect(rect);
        pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), through.map(Coverage::mask));
    }
}
