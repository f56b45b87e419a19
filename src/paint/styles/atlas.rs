//! An atlas page.

use super::climate::{Climates, Four, Ramp, hex, tints};
use super::look::{Look, haloed, strokes};
use crate::paint::palette::{Casing, Colour, Palette, ReliefLook, bordered, even, tinted};

/// Rings in the sea, the nearest first.
pub(super) const RINGS: &[(f32, f32)] =
    &[(3.5, 0.34), (8.1, 0.27), (14.1, 0.22), (21.8, 0.17), (31.5, 0.14), (43.7, 0.11)];

/// The colour of land without relief. This and the next ones are public so that `riverseed-exchange` gives them to QGIS.
pub const LAND: Colour = [0xdc, 0xe3, 0xbe];
/// The colour of lakes and of the deep sea.
pub const WATER: Colour = [0x8f, 0xb6, 0xc6];
/// The colour of the sea at the coast.
pub const SHALLOWS: Colour = [0xcf, 0xe3, 0xe6];
/// The colour of coastlines.
pub const COAST: Colour = [0x3c, 0x64, 0x78];
/// The colour of ridges.
pub const RIDGE: Colour = [0xa0, 0x86, 0x66];
/// The colour of rivers.
pub const RIVER: Colour = [0x2a, 0x6f, 0x9e];
/// The colour of letters.
pub const LETTERS: Colour = [0x17, 0x3e, 0x68];
/// The colour around letters.
pub const HALO: Colour = [0xf4, 0xee, 0xd6];

/// The colours of land by its height in metres, the lowest first.
pub const TINTS: &[(f32, Colour)] = &[
    (0.0, [0xb0, 0xce, 0x98]),
    (100.0, [0xc3, 0xd8, 0xa2]),
    (260.0, [0xdb, 0xe2, 0xb0]),
    (450.0, [0xef, 0xe4, 0xb8]),
    (680.0, [0xe8, 0xd0, 0x9e]),
    (980.0, [0xd9, 0xb7, 0x83]),
    (1400.0, [0xc5, 0x9c, 0x74]),
    (1900.0, [0xbf, 0xa6, 0x92]),
    (2500.0, [0xd6, 0xd0, 0xc8]),
    (3200.0, [0xef, 0xec, 0xe6]),
];

const RELIEF: ReliefLook = ReliefLook {
    casing: Casing { colour: [0xf7, 0xf1, 0xdd], strength: 0.35, margin: 0.55, blur: 0.0, gain: 1.0 },
    ..tinted(TINTS, ([0x18, 0x2a, 0x46], 0.54), ([0xff, 0xf2, 0xc8], 0.42))
};

/// The colours of other climates.
static CLIMATES: Four<Ramp> = Four {
    wet: Ramp {
        tints: tints(&[
            0x9cc890, 0xa9d098, 0xb9d8a2, 0xc3d9a4, 0xb6c898, 0xa3b48c, 0x929f84, 0x989f92, 0xc3cac8, 0xeef2f2,
        ]),
        shadow: hex(0x0f2c3a),
        light: hex(0xfbf7c4),
        land: hex(0xa9d098),
        lowland: hex(0xa9d098),
        blotch: hex(0x000000),
        water: hex(0x84b4bd),
        shallows: hex(0xc4e4dc),
        coast: hex(0x2c5f60),
        river: hex(0x17628a),
        casing: hex(0xeef3dc),
        cased: 0.35,
        letters: hex(0x0f3d4c),
        halo: hex(0xeef3dc),
        trees: hex(0x2c4a2c),
    },
    dry: Ramp {
        tints: tints(&[
            0xcfcf9e, 0xded6a4, 0xeedcac, 0xf0d39c, 0xe8bf88, 0xd8a274, 0xc28864, 0xb48c78, 0xcebaa8, 0xece2d8,
        ]),
        shadow: hex(0x3a2440),
        light: hex(0xfff0c0),
        land: hex(0xded6a4),
        lowland: hex(0xded6a4),
        blotch: hex(0x000000),
        water: hex(0x7fb0c0),
        shallows: hex(0xc8e6e2),
        coast: hex(0x4f5f68),
        river: hex(0x1c628e),
        casing: hex(0xfaf0d6),
        cased: 0.35,
        letters: hex(0x3a3036),
        halo: hex(0xfaf0d6),
        trees: hex(0x4a4a26),
    },
    cold: Ramp {
        tints: tints(&[
            0xaebf98, 0xbbc8a2, 0xc9ceb0, 0xd0cfba, 0xc8c6b8, 0xc4c5c0, 0xd4d9dc, 0xe8edf1, 0xf6f9fb, 0xffffff,
        ]),
        shadow: hex(0x1c2c50),
        light: hex(0xfffdf0),
        land: hex(0xbbc8a2),
        lowland: hex(0xbbc8a2),
        blotch: hex(0x000000),
        water: hex(0x8ba6ba),
        shallows: hex(0xd3e0e8),
        coast: hex(0x3f5468),
        river: hex(0x35648f),
        casing: hex(0xf4f6f4),
        cased: 0.35,
        letters: hex(0x1d3450),
        halo: hex(0xf4f6f4),
        trees: hex(0x36504a),
    },
    lava: Ramp {
        tints: tints(&[
            0x98ba78, 0xa5b87c, 0xaeae84, 0xaa9c84, 0x9c8c80, 0x8a7f7c, 0x7a7276, 0x766f76, 0x988e90, 0xc8c0be,
        ]),
        shadow: hex(0x1a1a34),
        light: hex(0xffe8c0),
        land: hex(0xa5b87c),
        lowland: hex(0xa5b87c),
        blotch: hex(0x000000),
        water: hex(0x6fa0b4),
        shallows: hex(0xbfe0e0),
        coast: hex(0x2c3f4c),
        river: hex(0x0f4c78),
        casing: hex(0xf0ecdc),
        cased: 0.7,
        letters: hex(0x1c2c44),
        halo: hex(0xf0ecdc),
        trees: hex(0x1c2a1c),
    },
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        is_open: true,
        bank: 0.9,
        shallows: SHALLOWS,
        fade: 150.0,
        rings: RINGS,
        relief: Some(RELIEF),
        neatline: bordered([0xf6, 0xf1, 0xe0], [0x5c, 0x6e, 0x70]),
        ..even(LAND, WATER, COAST, RIDGE, RIVER)
    },
    labels: haloed(LETTERS, HALO, 0.5),
    scenery: Some(strokes([0x3a, 0x55, 0x32])),
    climates: Climates::Ramps(&CLIMATES),
};
