//! Ink's drawing on dark paper.

use super::climate::Climates;
use super::ink;
use super::look::{Look, SceneryLook, bare, strokes};
use crate::paint::palette::{Colour, Palette, bordered, even};

const PAPER: Colour = [0x16, 0x1f, 0x2b];

const RIVER: Colour = [0x9c, 0xc6, 0xe8];

pub(super) static STYLE: Look = Look {
    palette: Palette {
        rings: ink::STYLE.palette.rings,
        neatline: bordered([0x0f, 0x16, 0x20], [0x46, 0x56, 0x64]),
        ..even(PAPER, [0x0f, 0x15, 0x1e], [0x6d, 0x8c, 0xa6], [0x6e, 0x60, 0x4c], RIVER)
    },
    labels: bare(RIVER, PAPER),
    scenery: Some(SceneryLook { shade: 0.65, ..strokes([0x93, 0xa2, 0xad]) }),
    climates: Climates::Alike,
};
