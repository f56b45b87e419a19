//! Hypsometric tints, lighter where light falls and darker elsewhere.

use glam::Vec2;

use super::Sheet;
use super::field::{Field, Place, places};
use super::light::{Light, light_of};
use super::rain::RainLevels;
use crate::paint::palette::{Colour, Tints};
use crate::paint::view::{Rows, View};
use crate::relief::Relief;
use crate::scale::USUAL_METRES;

/// The height and the light of land in each pixel of a picture, from north to south as far as they have been looked up.
#[derive(Clone, Debug)]
pub(super) struct Shading {
    pub light: Light,
    /// The surface; `None` once all pixels have been looked up.
    surface: Option<Surface>,
    places: Vec<Place>,
    /// The number of each pixel's colour in the table of colours.
    numbers: Vec<u16>,
}

/// The height of each cell as `Tints::place_of` has it, and its light, from -1 to 1.
#[derive(Clone, Debug)]
struct Surface {
    height: Field,
    light: Field,
}

impl Shading {
    /// Computes the light on a relief.
    pub fn new(relief: &Relief, light: Light, view: &View) -> Self {
        let lit = Field { grid: relief.grid(), values: light_of(relief, light) };
        let height = Field::of(relief, |height| Tints::place_of(height * USUAL_METRES));
        Self {
            light,
            surface: Some(Surface { height, light: lit }),
            places: places(view, relief.grid()),
            numbers: Vec::with_capacity(view.pixels()),
        }
    }

    /// Lays colours over the land of some rows of a ground.
    pub fn lay(
        &mut self,
        sheet: &Sheet<'_>,
        colours: &[Colours],
        rain: Option<&RainLevels>,
        rows: Rows,
        pixels: &mut [[u8; 4]],
    ) {
        let range = sheet.view.range(rows.clone());
        if self.numbers.len() == range.start {
            rows.clone().for_each(|y| self.look_at(sheet, y));
            self.surface.take_if(|_| range.end == sheet.view.pixels());
        }
        let mut lay = |i: usize, level: usize| {
            let share = sheet.land[range.start + i];
            if share > 0 {
                let number = self.numbers[range.start + i];
                sheet.shift(&mut pixels[i], colours[level].0[usize::from(number)], share);
            }
        };
        let Some(rain) = rain.filter(|_| colours.len() > 1) else { return (0..range.len()).for_each(|i| lay(i, 0)) };
        let width = sheet.view.width as usize;
        for (row, y) in rows.enumerate() {
            rain.for_each(sheet.view, y, |i, level| lay(row * width + i, level));
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

/// The colours of all heights and lights, by number.
#[derive(Clone, Debug)]
pub(super) struct Colours(Vec<Colour>);

const HEIGHTS: usize = 128;
/// An odd number, so that one of them is flat land's.
const LIGHT_STEPS: usize = 127;

impl Colours {
    pub fn new(tints: &Tints) -> Self {
        let colour = |i: usize| {
            let place = (i / LIGHT_STEPS) as f32 / (HEIGHTS - 1) as f32;
            let light = (i % LIGHT_STEPS) as f32 / (LIGHT_STEPS / 2) as f32 - 1.0;
            tints.lit(tints.at(Tints::metres_at(place)), light)
        };
        Self((0..HEIGHTS * LIGHT_STEPS).map(colour).collect())
    }
}

/// Returns the number of the colour at the place of a height (`Tints::place_of`), in a light from -1 to 1.
#[inline]
fn number(place: f32, light: f32) -> u16 {
    const MOST_HEIGHT: i32 = HEIGHTS as i32 - 1;
    const LIGHTEST: i32 = LIGHT_STEPS as i32 - 1;
    let height = ((place * MOST_HEIGHT as f32 + 0.5) as i32).clamp(0, MOST_HEIGHT);
    let light = (((light + 1.0) * (LIGHTEST / 2) as f32 + 0.5) as i32).clamp(0, LIGHTEST);
    (height * LIGHT_STEPS as i32 + light) as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::palette::mix;
    use crate::paint::styles::palette;
    use crate::recipe::{Choice, Style};

    fn all_tints() -> impl Iterator<Item = (Style, Tints)> {
        Style::ALL.iter().filter_map(|&style| Some((style, palette(style.into()).relief?.tints)))
    }

    /// Returns the colour in the table of a height in metres and a light.
    fn colour(colours: &Colours, metres: f32, light: f32) -> Colour {
        colours.0[usize::from(number(Tints::place_of(metres), light))]
    }

    #[test]
    fn a_wash_is_mostly_ink_where_it_is_dark_and_never_lighter_than_its_paper() {
        let tints = &palette(Style::InkWash.into()).relief.unwrap().tints;
        let colours = Colours::new(tints);
        for metres in [0.0, 500.0, 2500.0] {
            let [dark, flat, light] = [-1.0, 0.0, 1.0].map(|light| colour(&colours, metres, light));
            assert_eq!(flat, light, "at {metres}");
            let halfway = mix(flat, tints.shadow, 0.5);
            assert!((0..3).all(|i| (tints.shadow[i]..halfway[i]).contains(&dark[i])), "{dark:?} at {metres}");
        }
    }

    #[test]
    fn flat_land_has_the_tint_of_its_metres() {
        for (style, tints) in all_tints() {
            let colours = Colours::new(&tints);
            for metres in (0..4000).step_by(7).map(|metres| metres as f32) {
                let (tint, flat) = (tints.at(metres), colour(&colours, metres, 0.0));
                let off = (0..3).map(|i| tint[i].abs_diff(flat[i])).max().unwrap();
                assert!(off <= 4, "{style:?}: {flat:?} for {tint:?} at {metres} m");
            }
        }
    }

    #[test]
    fn light_adds_a_share_of_the_highlight_and_never_hides_the_tint() {
        for (style, tints) in all_tints() {
            let colours = Colours::new(&tints);
            assert!(tints.bright <= 0.6, "{style:?}: heights are told apart in full light");
            for (place, i) in (0..HEIGHTS * LIGHT_STEPS).step_by(LIGHT_STEPS).zip(0..) {
                let tint = tints.at(Tints::metres_at(i as f32 / (HEIGHTS - 1) as f32));
                let highlight = mix(tint, tints.highlight, tints.bright);
                for pixel in &colours.0[place..place + LIGHT_STEPS] {
                    let most = |part: usize| tint[part].max(highlight[part]);
                    assert!((0..3).all(|part| pixel[part] <= most(part)), "{style:?}: {pixel:?} over {highlight:?}");
                }
            }
            // Paper white is left to paper.
            assert!(tints.highlight[2] < 0xf0, "{style:?}: the highlight is warm");
        }
    }
}
