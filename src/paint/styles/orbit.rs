//! The land as satellites see it.

use super::look::{Look, haloed};
use crate::paint::palette::{BLANK, Casing, Palette, Paper, ReliefLook, Tints, even, tinted};

const TINTED: ReliefLook = tinted(
    &[
        (0.0, [0x3f, 0x5a, 0x34]),
        (0.12, [0x56, 0x68, 0x3c]),
        (0.3, [0x7d, 0x7a, 0x4e]),
        (0.55, [0x97, 0x85, 0x5f]),
        (0.78, [0xb7, 0xa9, 0x8c]),
        (0.88, [0xe8, 0xe6, 0xe0]),
    ],
    0.3,
);

static RELIEF: ReliefLook = ReliefLook {
    tints: Tints { light: [0.2, 1.0], shadow: [0x10, 0x18, 0x26], ..TINTED.tints },
    casing: Casing { colour: [0x2c, 0x4a, 0x2a], strength: 0.55, margin: 2.0, blur: 3.0, gain: 2.0 },
    ..TINTED
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        shallows: [0x24, 0x74, 0x8e],
        fade: 130.0,
        bank: 0.0,
        rings: &[(1.4, 0.34), (2.6, 0.27), (3.8, 0.2), (5.0, 0.14), (6.2, 0.08)],
        paper: Some(&Paper {
            blotch: [0x12, 0x24, 0x14],
            blotched: 0.75,
            size: 75.0,
            octaves: 6,
            at_sea: 0.0,
            ..BLANK
        }),
        relief: Some(&RELIEF),
        ..even([0x4a, 0x60, 0x38], [0x06, 0x22, 0x3d], [0xc9, 0xb9, 0x8c], [0x6e, 0x60, 0x4c], [0x1d, 0x55, 0x70])
    },
    labels: haloed([0xf8, 0xf6, 0xee], [0x10, 0x18, 0x26], 0.62),
    scenery: None,
};
