//! An engraving on old paper.

use super::climate::{Climates, Four, Tinge, hex};
use super::look::{Look, bodied, haloed};
use crate::paint::palette::{BLANK, Casing, Colour, Hachures, Palette, Paper, ReliefLook, bordered, even, tinted};

const LAND: Colour = [0xf1, 0xe4, 0xc3];

const TINTED: ReliefLook = tinted(&[(0.0, LAND)], ([0x5a, 0x4c, 0x4c], 0.26), ([0xff, 0xf6, 0xdc], 0.5));

const RELIEF: ReliefLook = ReliefLook {
    hachures: Some(Hachures { colour: [0x4a, 0x38, 0x28], strength: 0.6 }),
    casing: Casing { margin: 1.0, ..TINTED.casing },
    ..TINTED
};

/// The tinges of other climates.
const CLIMATES: Four<Tinge> = Four {
    wet: (hex(0xc9d2a0), [0.4; 2]),
    dry: (hex(0xecc47a), [0.35; 2]),
    cold: (hex(0xe6ebec), [0.45; 2]),
    lava: (hex(0xa8988a), [0.4; 2]),
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        is_open: true,
        bank: 0.9,
        lowland: [0xe0, 0xc9, 0x9c],
        fade: 14.0,
        rings: &[
            (2.4, 0.60),
            (5.8, 0.50),
            (10.2, 0.41),
            (15.7, 0.34),
            (22.7, 0.28),
            (31.3, 0.24),
            (41.9, 0.20),
            (54.9, 0.16),
        ],
        paper: Some(Paper { blotch: [0xbf, 0xa0, 0x6a], blotched: 0.3, edge: [0x7d, 0x5f, 0x33], edged: 0.4, ..BLANK }),
        relief: Some(RELIEF),
        neatline: bordered([0xea, 0xd9, 0xb0], [0x5a, 0x46, 0x32]),
        ..even(LAND, [0xdf, 0xcb, 0x9d], [0x4a, 0x38, 0x28], [0x6e, 0x5a, 0x40], [0x4a, 0x5a, 0x5c])
    },
    labels: haloed([0x2f, 0x3a, 0x3f], LAND, 0.6),
    scenery: Some(bodied([0x4a, 0x38, 0x28], LAND, 0.9)),
    climates: Climates::Tinges(CLIMATES),
};
