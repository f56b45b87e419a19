//! The letters of a grid's columns and the numbers of its rows in a margin around the map, and of its lines their ends there and where they cross.

use glam::{Vec2, Vec2Swizzles};

use super::background::{Background, NONE};
use super::corner::filled;
use super::input::{Input, SheetGrid};
use super::letters::{Box, Kind, Label, Stroke, Text};

/// The height of capitals, in ems.
const CAPITAL: f32 = 0.65;
/// The least visible part of a column or row that has a letter, in ems.
const LEAST_SEEN: f32 = 1.2;
/// The length of the ends of lines, half of that of crossings, and half the width of both, in ems.
const END: f32 = 0.5;
const CROSS: f32 = 0.36;
const HALF: f32 = 0.028;
/// Half the width of the lines that fill the margin's corners, and the length by which they reach beyond the margin, in ems: less than a
/// pixel.
const CORNER: f32 = 0.06;
/// The least distance of crossings from the coast, from ink and from labels, in ems.
const CLEAR: f32 = 0.25;

/// Sets the letters and numbers, each twice, on opposite sides.
pub fn letters(input: &Input<'_>, grid: &SheetGrid) -> Vec<Label> {
    let [least, most] = input.view;
    let off = 0.5 * SheetGrid::MARGIN * grid.em;
    let columns = cells(least.x, most.x, grid).flat_map(|(number, x)| {
        let name = char::from(b'A' + (number % 26) as u8).to_string();
        [least.y - off, most.y + off].map(move |y| letter(&name, Vec2::new(x, y), grid.em))
    });
    let rows = cells(least.y, most.y, grid).flat_map(|(number, y)| {
        let name = (number + 1).to_string();
        [least.x - off, most.x + off].map(move |x| letter(&name, Vec2::new(x, y), grid.em))
    });
    columns.chain(rows).collect()
}

/// Returns the columns or rows of which enough is seen, each with the middle of its visible part.
fn cells(least: f32, most: f32, grid: &SheetGrid) -> impl Iterator<Item = (u32, f32)> {
    let (every, room) = (grid.every, LEAST_SEEN * grid.em);
    // A conversion makes 0 of what is below.
    let [first, end] = [(least / every).floor(), (most / every).ceil()].map(|number| number as u32);
    let seen = move |number: u32| [(number as f32 * every).max(least), ((number + 1) as f32 * every).min(most)];
    let middle = move |number: u32| {
        let [from, to] = seen(number);
        (to - from >= room).then_some((number, (from + to) * 0.5))
    };
    (first..end).filter_map(middle)
}

/// Sets a letter around a place.
fn letter(name: &str, middle: Vec2, em: f32) -> Label {
    let text = Text::new(name, Kind::GridLetter);
    let start = middle + Vec2::new(-0.5 * text.length, 0.5 * CAPITAL) * em;
    let letters = text.level(start, em);
    Label::new(Kind::GridLetter, None, name, em, letters)
}

/// Draws the margin and the line around the map, the ends of the grid's lines in it, and the crossings of these lines, but for those in the
/// way of something.
pub fn lines<G: Background>(input: &Input<'_>, background: &G, grid: &SheetGrid, taken: &[(u32, Box)]) -> Label {
    let ([least, most], em) = (input.view, grid.em);
    let along = |least: f32, most: f32| {
        let numbers = (least / grid.every).floor() as u32 + 1..(most / grid.every).ceil() as u32;
        numbers.map(|number| number as f32 * grid.every)
    };
    let ends = [Vec2::X, Vec2::Y].into_iter().flat_map(|axis| {
        let [near, far, outward] = [least, most, Vec2::splat(END * em)].map(|corner| corner * axis.yx());
        let at = along(least.dot(axis), most.dot(axis)).map(move |at| axis * at);
        at.flat_map(move |at| [[at + near - outward, at + near], [at + far, at + far + outward]])
    });
    let crossings = along(least.x, most.x).flat_map(|x| along(least.y, most.y).map(move |y| Vec2::new(x, y)));
    let crossings = crossings.filter(|at| is_clear(input, background, *at, em, taken));
    let crosses =
        crossings.flat_map(|at| [Vec2::X, Vec2::Y].map(|axis| [at - axis * CROSS * em, at + axis * CROSS * em]));
    let strokes = around(least, most).into_iter().chain(ends).chain(crosses);
    Label {
        strokes: strokes.map(|ends| Stroke { ends, half: HALF * em }).collect(),
        cleared: margin(least, most, SheetGrid::MARGIN * em, CORNER * em),
        ..Label::new(Kind::Grid, None, "", em, Vec::new())
    }
}

/// Draws a margin around a map: a line along each side, and its corners, which lines with round ends leave out; they reach a little beyond
/// it.
pub fn margin(least: Vec2, most: Vec2, wide: f32, fine: f32) -> Vec<Stroke> {
    let half = 0.5 * wide;
    let middles = around(least - half, most + half);
    let corners = middles.map(|[corner, _]| filled(corner - half - fine, Vec2::splat(2.0 * (half + fine)), fine));
    middles.map(|ends| Stroke { ends, half }).into_iter().chain(corners.into_iter().flatten()).collect()
}

/// Returns the four sides between two corners.
pub fn around(least: Vec2, most: Vec2) -> [[Vec2; 2]; 4] {
    let corners = [least, Vec2::new(most.x, least.y), most, Vec2::new(least.x, most.y)];
    [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]])
}

/// Returns `true` if a crossing is off the coast, rivers, lakes, ridges and labels.
fn is_clear<G: Background>(input: &Input<'_>, background: &G, at: Vec2, em: f32, taken: &[(u32, Box)]) -> bool {
    let cross = Box::level(at - CROSS * em, at + CROSS * em);
    let reach = cross.radius() + 0.5 * CLEAR * em;
    input.map.coast().is_none_or(|coast| coast.height(at).abs() >= reach)
        && background.distances(at, NONE, 0.0, reach)[1] >= reach
        && cross.samples().all(|at| background.ink(at).width <= 0.0)
        && !taken.iter().any(|(_, other)| cross.meets(other, CLEAR * em))
}
