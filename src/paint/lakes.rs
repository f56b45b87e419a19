//! Lakes along rivers: their shores are banks, and their water lies over all banks.

use glam::Vec2;

use super::coverage::Coverage;
use super::view::View;
use super::waters::Waters;
use crate::lakes::{Lake, Lakes};

/// Draws lakes, moved outward by a margin in units.
pub(super) fn draw(waters: &mut Waters, view: &View, lakes: &Lakes, margin: f32) {
    let bank = waters.opening().map_or(0.0, |opening| opening.bank_px());
    for lake in &lakes.list {
        let rings: Vec<Vec<Vec2>> = in_pixels(lake, view);
        waters.banks.fill(&rings);
        let radius = bank + margin * view.scale;
        if radius > 0.0 {
            rings.iter().for_each(|ring| outline(&mut waters.banks, ring, radius));
        }
        if let Some((mask, _)) = waters.open_mut() {
            mask.fill(&rings);
        }
    }
}

fn in_pixels(lake: &Lake, view: &View) -> Vec<Vec<Vec2>> {
    lake.rings.iter().map(|ring| ring.iter().map(|at| view.pixel(*at)).collect()).collect()
}

/// Draws a line along a ring.
fn outline(mask: &mut Coverage, ring: &[Vec2], radius: f32) {
    for (from, to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        mask.capsule(*from, radius, *to, radius);
    }
}
