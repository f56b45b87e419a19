//! White on black, the coast dim.

use super::climate::Climates;
use super::look::{Look, bare};
use crate::paint::palette::{Colour, Lines, Palette, even};

const BLACK: Colour = [0; 3];

pub(super) static STYLE: Look = Look {
    palette: Palette { lines: Lines::Skeleton, ..even(BLACK, BLACK, [0x58; 3], [0x38; 3], [0xff; 3]) },
    labels: bare([0xd0; 3], BLACK),
    scenery: None,
    climates: Climates::Alike,
};
