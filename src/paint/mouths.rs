//! Mouths: where a river opens the line of the coast and its water turns into that of the sea.
//!
//! Rivers end at the line of the coast, which lies over them. A river that is wide enough then gets a tongue of the sea:
//! it opens the line between the banks, and upstream it fades into the river. What is left of the river on both sides of
//! it are the lines of the banks, which run out into that of the coast. A brook has no tongue and ends in the line.
//! In styles whose rivers are open between two banks, their water is the sea's already: nothing is seen of the tongue there
//! but the line that it opens.

use glam::Vec2;
use tiny_skia::Pixmap;

use super::beds::is_great;
use super::coverage::{Coverage, Rect};
use super::ground::COAST_WIDTH;
use super::palette::{Beds, Lines, Palette, over};
use super::paper::WaterColour;
use super::rivers::draw_line;
use super::strokes::Vertex;
use super::view::View;
use super::waters::Opening;
use crate::base::geometry::{direction, distance};
use crate::deltas::Distributary;
use crate::land::SmoothedDistance;
use crate::network::{Network, PastCourses, Place};
use crate::recipe::CourseShape;

/// The tongue of the sea in a mouth.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tongue {
    /// Its middle line between the banks, from inland to the point of the coast, and the way that it goes on.
    line: Vec<Place>,
    along: Vec2,
    /// Half its width at the coast, in units.
    half: f32,
    /// Half the width of the line of the coast, in units.
    half_coast: f32,
    /// The distance to which a tongue reaches inland from the point of the coast, and beyond it, in units.
    pub reach: f32,
    beyond: f32,
    /// `true` if its river gives way to letters.
    gives_way: bool,
}

impl Tongue {
    /// Returns the point of the coast in the tongue.
    pub fn at(&self) -> Vec2 {
        self.line.last().map_or(Vec2::ZERO, |place| place.at)
    }

    /// Returns the share of the sea at a distance from the point of the coast, in reaches.
    pub fn share(away: f32) -> f32 {
        /// Up to here it is all sea.
        const WHOLE: f32 = 0.25;
        let left = ((1.0 - away) / (1.0 - WHOLE)).clamp(0.0, 1.0);
        left * left * (3.0 - 2.0 * left)
    }

    /// Returns how far the line of the coast bends into a bank at a place in it, from 0 in its middle to 1 at the sea,
    /// in units.
    fn aside(&self, across: f32) -> f32 {
        let (radius, way) = (self.half.min(self.half_coast), across.clamp(0.0, 1.0));
        radius * (1.0 - (1.0 - way * way).sqrt())
    }

    /// Returns the line of the tongue to its end, with its whole width.
    pub fn whole_line(&self) -> Vec<Place> {
        const STEPS: u8 = 4;
        let edge = self.along * self.half_coast;
        let opened = (1..=STEPS).map(|step| f32::from(step) / f32::from(STEPS));
        let opened = opened.map(|way| Place { at: self.at() + edge * way, half: self.half + self.aside(way) });
        let end = Place { at: self.at() + self.along * self.beyond, half: self.half + self.aside(1.0) };
        self.line.iter().copied().chain(opened).chain([end]).collect()
    }

    /// Returns the line of the tongue to its end, with the width that it has between the banks.
    fn even_line(&self) -> Vec<Place> {
        let end = Place { at: self.at() + self.along * self.beyond, half: self.half };
        self.line.iter().copied().chain([end]).collect()
    }
}

/// The look of the rivers that get tongues.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drawn<'a> {
    pub palette: &'a Palette,
    /// How rivers open between their banks, and the scale of that in pixels per unit; `None` if they do not.
    pub opening: Option<Opening>,
    pub scale: f32,
    /// The former courses of great rivers; `None` if those are drawn like the others.
    pub past: Option<&'a PastCourses>,
    /// The factor and the margin of the distance of the banks from the middle, in units.
    pub times: f32,
    pub margin: f32,
    /// The least width of the line that is left along a bank, in units: as much as can be seen.
    pub hairline: f32,
    /// The width of the line of the coast, in units.
    pub coast_width: f32,
}

