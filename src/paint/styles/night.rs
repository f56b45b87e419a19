//! The land by night.

use crate::paint::palette::{Casing, Palette, ReliefLook, Tints, even};

pub(super) static PALETTE: Palette = Palette {
    shallows: [0x16, 0x30, 0x3d],
    deep: [0x09, 0x13, 0x1a],
    fade: 150.0,
    rings: &[(3.5, 0.34), (8.1, 0.27), (14.1, 0.22), (21.8, 0.17)],
    relief: Some(&ReliefLook {
        tints: Tints {
            stops: &[
                (0.0, [0x1f, 0x3a, 0x3a]),
                (0.3, [0x2b, 0x44, 0x42]),
                (0.6, [0x4a, 0x52, 0x48]),
                (1.0, [0x75, 0x69, 0x5a]),
            ],
            light: [0.35, 1.0],
        },
        contours: None,
        hachures: None,
        basins: None,
        casing: Casing { colour: [0x4f, 0xa8, 0xd8], strength: 0.5, margin: 0.3, blur: 2.0, gain: 2.5 },
    }),
    ..even([0x24, 0x3e, 0x3d], [0x09, 0x13, 0x1a], [0x7f, 0xb3, 0xc6], [0x6e, 0x60, 0x4c], [0xb5, 0xe0, 0xf7])
};
