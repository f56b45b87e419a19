//! Woods and hills: pen strokes in a mask of their own. A glyph first empties its silhouette and so hides the glyphs
//! behind it. Round crowns merge: the outlines of all are drawn, then the inside of all is emptied, so that only the edge
//! of what they cover together is left.

use glam::Vec2;

use super::super::coverage::{Coverage, Rect};
use super::super::styles::SceneryLook;
use super::super::view::View;
use super::masks::SparseMask;
use crate::annotate::glyph::{Fill, pieces_of};
use crate::annotate::place::{PenStroke, Shape, Standing};
use crate::base::memory;

/// The lowest half width of strokes in pixels.
const HALF_PX: f32 = 0.32;
/// The heights of trees and widths of hills, in pixels, below which they are left out: all of them, and every second
/// one.
const LEAST_PX: f32 = 1.2;
const HALVED_PX: f32 = 2.0;
/// The size in pixels below which a glyph has no fainter strokes.
const SHADED_PX: f32 = 4.0;
/// The strength of a wash as a share of that of faint strokes.
pub(crate) const WASH: f32 = 0.26;
/// The lit side of a wood: its own area moved by this, in units, lies in the light.
const LIT: Vec2 = Vec2::new(-1.9, -2.5);

/// The passes over all glyphs, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    /// Outlines of round crowns.
    Crowns,
    /// Their inside, without outlines.
    Merge,
    /// The wash over all of them.
    Wash,
    /// The light that takes it away but on their dark side.
    Light,
    /// All other glyphs.
    Others,
}

const PASSES: [Pass; 5] = [Pass::Crowns, Pass::Merge, Pass::Wash, Pass::Light, Pass::Others];

/// The mask of a picture's scenery while it is drawn.
#[derive(Clone, Debug)]
pub(crate) struct SceneryPainter {
    mask: Coverage,
    /// The wash on the dark side of woods.
    washed: Coverage,
    /// The inside of silhouettes, if the style covers it.
    bodies: Option<Coverage>,
    fill: Fill,
    /// `true` if strokes are drawn, too, and not areas alone.
    has_strokes: bool,
    /// The number of passes that are over.
    pass: usize,
    /// The number of glyphs that have been drawn or left out in this one.
    drawn: usize,
}

impl SceneryPainter {
    /// Makes an empty mask; `None` if there is not enough memory.
    pub fn new(view: &View, look: SceneryLook) -> Option<Self> {
        /// The memory that records touched parts, besides a byte for each pixel.
        const BYTES: usize = 100_000;
        let masks = if look.body.is_some() { 3 } else { 2 };
        if !memory::can_allocate(masks * (view.pixels() + BYTES)) {
            return None;
        }
        let mask = || Coverage::new(view.width, view.height);
        let bodies = look.body.and_then(|_| mask());
        let fill = Fill::default();
        Some(Self { mask: mask()?, washed: mask()?, bodies, fill, has_strokes: true, pass: 0, drawn: 0 })
    }

    /// Paints areas alone, at once: the inside of silhouettes, if the style covers it, and the washes; none if there is not enough memory.
    pub fn areas(view: &View, all: &[Standing], look: SceneryLook) -> [SparseMask; 2] {
        let Some(painter) = Self::new(view, look) else { return Default::default() };
        let mut painter = Self { has_strokes: false, ..painter };
        while painter.advance(view, all, look) {}
        painter.into_masks()
    }

    /// Draws as many glyphs as fit into a few milliseconds. Returns `true` if there are more.
    pub fn advance(&mut self, view: &View, all: &[Standing], look: SceneryLook) -> bool {
        /// The area drawn at once, in square pixels, and the cost of a glyph besides its own area.
        const AREA: f32 = 600_000.0;
        const BESIDES: f32 = 3000.0;
        let mut area = 0.0;
        while let Some(pass) = PASSES.get(self.pass) {
            while let Some(one) = all.get(self.drawn) {
                if area >= AREA {
                    return true;
                }
                self.drawn += 1;
                if one.feature().is_leafy() != (*pass == Pass::Others) && is_shown(one, view.scale) {
                    let size = one.size * view.scale;
                    area += size * size + BESIDES;
                    self.draw(view, one, look, *pass);
                }
            }
            (self.pass, self.drawn) = (self.pass + 1, 0);
        }
        false
    }

