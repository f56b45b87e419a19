//! The ground of a map: sea and land shaded by their distance from the coast, rings, the coast, ridges.

use std::fmt::{Result, Write};

use super::path::Path;
use super::{Colour, Size, Units};
use crate::land::Land;
use crate::paint::ground::{COAST_WIDTH, RIDGE_WIDTH, RING_WIDTH};
use crate::paint::palette::{Palette, mix};

/// In how many steps land and sea change colour.
const SHADES: u32 = 16;

/// Writes what rivers are drawn on. Each shade is laid over the one before, so there are no gaps between them.
pub(super) fn ground(out: &mut String, size: Size, land: Option<&Land>, palette: &Palette) -> Result {
    let Some(land) = land else {
        return writeln!(out, r#"<rect id="land" {size} fill="{}"/>"#, Colour(palette.plain));
    };
    let steps = if palette.fade > 0.0 { SHADES } else { 0 };
    writeln!(out, "<g id=\"sea\">\n<rect {size} fill=\"{}\"/>", Colour(palette.deep))?;
    for step in (1..=steps).rev() {
        let colour = Colour(mix(palette.shallows, palette.deep, share(step) - HALF_A_STEP));
        writeln!(out, r#"<path fill="{colour}" d="{}"/>"#, shade(land, -palette.fade * share(step)))?;
    }
    for &(distance, strength) in palette.rings {
        let (colour, rings) = (Colour(palette.coast), level(land, -distance));
        let [width, strength] = [RING_WIDTH, strength].map(Units);
        writeln!(
            out,
            r#"<path fill="none" stroke="{colour}" stroke-width="{width}" stroke-opacity="{strength}" d="{rings}"/>"#
        )?;
    }
    out.push_str("</g>\n");
    shaded_land(out, land, palette, steps)?;
    ridges(out, land, palette)
}

const HALF_A_STEP: f32 = 0.5 / SHADES as f32;

fn share(step: u32) -> f32 {
    step as f32 / SHADES as f32
}

fn shaded_land(out: &mut String, land: &Land, palette: &Palette, steps: u32) -> Result {
    out.push_str("<g id=\"land\">\n");
    let colour = |step: u32| {
        let far = share(step) + HALF_A_STEP;
        Colour(mix(palette.lowland, palette.inland, if far < 1.0 { far } else { 1.0 }))
    };
    let (line, width) = (Colour(palette.coast), Units(COAST_WIDTH));
    let coast = level(land, 0.0);
    writeln!(
        out,
        r#"<path id="coast" fill="{}" stroke="{line}" stroke-width="{width}" stroke-linejoin="round" d="{coast}"/>"#,
        colour(0)
    )?;
    for step in 1..=steps {
        writeln!(out, r#"<path fill="{}" d="{}"/>"#, colour(step), shade(land, palette.fade * share(step)))?;
    }
    out.push_str("</g>\n");
    Ok(())
}

/// Ridges, where they do not run out to sea.
fn ridges(out: &mut String, land: &Land, palette: &Palette) -> Result {
    if land.ridges().is_empty() {
        return Ok(());
    }
    let mut path = Path::default();
    for ridge in land.ridges() {
        path.line(ridge);
    }
    let (colour, width) = (Colour(palette.ridge), Units(RIDGE_WIDTH));
    writeln!(out, r##"<clipPath id="ashore"><use href="#coast"/></clipPath>"##)?;
    writeln!(
        out,
        r#"<path id="ridges" clip-path="url(#ashore)" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round" stroke-linejoin="round" d="{}"/>"#,
        path.data
    )
}

/// All that lies higher than a level.
fn level(land: &Land, level: f32) -> String {
    around(land, level, 1)
}

/// The same with every second point, as shades need no more.
fn shade(land: &Land, level: f32) -> String {
    around(land, level, 2)
}

fn around(land: &Land, level: f32, every: usize) -> String {
    let mut path = Path::default();
    for ring in land.relief().rings_above(level) {
        let points: Vec<_> = ring.into_iter().step_by(every).collect();
        path.ring(&points);
    }
    path.data
}
