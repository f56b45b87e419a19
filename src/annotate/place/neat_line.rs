//! The neat line of a sheet: a thin and a wide line around the map, and paper beyond.

use glam::Vec2;

use super::grid_letters::{around, margin};
use super::letters::{Kind, Label, Stroke};

/// The width of the margin of a sheet, in units.
pub const MARGIN: f32 = 9.0;
/// The distances of the lines from the map, and half their widths, in units.
const LINES: [(f32, f32); 2] = [(0.35, 0.35), (3.65, 0.75)];
/// Half the width of the lines that fill the margin's corners, in units.
const CORNER: f32 = 0.4;

/// Draws the neat line just within a sheet.
pub fn label([least, most]: [Vec2; 2]) -> Label {
    let (least, most) = (least + MARGIN, most - MARGIN);
    let lines = LINES
        .into_iter()
        .flat_map(|(out, half)| around(least - out, most + out).into_iter().map(move |ends| Stroke { ends, half }));
    Label {
        strokes: lines.collect(),
        cleared: margin(least, most, MARGIN, CORNER),
        ..Label::new(Kind::Grid, None, "", MARGIN, Vec::new())
    }
}
