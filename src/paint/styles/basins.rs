//! River systems in colours of their own on paper, their basins in tints of those.

use crate::paint::palette::{BasinColours, Casing, Palette, ReliefLook, Tints, even};

const PAPER: [u8; 3] = [0xf6, 0xf1, 0xe4];

pub(super) static PALETTE: Palette = Palette {
    relief: Some(&ReliefLook {
        tints: Tints { stops: &[(0.0, PAPER)], light: [0.82, 1.0] },
        contours: None,
        hachures: None,
        basins: Some(BasinColours {
            colours: &[
                [0xe4, 0x57, 0x2e],
                [0xf3, 0xa7, 0x12],
                [0xa8, 0xc6, 0x86],
                [0x66, 0x9b, 0xbc],
                [0x7b, 0x5e, 0xa7],
                [0xe8, 0xa0, 0xbf],
                [0x3f, 0xb8, 0xaf],
                [0xf2, 0x6b, 0x8a],
                [0xc7, 0xd3, 0x6f],
                [0x5b, 0x8d, 0xef],
                [0xd9, 0x8e, 0x04],
                [0x8f, 0xd6, 0x94],
                [0xb3, 0x88, 0xeb],
                [0xff, 0x9f, 0x80],
                [0x59, 0xc3, 0xc3],
                [0xff, 0xd1, 0x66],
            ],
            rest: [0xec, 0xe5, 0xd3],
            paper: PAPER,
            strength: 0.34,
            rivers: 0.55,
        }),
        casing: Casing { colour: PAPER, strength: 0.0, margin: 0.0, blur: 0.0, gain: 0.0 },
    }),
    ..even(PAPER, PAPER, [0xc9, 0xbd, 0xa2], [0xa8, 0x93, 0x78], [0x6b, 0x63, 0x58])
};
