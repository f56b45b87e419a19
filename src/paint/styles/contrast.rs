//! The contrast of ink with the grounds of a style, for tests.

use crate::paint::palette::{Colour, Palette};

/// The contrast of two colours by WCAG 2, from 1 to 21.
pub fn contrast(a: Colour, b: Colour) -> f64 {
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

/// All colours of a style's land, apart from light and shade.
pub fn grounds(palette: &Palette) -> Vec<Colour> {
    let relief = palette.relief.iter().flat_map(|relief| {
        let basins = relief.basins.iter().flat_map(|look| (0..=look.colours.len()).map(|number| look.tint(number)));
        relief.tints.stops.iter().map(|stop| stop.1).chain(basins)
    });
    [palette.lowland, palette.inland, palette.plain].into_iter().chain(relief).collect()
}
