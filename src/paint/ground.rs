//! The ground under rivers where there is a sea: land and water by their distance from the coast, rings, the coast line
//! and ridges.

use glam::Vec2;

use super::coverage::{Coverage, Covered};
use super::palette::{Colour, Palette, Tints, mix};
use super::ridges::ridges;
use super::view::{Rows, View};
use crate::land::{Across, CoastDetail, Land, Parabola, REACH, SmoothedDistance};

/// The widths of lines, in units, in files and in pictures whose pixels are not small.
pub(crate) const RING_WIDTH: f32 = 1.1;
pub(crate) const COAST_WIDTH: f32 = 1.8;

/// Returns the share of their full width that lines have with so many pixels to a unit: in print they would be as thick as
/// a marker pen's, so they grow with the root of the size.
pub(super) fn thinned(scale: f32) -> f32 {
    /// A picture of some 2,000 pixels.
    const FULL: f32 = 1.65;
    (FULL / scale).min(1.0).sqrt()
}

/// A coast as pictures show it.
#[derive(Clone, Copy)]
pub(super) struct ShownCoast<'a> {
    pub smooth: &'a SmoothedDistance,
    /// The detail between its corners; `None` if pixels are too large for that.
    pub detail: Option<&'a CoastDetail>,
}

/// The fourth channel of a ground's pixels on the line of the coast, where land begins but rivers have ended. It rises from
/// 0 at sea over this value to 255 on land.
const ON_COAST: u8 = 127;

/// Returns the share of land in a pixel of a ground, given its fourth channel, in 255ths. The line of the coast is
/// land.
#[inline]
pub(super) fn land_share(ashore: u8) -> u8 {
    ashore.min(ON_COAST) * 2 + ashore.min(1)
}

/// Returns the visibility of rivers in a pixel of a ground, given its fourth channel, in 255ths.
#[inline]
pub(super) fn river_share(ashore: u8) -> u8 {
    ashore.saturating_sub(ON_COAST).saturating_mul(2)
}

/// Returns the fourth channel after something has covered a part of the pixel that hides rivers, in 255ths.
pub(super) fn without_rivers(ashore: u8, covered: u8) -> u8 {
    ashore - (u32::from(ashore.saturating_sub(ON_COAST)) * u32::from(covered) / 255) as u8
}

/// The ground of a picture, painted from north to south. The fourth channel of its pixels is not opacity: it says what
/// is land (`land_share`) and where rivers are seen (`river_share`).
#[derive(Clone, Debug)]
pub(super) struct Ground {
    shades: Shades,
    stretches: Vec<Stretch>,
    /// The spans of the row of corners around which rows were last painted.
    spans: Vec<Span>,
    spanned: Option<usize>,
    /// The mask and the colour of ridges; `None` if there are none.
    ridges: Option<(Coverage, Colour)>,
}

impl Ground {
    /// Begins the ground of a style. Land has the style's colours, or tints for its height as far as that can be told from
    /// the distance to the sea.
    pub fn new(
        view: &View,
        land: &Land,
        shown: &SmoothedDistance,
        (palette, tints): (&Palette, Option<&Tints>),
    ) -> Self {
        // Where there is relief, a ridge is that.
        let strokes = if palette.relief.is_none() { ridges(land) } else { Vec::new() };
        let mut mask = Coverage::new(view.width, view.height).filter(|_| !strokes.is_empty());
        mask.iter_mut().for_each(|mask| draw(mask, view, &strokes));
        Self {
            shades: Shades::new(view.scale, (palette, tints), shown),
            stretches: stretches(view, shown),
            spans: Vec::new(),
            spanned: None,
            ridges: mask.map(|mask| (mask, palette.ridge)),
        }
    }

