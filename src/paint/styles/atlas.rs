//! An atlas page.

use super::look::{Look, haloed, strokes};
use crate::paint::palette::{Casing, Palette, ReliefLook, bordered, even, tinted};

/// Rings in the sea, the nearest first.
pub(super) const RINGS: &[(f32, f32)] =
    &[(3.5, 0.34), (8.1, 0.27), (14.1, 0.22), (21.8, 0.17), (31.5, 0.14), (43.7, 0.11)];

static RELIEF: ReliefLook = ReliefLook {
    casing: Casing { colour: [0xf7, 0xf1, 0xdd], strength: 0.35, margin: 0.55, blur: 0.0, gain: 1.0 },
    ..tinted(
        &[
            (0.0, [0xb4, 0xd0, 0x9c]),
            (100.0, [0xc6, 0xd9, 0xa5]),
            (260.0, [0xdb, 0xe2, 0xb2]),
            (480.0, [0xee, 0xe6, 0xbf]),
            (740.0, [0xec, 0xd9, 0xaa]),
            (1080.0, [0xdd, 0xbd, 0x8c]),
            (1500.0, [0xc9, 0xa2, 0x7c]),
            (2000.0, [0xc2, 0xac, 0x9c]),
            (2500.0, [0xd8, 0xd2, 0xca]),
            (3200.0, [0xef, 0xec, 0xe6]),
        ],
        ([0x1a, 0x2c, 0x48], 0.46),
        ([0xff, 0xf4, 0xcc], 0.5),
    )
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        shallows: [0xcf, 0xe3, 0xe6],
        fade: 150.0,
        rings: RINGS,
        relief: Some(&RELIEF),
        neatline: bordered([0xf6, 0xf1, 0xe0], [0x5c, 0x6e, 0x70]),
        ..even([0xdc, 0xe3, 0xbe], [0x8f, 0xb6, 0xc6], [0x3c, 0x64, 0x78], [0xa0, 0x86, 0x66], [0x2a, 0x6f, 0x9e])
    },
    labels: haloed([0x17, 0x3e, 0x68], [0xf4, 0xee, 0xd6], 0.5),
    scenery: Some(strokes([0x3a, 0x55, 0x32])),
};
