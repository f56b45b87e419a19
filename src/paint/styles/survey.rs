//! A sheet of a topographic survey: contours over the faintest of tints and shades.

use crate::paint::palette::{Casing, Contours, Palette, ReliefLook, Tints, even};

pub(super) static PALETTE: Palette = Palette {
    rings: &[(14.0, 0.42), (34.0, 0.34), (70.0, 0.26)],
    relief: Some(&ReliefLook {
        tints: Tints {
            stops: &[
                (0.0, [0xd9, 0xe8, 0xc4]),
                (0.3, [0xee, 0xf0, 0xd0]),
                (0.6, [0xf6, 0xe7, 0xc4]),
                (1.0, [0xec, 0xd2, 0xab]),
            ],
            light: [0.8, 1.0],
        },
        contours: Some(Contours { colour: [0xab, 0x6a, 0x30], widths: [0.4, 0.85], strengths: [0.75, 0.95] }),
        hachures: None,
        basins: None,
        casing: Casing { colour: [0; 3], strength: 0.0, margin: 0.8, blur: 0.0, gain: 0.0 },
    }),
    ..even([0xe2, 0xec, 0xca], [0xcf, 0xe3, 0xec], [0x2f, 0x7c, 0xa8], [0xa0, 0x86, 0x66], [0x2b, 0x7a, 0xb5])
};