    /// Paints the next rows, which follow the ones already painted.
    pub fn paint(&mut self, view: &View, shown: ShownCoast<'_>, rows: Rows, pixels: &mut Vec<[u8; 4]>) {
        let first = pixels.len();
        for y in rows.clone() {
            let at = view.point(Vec2::splat(y as f32 + 0.5)).y;
            let across = shown.smooth.across(at);
            // Several rows lie between the same corners.
            if self.spanned.replace(across.row) != Some(across.row) {
                self.spans = self.shades.spans(&self.stretches, shown, across.row);
            }
            for span in &self.spans {
                match span {
                    Span::Even(colour, count) => pixels.resize(pixels.len() + count, *colour),
                    Span::Uneven(stretch, Holds::Tints) => self.shades.tint(stretch, &across, pixels),
                    Span::Uneven(stretch, Holds::Lines) => {
                        self.shades.draw_lines(stretch, &across, shown.smooth, at, pixels)
                    }
                    Span::Uneven(stretch, Holds::Detail) => {
                        self.shades.draw_detail(stretch, &across, shown, at, pixels)
                    }
                }
            }
        }
        if let Some((ridges, colour)) = &self.ridges {
            lay_mask(&ridges.mask().data()[view.range(rows)], *colour, &|_| 1.0, &mut pixels[first..]);
        }
    }
}

/// Pixels of a row around one column of the lattice's corners. The height along them is a parabola.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    count: usize,
    column: usize,
    /// The distance of the first pixel's middle beyond the column, in intervals.
    first: f32,
}

/// Returns the stretches that make up a row.
fn stretches(view: &View, shown: &SmoothedDistance) -> Vec<Stretch> {
    let (width, mut start) = (view.width as usize, 0);
    let mut stretches = Vec::new();
    while start < width {
        let (column, first) = shown.column(view.point(Vec2::splat(start as f32 + 0.5)).x);
        // Up to the end of the picture, the pixels whose middles are nearest to this column.
        let rest = (0.5 - first) * shown.spacing() * view.scale;
        let count = (rest.ceil().max(1.0) as usize).min(width - start);
        stretches.push(Stretch { count, column, first });
        start += count;
    }
    stretches
}

/// Pixels of a row that are painted together.
#[derive(Clone, Debug)]
enum Span {
    /// A number of pixels of one colour, as in most of a picture, far from any coast.
    Even([u8; 4], usize),
    /// A stretch whose colours have to be looked up.
    Uneven(Stretch, Holds),
}

/// The lines of a stretch, besides its tints.
#[derive(Clone, Copy, Debug)]
enum Holds {
    Tints,
    Lines,
    /// Detail of a coast, and lines.
    Detail,
}

/// A table of the colours along the coast, by distance from it.
#[derive(Clone, Debug)]
struct Shades {
    colours: Vec<[u8; 4]>,
    /// The colours of the sea without rings, which show where a ring has no room; and that room, `None` if there are no rings.
    bare: Vec<[u8; 4]>,
    room: Option<RingRoom>,
    rings: &'static [(f32, f32)],
    /// The distance from its middle at which a line can still be seen, in units.
    margin: f32,
    /// The distance to the next pixel, in intervals of the lattice.
    step: f32,
    /// The length of an interval, in units.
    spacing: f32,
    /// The distances at the start and at the end of the table, in units.
    first: f32,
    end: f32,
    per_unit: f32,
}

impl Shades {
    fn new(scale: f32, (palette, tints): (&Palette, Option<&Tints>), smooth: &SmoothedDistance) -> Self {
        const PER_PIXEL: f32 = 16.0;
        let coast_width = COAST_WIDTH * thinned(scale);
        let past = (coast_width + 2.0 / scale).max(RING_WIDTH);
        let outermost = palette.rings.last().map_or(0.0, |ring| ring.0);
        let first = -palette.fade.max(outermost + past);
        let last = if tints.is_some() { TINTED } else { palette.fade }.max(past);
        let per_unit = PER_PIXEL * scale;
        let count = ((last - first) * per_unit) as usize + 1;
        let colour = |i: usize| shore(scale, (palette, tints), first + (i as f32 + 0.5) / per_unit);
        let (colours, end) = ((0..count).map(colour).collect(), first + count as f32 / per_unit);
        let without = Palette { rings: &[], ..*palette };
        let at_sea = if palette.rings.is_empty() { 0 } else { (-first * per_unit) as usize };
        let bare = (0..at_sea).map(|i| shore(scale, (&without, tints), first + (i as f32 + 0.5) / per_unit)).collect();
        let (spacing, room) = (smooth.spacing(), RingRoom::of(smooth, palette.rings));
        let step = 1.0 / (spacing * scale);
        Self {
            colours,
            bare,
            room,
            rings: palette.rings,
            margin: coast_width * 0.5 + 0.75 / scale,
            step,
            spacing,
            first,
            end,
            per_unit,
        }
    }

