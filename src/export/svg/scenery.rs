//! Woods and hills. What nearer ones hide of their strokes is left out, so there is no mask. Each that is seen as a whole is a `use` of a
//! symbol; the strokes of all others are paths together. The ground within silhouettes and the washes are areas, as a picture has them.

use glam::Vec2;

use super::hidden::{Parabola, Silhouettes, Turn};
use super::pens::Pens;
use super::text::Text;
use super::traced;
use crate::annotate::place::{PenStroke, SHAPES, Shape, Standing};
use crate::domain::Domain;
use crate::paint::annotation::scenery::WASH;
use crate::paint::{SceneryLook, SceneryPainter};

/// The size of a symbol, in its units, since numbers are rounded to hundredths.
const SIZE: f32 = 10.0;

/// Writes trees and hills.
pub(super) fn draw(out: &mut Text, domain: &Domain, all: &[Standing], look: SceneryLook) {
    if all.is_empty() {
        return;
    }
    let glyphs: Vec<Vec<Curve>> = (0..SHAPES.len() as u8).map(glyph).collect();
    let silhouettes = Silhouettes::of(domain.size, all);
    let groups = [true, false].map(|is_wood| Group::of(&silhouettes, &glyphs, all, is_wood));
    out.text("<defs>\n");
    for (number, glyph) in (0..).zip(&glyphs) {
        if groups.iter().flat_map(|group| &group.whole).any(|one| one.shape == number) {
            symbol(out, number, glyph, look);
        }
    }
    out.text("</defs>\n<g id=\"scenery\">\n");
    areas(out, domain, all, look);
    out.text("<g fill=\"none\" stroke-linecap=\"round\" stroke=\"").colour(look.ink).text("\">\n");
    for (class, group) in ["woods", "hills"].into_iter().zip(&groups) {
        group.write(out, class, look);
    }
    out.text("</g>\n</g>\n");
}

/// Writes the ground within silhouettes, if the style covers it, and the washes.
fn areas(out: &mut Text, domain: &Domain, all: &[Standing], look: SceneryLook) {
    let Some(view) = traced::view(domain) else { return };
    let [bodies, washes] = SceneryPainter::areas(&view, all, look);
    let wash = WASH * look.shade;
    let body = look.body.map(|(colour, covers)| ("bodies", bodies, 1.0, colour, covers));
    for (class, mask, most, colour, covers) in body.into_iter().chain([("washes", washes, wash, look.ink, wash)]) {
        if !mask.is_empty() {
            out.text("<path class=\"").text(class).text("\" fill-rule=\"evenodd\" fill=\"").colour(colour);
            out.text("\" fill-opacity=\"").units(covers);
            out.text("\" d=\"").path(&traced::area(&view, &mask, 0.5 * most)).text("\"/>\n");
        }
    }
}

/// A curve of a glyph, around its foot, in sizes of the glyph.
#[derive(Clone, Copy)]
struct Curve {
    points: Parabola,
    /// Half of its width.
    half: f32,
    /// `true` for the strokes on the dark side.
    is_faint: bool,
}

impl Curve {
    /// Returns its points where it is drawn.
    fn at(&self, one: &Standing) -> Parabola {
        self.points.map(|at| one.foot + at * one.size)
    }

    /// Returns the parts that are seen of it where it is drawn, for a tree or a hill of this number.
    fn seen(&self, silhouettes: &Silhouettes<'_>, number: usize, one: &Standing) -> Vec<Parabola> {
        let is_of_crown = one.feature().is_leafy() && !self.is_faint;
        silhouettes.visible(self.at(one), Turn { number, is_of_crown }, self.half * one.size)
    }
}

