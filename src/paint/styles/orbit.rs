//! The land as satellites see it.

use super::look::{Look, haloed};
use crate::paint::palette::{BLANK, Casing, Palette, Paper, ReliefLook, bordered, even, tinted};

const TINTED: ReliefLook = tinted(
    &[
        (0.0, [0x3f, 0x5a, 0x34]),
        (180.0, [0x52, 0x66, 0x3b]),
        (420.0, [0x73, 0x76, 0x4a]),
        (780.0, [0x8d, 0x80, 0x58]),
        (1150.0, [0x9c, 0x8a, 0x6a]),
        (1450.0, [0xb1, 0xa4, 0x8b]),
        (1700.0, [0xd8, 0xd3, 0xc9]),
        (2050.0, [0xe8, 0xe6, 0xe0]),
    ],
    ([0x10, 0x18, 0x2a], 0.6),
    ([0xff, 0xf2, 0xcf], 0.3),
);

static RELIEF: ReliefLook = ReliefLook {
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
        neatline: bordered([0x04, 0x0c, 0x16], [0x3c, 0x4c, 0x58]),
        ..even([0x4a, 0x60, 0x38], [0x06, 0x22, 0x3d], [0xc9, 0xb9, 0x8c], [0x6e, 0x60, 0x4c], [0x1d, 0x55, 0x70])
    },
    labels: haloed([0xf8, 0xf6, 0xee], [0x10, 0x18, 0x26], 0.62),
    scenery: None,
};