impl Drawn<'_> {
    /// Finds the tongues in all mouths at a coast, of rivers and of their branches in deltas.
    pub fn tongues(&self, network: &Network, distributaries: &[Distributary], shown: &SmoothedDistance) -> Vec<Tongue> {
        if self.palette.lines == Lines::Skeleton {
            return Vec::new();
        }
        let past = self.past.filter(|_| self.palette.beds.is_some());
        let is_great = past.map(|past| is_great(network, past));
        let tongue = |id: u32| {
            let river = &network.rivers[id as usize];
            let is_great = is_great.as_ref().is_some_and(|is_great| is_great(id, river.order));
            self.tongue(&network.middle(river), is_great, shown)
        };
        let branch = |branch: &Distributary| self.tongue(&branch.middle(), false, shown);
        let branches = distributaries.iter().filter(|branch| branch.reaches_sea).filter_map(branch);
        network.mouths().into_iter().filter_map(tongue).chain(branches).collect()
    }

    /// Finds the tongue in the mouth of a river; `None` if that is a brook, or ends elsewhere than at a coast.
    fn tongue(&self, middle: &[Place], is_great: bool, shown: &SmoothedDistance) -> Option<Tongue> {
        /// The farthest of a mouth from the coast that is shown, in units.
        const NEAR: f32 = 2.0;
        /// The least distance to which a tongue reaches beyond the line, in units. What lies beyond it is not drawn.
        const BEYOND: f32 = 0.6;
        /// The reach inland, in units and in widths.
        const REACH: f32 = 1.5;
        const WIDTHS: f32 = 1.6;
        /// The least half width, in units: less would be a nick in the line of the coast.
        const LEAST: f32 = 0.25;
        let [course @ .., mouth, end] = middle else { return None };
        let half = self.half(mouth, is_great);
        let (height, rise) = shown.at(mouth.at);
        let least = if self.opening.is_some() { self.hairline * 0.5 } else { LEAST.max(self.hairline * 0.75) };
        if half <= least || height.abs() > NEAR {
            return None;
        }
        let seaward = -direction(rise);
        let along = direction(direction(end.at - mouth.at) + seaward);
        let half_coast = self.coast_width * 0.5;
        let beyond = half_coast + BEYOND + half;
        let reach = REACH + WIDTHS * 2.0 * mouth.half;
        let inner = |place: &Place| Place { half: self.half(place, is_great).max(0.0), ..*place };
        let mut line = vec![Place { at: mouth.at + seaward * height, half }, inner(mouth)];
        let (mut below, mut way) = (mouth, 0.0);
        for place in course.iter().rev() {
            line.push(inner(place));
            way += distance(place.at, below.at);
            below = place;
            if way > reach {
                break;
            }
        }
        line.reverse();
        Some(Tongue { line, along, half, half_coast, reach, beyond, gives_way: !is_great })
    }

    /// Returns half the width of the sea between the banks at a place of a river.
    fn half(&self, place: &Place, is_great: bool) -> f32 {
        if is_great {
            return Beds::half(place, 0.0) + self.margin;
        }
        let whole = place.half * self.palette.lines.share() * self.times + self.margin;
        if let Some(opening) = self.opening {
            return opening.half_px(whole * self.scale) / self.scale;
        }
        let bank = if self.palette.bank > 0.0 { self.palette.bank.max(self.hairline) } else { 0.0 };
        whole - bank
    }
}

/// The pixels of tongues, each with the share of the sea in it, in 255ths.
pub(super) type SeaShares = Vec<(u32, u8)>;

/// Draws tongues on a picture.
#[derive(Clone, Copy)]
pub(super) struct TonguePainter<'a> {
    pub view: &'a View,
    pub courses: CourseShape,
    pub shown: &'a SmoothedDistance,
    /// The mask of the rivers: where letters interrupt a river, there is no tongue.
    pub rivers: &'a Coverage,
    /// The water between banks, in 255ths of each pixel; `None` if rivers do not open.
    pub open: Option<&'a [u8]>,
}

