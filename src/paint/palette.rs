//! The parts of a style: its colours, its rivers and its relief.

use super::belts::Belts;

/// A colour: red, green, blue.
pub(crate) type Colour = [u8; 3];

/// The colours and forms of a style.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Palette {
    /// The colours of land at the coast and far from it.
    pub lowland: Colour,
    pub inland: Colour,
    /// The colours of water at the coast and far from it.
    pub shallows: Colour,
    pub deep: Colour,
    /// The distance from the coast beyond which land and water have only their farther colour, in units.
    pub fade: f32,
    pub coast: Colour,
    /// The rings around coasts that old engravers drew: distance from the coast in units and strength, outermost last.
    pub rings: &'static [(f32, f32)],
    pub ridge: Colour,
    pub river: Colour,
    /// The colour of land if the whole domain is land.
    pub plain: Colour,
    pub lines: Lines,
    /// `true` if wide rivers are two banks with water between, in the colour of the shallows.
    pub is_open: bool,
    /// The width of the line along each bank of such a river, or of any where the sea reaches into its mouth, in units.
    pub bank: f32,
    /// The look of great rivers over their former beds; `None` if all rivers look alike.
    pub beds: Option<&'static Beds>,
    /// Grids over land and sea, the closest lines first.
    pub grids: &'static [Grid],
    /// The paper under everything; `None` for an even colour.
    pub paper: Option<Paper>,
    /// The look of relief; `None` if the style has none.
    pub relief: Option<ReliefLook>,
    /// The look of the border of a map whose land runs off it; `None` if the style has none.
    pub neatline: Option<NeatlineLook>,
}

/// The look of the border of a map.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NeatlineLook {
    /// The paper beyond the map.
    pub paper: Colour,
    pub line: Colour,
}

/// Returns the look of a border with a line of one colour on paper of another.
pub(super) const fn bordered(paper: Colour, line: Colour) -> Option<NeatlineLook> {
    Some(NeatlineLook { paper, line })
}

/// The look of great rivers and of their former beds.
#[derive(Debug)]
pub(crate) struct Beds {
    /// The colours of flood plains and of the lines around them.
    pub plain: Colour,
    pub bluff: Colour,
    /// The colours of scars that are older than all rounds, the oldest first.
    pub old: [Colour; Belts::SCARS],
    /// The colours of the rounds that are kept, oldest first.
    pub colours: &'static [Colour],
    /// The colour of the lines on both sides of a former bed.
    pub line: Colour,
    /// The colours of the current rivers and of the lines on both sides.
    pub water: Colour,
    pub bank: Colour,
}

/// Lines from north to south and from west to east.
#[derive(Debug)]
pub(crate) struct Grid {
    /// The distance between two lines, in units.
    pub every: f32,
    pub colour: Colour,
    pub strength: f32,
}

impl Grid {
    /// The width of the lines, in units.
    pub const WIDTH: f32 = 0.8;
}

/// Paper, or another uneven ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paper {
    pub blotch: Colour,
    pub blotched: f32,
    /// The approximate size of blotches, in units.
    pub size: f32,
    /// The number of sizes of blotches, each half as large as the previous one.
    pub octaves: i32,
    /// The strength of blotches on water, as a share of that on land.
    pub at_sea: f32,
    /// The colour towards the edges.
    pub edge: Colour,
    pub edged: f32,
}

/// Paper without blotches and edges.
pub(super) const BLANK: Paper =
    Paper { blotch: [0; 3], blotched: 0.0, size: 260.0, octaves: 4, at_sea: 1.0, edge: [0; 3], edged: 0.0 };

/// The look of a style's relief, part by part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReliefLook {
    pub tints: Tints,
    pub contours: Option<Contours>,
    pub hachures: Option<Hachures>,
    pub basins: Option<BasinColours>,
    /// The surroundings of rivers.
    pub casing: Casing,
}

/// Makes the look of a relief of tints and light alone. Tints are those at heights in metres.
pub(super) const fn tinted(stops: &[(f32, Colour)], shadow: (Colour, f32), highlight: (Colour, f32)) -> ReliefLook {
    let casing = Casing { colour: [0; 3], strength: 0.0, margin: 0.0, blur: 0.0, gain: 1.0 };
    let tints = Tints {
        stops: Tints::filled(stops),
        shadow: shadow.0,
        dark: shadow.1,
        highlight: highlight.0,
        bright: highlight.1,
    };
    ReliefLook { tints, contours: None, hachures: None, basins: None, casing }
}

impl ReliefLook {
    /// Returns `true` if the relief depends on where rivers are.
    pub fn minds_rivers(&self) -> bool {
        self.contours.is_some() || self.hachures.is_some() || self.casing.strength > 0.0
    }
}

/// Colours by height and light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tints {
    /// Colours by height, in metres over the sea; the first height is 0. Where a style has fewer, the last comes again.
    pub stops: [(f32, Colour); Tints::STOPS],
    /// The colour of shadow, and its share in the darkest: a wash that lets the tint through.
    pub shadow: Colour,
    pub dark: f32,
    /// The colour of full light, and its share there.
    pub highlight: Colour,
    pub bright: f32,
}

/// Lines of equal height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Contours {
    pub colour: Colour,
    /// The widths of usual lines and of index lines, in units.
    pub widths: [f32; 2],
    pub strengths: [f32; 2],
}

/// Strokes down the slope.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hachures {
    pub colour: Colour,
    pub strength: f32,
}

