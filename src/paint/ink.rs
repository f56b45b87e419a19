//! Ink on paper.
//!
//! A pixel's colour depends on its coverage alone, so there are 256 of them: laying them down is a look-up, several
//! times as fast as a blend through a mask, and repeating it changes nothing.

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Rect};

const PAPER: [u8; 3] = [0xf6, 0xf0, 0xe2];
const INK: [u8; 3] = [0x1f, 0x3f, 0x66];

/// The colour of each coverage, from bare paper to full ink.
static RAMP: [[u8; 4]; 256] = ramp(PAPER, INK);

const fn ramp(from: [u8; 3], to: [u8; 3]) -> [[u8; 4]; 256] {
    let mut ramp = [[255; 4]; 256];
    let mut coverage = 0;
    while coverage < 256 {
        let mut channel = 0;
        while channel < 3 {
            let (from, to) = (from[channel] as usize, to[channel] as usize);
            ramp[coverage][channel] = ((from * (255 - coverage) + to * coverage + 127) / 255) as u8;
            channel += 1;
        }
        coverage += 1;
    }
    ramp
}

/// Colours a rectangle of the picture.
pub(super) fn compose(pixmap: &mut Pixmap, coverage: &Coverage, rect: Rect) {
    let width = pixmap.width() as usize;
    for row in rect.top as usize..rect.bottom as usize {
        let (start, end) = (row * width + rect.left as usize, row * width + rect.right as usize);
        let pixels = pixmap.data_mut()[start * 4..end * 4].chunks_exact_mut(4);
        for (pixel, &coverage) in pixels.zip(&coverage.mask().data()[start..end]) {
            pixel.copy_from_slice(&RAMP[coverage as usize]);
        }
    }
}
