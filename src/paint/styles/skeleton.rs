//! White on black, the coast dim.

use crate::paint::palette::{Lines, Palette, even};

pub(super) static PALETTE: Palette =
    Palette { lines: Lines::Skeleton, ..even([0; 3], [0; 3], [0x58; 3], [0x38; 3], [0xff; 3]) };
