//! A grid of thin lines over a map, counted from its north-western corner.

use glam::{Vec2, Vec2Swizzles};

use super::coverage::Coverage;
use super::ground::lay_mask;
use super::palette::Grid;
use super::view::View;

/// Lays a grid over a ground, land and sea.
pub(super) fn lay(view: &View, grid: &Grid, pixels: &mut [[u8; 4]]) {
    let Some(mut mask) = Coverage::new(view.width, view.height) else { return };
    let half = Grid::WIDTH * 0.5 * view.scale;
    let [first, last] = view.frame();
    // Lines start at the map's corner, which avoids rounding, unless the picture shows a part of the map.
    let first = if view.is_framed() { first } else { Vec2::ZERO };
    for [from, to] in lines(grid, [first, last]) {
        mask.capsule(view.pixel(from), half, view.pixel(to), half);
    }
    lay_mask(mask.mask().data(), grid.colour, &|_| grid.strength, pixels);
}

/// Returns the lines of a grid between the two corners of a frame, in units.
pub(crate) fn lines(grid: &Grid, [first, last]: [Vec2; 2]) -> Vec<[Vec2; 2]> {
    let mut lines = Vec::new();
    for axis in [Vec2::X, Vec2::Y] {
        let aside = axis.yx();
        let (from, to) = (first * aside, last * aside);
        let mut number = (first.dot(axis) / grid.every).floor() + 1.0;
        while number * grid.every < last.dot(axis) {
            let at = axis * (number * grid.every);
            lines.push([at + from, at + to]);
            number += 1.0;
        }
    }
    lines
}
