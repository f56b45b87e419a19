//! The styles, each a file of its own and a line in this list.

mod atlas;
mod basins;
mod blueprint;
mod dark;
mod ink;
mod ink_wash;
mod night;
mod orbit;
mod parchment;
mod past_courses;
mod skeleton;
mod survey;

use super::palette::Palette;
use crate::recipe::Style;

/// What a style paints with.
pub(crate) fn palette(style: Style) -> &'static Palette {
    match style {
        Style::Ink => &ink::PALETTE,
        Style::Dark => &dark::PALETTE,
        Style::Atlas => &atlas::PALETTE,
        Style::Night => &night::PALETTE,
        Style::Survey => &survey::PALETTE,
        Style::Basins => &basins::PALETTE,
        Style::Parchment => &parchment::PALETTE,
        Style::PastCourses => &past_courses::PALETTE,
        Style::InkWash => &ink_wash::PALETTE,
        Style::Orbit => &orbit::PALETTE,
        Style::Blueprint => &blueprint::PALETTE,
        Style::Skeleton => &skeleton::PALETTE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::palette::{Colour, mix};
    use crate::recipe::Choice;

    /// The contrast of two colours as WCAG 2 has it, from 1 to 21.
    fn contrast(a: Colour, b: Colour) -> f64 {
        let luminance = |colour: Colour| {
            let linear = |channel: u8| {
                let share = f64::from(channel) / 255.0;
                if share <= 0.040_45 { share / 12.92 } else { libm::pow((share + 0.055) / 1.055, 2.4) }
            };
            let [red, green, blue] = colour.map(linear);
            0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05
        };
        let (a, b) = (luminance(a), luminance(b));
        a.max(b) / a.min(b)
    }

    #[test]
    fn letters_stand_out_from_the_land_of_their_style() {
        for &style in Style::ALL {
            let look = palette(style);
            let relief = look.relief.iter().flat_map(|relief| {
                let basins =
                    relief.basins.iter().flat_map(|look| (0..=look.colours.len()).map(|number| look.tint(number)));
                relief.tints.stops.iter().map(|stop| stop.1).chain(basins)
            });
            for ground in [look.lowland, look.inland, look.plain].into_iter().chain(relief) {
                let under = look.label_halo.map_or(ground, |(colour, strength)| mix(ground, colour, strength));
                let contrast = contrast(look.label, under);
                assert!(contrast >= 4.5, "{style:?}: {contrast:.1} : 1 on {ground:x?}");
            }
        }
    }

    #[test]
    fn styles_that_show_relief_have_tints_for_it_and_no_others() {
        for &style in Style::ALL {
            assert_eq!(style.has_relief(), palette(style).relief.is_some(), "{style:?}");
        }
    }
}
