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
    lay_mask(mask.mask().data(), grid.colour, &|_| grid.strength, pixels);
}

/// The lines of a grid as far as a corner, in units.
pub(crate) fn lines(grid: &Grid, corner: Vec2) -> Vec<[Vec2; 2]> {
    let mut lines = Vec::new();
    for axis in [Vec2::X, Vec2::Y] {
        let (mut start, across) = (axis * grid.every, corner * axis.yx());
        while (corner - start).min_element() > 0.0 {
            lines.push([start, start + across]);
            start += axis * grid.every;
        }
    }
    lines
}
