//! Ink on paper.
//!
//! A pixel's colour depends on its coverage alone, so there are 256 of them: laying them down is a look-up, several
//! times as fast as a blend through a mask, and repeating it changes nothing.

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Rect};
use super::ground::PAPER;

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

/// Colours a rectangle of the picture: ink on a ground, or on bare paper.
pub(super) fn compose(pixmap: &mut Pixmap, coverage: &Coverage, ground: Option<&[[u8; 4]]>, rect: Rect) {
    let width = pixmap.width() as usize;
    for row in rect.top as usize..rect.bottom as usize {
        let (start, end) = (row * width + rect.left as usize, row * width + rect.right as usize);
        let pixels = pixmap.data_mut()[start * 4..end * 4].chunks_exact_mut(4);
        let coverage = &coverage.mask().data()[start..end];
        match ground {
            None => pixels.zip(coverage).for_each(|(pixel, &c)| pixel.copy_from_slice(&RAMP[c as usize])),
            Some(ground) => {
                for ((pixel, &c), ground) in pixels.zip(coverage).zip(&ground[start..end]) {
                    pixel.copy_from_slice(&over(*ground, c));
                }
            }
        }
    }
}

/// Ink of some coverage over a colour.
#[inline]
fn over(ground: [u8; 4], coverage: u8) -> [u8; 4] {
    if coverage == 0 {
        return ground;
    }
    let mix = |from: u8, to: u8| {
        ((u32::from(from) * u32::from(255 - coverage) + u32::from(to) * u32::from(coverage) + 127) / 255) as u8
    };
    [mix(ground[0], INK[0]), mix(ground[1], INK[1]), mix(ground[2], INK[2]), 255]
}