/// A colour for each basin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BasinColours {
    pub colours: &'static [Colour],
    /// The colour of land that drains to the sea without a river.
    pub rest: Colour,
    /// The colour that basins are mixed into, and their share of the mixture.
    pub paper: Colour,
    pub strength: f32,
    /// The factor that darkens the colour of a basin for its rivers.
    pub rivers: f32,
}

impl BasinColours {
    /// Returns the colour of land in a basin with a numbered colour.
    pub fn tint(&self, number: usize) -> Colour {
        match number.checked_sub(1).and_then(|i| self.colours.get(i)) {
            Some(&colour) => mix(self.paper, colour, self.strength),
            None => self.rest,
        }
    }

    /// Returns the colour of rivers in a basin with a numbered colour.
    pub fn river(&self, number: usize) -> Colour {
        mix([0; 3], self.colours[number.max(1) - 1], self.rivers)
    }
}

/// The surroundings of rivers: a light edge or a glow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Casing {
    pub colour: Colour,
    pub strength: f32,
    /// The reach on both sides before blurring, in units.
    pub margin: f32,
    /// The radius of the blur in units, and the factor that makes up for it.
    pub blur: f32,
    pub gain: f32,
}

impl Tints {
    /// The height above which colours do not change any more, in metres.
    const HIGHEST: f32 = 3200.0;

    /// The most colours that a style has by height.
    pub const STOPS: usize = 10;

    /// Fills the list of colours of a style with its last.
    const fn filled(some: &[(f32, Colour)]) -> [(f32, Colour); Self::STOPS] {
        let (mut stops, mut i) = ([some[some.len() - 1]; Self::STOPS], 0);
        while i < some.len() {
            stops[i] = some[i];
            i += 1;
        }
        stops
    }

    /// Returns `true` if land has one colour at all heights.
    pub fn are_even(&self) -> bool {
        self.stops.iter().all(|stop| stop.1 == self.stops[0].1)
    }

    /// Returns the place of a height on a scale from 0 at the sea to 1 at [`Tints::HIGHEST`] metres and above, which is
    /// the finer the lower it is: lowland has more tints.
    pub fn place_of(metres: f32) -> f32 {
        (metres / Self::HIGHEST).clamp(0.0, 1.0).sqrt()
    }

    /// Returns the height at a place on the scale of tints, in metres.
    pub fn metres_at(place: f32) -> f32 {
        place * place * Self::HIGHEST
    }

    /// Returns the colour of flat land at a height in metres.
    pub fn at(&self, metres: f32) -> Colour {
        let above = self.stops.iter().position(|stop| stop.0 >= metres).unwrap_or(self.stops.len() - 1);
        let ((from, low), (to, high)) = (self.stops[above.saturating_sub(1)], self.stops[above]);
        let share = if to > from { ((metres - from) / (to - from)).min(1.0) } else { 0.0 };
        mix(low, high, share)
    }

    /// Returns a tint in a light from -1, the darkest, over 0, that on flat land, to 1.
    pub fn lit(&self, tint: Colour, light: f32) -> Colour {
        if light < 0.0 {
            mix(tint, self.shadow, -light * self.dark)
        } else {
            mix(tint, self.highlight, light * self.bright)
        }
    }
}

/// The lines of a style's rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lines {
    /// At full width, with oxbow lakes.
    Wide,
    /// At half width, without oxbow lakes. Great rivers show theirs with their former beds.
    Thin,
    /// One pixel wide, without oxbow lakes.
    Skeleton,
}

/// A palette that shows land in white and everything else in black.
pub(crate) static LAND_ONLY: Palette = even([0xff; 3], [0; 3], [0; 3], [0xff; 3], [0; 3]);

impl Lines {
    /// Returns the share of their width at which rivers are drawn.
    pub fn share(self) -> f32 {
        if self == Self::Thin { 0.5 } else { 1.0 }
    }
}

impl Palette {
    /// Returns the colour for each coverage, from bare plain land to river. It is computed for each picture: a table
    /// for each style would add a kilobyte to every download.
    pub fn ramp(&self) -> [[u8; 4]; 256] {
        std::array::from_fn(|coverage| over(self.plain, self.river, coverage as u32))
    }
}

/// Makes a palette with one colour for land and one for water, without rings.
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
        is_open: false,
        bank: 0.5,
        beds: None,
        grids: &[],
        paper: None,
        relief: None,
        neatline: None,
    }
}

/// Makes the colour of a ground opaque; its fourth channel holds another value.
#[inline]
pub(super) fn opaque(ground: [u8; 4]) -> [u8; 4] {
    const OPAQUE: u32 = u32::from_le_bytes([0, 0, 0, 255]);
    (u32::from_le_bytes(ground) | OPAQUE).to_le_bytes()
}

/// Covers a colour by another, with `coverage` in 255ths. The result is opaque.
#[inline]
pub(super) fn over([red, green, blue]: Colour, by: Colour, coverage: u32) -> [u8; 4] {
    let blend = |from: u8, to: u8| ((u32::from(from) * (255 - coverage) + u32::from(to) * coverage + 127) / 255) as u8;
    [blend(red, by[0]), blend(green, by[1]), blend(blue, by[2]), 255]
}

/// Mixes two colours; `share` is that of the second.
pub(crate) fn mix(from: Colour, to: Colour, share: f32) -> Colour {
    std::array::from_fn(|i| (f32::from(from[i]) + (f32::from(to[i]) - f32::from(from[i])) * share + 0.5) as u8)
}