/// Returns the curves that are seen of a glyph where it stands alone: trunks begin at the edge of their crown.
fn glyph(number: u8) -> Vec<Curve> {
    /// A size in units at which curves are cut much more exactly than is seen.
    const LARGE: f32 = 100.0;
    let alone = Standing { shape: number, number: 0, foot: Vec2::splat(2.0 * LARGE), size: LARGE };
    let silhouettes = Silhouettes::of(alone.foot * 2.0, std::slice::from_ref(&alone));
    let mut seen = Vec::new();
    for curve in curves(alone.shape()) {
        for part in curve.seen(&silhouettes, 0, &alone) {
            seen.push(Curve { points: part.map(|at| (at - alone.foot) / alone.size), ..curve });
        }
    }
    seen
}

/// Returns the curves of a shape. Of an edge of a round crown the outer half is left.
fn curves(shape: &Shape) -> Vec<Curve> {
    let mut curves = Vec::new();
    for stroke in &shape.outline {
        let is_edge = shape.feature.is_leafy() && shape.silhouette.curves.contains(&stroke.curves[0]);
        let outer = is_edge.then(|| outer_half(stroke, shape.discs[0].0));
        add_stroke(&mut curves, outer.as_ref().unwrap_or(stroke), false);
    }
    shape.shade.iter().for_each(|stroke| add_stroke(&mut curves, stroke, true));
    curves
}

/// Returns the half of a stroke that is farther from the middle of a crown.
fn outer_half(stroke: &PenStroke, middle: Vec2) -> PenStroke {
    let [first, last] = stroke.halves.map(|half| 0.5 * half);
    let out = |at: Vec2, by: f32| at + (at - middle).normalize_or_zero() * by;
    let curves = stroke.curves.iter().map(|&[control, end]| [out(control, 0.5 * (first + last)), out(end, last)]);
    PenStroke { start: out(stroke.start, first), curves: curves.collect(), halves: [first, last] }
}

/// Adds the curves of a stroke, each with a width.
fn add_stroke(curves: &mut Vec<Curve>, stroke: &PenStroke, is_faint: bool) {
    let ([first, last], count) = (stroke.halves, stroke.curves.len() as f32);
    let mut start = stroke.start;
    for (i, &[control, end]) in stroke.curves.iter().enumerate() {
        let half = first + (last - first) * (i as f32 + 0.5) / count;
        curves.push(Curve { points: [start, control, end], half, is_faint });
        start = end;
    }
}

/// Writes a glyph as a symbol.
fn symbol(out: &mut Text, number: u8, glyph: &[Curve], look: SceneryLook) {
    let mut pens = Pens::default();
    glyph.iter().for_each(|curve| pens.draw(curve.points.map(|at| at * SIZE), curve.half * SIZE, curve.is_faint));
    out.text("<symbol id=\"");
    name(out, number);
    out.text("\" overflow=\"visible\">");
    pens.write(out, look.shade);
    out.text("</symbol>\n");
}

fn name(out: &mut Text, number: u8) {
    let kind = if SHAPES[usize::from(number)].feature.is_plant() { "tree" } else { "hill" };
    out.own(kind).text("-").whole(number.into());
}

/// Woods or hills, as far as they are seen.
#[derive(Default)]
struct Group<'a> {
    /// Those of which nothing is hidden.
    whole: Vec<&'a Standing>,
    /// What is left of the others.
    rest: Pens,
}

impl<'a> Group<'a> {
    fn of(silhouettes: &Silhouettes<'_>, glyphs: &[Vec<Curve>], all: &'a [Standing], is_wood: bool) -> Self {
        let mut group = Self::default();
        for (number, one) in all.iter().enumerate().filter(|(_, one)| one.is_plant() == is_wood) {
            let curves = &glyphs[usize::from(one.shape)];
            let seen: Vec<Vec<Parabola>> = curves.iter().map(|curve| curve.seen(silhouettes, number, one)).collect();
            if seen.iter().zip(curves).all(|(parts, curve)| *parts == [curve.at(one)]) {
                group.whole.push(one);
                continue;
            }
            for (curve, parts) in curves.iter().zip(seen) {
                parts.into_iter().for_each(|part| group.rest.draw(part, curve.half * one.size, curve.is_faint));
            }
        }
        group
    }

