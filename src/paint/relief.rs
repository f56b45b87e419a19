//! Relief on the ground of a picture: hypsometric tints, lighter where light falls and darker where it does not.

use glam::{Vec2, Vec3};

use super::coverage::Coverage;
use super::palette::{Casing, Colour, Tints, mix};
use super::view::View;
use crate::land::{Parabola, beside, nearest};
use crate::relief::{CELL_SIZE, Relief};
use crate::sort::quantile;

/// Light from the north-west at 45° over the horizon, with a share of 0.55, from the west at 50° with 0.25 and from the north at 55° with
/// 0.2: the strongest light is the lowest, and ridges of all directions have a dark side (after Imhof 1965). Each points to its light and
/// is as long as its share.
const LIGHTS: [Vec3; 3] =
    [Vec3::new(-0.275, -0.275, 0.388_909), Vec3::new(-0.160_697, 0.0, 0.191_511), Vec3::new(0.0, -0.114_715, 0.163_83)];

/// What has the colour of the highest land lies above this share of all.
pub(crate) const HIGHEST: f32 = 0.99;

/// A relief as a style shows it: how high and how light each cell is.
pub(super) struct Surface {
    columns: usize,
    rows: usize,
    /// The height of each cell as a share of the highest, and its light as a share of that on flat land.
    tint: Vec<f32>,
    light: Vec<f32>,
}

impl Surface {
    pub fn new(relief: &Relief, exaggeration: f32) -> Self {
        let (columns, rows) = (relief.columns(), relief.rows());
        let heights: Vec<f32> = relief.heights().iter().map(|height| height.max(0.0)).collect();
        let highest = relief.quantile(HIGHEST).max(f32::MIN_POSITIVE);
        let mut light = vec![0.0; heights.len()];
        for row in 0..rows {
            let [north, _, south] = beside(row, rows).map(|row| row * columns);
            for column in 0..columns {
                let [west, _, east] = beside(column, columns);
                let here = row * columns;
                let rise = Vec2::new(
                    heights[here + east] - heights[here + west],
                    heights[south + column] - heights[north + column],
                );
                light[here + column] = lit(rise * (exaggeration / (2.0 * CELL_SIZE)));
            }
        }
        let land = relief.heights().iter().zip(&light).filter(|(height, _)| **height > 0.0);
        let some: Vec<f32> = land.map(|(_, light)| *light).step_by(7).collect();
        let usual = quantile(&some, 0.5).max(0.05);
        light.iter_mut().for_each(|light| *light /= usual);
        Self { columns, rows, tint: heights.iter().map(|height| height / highest).collect(), light }
    }

    /// Lays tints over the land of a ground. `shares` says how much of each pixel is land, in 255ths.
    pub fn lay(&self, view: &View, tints: &Tints, plain: Colour, shares: &[u8], pixels: &mut [[u8; 4]]) {
        let colours = Colours::new(tints);
        let width = view.width as usize;
        let columns: Vec<(usize, f32)> = (0..width)
            .map(|x| nearest(view.point(Vec2::splat(x as f32 + 0.5)).x / CELL_SIZE - 0.5, self.columns))
            .collect();
        let (mut tint, mut light) = (Vec::new(), Vec::new());
        for (y, (row, shares)) in pixels.chunks_mut(width).zip(shares.chunks(width)).enumerate() {
            let (middle, t) = nearest(view.point(Vec2::splat(y as f32 + 0.5)).y / CELL_SIZE - 0.5, self.rows);
            let rows = beside(middle, self.rows);
            self.blend(&self.tint, rows, t, &mut tint);
            self.blend(&self.light, rows, t, &mut light);
            for ((pixel, &share), &(column, t)) in
                row.iter_mut().zip(shares).zip(&columns).filter(|((_, share), _)| **share > 0)
            {
                let around = beside(column, self.columns);
                let at = |values: &[f32]| Parabola::of(around.map(|column| values[column])).at(t);
                let colour = colours.at(at(&tint), at(&light));
                for i in 0..3 {
                    let more = (i32::from(colour[i]) - i32::from(plain[i])) * i32::from(share);
                    pixel[i] = (i32::from(pixel[i]) + more / 255).clamp(0, 255) as u8;
                }
            }
        }
    }