    /// Returns the spans of all rows nearest to one row of corners.
    fn spans(&self, stretches: &[Stretch], shown: ShownCoast<'_>, row: usize) -> Vec<Span> {
        let mut spans = Vec::new();
        for stretch in stretches {
            // No point between these heights is lower or higher than all of them.
            let around = shown.smooth.around(row, stretch.column);
            let (least, most) = around.fold((f32::MAX, f32::MIN), |(least, most), at| (least.min(at), most.max(at)));
            match (self.even(least, most), spans.last_mut()) {
                (Some(colour), Some(Span::Even(same, count))) if colour == *same => *count += stretch.count,
                (Some(colour), _) => spans.push(Span::Even(colour, stretch.count)),
                (None, _) => spans.push(Span::Uneven(*stretch, self.holds(least, most, shown.detail.is_some()))),
            }
        }
        spans
    }

    /// Returns the area between two heights, on a coast with or without detail.
    fn holds(&self, least: f32, most: f32, has_detail: bool) -> Holds {
        if has_detail && least < REACH && most > -REACH {
            return Holds::Detail;
        }
        if self.line_near(least, most).is_some() { Holds::Lines } else { Holds::Tints }
    }

    /// Adds the pixels of a stretch that no line comes near.
    fn tint(&self, stretch: &Stretch, across: &Across<'_>, pixels: &mut Vec<[u8; 4]>) {
        let heights = Parabola::of(across.around(stretch.column));
        let [mut height, mut rise, bend] = heights.steps(stretch.first, self.step);
        pixels.extend((0..stretch.count).map(|_| {
            let colour = self.at(height);
            height += rise;
            rise += bend;
            colour
        }));
    }

    /// Adds the pixels of a stretch with lines.
    fn draw_lines(
        &self,
        stretch: &Stretch,
        across: &Across<'_>,
        smooth: &SmoothedDistance,
        y: f32,
        pixels: &mut Vec<[u8; 4]>,
    ) {
        let (heights, south) = (Parabola::of(across.around(stretch.column)), across.rise(stretch.column));
        pixels.extend((0..stretch.count).map(|i| {
            let t = stretch.first + i as f32 * self.step;
            let height = heights.at(t);
            let Some(line) = self.line_near(height, height) else { return self.at(height) };
            let at = Vec2::new(smooth.x_of(stretch.column, t), y);
            self.near_line(line, height, (at, Vec2::new(heights.rise(t), south.at(t))))
        }));
    }

    /// Adds the pixels of a stretch along a coast with detail, at a y in units.
    fn draw_detail(
        &self,
        stretch: &Stretch,
        across: &Across<'_>,
        shown: ShownCoast<'_>,
        y: f32,
        pixels: &mut Vec<[u8; 4]>,
    ) {
        let Some(detail) = shown.detail else { return };
        let (heights, south) = (Parabola::of(across.around(stretch.column)), across.rise(stretch.column));
        pixels.extend((0..stretch.count).map(|i| {
            let t = stretch.first + i as f32 * self.step;
            let (smooth, rise) = (heights.at(t), Vec2::new(heights.rise(t), south.at(t)));
            let at = Vec2::new(shown.smooth.x_of(stretch.column, t), y);
            let (more, steeper) = detail.shift(at, smooth, rise.length() / self.spacing);
            let (height, rise) = (smooth + more, rise + steeper * self.spacing);
            // Where detail is steep, heights far from that of the coast are near its line.
            let off = height * self.spacing / rise.length().max(0.01);
            if off.abs() < self.margin {
                return self.at(off);
            }
            let Some(line) = self.line_near(height, height) else { return self.at(height) };
            self.near_line(line, height, (at, rise))
        }));
    }

