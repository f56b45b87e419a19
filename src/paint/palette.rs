//! The colours of the styles.

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
    /// How far from the coast land and water have their farther colour, in units.
    pub fade: f32,
    pub coast: Colour,
    /// Distances from the coast of the rings that old engravers drew, in units, outermost last, with their strength.
    pub rings: &'static [(f32, f32)],
    pub ridge: Colour,
    pub river: Colour,
    /// The colour of each coverage by river, from bare plain land to river.
    pub ramp: [[u8; 4]; 256],
}

/// Ink on paper.
pub(super) static INK: Palette = Palette {
    rings: &[(7.0, 0.34), (16.0, 0.2), (28.0, 0.1)],
    ..even([0xf6, 0xf0, 0xe2], [0xdd, 0xe6, 0xe4], [0x4a, 0x62, 0x78], [0xa8, 0x93, 0x78], [0x1f, 0x3f, 0x66])
};

/// A map as atlases colour it: green lowland, blue water.
pub(super) static MAP: Palette = Palette {
    lowland: [0xdc, 0xe6, 0xc8],
    inland: [0xf1, 0xea, 0xd3],
    deep: [0xa9, 0xcc, 0xdf],
    fade: 140.0,
    ..even([0xe8, 0xe9, 0xcf], [0xcb, 0xe2, 0xec], [0x5f, 0x93, 0xb0], [0xb0, 0x97, 0x74], [0x2f, 0x74, 0xa8])
};

/// White on black, the coast dim.
pub(super) static NIGHT: Palette = even([0; 3], [0; 3], [0x58; 3], [0x38; 3], [0xff; 3]);

#[cfg(feature = "tools")]
impl Palette {
    /// The colour of land where all of the domain is.
    pub fn plain(&self) -> Colour {
        let [red, green, blue, _] = self.ramp[0];
        [red, green, blue]
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
        ramp: ramp(land, river),
    }
}

const fn ramp(from: Colour, to: Colour) -> [[u8; 4]; 256] {
    let mut ramp = [[255; 4]; 256];
    let mut coverage = 0;
    while coverage < 256 {
        let mut channel = 0;
        while channel < 3 {
            ramp[coverage][channel] = blend(from[channel], to[channel], coverage as u32);
            channel += 1;
        }
        coverage += 1;
    }
    ramp
}

/// A channel, covered by another in so many 255ths.
pub(super) const fn blend(from: u8, to: u8, coverage: u32) -> u8 {
    ((from as u32 * (255 - coverage) + to as u32 * coverage + 127) / 255) as u8
}

/// A colour, so much of the way to another.
pub(crate) fn mix(from: Colour, to: Colour, share: f32) -> Colour {
    std::array::from_fn(|i| (f32::from(from[i]) + (f32::from(to[i]) - f32::from(from[i])) * share + 0.5) as u8)
}
