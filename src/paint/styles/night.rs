//! The land by night.

use super::atlas::RINGS;
use super::climate::{Climates, Four, Tinge, hex};
use super::look::{Look, haloed, strokes};
use crate::paint::palette::{Casing, Palette, ReliefLook, bordered, even, tinted};

const RELIEF: ReliefLook = ReliefLook {
    casing: Casing { colour: [0x4f, 0xa8, 0xd8], strength: 0.5, margin: 0.3, blur: 2.0, gain: 2.5 },
    ..tinted(
        &[
            (0.0, [0x1f, 0x3a, 0x3a]),
            (350.0, [0x2a, 0x44, 0x41]),
            (800.0, [0x45, 0x51, 0x49]),
            (1400.0, [0x62, 0x5e, 0x54]),
            (2200.0, [0x73, 0x6b, 0x60]),
        ],
        ([0x07, 0x10, 0x1c], 0.62),
        ([0xe0, 0xd6, 0xb4], 0.32),
    )
};

/// The tinges of other climates.
const CLIMATES: Four<Tinge> = Four {
    wet: (hex(0x0f4a34), [0.35, 0.45]),
    dry: (hex(0x82663a), [0.3, 0.4]),
    cold: (hex(0x586a84), [0.25, 0.8]),
    lava: (hex(0x17131c), [0.35, 0.6]),
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        shallows: [0x16, 0x30, 0x3d],
        fade: 150.0,
        rings: RINGS.split_at(4).0,
        relief: Some(RELIEF),
        neatline: bordered([0x06, 0x0c, 0x11], [0x56, 0x78, 0x86]),
        ..even([0x24, 0x3e, 0x3d], [0x09, 0x13, 0x1a], [0x7f, 0xb3, 0xc6], [0x6e, 0x60, 0x4c], [0xb5, 0xe0, 0xf7])
    },
    labels: haloed([0xe8, 0xf5, 0xfc], [0x14, 0x26, 0x28], 0.5),
    scenery: Some(strokes([0xa9, 0xce, 0xbc])),
    climates: Climates::Tinges(CLIMATES),
};