    /// Returns the colour at a height near that of a line. A ring is fainter where it hardly has room, also beside the
    /// line of the coast.
    fn near_line(&self, line: f32, height: f32, (at, rise): (Vec2, Vec2)) -> [u8; 4] {
        let off = line + self.apart(height - line, rise);
        let with = self.at(off);
        let plain = self.bare.get(self.index(if line < 0.0 { height } else { off })).filter(|plain| **plain != with);
        let (Some(&[red, green, blue, _]), Some(room), Some(nearest)) = (plain, &self.room, self.rings.first()) else {
            return with;
        };
        let [r, g, b, ashore] = with;
        let [r, g, b] = mix([red, green, blue], [r, g, b], room.at(nearest.0.max(-line), at));
        [r, g, b, ashore]
    }

    /// Returns the height of a line, coast or ring, close to a range of heights.
    fn line_near(&self, least: f32, most: f32) -> Option<f32> {
        let rings = self.rings.iter().map(|ring| -ring.0);
        std::iter::once(0.0).chain(rings).find(|line| least - self.margin < *line && *line < most + self.margin)
    }

    /// Returns the distance from a line, given the difference in height. The two differ where the surface is flatter
    /// than a distance field should be, as between two coasts; lines would be too wide there. (`clamp` could panic, and
    /// would bring the code that prints floats into the page.)
    fn apart(&self, higher: f32, rise: Vec2) -> f32 {
        (higher * self.spacing / rise.length().max(0.01)).max(-self.margin).min(self.margin)
    }

    fn at(&self, height: f32) -> [u8; 4] {
        self.colours[self.index(height).min(self.colours.len() - 1)]
    }

    /// Returns the place of a height in the tables, which may end before it.
    fn index(&self, height: f32) -> usize {
        // A conversion turns negative numbers into 0.
        ((height - self.first) * self.per_unit) as u32 as usize
    }

    /// Returns the colour of all heights between two, if they have one.
    fn even(&self, least: f32, most: f32) -> Option<[u8; 4]> {
        if least >= self.end {
            return self.colours.last().copied();
        }
        if most <= self.first { self.colours.first().copied() } else { None }
    }
}

/// The shortest piece of a ring that is drawn in files, in units. In pictures what there is room for is longer.
pub(crate) const SHORTEST_RING: f32 = 8.0 * RING_WIDTH;

/// The room that rings have at sea. A ring has room where the water goes on to deepen beyond it, if only some way off. In a
/// narrow inlet there would be stray dashes and small closed rings.
#[derive(Clone, Debug)]
pub(crate) struct RingRoom {
    /// How deep the water is around each place.
    deepest: SmoothedDistance,
    /// By how much it is deeper than at a ring where that has room, in units.
    enough: f32,
}

impl RingRoom {
    /// Finds the room of some rings; `None` if there are no rings.
    pub fn of(smooth: &SmoothedDistance, rings: &[(f32, f32)]) -> Option<Self> {
        /// How much deeper that is, in units, and in steps from one ring to the next where rings are close.
        const DEEPER: f32 = 3.5;
        const STEPS: f32 = 1.4;
        /// How far off, in units.
        const AROUND: f32 = 8.0;
        let step = rings.windows(2).fold(rings.first()?.0, |least, pair| least.min(pair[1].0 - pair[0].0));
        Some(Self { deepest: smooth.lowered(AROUND), enough: DEEPER.min(step * STEPS) })
    }

    /// Returns the room of a ring at a distance from the coast, from 0 for none to 1, at a place of it.
    pub fn at(&self, distance: f32, place: Vec2) -> f32 {
        /// The part of what is enough where there is none yet.
        const NONE: f32 = 0.75;
        let deeper = (-self.deepest.at(place).0 - distance) / self.enough;
        ((deeper - NONE) / (1.0 - NONE)).clamp(0.0, 1.0)
    }
}

/// The distance from the sea up to which land is taken to rise as long as its relief is not known, in units.
const TINTED: f32 = 150.0;
/// The height that land is taken to have there and beyond, in metres: that of the middle of a usual island, without its
/// mountains.
const TINTED_METRES: f32 = 560.0;

