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
    /// How it shows relief; `None` if it does not.
    pub relief: Option<&'static Tints>,
}

/// How a style shows relief.
#[derive(Debug)]
pub(crate) struct Tints {
    /// Colours by height, as shares of the highest; the first is 0.
    pub stops: &'static [(f32, Colour)],
    /// What colours are multiplied by where there is no light, and where there is as much as on flat land.
    pub light: [f32; 2],
    /// What lies around rivers.
    pub casing: Casing,
}

/// What lies around rivers.
#[derive(Debug)]
pub(crate) struct Casing {
    pub colour: Colour,
    pub strength: f32,
    /// How far it reaches on either side, in units, before it is blurred.
    pub margin: f32,
    /// The radius of its blur, in units, and by how much that is made up for.
    pub blur: f32,
    pub gain: f32,
}

impl Tints {
    /// The colour at a height.
    pub fn at(&self, height: f32) -> Colour {
        let above = self.stops.iter().position(|stop| stop.0 >= height).unwrap_or(self.stops.len() - 1);
        let ((from, low), (to, high)) = (self.stops[above.saturating_sub(1)], self.stops[above]);
        let share = if to > from { ((height - from) / (to - from)).min(1.0) } else { 0.0 };
        mix(low, high, share)
    }
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
        Style::Atlas => &ATLAS,
        Style::Night => &NIGHT,
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

/// An atlas page.
static ATLAS: Palette = Palette {
    shallows: [0xcf, 0xe3, 0xe6],
    deep: [0x8f, 0xb6, 0xc6],
    fade: 150.0,
    rings: &[(3.5, 0.34), (8.1, 0.27), (14.1, 0.22), (21.8, 0.17), (31.5, 0.14), (43.7, 0.11)],
    relief: Some(&Tints {
        stops: &[
            (0.0, [0xcf, 0xdc, 0xb4]),
            (0.18, [0xe2, 0xe4, 0xbf]),
            (0.42, [0xf0, 0xe6, 0xc8]),
            (0.7, [0xe6, 0xcf, 0xa8]),
            (1.0, [0xd3, 0xb5, 0x8f]),
        ],
        light: [0.42, 1.0],
        casing: Casing { colour: [0xf7, 0xf1, 0xdd], strength: 0.35, margin: 0.55, blur: 0.0, gain: 1.0 },
    }),
    ..even([0xdc, 0xe3, 0xbe], [0x8f, 0xb6, 0xc6], [0x3c, 0x64, 0x78], [0xa0, 0x86, 0x66], [0x2a, 0x6f, 0x9e])
};

/// The land by night.
static NIGHT: Palette = Palette {
    shallows: [0x16, 0x30, 0x3d],
    deep: [0x09, 0x13, 0x1a],
    fade: 150.0,
    rings: &[(3.5, 0.34), (8.1, 0.27), (14.1, 0.22), (21.8, 0.17)],
    relief: Some(&Tints {
        stops: &[
            (0.0, [0x1f, 0x3a, 0x3a]),
            (0.3, [0x2b, 0x44, 0x42]),
            (0.6, [0x4a, 0x52, 0x48]),
            (1.0, [0x75, 0x69, 0x5a]),
        ],
        light: [0.35, 1.0],
        casing: Casing { colour: [0x4f, 0xa8, 0xd8], strength: 0.5, margin: 0.3, blur: 2.0, gain: 2.5 },
    }),
    ..even([0x24, 0x3e, 0x3d], [0x09, 0x13, 0x1a], [0x7f, 0xb3, 0xc6], [0x6e, 0x60, 0x4c], [0xb5, 0xe0, 0xf7])
};

/// What of a picture is land: white, and all else black.
pub(crate) static LAND_ONLY: Palette = even([0xff; 3], [0; 3], [0; 3], [0xff; 3], [0; 3]);

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
        relief: None,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Choice;

    #[test]
    fn styles_that_show_relief_have_tints_for_it_and_no_others() {
        for &style in Style::ALL {
            assert_eq!(style.has_relief(), palette(style).relief.is_some(), "{style:?}");
        }
    }
}
