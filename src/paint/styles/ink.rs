//! Ink on paper.

use super::climate::Climates;
use super::look::{Look, bare, strokes};
use crate::paint::palette::{Colour, Palette, bordered, even};

const PAPER: Colour = [0xf6, 0xf0, 0xe2];

const RIVER: Colour = [0x1f, 0x3f, 0x66];

pub(super) static STYLE: Look = Look {
    palette: Palette {
        is_open: true,
        bank: 0.9,
        rings: &[(7.0, 0.34), (16.0, 0.2), (28.0, 0.1)],
        neatline: bordered([0xee, 0xe8, 0xd8], [0x8a, 0x8c, 0x88]),
        ..even(PAPER, [0xdd, 0xe6, 0xe4], [0x4a, 0x62, 0x78], [0xa8, 0x93, 0x78], RIVER)
    },
    labels: bare(RIVER, PAPER),
    scenery: Some(strokes([0x5c, 0x54, 0x42])),
    climates: Climates::Alike,
};