/// Returns the colour at a distance from the coast, in units and positive on land, and the fourth channel there.
fn shore(scale: f32, (palette, tints): (&Palette, Option<&Tints>), distance: f32) -> [u8; 4] {
    let [coast_width, ring_width] = [COAST_WIDTH, RING_WIDTH].map(|width| width * thinned(scale));
    let far = if palette.fade > 0.0 { faded(distance.abs() / palette.fade) } else { 1.0 };
    let water = mix(palette.shallows, palette.deep, far);
    let rising = |tints: &Tints| tints.at(faded(distance.max(0.0) / TINTED) * TINTED_METRES);
    let land = tints.map_or_else(|| mix(palette.lowland, palette.inland, far), rising);
    let inside = |distance: f32| (distance * scale + 0.5).clamp(0.0, 1.0);
    let mut colour = mix(water, land, inside(distance));
    for (at, strength) in palette.rings {
        colour = mix(colour, palette.coast, line(scale, distance + at, ring_width) * strength);
    }
    let [r, g, b] = mix(colour, palette.coast, line(scale, distance, coast_width));
    // Rivers reach a pixel into the line of the coast, so that no land shows between the two.
    let seen = inside(distance - coast_width * 0.5 + 0.75 / scale);
    let (coast, rest) = (f32::from(ON_COAST), f32::from(255 - ON_COAST));
    [r, g, b, (inside(distance + coast_width * 0.5) * coast + seen * rest + 0.5) as u8]
}

/// Returns the share of the farther colour, given the share of the way over which it sets in. It ends without an edge.
fn faded(way: f32) -> f32 {
    let rest = 1.0 - way.min(1.0);
    1.0 - rest * rest
}

/// Returns the share of the way at which the farther colour has this share: the inverse of `faded`.
pub(crate) fn way_to(share: f32) -> f32 {
    1.0 - (1.0 - share).sqrt()
}

/// Returns the coverage of a pixel by a line, given its distance from the line and the line's width in units.
fn line(scale: f32, distance: f32, width: f32) -> f32 {
    let half_width_px = width * scale * 0.5 + 0.25;
    (half_width_px + 0.5 - distance.abs() * scale).clamp(0.0, 1.0) * (half_width_px * 2.0).min(1.0)
}

/// Draws strokes: lines between two places, each with half the width there, in units.
pub(super) fn draw(mask: &mut Coverage, view: &View, strokes: &[[(Vec2, f32); 2]]) {
    for &[(a, half_a), (b, half_b)] in strokes {
        mask.capsule(view.pixel(a), half_a * view.scale, view.pixel(b), half_b * view.scale);
    }
}

