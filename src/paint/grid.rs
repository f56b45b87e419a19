//! A grid of thin lines over a map, counted from its north-western corner.

use glam::{Vec2, Vec2Swizzles};

use super::coverage::Coverage;
use super::ground::lay_mask;
use super::palette::Grid;
use super::view::View;

/// Lays a grid over a ground, land and sea.
pub(super) fn lay(view: &View, grid: &Grid, pixels: &mut [[u8; 4]]) {
    let Some(mut mask) = Coverage::new(view.width, view.height) else { return };
    let corner = view.point(Vec2::new(view.width as f32, view.height as f32));
    let half = Grid::WIDTH * 0.5 * view.scale;
    for [from, to] in lines(grid, corner) {
        mask.capsule(view.pixel(from), half, view.pixel(to), half);
    }
    lay_mask(view, &mut mask, grid.colour, &|_| grid.strength, pixels);
}

/// The lines of a grid as far as a corner, in units.
pub(crate) fn lines(grid: &Grid, corner: Vec2) -> impl Iterator<Item = [Vec2; 2]> {
    let along = |axis: Vec2| {
        let across = axis.yx();
        (1..=(corner.dot(axis) / grid.every) as u32).map(move |i| {
            let start = axis * (i as f32 * grid.every);
            [start, start + corner * across]
        })
    };
    along(Vec2::X).chain(along(Vec2::Y))
}
