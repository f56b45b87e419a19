//! Hypsometric tints, lighter where light falls and darker where it does not.

use glam::{Vec2, Vec3};

use super::Sheet;
use super::field::{Field, Place, places};
use crate::land::beside;
use crate::paint::palette::{Colour, Tints, mix};
use crate::relief::{CELL_SIZE, Relief};
use crate::sort::quantile;

/// Light from the north-west at 45° over the horizon, with a share of 0.55, from the west at 50° with 0.25 and from the north at 55° with
/// 0.2: the strongest light is the lowest, and ridges of all directions have a dark side (after Imhof 1965). Each points to its light and
/// is as long as its share.
const LIGHTS: [Vec3; 3] =
    [Vec3::new(-0.275, -0.275, 0.388_909), Vec3::new(-0.160_697, 0.0, 0.191_511), Vec3::new(0.0, -0.114_715, 0.163_83)];

/// A relief as a picture shows it: how high and how light each cell is.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    /// The height of each cell as a share of the highest, and its light as a share of that on flat land.
    tint: Field,
    light: Field,
    /// The exaggeration of slopes that it is lit with.
    lit_with: Option<f32>,
}

impl Surface {
    /// A relief without light.
    pub fn new(relief: &Relief, highest: f32) -> Self {
        let tint = Field::of(relief, |height| height.max(0.0) / highest);
        Self { tint, light: Field::of(relief, |_| 1.0), lit_with: None }
    }

    /// Lets light fall on it.
    pub fn light(&mut self, relief: &Relief, exaggeration: f32) {
        if self.lit_with.replace(exaggeration) == Some(exaggeration) {
            return;
        }
        light_of(relief, exaggeration, &mut self.light.values);
    }

    /// Lays tints over the land of a ground.
    pub fn lay(&self, sheet: &Sheet<'_>, tints: &Tints, pixels: &mut [[u8; 4]]) {
        let colours = Colours::new(tints);
        let (places, width) = (places(sheet.view, self.tint.columns), sheet.view.width as usize);
        let (mut tint, mut light) = (Vec::new(), Vec::new());
        for (y, (row, land)) in pixels.chunks_mut(width).zip(sheet.land.chunks(width)).enumerate() {
            let y = sheet.view.point(Vec2::splat(y as f32 + 0.5)).y;
            self.tint.line(y, false, &mut tint);
            self.light.line(y, false, &mut light);
            for ((pixel, &share), &Place { column, along }) in row.iter_mut().zip(land).zip(&places) {
                if share > 0 {
                    sheet.shift(pixel, colours.at(tint[column].at(along), light[column].at(along)), share);
                }
            }
        }
    }
}

/// How light each cell is, as a share of the light on flat land.
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
            mix(tints.shadow, tints.at(height), tints.factor(light))
        };
        Self((0..HEIGHTS * LIGHT_STEPS).map(colour).collect())
    }

    #[inline]
    fn at(&self, height: f32, light: f32) -> Colour {
        // What is less than 0 becomes 0.
        let height = ((height * (HEIGHTS - 1) as f32 + 0.5) as u32).min(HEIGHTS as u32 - 1);
        let light = ((light * ((LIGHT_STEPS - 1) as f32 / MOST_LIGHT) + 0.5) as u32).min(LIGHT_STEPS as u32 - 1);
        self.0[height as usize * LIGHT_STEPS + light as usize]
    }
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
            let (dark, flat, light) =
                (colours.at(height, 0.0), colours.at(height, 1.0), colours.at(height, MOST_LIGHT));
            let paper = tints.at((height * (HEIGHTS - 1) as f32).round() / (HEIGHTS - 1) as f32);
            assert_eq!((flat, light), (paper, paper), "at {height}");
            let off = |i: usize| dark[i].abs_diff(tints.shadow[i]);
            assert!((0..3).all(|i| off(i) < 24), "{dark:?} at {height}");
        }
    }
}