/// Lays a colour over the pixels that a mask covers. `open` is the strength of the colour in a pixel.
pub(super) fn lay_mask(mask: &[u8], colour: Colour, open: &dyn Fn(usize) -> f32, pixels: &mut [[u8; 4]]) {
    for (i, covered) in Covered::by(mask) {
        let [r, g, b, rest] = pixels[i];
        let [r, g, b] = mix([r, g, b], colour, f32::from(covered) / 255.0 * open(i));
        pixels[i] = [r, g, b, rest];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::land::CoastDistance;
    use crate::paint::styles::palette;
    use crate::recipe::Style;

    #[test]
    fn coasts_are_as_wide_along_a_strait_as_anywhere() {
        let domain = Domain::with_aspect(1.0);
        let view = View::new(&domain, 1000, 1000).unwrap();
        // Two coasts from one side of the domain to the other, at an angle to the lattice.
        let (from, to) = (Vec2::new(-50.0, 300.0), Vec2::new(1050.0, 620.0));
        let across = (to - from).perp().normalize();
        for width in [6.5, 9.0, 60.0] {
            let coast_distance = CoastDistance::of_strait(&domain, from, to, width);
            let shown = SmoothedDistance::of(&coast_distance);
            let land = Land::new(&domain, coast_distance, Vec::new());
            let mut pixels = Vec::new();
            let coast = ShownCoast { smooth: &shown, detail: None };
            Ground::new(&view, &land, &shown, (&palette(Style::Skeleton.into()), None)).paint(
                &view,
                coast,
                0..1000,
                &mut pixels,
            );
            let strait = (0..1000).flat_map(|y| (300..700).map(move |x| (x, y)));
            let coast = strait
                .map(|(x, y)| f32::from(pixels[y * 1000 + x][0]) / f32::from(palette(Style::Skeleton.into()).coast[0]))
                .sum::<f32>();
            let length = 2.0 * 400.0 / across.y.abs();
            // A drawn line is half a pixel wider than asked for.
            assert!(
                (coast / length - COAST_WIDTH - 0.5).abs() < 0.1,
                "{} wide, in a strait of {width}",
                coast / length
            );
        }
    }

    #[test]
    fn lines_of_depth_run_where_there_is_room_for_them() {
        let domain = Domain::with_aspect(1.0);
        let (from, to) = (Vec2::new(-50.0, 300.0), Vec2::new(1050.0, 620.0));
        let rings = palette(Style::Atlas.into()).rings;
        let nearest = rings[0].0;
        let room = |width: f32, distance: f32| {
            let shown = SmoothedDistance::of(&CoastDistance::of_strait(&domain, from, to, width));
            let off_coast = (to - from).perp().normalize() * (width / 2.0 - distance);
            RingRoom::of(&shown, rings).unwrap().at(distance, from.midpoint(to) + off_coast)
        };
        assert_eq!([9.0, 11.0].map(|width| room(width, nearest)), [0.0; 2], "narrower than three steps");
        assert_eq!([18.0, 60.0].map(|width| room(width, nearest)), [1.0; 2]);
        assert_eq!([18.0, 30.0].map(|width| room(width, rings[1].0)), [0.0, 1.0]);
        let shown = SmoothedDistance::of(&CoastDistance::of_strait(&domain, from, to, 60.0));
        assert!(RingRoom::of(&shown, &[]).is_none());
    }

    #[test]
    fn a_strait_without_room_has_the_colours_of_one_without_rings() {
        let domain = Domain::with_aspect(1.0);
        let view = View::new(&domain, 500, 500).unwrap();
        let (from, to) = (Vec2::new(-50.0, 300.0), Vec2::new(1050.0, 620.0));
        let pixels = |width: f32, palette: &Palette| {
            let coast_distance = CoastDistance::of_strait(&domain, from, to, width);
            let shown = SmoothedDistance::of(&coast_distance);
            let land = Land::new(&domain, coast_distance, Vec::new());
            let (mut pixels, coast) = (Vec::new(), ShownCoast { smooth: &shown, detail: None });
            Ground::new(&view, &land, &shown, (palette, None)).paint(&view, coast, 0..500, &mut pixels);
            pixels
        };
        let atlas = palette(Style::Atlas.into());
        let bare = Palette { rings: &[], ..atlas };
        let most = |width: f32| {
            let pairs = pixels(width, &atlas).into_iter().zip(pixels(width, &bare));
            pairs.map(|(with, without)| with[0].abs_diff(without[0])).max().unwrap()
        };
        assert!(most(10.0) <= 1, "but for rounding: {}", most(10.0));
        assert!(most(40.0) > 20, "{}", most(40.0));
    }

    #[test]
    fn land_whose_relief_is_not_known_rises_from_the_coast() {
        let atlas = palette(Style::Atlas.into());
        let tints = &atlas.relief.unwrap().tints;
        let land = |tints, distance: f32| shore(4.0, (&atlas, tints), distance)[..3].to_vec();
        // Lowland is green, and what lies behind it less and less so.
        let green = |distance: f32| {
            let colour = land(Some(tints), distance);
            i32::from(colour[1]) - i32::from(colour[0])
        };
        let greens = [3.0, 30.0, 80.0, 150.0].map(green);
        assert!(greens.is_sorted_by(|nearer, farther| nearer > farther), "{greens:?}");
        assert_eq!(land(Some(tints), 400.0), tints.at(TINTED_METRES));
        assert_eq!(land(None, 3.0), land(None, 400.0));
        // The sea is the same.
        assert_eq!(land(Some(tints), -20.0), land(None, -20.0));
    }

    #[test]
    fn the_line_of_the_coast_is_land_without_rivers() {
        let scale = 4.0;
        let ashore = |distance: f32| shore(scale, (&palette(Style::Ink.into()), None), distance)[3];
        let shares = |distance: f32| [land_share(ashore(distance)), river_share(ashore(distance))];
        assert_eq!([-2.0, 0.0, 2.0].map(shares), [[0, 0], [255, 0], [255, 255]]);
        assert_eq!([0, 100, 255].map(|covered| river_share(without_rivers(255, covered))), [255, 156, 0]);
    }
}
