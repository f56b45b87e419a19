//! A sheet of a topographic survey: contours over the faintest of tints and shades.

use super::climate::Climates;
use super::look::{LabelLook, Look, bodied, haloed};
use crate::paint::palette::{Casing, Contours, Palette, ReliefLook, bordered, even, tinted};

const TINTED: ReliefLook = tinted(
    &[
        (0.0, [0xd4, 0xe6, 0xc0]),
        (250.0, [0xe4, 0xec, 0xca]),
        (520.0, [0xf2, 0xef, 0xce]),
        (950.0, [0xf5, 0xe4, 0xbf]),
        (1500.0, [0xea, 0xcf, 0xa9]),
        (2600.0, [0xe2, 0xd2, 0xc4]),
    ],
    ([0x4c, 0x54, 0x70], 0.32),
    ([0xff, 0xfa, 0xe2], 0.5),
);

const RELIEF: ReliefLook = ReliefLook {
    contours: Some(Contours { colour: [0xab, 0x6a, 0x30], widths: [0.4, 1.1], strengths: [0.75, 0.95] }),
    casing: Casing { margin: 0.8, ..TINTED.casing },
    ..TINTED
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        is_open: true,
        bank: 0.9,
        rings: &[(14.0, 0.42), (34.0, 0.34), (70.0, 0.26)],
        relief: Some(RELIEF),
        neatline: bordered([0xf8, 0xf6, 0xec], [0x4a, 0x44, 0x3c]),
        ..even([0xe2, 0xec, 0xca], [0xcf, 0xe3, 0xec], [0x2f, 0x7c, 0xa8], [0xa0, 0x86, 0x66], [0x2b, 0x7a, 0xb5])
    },
    labels: LabelLook { mark: [0x4a, 0x33, 0x22], ..haloed([0x17, 0x3e, 0x68], [0xf4, 0xf1, 0xdc], 0.6) },
    scenery: Some(bodied([0x2f, 0x6b, 0x35], [0xee, 0xf0, 0xd0], 0.6)),
    climates: Climates::Alike,
};
