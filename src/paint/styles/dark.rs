//! Ink's drawing on dark paper, for pages with a dark scheme.

use super::ink::PALETTE as INK;
use crate::paint::palette::{Palette, even};

pub(super) static PALETTE: Palette = Palette {
    rings: INK.rings,
    ..even([0x16, 0x1f, 0x2b], [0x0f, 0x15, 0x1e], [0x6d, 0x8c, 0xa6], [0x6e, 0x60, 0x4c], [0x9c, 0xc6, 0xe8])
};
