//! What a style is made of: its colours, how it draws rivers, and how it shows relief.

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
    /// Great rivers over their former beds; `None` if rivers are all alike.
    pub beds: Option<&'static Beds>,
    /// Lines over land and sea, the closest first.
    pub grids: &'static [Grid],
    /// What is under all of it; `None` if that is as even as a screen.
    pub paper: Option<&'static Paper>,
    /// How it shows relief; `None` if it does not.
    pub relief: Option<&'static ReliefLook>,
}

/// Great rivers and the beds that they have left.
#[derive(Debug)]
pub(crate) struct Beds {
    /// Of the rounds that are kept, the oldest first.
    pub colours: &'static [Colour],
    /// The line on both sides of a former bed.
    pub line: Colour,
    /// The rivers as they are, and the line on both sides.
    pub water: Colour,
    pub bank: Colour,
}

/// Lines from north to south and from west to east.
#[derive(Debug)]
pub(crate) struct Grid {
    /// How far apart they are, in units.
    pub every: f32,
    pub colour: Colour,
    pub strength: f32,
}

impl Grid {
    /// How wide they are, in units.
    pub const WIDTH: f32 = 0.8;
}

/// Paper, or other ground that is not even.
#[derive(Debug)]
pub(crate) struct Paper {
    pub blotch: Colour,
    pub blotched: f32,
    /// About how large blotches are, in units.
    pub size: f32,
    /// How many sizes they have, each half as large as the one before.
    pub octaves: i32,
    /// How much of them water has, as a share.
    pub at_sea: f32,
    /// The colour of its edges.
    pub edge: Colour,
    pub edged: f32,
}

/// Paper without blotches and edges.
pub(super) const BLANK: Paper =
    Paper { blotch: [0; 3], blotched: 0.0, size: 260.0, octaves: 4, at_sea: 1.0, edge: [0; 3], edged: 0.0 };

/// How a style shows relief, part by part.
#[derive(Debug)]
pub(crate) struct ReliefLook {
    pub tints: Tints,
    pub contours: Option<Contours>,
    pub hachures: Option<Hachures>,
    pub basins: Option<BasinColours>,
    /// What lies around rivers.
    pub casing: Casing,
}

/// Relief in tints and light alone.
pub(super) const fn tinted(stops: &'static [(f32, Colour)], darkest: f32) -> ReliefLook {
    let casing = Casing { colour: [0; 3], strength: 0.0, margin: 0.0, blur: 0.0, gain: 1.0 };
    let tints = Tints { stops, light: [darkest, 1.0], most: f32::MAX, shadow: [0; 3] };
    ReliefLook { tints, contours: None, hachures: None, basins: None, casing }
}

impl ReliefLook {
    /// Whether it depends on where rivers are.
    pub fn minds_rivers(&self) -> bool {
        self.contours.is_some() || self.hachures.is_some() || self.casing.strength > 0.0
    }
}

/// Colours by height and light.
#[derive(Debug)]
pub(crate) struct Tints {
    /// Colours by height, as shares of the highest; the first is 0.
    pub stops: &'static [(f32, Colour)],
    /// What colours are multiplied by where there is no light, and where there is as much as on flat land.
    pub light: [f32; 2],
    /// The most that they are multiplied by.
    pub most: f32,
    /// What is left of them where they are multiplied by nothing.
    pub shadow: Colour,
}

/// Lines of one height each.
#[derive(Debug)]
pub(crate) struct Contours {
    pub colour: Colour,
    /// Of usual lines, and of index lines: widths in units.
    pub widths: [f32; 2],
    pub strengths: [f32; 2],
}

/// Strokes down the slope.
#[derive(Debug)]
pub(crate) struct Hachures {
    pub colour: Colour,
    pub strength: f32,
}

/// A colour for each basin.
#[derive(Debug)]
pub(crate) struct BasinColours {
    pub colours: &'static [Colour],
    /// Land whose water runs to the sea in no river.
    pub rest: Colour,
    /// What colours are mixed into, and how much of them that takes.
    pub paper: Colour,
    pub strength: f32,
    /// What they are multiplied by for rivers.
    pub rivers: f32,
}

impl BasinColours {
    /// The colour of land in a basin of a numbered colour.
    pub fn tint(&self, number: usize) -> Colour {
        match number.checked_sub(1).and_then(|i| self.colours.get(i)) {
            Some(&colour) => mix(self.paper, colour, self.strength),
            None => self.rest,
        }
    }

    /// That of rivers there.
    pub fn river(&self, number: usize) -> Colour {
        mix([0; 3], self.colours[number.max(1) - 1], self.rivers)
    }
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

    /// What a colour is multiplied by in a light, which is a share of that on flat land.
    pub fn factor(&self, light: f32) -> f32 {
        let [none, full] = self.light;
        (none + (full - none) * light).min(self.most)
    }
}

/// How a style draws rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lines {
    /// As wide as they are, with the lakes that they have left.
    Wide,
    /// At half their width, without lakes: great rivers show theirs with their former beds.
    Thin,
    /// One pixel wide, without lakes.
    Skeleton,
}

/// What of a picture is land: white, and all else black.
pub(crate) static LAND_ONLY: Palette = even([0xff; 3], [0; 3], [0; 3], [0xff; 3], [0; 3]);

impl Lines {
    /// The share of their width that rivers are drawn with.
    pub fn share(self) -> f32 {
        if self == Self::Thin { 0.5 } else { 1.0 }
    }
}

impl Palette {
    /// The colour of each coverage by river, from bare plain land to river. Made for a picture: as a table for each style it
    /// would weigh a kilobyte of every download.
    pub fn ramp(&self) -> [[u8; 4]; 256] {
        std::array::from_fn(|coverage| over(self.plain, self.river, coverage as u32))
    }
}

/// Land and water of one colour each, no rings.
pub(super) const fn even(land: Colour, water: Colour, coast: Colour, ridge: Colour, river: Colour) -> Palette {
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
        beds: None,
        grids: &[],
        paper: None,
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