    /// The control points of one y.
    fn blend(&self, values: &[f32], rows: [usize; 3], t: f32, line: &mut Vec<f32>) {
        let [north, here, south] = rows.map(|row| &values[row * self.columns..][..self.columns]);
        line.clear();
        line.extend(north.iter().zip(here).zip(south).map(|((&a, &b), &c)| Parabola::of([a, b, c]).at(t)));
    }
}

/// How light a slope is.
fn lit(rise: Vec2) -> f32 {
    let normal = (-rise).extend(1.0);
    let length = (rise.length_squared() + 1.0).sqrt();
    LIGHTS.iter().map(|light| (normal.dot(*light) / length).max(0.0)).sum()
}

/// The colours of all heights and lights, looked up.
struct Colours(Vec<Colour>);

const HEIGHTS: usize = 128;
const LIGHT_STEPS: usize = 128;
/// The most light that is told apart, as a share of that on flat land.
const MOST_LIGHT: f32 = 2.0;

impl Colours {
    fn new(tints: &Tints) -> Self {
        let colour = |i: usize| {
            let height = (i / LIGHT_STEPS) as f32 / (HEIGHTS - 1) as f32;
            let light = (i % LIGHT_STEPS) as f32 / (LIGHT_STEPS - 1) as f32 * MOST_LIGHT;
            let [low, high] = tints.light;
            let factor = low + (high - low) * light;
            tints.at(height).map(|part| (f32::from(part) * factor + 0.5).clamp(0.0, 255.0) as u8)
        };
        Self((0..HEIGHTS * LIGHT_STEPS).map(colour).collect())
    }

    #[inline]
    fn at(&self, height: f32, light: f32) -> Colour {
        // What is less than 0 becomes 0.
        let height = ((height * (HEIGHTS - 1) as f32 + 0.5) as usize).min(HEIGHTS - 1);
        let light = ((light / MOST_LIGHT * (LIGHT_STEPS - 1) as f32 + 0.5) as usize).min(LIGHT_STEPS - 1);
        self.0[height * LIGHT_STEPS + light]
    }
}

/// Lays a casing or a glow around rivers, which were drawn as wide as it begins.
pub(super) fn lay_casing(view: &View, mut rivers: Coverage, casing: &Casing, pixels: &mut [[u8; 4]]) {
    let (width, height) = (view.width as usize, view.height as usize);
    let radius = (casing.blur * view.scale).round() as usize;
    let _ = rivers.take_touched();
    let mut mask = rivers.mask().data().to_vec();
    if radius > 0 {
        // Three boxes are nearly a bell.
        for _ in 0..3 {
            mask = blurred_and_turned(&mask, width, height, radius);
            mask = blurred_and_turned(&mask, height, width, radius);
        }
    }
    for (pixel, &covered) in pixels.iter_mut().zip(&mask).filter(|(_, covered)| **covered > 0) {
        let [r, g, b, open] = *pixel;
        let share = (f32::from(covered) / 255.0 * casing.gain).min(1.0) * casing.strength * f32::from(open) / 255.0;
        let [r, g, b] = mix([r, g, b], casing.colour, share);
        *pixel = [r, g, b, open];
    }
}

/// The mean of the pixels of each row that are no farther than a radius, rows become columns.
fn blurred_and_turned(mask: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let mut turned = vec![0; mask.len()];
    let whole = (2 * radius + 1) as u32;
    for y in 0..height {
        let row = &mask[y * width..][..width];
        let mut sum: u32 = row.iter().take(radius).map(|&value| u32::from(value)).sum();
        for x in 0..width {
            sum += row.get(x + radius).map_or(0, |&value| u32::from(value));
            turned[x * height + y] = ((sum + whole / 2) / whole) as u8;
            sum -= if x >= radius { u32::from(row[x - radius]) } else { 0 };
        }
    }
    turned
}
