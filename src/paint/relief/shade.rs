//! Hypsometric tints, lighter where light falls and darker elsewhere.

use glam::{Vec2, Vec3};

use super::Sheet;
use super::field::{Field, Place, places};
use crate::base::sort::quantile;
use crate::land::beside;
use crate::paint::palette::{Colour, Tints, mix};
use crate::paint::view::{Rows, View};
use crate::relief::{CELL_SIZE, Relief};

/// Three lights: from the north-west at 45° above the horizon with a share of 0.55, from the west at 50° with 0.25 and
/// from the north at 55° with 0.2. The strongest light is the lowest, and ridges of all directions have a dark side
/// (after Imhof 1965). Each vector points to its light and is as long as its share.
const LIGHTS: [Vec3; 3] =
    [Vec3::new(-0.275, -0.275, 0.388_909), Vec3::new(-0.160_697, 0.0, 0.191_511), Vec3::new(0.0, -0.114_715, 0.163_83)];

/// The height and the light of land in each pixel of a picture, from north to south as far as they have been looked up.
#[derive(Clone, Debug)]
pub(super) struct Shading {
    /// The exaggeration of slopes for this light.
    lit_with: f32,
    /// The surface; `None` once all pixels have been looked up.
    surface: Option<Surface>,
    places: Vec<Place>,
    /// The number of each pixel's colour in the table of colours.
    numbers: Vec<u16>,
}

/// The height of each cell as a share of the greatest height, and its light as a share of that on flat land.
#[derive(Clone, Debug)]
struct Surface {
    height: Field,
    light: Field,
}

impl Shading {
    /// Computes the light on a relief. `highest` is the height that has the colour of the highest land, in units of
    /// height.
    pub fn new(relief: &Relief, highest: f32, exaggeration: f32, view: &View) -> Self {
        let mut light = Field::of(relief, |_| 0.0);
        light_of(relief, exaggeration, &mut light.values);
        let height = Field::of(relief, |height| height.max(0.0) / highest);
        Self {
            lit_with: exaggeration,
            surface: Some(Surface { height, light }),
            places: places(view, relief.columns()),
            numbers: Vec::with_capacity(view.pixels()),
        }
    }

    /// Returns `true` if slopes are exaggerated by this factor.
    pub fn is_lit_with(&self, exaggeration: f32) -> bool {
        self.lit_with == exaggeration
    }

    /// Lays colours over the land of some rows of a ground.
    pub fn lay(&mut self, sheet: &Sheet<'_>, colours: &Colours, rows: Rows, pixels: &mut [[u8; 4]]) {
        let range = sheet.view.range(rows.clone());
        if self.numbers.len() == range.start {
            rows.for_each(|y| self.look_at(sheet, y));
            self.surface.take_if(|_| range.end == sheet.view.pixels());
        }
        let numbers = &self.numbers[range.clone()];
        for ((pixel, &number), &share) in pixels.iter_mut().zip(numbers).zip(&sheet.land[range]) {
            if share > 0 {
                sheet.shift(pixel, colours.0[usize::from(number)], share);
            }
        }
    }

    /// Looks up the pixels of a row.
    fn look_at(&mut self, sheet: &Sheet<'_>, y: u32) {
        let Some(Surface { height, light }) = &self.surface else { return };
        let at = sheet.view.point(Vec2::splat(y as f32 + 0.5)).y;
        let (height, light, land) =
            (height.line(at, false), light.line(at, false), &sheet.land[sheet.view.range(y..y + 1)]);
        self.numbers.extend(self.places.iter().zip(land).map(|(&Place { column, along }, &share)| {
            if share > 0 { number(height[column].at(along), light[column].at(along)) } else { 0 }
        }));
    }
}

/// Computes the light on each cell, as a share of the light on flat land.
pub(crate) fn light_of(relief: &Relief, exaggeration: f32, light: &mut [f32]) {
    let (columns, rows) = (relief.columns(), relief.rows());
    let height = |cell: usize| relief.heights()[cell].max(0.0);
    for row in 0..rows {
        let [north, _, south] = beside(row, rows).map(|row| row * columns);
        for column in 0..columns {
            let [west, _, east] = beside(column, columns);
            let here = row * columns;
            let rise =
                Vec2::new(height(here + east) - height(here + west), height(south + column) - height(north + column));
            light[here + column] = lit(rise * (exaggeration / (2.0 * CELL_SIZE)));
        }
    }
    let land = relief.heights().iter().zip(light.iter()).filter(|(height, _)| **height > 0.0);
    let some: Vec<f32> = land.map(|(_, light)| *light).step_by(7).collect();
    let usual = quantile(&some, 0.5).max(0.05);
    light.iter_mut().for_each(|light| *light /= usual);
}

/// The light on a slope.
fn lit(rise: Vec2) -> f32 {
    let normal = (-rise).extend(1.0);
    let length = (rise.length_squared() + 1.0).sqrt();
    LIGHTS.iter().map(|light| (normal.dot(*light) / length).max(0.0)).sum()
}

/// The colours of all heights and lights, by number.
#[derive(Clone, Debug)]
pub(super) struct Colours(Vec<Colour>);

const HEIGHTS: usize = 128;
const LIGHT_STEPS: usize = 128;
/// The greatest light in the table, as a share of that on flat land.
const MOST_LIGHT: f32 = 2.0;

impl Colours {
    pub fn new(tints: &Tints) -> Self {
        let colour = |i: usize| {
            let height = (i / LIGHT_STEPS) as f32 / (HEIGHTS - 1) as f32;
            let light = (i % LIGHT_STEPS) as f32 / (LIGHT_STEPS - 1) as f32 * MOST_LIGHT;
            mix(tints.shadow, tints.at(height), tints.factor(light))
        };
        Self((0..HEIGHTS * LIGHT_STEPS).map(colour).collect())
    }
}

/// The number of the colour of a height and a light: the height as a share of the greatest, the light as a share of
/// that on flat land.
#[inline]
fn number(height: f32, light: f32) -> u16 {
    const MOST_HEIGHT: i32 = HEIGHTS as i32 - 1;
    const LIGHTEST: i32 = LIGHT_STEPS as i32 - 1;
    let height = ((height * MOST_HEIGHT as f32 + 0.5) as i32).clamp(0, MOST_HEIGHT);
    let light = ((light * (LIGHTEST as f32 / MOST_LIGHT) + 0.5) as i32).clamp(0, LIGHTEST);
    (height * LIGHT_STEPS as i32 + light) as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::styles::palette;
    use crate::recipe::Style;

    #[test]
    fn a_wash_is_ink_where_it_is_dark_and_never_lighter_than_its_paper() {
        let tints = &palette(Style::InkWash).relief.unwrap().tints;
        let colours = Colours::new(tints);
        for height in [0.0, 0.4, 1.0] {
            let [dark, flat, light] = [0.0, 1.0, MOST_LIGHT].map(|light| colours.0[usize::from(number(height, light))]);
            let paper = tints.at((height * (HEIGHTS - 1) as f32).round() / (HEIGHTS - 1) as f32);
            assert_eq!((flat, light), (paper, paper), "at {height}");
            let off = |i: usize| dark[i].abs_diff(tints.shadow[i]);
            assert!((0..3).all(|i| off(i) < 24), "{dark:?} at {height}");
        }
    }
}
