//! The ground of a map: sea and land shaded by their distance from the coast, rings, the coast, ridges.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::land::Land;
use crate::paint::ground::{COAST_WIDTH, RIDGE_WIDTH, RING_WIDTH};
use crate::paint::palette::{Colour, Palette, mix};

/// In how many steps land and sea change colour.
const SHADES: u32 = 16;

/// Writes what rivers are drawn on. Each shade is laid over the one before, so there are no gaps between them.
pub(super) fn ground(out: &mut Text, size: Vec2, land: Option<&Land>, palette: &Palette) {
    let Some(land) = land else {
        out.text("<rect id=\"land\"");
        sheet(out, size, palette.plain);
        return;
    };
    out.text("<g id=\"sea\">\n<rect");
    sheet(out, size, palette.deep);
    let steps = if palette.fade > 0.0 { SHADES } else { 0 };
    let share = |step: u32| step as f32 / SHADES as f32;
    for step in (1..=steps).rev() {
        let colour = mix(palette.shallows, palette.deep, share(step));
        area(out, land, -palette.fade * share(step), colour);
    }
    for &(distance, strength) in palette.rings {
        out.text("<path stroke-opacity=\"").units(strength).text("\" fill=\"none\"");
        line(out, palette.coast, RING_WIDTH, &level(land, -distance, 1));
    }
    out.text("</g>\n<g id=\"land\">\n<path id=\"coast\" fill=\"").colour(palette.lowland).text("\"");
    line(out, palette.coast, COAST_WIDTH, &level(land, 0.0, 1));
    for step in 1..=steps {
        area(out, land, palette.fade * share(step), mix(palette.lowland, palette.inland, share(step)));
    }
    ridges(out, land, palette);
    out.text("</g>\n");
}

fn sheet(out: &mut Text, size: Vec2, colour: Colour) {
    out.text(" width=\"").units(size.x).text("\" height=\"").units(size.y);
    out.text("\" fill=\"").colour(colour).text("\"/>\n");
}

/// All that lies higher than a level, in one colour. Every second point is enough for that.
fn area(out: &mut Text, land: &Land, height: f32, colour: Colour) {
    out.text("<path fill=\"").colour(colour).text("\" d=\"").text(&level(land, height, 2)).text("\"/>\n");
}

/// The end of a path that is a line.
fn line(out: &mut Text, colour: Colour, width: f32, data: &str) {
    out.text(" stroke=\"").colour(colour).text("\" stroke-width=\"").units(width);
    out.text("\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"").text(data).text("\"/>\n");
}

/// Ridges, where they do not run out to sea.
fn ridges(out: &mut Text, land: &Land, palette: &Palette) {
    if land.ridges().is_empty() {
        return;
    }
    let mut path = Path::default();
    for ridge in land.ridges() {
        path.line(ridge);
    }
    out.text("<clipPath id=\"ashore\"><use href=\"#coast\"/></clipPath>\n");
    out.text("<path id=\"ridges\" clip-path=\"url(#ashore)\" fill=\"none\"");
    line(out, palette.ridge, RIDGE_WIDTH, path.data());
}

/// The rings around all that lies higher than a level.
#[inline(never)]
fn level(land: &Land, level: f32, every: usize) -> String {
    let mut path = Path::default();
    for ring in land.relief().rings_above(level) {
        let points: Vec<Vec2> = ring.into_iter().step_by(every).collect();
        path.ring(&points);
    }
    path.into_data()
}