impl TonguePainter<'_> {
    /// Adds the pixels of a tongue.
    pub fn draw(&self, tongue: &Tongue, shares: &mut SeaShares) {
        let in_pixels = |place: &Place| (self.view.pixel(place.at), place.half * self.view.scale);
        let mut line: Vec<Vertex> = tongue.even_line().iter().map(in_pixels).collect();
        let Some(rect) = around(&line, COAST_WIDTH * self.view.scale, self.view) else { return };
        let Some(mut mask) = Coverage::new(rect.right - rect.left, rect.bottom - rect.top) else { return };
        let corner = Vec2::new(rect.left as f32, rect.top as f32);
        line.iter_mut().for_each(|vertex| vertex.0 -= corner);
        draw_line(&mut mask, &line, self.courses);
        for (y, row) in (rect.top..).zip(mask.mask().data().chunks(mask.mask().width() as usize)) {
            for (x, &between) in (rect.left..).zip(row) {
                let i = y * self.view.width + x;
                let share = self.share(tongue, i as usize, Vec2::new(x as f32, y as f32) + 0.5, between);
                if share > 0 {
                    shares.push((i, share));
                }
            }
        }
    }

    /// Returns the share of the sea in a pixel, given how much of it lies between the banks.
    fn share(&self, tongue: &Tongue, i: usize, pixel: Vec2, between: u8) -> u8 {
        let (at, scale) = (self.view.point(pixel), self.view.scale);
        let ashore = off_coast(self.shown, at);
        let mut covered = f32::from(between);
        if ashore > tongue.half_coast {
            // Land on either side of a narrow bay is none of the sea's, but the bank of a wider river that ends there.
            let is_ahead = (at - tongue.at()).dot(tongue.along) > 0.0;
            let seen = match self.open.filter(|_| is_ahead) {
                Some(open) => open[i],
                None if tongue.gives_way => self.rivers.mask().data()[i],
                None => u8::MAX,
            };
            covered = covered.min(f32::from(seen));
        } else if ashore < 0.0 {
            let off = at - tongue.at();
            let half = tongue.half + tongue.aside(-ashore / tongue.half_coast);
            let opened = (half - off.perp_dot(tongue.along).abs()) * scale + 0.5;
            let is_here = off.length_squared() < (half + COAST_WIDTH) * (half + COAST_WIDTH);
            covered = covered.max(if is_here { opened.clamp(0.0, 1.0) * 255.0 } else { 0.0 });
        }
        // The line of the coast ends three quarters of a pixel beyond its edge, and there the tongue does.
        let inside = ((ashore + tongue.half_coast) * scale + 1.25).clamp(0.0, 1.0);
        (Tongue::share(distance(at, tongue.at()) / tongue.reach) * inside * covered + 0.5) as u8
    }
}

/// Returns the distance of a point from the coast as its line is drawn, in units; negative at sea.
fn off_coast(shown: &SmoothedDistance, at: Vec2) -> f32 {
    let (height, rise) = shown.at(at);
    height / rise.length().max(0.01)
}

/// Returns the pixels around a line, with a margin.
fn around(line: &[Vertex], margin: f32, view: &View) -> Option<Rect> {
    let (mut least, mut most) = (Vec2::splat(f32::MAX), Vec2::splat(f32::MIN));
    for (at, radius) in line {
        (least, most) = (least.min(*at - *radius - margin), most.max(*at + *radius + margin));
    }
    Rect::between([least, most], view.width, view.height)
}