    /// Returns the masks of the inside of silhouettes and of the strokes.
    pub fn into_masks(mut self) -> [SparseMask; 2] {
        let sparse = |mask: &Coverage| SparseMask::of(mask.mask().data());
        self.mask.add(&self.washed);
        [self.bodies.as_ref().map_or_else(SparseMask::default, sparse), sparse(&self.mask)]
    }

    fn draw(&mut self, view: &View, one: &Standing, look: SceneryLook, pass: Pass) {
        let (foot, size) = (view.pixel(one.foot), one.size * view.scale);
        let shape = one.shape();
        let paler = paleness(size);
        match pass {
            Pass::Crowns => self.strokes(&shape.outline, foot, size, paler),
            Pass::Merge => {
                self.empty(view, shape, foot, size);
                self.faint_strokes(shape, foot, size, look.shade * paler);
            }
            Pass::Wash => {
                if let Some(rect) = self.fill(view, &shape.silhouette, foot, size) {
                    self.washed.add_shares(rect, self.fill.rows(), WASH * look.shade);
                }
            }
            Pass::Light => {
                if let Some(rect) = self.fill(view, &shape.silhouette, foot + LIT * view.scale, size) {
                    self.washed.take_away_shares(rect, self.fill.rows());
                }
            }
            Pass::Others => {
                self.empty(view, shape, foot, size);
                let wash = shape.wash.as_ref().filter(|_| size >= SHADED_PX);
                if let Some(rect) = wash.and_then(|wash| self.fill(view, wash, foot, size)) {
                    self.mask.add_shares(rect, self.fill.rows(), WASH * look.shade);
                }
                self.faint_strokes(shape, foot, size, look.shade * paler);
                self.strokes(&shape.outline, foot, size, paler);
            }
        }
    }

    fn faint_strokes(&mut self, shape: &Shape, foot: Vec2, size: f32, strength: f32) {
        self.strokes(if size < SHADED_PX { &[] } else { &shape.shade }, foot, size, strength);
    }

    /// Draws strokes whose widths run from their start to their end.
    fn strokes(&mut self, strokes: &[PenStroke], foot: Vec2, size: f32, strength: f32) {
        if !self.has_strokes {
            return;
        }
        self.mask.set_strength(strength);
        for stroke in strokes {
            let [first, last] = stroke.halves;
            let per_curve = (last - first) / stroke.curves.len().max(1) as f32;
            let (mut start, mut half) = (stroke.start, first);
            for curve in &stroke.curves {
                let next = half + per_curve;
                let [a, b] = [half, next].map(|half| (half * size).max(HALF_PX));
                let mut from = a;
                let along = |at: Vec2| foot + at * size;
                let (begin, end) = (along(start), along(curve[1]));
                let length = begin.distance(end).max(1e-3);
                pieces_of(start, std::slice::from_ref(curve), along, TOLERANCE_PX, |piece, to| {
                    let half = a + (b - a) * (to.distance(begin) / length).min(1.0);
                    self.mask.capsule(piece, from, to, half);
                    from = half;
                });
                (start, half) = (curve[1], next);
            }
        }
    }

    /// Removes everything behind a silhouette.
    fn empty(&mut self, view: &View, shape: &Shape, foot: Vec2, size: f32) {
        let Some(rect) = self.fill(view, &shape.silhouette, foot, size) else { return };
        self.mask.take_away_shares(rect, self.fill.rows());
        if let Some(bodies) = &mut self.bodies {
            bodies.add_shares(rect, self.fill.rows(), 1.0);
        }
    }