    /// Writes it, unless it is empty.
    fn write(&self, out: &mut Text, class: &'static str, look: SceneryLook) {
        if self.whole.is_empty() && self.rest.is_empty() {
            return;
        }
        out.text("<g class=\"").text(class).text("\">\n");
        self.rest.write(out, look.shade);
        for one in &self.whole {
            out.text("<use href=\"#");
            name(out, one.shape);
            out.text("\" transform=\"translate(").units(one.foot.x).text(" ").units(one.foot.y).text(")scale(");
            out.units(one.size / SIZE).text(")\"/>\n");
        }
        out.text("</g>\n");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::place::Feature;

    /// Returns what is seen of some woods.
    fn woods(all: &[Standing]) -> (Vec<&Standing>, Pens) {
        let glyphs: Vec<Vec<Curve>> = (0..SHAPES.len() as u8).map(glyph).collect();
        let group = Group::of(&Silhouettes::of(Vec2::splat(200.0), all), &glyphs, all, true);
        (group.whole, group.rest)
    }

    /// Makes a crown without treetops in it.
    fn crown(foot: Vec2, size: f32) -> Standing {
        let shape = Feature::Canopy.shapes().find(|&shape| SHAPES[usize::from(shape)].shade.is_empty()).unwrap();
        Standing { shape, number: 0, foot, size }
    }

    #[test]
    fn a_crown_within_another_vanishes_whichever_is_nearer() {
        let (large, middle) = (crown(Vec2::splat(100.0), 50.0), Vec2::new(100.0, 100.0 - 0.54 * 50.0));
        let small = crown(middle + Vec2::new(0.0, 0.4 * 10.0), 10.0);
        for all in [[small, large], [large, small]] {
            let (whole, rest) = woods(&all);
            assert!(whole == [&large] && rest.is_empty(), "{whole:?}, {rest:?}");
        }
    }

    #[test]
    fn trees_apart_are_whole_and_of_those_that_touch_a_part_is_left() {
        let [first, second, third] = [40.0, 55.0, 150.0].map(|x| crown(Vec2::new(x, 100.0), 30.0));
        let all = [first, second, third];
        let (whole, rest) = woods(&all);
        assert!(whole == [&third] && !rest.is_empty(), "{whole:?}");
    }

    #[test]
    fn every_glyph_that_stands_alone_is_whole() {
        for shape in 0..SHAPES.len() as u8 {
            for size in [3.0, 7.7, 40.0] {
                let alone = [Standing { shape, number: 0, foot: Vec2::new(100.3, 99.1), size }];
                let glyphs: Vec<Vec<Curve>> = (0..SHAPES.len() as u8).map(glyph).collect();
                let is_wood = alone[0].is_plant();
                let group = Group::of(&Silhouettes::of(Vec2::splat(200.0), &alone), &glyphs, &alone, is_wood);
                assert!(group.rest.is_empty() && group.whole.len() == 1, "{shape} of size {size}");
            }
        }
    }

    #[test]
    fn of_an_edge_of_a_crown_the_outer_half_is_drawn() {
        let shape = crown(Vec2::ZERO, 1.0).shape();
        let glyph = curves(shape);
        // The trunk comes first, and ends in the ground.
        for (curve, stroke) in glyph.iter().zip(&shape.outline).skip(1) {
            let middle = shape.discs[0].0;
            let outward = curve.points[0].distance(middle) - stroke.start.distance(middle);
            assert!((outward - 0.5 * stroke.halves[0]).abs() < 1e-5, "{outward}");
            assert!((curve.half - 0.25 * (stroke.halves[0] + stroke.halves[1])).abs() < 1e-6);
        }
        assert_eq!(glyph[0].points[0], shape.outline[0].start);
    }
}
