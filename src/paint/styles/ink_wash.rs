//! A painting in ink and water.

use super::climate::Climates;
use super::look::{LabelLook, Look, bodied, haloed};
use crate::paint::palette::{BLANK, Casing, Colour, Hachures, Palette, Paper, ReliefLook, bordered, even, tinted};

const PAPER: Colour = [0xf5, 0xf1, 0xe8];

const INK: Colour = [0x23, 0x27, 0x2b];

const TINTED: ReliefLook = tinted(
    &[(0.0, PAPER), (500.0, [0xee, 0xea, 0xe1]), (1800.0, [0xcc, 0xcb, 0xc7]), (2800.0, [0xbc, 0xbc, 0xba])],
    (INK, 0.72),
    (PAPER, 0.0),
);

const RELIEF: ReliefLook = ReliefLook {
    hachures: Some(Hachures { colour: INK, strength: 0.3 }),
    casing: Casing { colour: PAPER, strength: 0.8, margin: 2.0, blur: 2.0, gain: 1.5 },
    ..TINTED
};

pub(super) static STYLE: Look = Look {
    palette: Palette {
        is_open: true,
        bank: 0.9,
        shallows: [0x8f, 0xb0, 0xb8],
        fade: 55.0,
        paper: Some(Paper {
            blotch: [0xb9, 0xb4, 0xa8],
            blotched: 0.16,
            edge: [0xb0, 0xa8, 0x98],
            edged: 0.15,
            ..BLANK
        }),
        relief: Some(RELIEF),
        neatline: bordered(PAPER, [0x6a, 0x68, 0x62]),
        ..even(PAPER, PAPER, [0x6f, 0x93, 0x9e], [0x55, 0x55, 0x52], [0x3c, 0x69, 0x7e])
    },
    labels: LabelLook { mark: [0xa8, 0x32, 0x2a], ..haloed([0x1c, 0x36, 0x44], PAPER, 0.6) },
    scenery: Some(bodied([0x33, 0x3a, 0x3c], PAPER, 0.75)),
    climates: Climates::Alike,
};