    /// Fills an area, and returns the rectangle around it; `None` beyond the picture.
    fn fill(&mut self, view: &View, edge: &PenStroke, foot: Vec2, size: f32) -> Option<Rect> {
        let (least, most) = box_around(edge);
        let rect = Rect::between([foot + least * size, foot + most * size], view.width, view.height)?;
        self.fill.clear(
            [rect.left as i32, rect.top as i32],
            (rect.right - rect.left) as usize,
            (rect.bottom - rect.top) as usize,
        );
        self.fill.add_line(edge.start, &edge.curves, |at| foot + at * size);
        Some(rect)
    }
}

const TOLERANCE_PX: f32 = 0.15;

/// Returns the corners of a box around a line. A parabola lies within the box of its ends and its control point.
fn box_around(edge: &PenStroke) -> (Vec2, Vec2) {
    let start = (edge.start, edge.start);
    edge.curves.iter().flatten().fold(start, |(least, most), at| (least.min(*at), most.max(*at)))
}

/// Returns the strength of strokes for a glyph size in pixels. Small glyphs in full ink would be blots.
fn paleness(size: f32) -> f32 {
    const FULL_PX: f32 = 5.0;
    (0.35 + 0.65 * size / FULL_PX).min(1.0)
}

fn is_shown(one: &Standing, scale: f32) -> bool {
    let size = one.size * scale;
    size >= LEAST_PX && (size >= HALVED_PX || one.number.is_multiple_of(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::place::{Feature, SHAPES};
    use crate::base::memory::testing::with_lists_up_to;
    use crate::domain::Domain;
    use crate::paint::styles::scenery_look;
    use crate::recipe::Style;

    fn standing(shape: u8, number: u32, foot: Vec2, size: f32) -> Standing {
        Standing { shape, number, foot, size }
    }

    fn drawn(all: &[Standing], style: Style) -> SceneryPainter {
        let view = View::new(&Domain::with_aspect(1.0), 200, 200).unwrap();
        let look = scenery_look(style.into()).unwrap();
        let mut sheet = SceneryPainter::new(&view, look).unwrap();
        while sheet.advance(&view, all, look) {}
        sheet
    }

    fn ink(sheet: &SceneryPainter) -> u64 {
        sheet.mask.mask().data().iter().map(|&covered| u64::from(covered)).sum()
    }

    #[test]
    fn what_is_nearer_hides_what_is_behind_it_and_nothing_else() {
        for shape in 0..SHAPES.len() as u8 {
            let feature = SHAPES[usize::from(shape)].feature;
            // Round crowns have a test of their own, and reeds are next to nothing.
            if feature.is_leafy() || feature == Feature::Marsh {
                continue;
            }
            let aside = if feature.is_plant() { Vec2::new(20.0, 40.0) } else { Vec2::new(40.0, 25.0) };
            let behind = standing(shape, 0, Vec2::new(480.0, 480.0), 100.0);
            let front = Standing { number: 2, foot: behind.foot + aside, ..behind };
            let (alone, both) = (drawn(&[front], Style::Ink), drawn(&[behind, front], Style::Ink));
            let more = ink(&both) - ink(&alone);
            let whole = ink(&drawn(&[behind], Style::Ink));
            assert!(more < whole * 9 / 10 && more > whole / 10, "{shape}: {more} of {whole} is left");
            // The whole front is there, whatever it is made of.
            let pixels = alone.mask.mask().data().iter().zip(both.mask.mask().data());
            assert!(pixels.clone().all(|(alone, both)| both >= alone), "{shape}");
            let apart = [behind, Standing { foot: Vec2::new(800.0, 800.0), ..front }];
            assert!(ink(&drawn(&apart, Style::Ink)).abs_diff(2 * whole) < whole / 10, "{shape}");
        }
    }

    #[test]
    fn crowns_that_touch_have_one_edge_around_all_of_them() {
        // A crown without treetops in it.
        let shape = Feature::Canopy.shapes().find(|&shape| SHAPES[usize::from(shape)].shade.is_empty()).unwrap();
        let crown = |number: u32, x: f32| standing(shape, number, Vec2::new(x, 560.0), 250.0);
        let all = [crown(0, 440.0), crown(1, 560.0)];
        let painter = drawn(&all, Style::Ink);
        let [one, other] = [0, 1].map(|i| ink(&drawn(&all[i..=i], Style::Ink)));
        assert!(ink(&painter) < (one + other) * 4 / 5, "{} of {}", ink(&painter), one + other);
        let (mask, edge) = (painter.mask.mask(), &SHAPES[usize::from(shape)].silhouette);
        // The edge of each within the other is gone, but for what lies at the other's own.
        let inside = |at: Vec2, other: &Standing| (at - other.foot - Vec2::new(0.0, -0.54 * 250.0)).length() < 75.0;
        for (this, other) in [(&all[0], &all[1]), (&all[1], &all[0])] {
            let points = edge.curves.iter().map(|curve| this.foot + curve[1] * this.size);
            let within: Vec<Vec2> = points.filter(|at| inside(*at, other)).collect();
            assert!(!within.is_empty());
            for at in within {
                let at = at * 0.2;
                let pixel = mask.data()[at.y as usize * 200 + at.x as usize];
                assert_eq!(pixel, 0, "{at}");
            }
        }
        // The dark side is right and below.
        let washed = |x: f32, y: f32| painter.washed.mask().data()[y as usize * 200 + x as usize];
        assert!(washed(80.0, 85.0) == 0 && washed(112.0, 100.0) == 0);
    }

    #[test]
    fn the_wash_of_a_wood_lies_on_its_right_and_below() {
        let crown = [standing(6, 0, Vec2::new(500.0, 560.0), 100.0)];
        let painter = drawn(&crown, Style::Ink);
        let (mut sum, mut count) = (Vec2::ZERO, 0.0);
        for (i, &washed) in painter.washed.mask().data().iter().enumerate() {
            let at = Vec2::new((i % 200) as f32, (i / 200) as f32) + 0.5;
            sum += at * f32::from(washed);
            count += f32::from(washed);
        }
        let middle = Vec2::new(500.0, 560.0 - 54.0) * 0.2;
        let aside = sum / count - middle;
        assert!(count > 0.0 && aside.x > 1.0 && aside.y > 1.0, "{aside} of {count}");
    }

    #[test]
    fn small_glyphs_are_halved_and_smaller_ones_left_out() {
        let shown =
            |px: f32| (0..10).filter(|&number| is_shown(&standing(0, number, Vec2::ZERO, px * 4.0), 0.25)).count();
        assert_eq!([1.1, 1.3, 1.9, 2.1].map(shown), [0, 5, 5, 10]);
    }

    #[test]
    fn only_styles_with_uneven_ground_cover_it_behind_trees() {
        let tree = [standing(1, 0, Vec2::new(500.0, 500.0), 100.0)];
        assert!(drawn(&tree, Style::Ink).bodies.is_none());
        let bodies = drawn(&tree, Style::Survey).bodies.unwrap();
        let full = bodies.mask().data().iter().filter(|&&covered| covered == 255).count();
        assert!((100..180).contains(&full), "{full} of some 150 pixels");
    }

    #[test]
    fn glyphs_beyond_the_picture_are_no_matter_and_without_memory_there_are_none() {
        let beyond =
            [Vec2::new(-500.0, 20.0), Vec2::new(20.0, 4000.0), Vec2::new(-2.0, -3.0), Vec2::new(1002.0, 1003.0)];
        for shape in [7, 18, 24, 30, 40] {
            drawn(&beyond.map(|foot| standing(shape, 0, foot, 60.0)), Style::Survey);
        }
        let view = View::new(&Domain::with_aspect(1.0), 2000, 2000).unwrap();
        let look = scenery_look(Style::Ink.into()).unwrap();
        assert!(with_lists_up_to(3_000_000, || SceneryPainter::new(&view, look)).is_none());
    }
}
