//! A blueprint: white lines on blue.

use super::climate::Climates;
use super::look::{Look, bodied, haloed};
use crate::paint::palette::{
    BLANK, Casing, Colour, Contours, Grid, Palette, Paper, ReliefLook, bordered, even, tinted,
};

const LAND: Colour = [0x13, 0x44, 0x81];

const TINTED: ReliefLook = tinted(
    &[(0.0, LAND), (800.0, [0x19, 0x4e, 0x8e]), (2400.0, [0x24, 0x60, 0xa2])],
    ([0x06, 0x20, 0x48], 0.4),
    ([0x8c, 0xb4, 0xdc], 0.2),
);

const RELIEF: ReliefLook = ReliefLook {
    contours: Some(Contours { colour: [0xbf, 0xe0, 0xff], widths: [0.4, 0.9], strengths: [0.3, 0.5] }),
    casing: Casing { margin: 0.8, ..TINTED.casing },
    ..TINTED
};

const RIVER: Colour = [0xf4, 0xfa, 0xff];

pub(super) static STYLE: Look = Look {
    palette: Palette {
        rings: &[(5.0, 0.4), (10.0, 0.28), (16.0, 0.18)],
        grids: &[
            Grid { every: 24.0, colour: [0xbf, 0xe0, 0xff], strength: 0.12 },
            Grid { every: 120.0, colour: [0xbf, 0xe0, 0xff], strength: 0.16 },
        ],
        paper: Some(Paper {
            blotch: [0x2a, 0x62, 0xa6],
            blotched: 0.25,
            edge: [0x08, 0x26, 0x50],
            edged: 0.5,
            ..BLANK
        }),
        relief: Some(RELIEF),
        neatline: bordered([0x0d, 0x37, 0x6c], [0xbf, 0xe0, 0xff]),
        ..even(LAND, [0x0f, 0x3c, 0x73], [0xe6, 0xf2, 0xff], [0xbf, 0xe0, 0xff], RIVER)
    },
    labels: haloed(RIVER, LAND, 0.6),
    scenery: Some(bodied([0xbf, 0xe0, 0xff], LAND, 0.5)),
    climates: Climates::Alike,
};