/// Lays tongues over a picture, in the colour of the water at the coast. `opened` is the share of a pixel that has it
/// already, in 255ths.
pub(super) fn lay(pixmap: &mut Pixmap, shares: &SeaShares, opened: &dyn Fn(usize) -> u32, colour: &WaterColour<'_>) {
    let width = pixmap.width();
    let pixels = pixmap.data_mut().as_chunks_mut::<4>().0;
    for &(i, share) in shares {
        let Some(pixel) = pixels.get_mut(i as usize) else { return };
        let (share, opened) = (u32::from(share), opened(i as usize));
        if share > opened {
            let [red, green, blue, _] = *pixel;
            // Laid over what is not water yet, so that together there is as much as the share.
            let more = (share - opened) * 255 / (255 - opened);
            *pixel = over([red, green, blue], colour.at(i % width, i / width), more);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::land::CoastDistance;
    use crate::network::{NONE, River, Vertex};
    use crate::paint::styles::palette;
    use crate::recipe::Style;

    /// The pixels of a unit in which rivers open.
    const SCALE: f32 = 2.0;

    /// Makes the tongue of a river that runs east through a coast at x = 500.
    fn tongue_of(width: f32, end: f32, style: Style) -> Option<Tongue> {
        let domain = Domain::with_aspect(1.0);
        let coast = CoastDistance::of_strait(&domain, Vec2::new(700.0, -50.0), Vec2::new(700.0, 1050.0), 400.0);
        let vertex = |i: u8| Vertex {
            at: Vec2::new(end - 5.0 * f32::from(i), 400.0),
            left: width / 2.0,
            right: width / 2.0,
            ..Vertex::default()
        };
        let river = River { start: 0, end: 30, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: 0 };
        let network =
            Network { vertices: (0..30).rev().map(vertex).collect(), rivers: vec![river], ..Network::default() };
        let drawn = Drawn {
            palette: &palette(style.into()),
            opening: Opening::of(&palette(style.into()), SCALE),
            scale: SCALE,
            past: None,
            times: 1.0,
            margin: 0.0,
            hairline: 0.0,
            coast_width: COAST_WIDTH,
        };
        drawn.tongues(&network, &[], &SmoothedDistance::of(&coast)).pop()
    }

    #[test]
    fn the_sea_reaches_into_wide_rivers_at_a_coast_alone() {
        assert!(tongue_of(4.0, 500.0, Style::Ink).is_some() && tongue_of(4.0, 501.0, Style::Ink).is_some());
        assert_eq!(tongue_of(1.0, 500.0, Style::Ink), None, "a brook");
        assert_eq!(tongue_of(4.0, 300.0, Style::Ink), None, "a river that ends inland");
        assert_eq!(tongue_of(4.0, 500.0, Style::Skeleton), None, "a line");
    }

    #[test]
    fn a_tongue_leaves_the_banks_and_opens_the_whole_line_of_the_coast() {
        let ink = Opening::of(&palette(Style::Ink.into()), SCALE).unwrap();
        assert!(ink.half_px(2.0 * SCALE) > 0.0);
        for (style, half) in [(Style::Night, 1.5), (Style::Ink, ink.half_px(2.0 * SCALE) / SCALE)] {
            let tongue = tongue_of(4.0, 500.0, style).unwrap();
            assert!(tongue.whole_line().iter().all(|place| place.at.x >= 500.0 || place.half == half), "{style:?}");
        }
        let tongue = tongue_of(4.0, 500.0, Style::Night).unwrap();
        let line = tongue.whole_line();
        assert!((tongue.at() - Vec2::new(500.0, 400.0)).length() < 0.6, "{}", tongue.at());
        assert!(line[0].at.x < 500.0 - tongue.reach, "{line:?}");
        let (first, last) = (line[0], line[line.len() - 1]);
        assert!(last.at.x > 500.0 + COAST_WIDTH * 0.5 && last.half > first.half, "{line:?}");
    }

    #[test]
    fn a_tongue_fades_upstream_from_all_to_nothing() {
        assert_eq!([0.0, 0.2, 1.0, 3.0].map(Tongue::share), [1.0, 1.0, 0.0, 0.0]);
        let shares: Vec<f32> = (0..=20).map(|i| Tongue::share(i as f32 / 20.0)).collect();
        assert!(shares.windows(2).all(|pair| pair[0] >= pair[1] && pair[0] - pair[1] < 0.11), "{shares:?}");
    }
}
