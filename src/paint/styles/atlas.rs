//! An atlas page.

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

static RELIEF: ReliefLook = ReliefLook {
    casing: Casing { colour: [0xf7, 0xf1, 0xdd], strength: 0.35, margin: 0.55, blur: 0.0, gain: 1.0 },
    ..tinted(TINTS, ([0x18, 0x2a, 0x46], 0.54), ([0xff, 0xf2, 0xc8], 0.42))
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        shallows: SHALLOWS,
        fade: 150.0,
        rings: RINGS,
        relief: Some(&RELIEF),
        neatline: bordered([0xf6, 0xf1, 0xe0], [0x5c, 0x6e, 0x70]),
        ..even(LAND, WATER, COAST, RIDGE, RIVER)
    },
    labels: haloed(LETTERS, HALO, 0.5),
    scenery: Some(strokes([0x3a, 0x55, 0x32])),
};
