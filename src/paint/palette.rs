//! The styles: their colours, and how they draw rivers. A style has a line in `palette` and a constant here.

use crate::recipe::Style;

/// A colour: red, green, blue.
pub(crate) type Colour = [u8; 3];

/// What a style paints with.
#[derive(Debug)]
pub(crate) struct Palette {
    /// Land at the coast, and far from it.
    pub lowland: Colour,
    pub inland: Colour,
    /// Water at the coast, and far from it.
    pub shallows: Colour,
    pub deep: Colour,
    /// How far from the coast land and water have nothing but their farther colour, in units.
    pub fade: f32,
    pub coast: Colour,
    /// Distances from the coast of the rings that old engravers drew, in units, outermost last, with their strength.
    pub rings: &'static [(f32, f32)],
    pub ridge: Colour,
    pub river: Colour,
    /// Land where all of the domain is.
    pub plain: Colour,
    pub lines: Lines,
}

/// How a style draws rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lines {
    /// As wide as they are, with the lakes that they have left.
    Wide,
    /// One pixel wide, without lakes.
    Skeleton,
}

/// What a style paints with.
pub(crate) fn palette(style: Style) -> &'static Palette {
    match style {
        Style::Ink => &INK,
        Style::Dark => &DARK,
        Style::Map => &MAP,
        Style::Skeleton => &SKELETON,
    }
}

/// Ink on paper.
static INK: Palette = Palette {
    rings: &[(7.0, 0.34), (16.0, 0.2), (28.0, 0.1)],
    ..even([0xf6, 0xf0, 0xe2], [0xdd, 0xe6, 0xe4], [0x4a, 0x62, 0x78], [0xa8, 0x93, 0x78], [0x1f, 0x3f, 0x66])
};

/// Ink's drawing on dark paper, for pages with a dark scheme.
static DARK: Palette = Palette {
    rings: INK.rings,
    ..even([0x16, 0x1f, 0x2b], [0x0f, 0x15, 0x1e], [0x6d, 0x8c, 0xa6], [0x6e, 0x60, 0x4c], [0x9c, 0xc6, 0xe8])
};

/// A map as atlases colour it: green lowland, blue water.
static MAP: Palette = Palette {
    lowland: [0xdc, 0xe6, 0xc8],
    inland: [0xf1, 0xea, 0xd3],
    deep: [0xa9, 0xcc, 0xdf],
    fade: 160.0,
    ..even([0xe8, 0xe9, 0xcf], [0xcb, 0xe2, 0xec], [0x5f, 0x93, 0xb0], [0xb0, 0x97, 0x74], [0x2f, 0x74, 0xa8])
};

/// White on black, the coast dim.
static SKELETON: Palette = Palette { lines: Lines::Skeleton, ..even([0; 3], [0; 3], [0x58; 3], [0x38; 3], [0xff; 3]) };

impl Palette {
    /// The colour of each coverage by river, from bare plain land to river. Made for a picture: as a table for each style it
    /// would weigh a kilobyte of every download.
    pub fn ramp(&self) -> [[u8; 4]; 256] {
        std::array::from_fn(|coverage| over(self.plain, self.river, coverage as u32))
    }
}

/// Land and water of one colour each, no rings.
const fn even(land: Colour, water: Colour, coast: Colour, ridge: Colour, river: Colour) -> Palette {
    Palette {
        lowland: land,
        inland: land,
        shallows: water,
        deep: water,
        fade: 0.0,
        coast,
        rings: &[],
        ridge,
        river,
        plain: land,
        lines: Lines::Wide,
    }
}

/// The colour of a ground, without the value that it holds in place of an opacity.
#[inline]
pub(super) fn opaque(ground: [u8; 4]) -> [u8; 4] {
    const OPAQUE: u32 = u32::from_le_bytes([0, 0, 0, 255]);
    (u32::from_le_bytes(ground) | OPAQUE).to_le_bytes()
}

/// A colour covered by another, `coverage` in 255ths; opaque.
#[inline]
pub(super) fn over([red, green, blue]: Colour, by: Colour, coverage: u32) -> [u8; 4] {
    let blend = |from: u8, to: u8| ((u32::from(from) * (255 - coverage) + u32::from(to) * coverage + 127) / 255) as u8;
    [blend(red, by[0]), blend(green, by[1]), blend(blue, by[2]), 255]
}

/// A colour a share of the way to another.
pub(crate) fn mix(from: Colour, to: Colour, share: f32) -> Colour {
    std::array::from_fn(|i| (f32::from(from[i]) + (f32::from(to[i]) - f32::from(from[i])) * share + 0.5) as u8)
}
