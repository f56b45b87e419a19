//! The land as satellites see it.

use super::climate::{Climates, Four, Ramp, hex, tints};
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

const RELIEF: ReliefLook = ReliefLook {
    casing: Casing { colour: [0x2c, 0x4a, 0x2a], strength: 0.55, margin: 2.0, blur: 3.0, gain: 2.0 },
    ..TINTED
};

/// The colours of other climates: rain forest, desert, ice, lava.
static CLIMATES: Four<Ramp> = Four {
    wet: Ramp {
        tints: tints(&[0x2c4f2a, 0x335830, 0x3d6134, 0x4a683a, 0x5c6e46, 0x75795c, 0x9aa08c, 0xe0e4e2]),
        shadow: hex(0x0c1c22),
        light: hex(0xfdf6c8),
        land: hex(0x2c4f2a),
        lowland: hex(0x2c4f2a),
        blotch: hex(0x0a1c0e),
        water: hex(0x06263a),
        shallows: hex(0x1c7478),
        coast: hex(0xa8a47c),
        river: hex(0x1d5560),
        casing: hex(0x1a3c1e),
        cased: 0.55,
        letters: hex(0xf8f6ee),
        halo: hex(0x0c1c1e),
        trees: hex(0x000000),
    },
    dry: Ramp {
        tints: tints(&[0xb59a6c, 0xc4a878, 0xd0b083, 0xc99f70, 0xb98a60, 0xa67a58, 0xa8876e, 0xc9b8a4]),
        shadow: hex(0x241426),
        light: hex(0xfff0c8),
        land: hex(0xb59a6c),
        lowland: hex(0xb59a6c),
        blotch: hex(0x8a6844),
        water: hex(0x08283f),
        shallows: hex(0x22788a),
        coast: hex(0xd8c89c),
        river: hex(0x1f5a6c),
        casing: hex(0x56683a),
        cased: 0.55,
        letters: hex(0xf8f6ee),
        halo: hex(0x201820),
        trees: hex(0x000000),
    },
    cold: Ramp {
        tints: tints(&[0x5c6650, 0x6d7462, 0x8c9088, 0xb2b8b6, 0xd4dadc, 0xe6ebee, 0xf2f5f8, 0xfcfdff]),
        shadow: hex(0x14203a),
        light: hex(0xfffdf0),
        land: hex(0x5c6650),
        lowland: hex(0x5c6650),
        blotch: hex(0x46524e),
        water: hex(0x0a2236),
        shallows: hex(0x2c6a82),
        coast: hex(0xc4ccd0),
        river: hex(0x2a5872),
        casing: hex(0x4a5c4c),
        cased: 0.55,
        letters: hex(0xf8f6ee),
        halo: hex(0x101a2a),
        trees: hex(0x000000),
    },
    lava: Ramp {
        tints: tints(&[0x3c4a30, 0x42462f, 0x46423a, 0x443e3a, 0x3e3a3a, 0x4a4544, 0x6a6462, 0xb8b2b0]),
        shadow: hex(0x0a0a14),
        light: hex(0xffe6c4),
        land: hex(0x3c4a30),
        lowland: hex(0x3c4a30),
        blotch: hex(0x14100f),
        water: hex(0x06202f),
        shallows: hex(0x1c6c86),
        coast: hex(0x34322e),
        river: hex(0x1c5068),
        casing: hex(0x34462a),
        cased: 0.55,
        letters: hex(0xf8f6ee),
        halo: hex(0x101218),
        trees: hex(0x000000),
    },
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        shallows: [0x24, 0x74, 0x8e],
        fade: 130.0,
        bank: 0.0,
        rings: &[(1.4, 0.34), (2.6, 0.27), (3.8, 0.2), (5.0, 0.14), (6.2, 0.08)],
        paper: Some(Paper { blotch: [0x12, 0x24, 0x14], blotched: 0.75, size: 75.0, octaves: 6, at_sea: 0.0, ..BLANK }),
        relief: Some(RELIEF),
        neatline: bordered([0x04, 0x0c, 0x16], [0x3c, 0x4c, 0x58]),
        ..even([0x4a, 0x60, 0x38], [0x06, 0x22, 0x3d], [0xc9, 0xb9, 0x8c], [0x6e, 0x60, 0x4c], [0x1d, 0x55, 0x70])
    },
    labels: haloed([0xf8, 0xf6, 0xee], [0x10, 0x18, 0x26], 0.62),
    scenery: None,
    climates: Climates::Ramps(&CLIMATES),
};
