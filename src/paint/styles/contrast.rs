//! The contrast of a style's inks with its grounds.

use super::{label_look, palette, scenery_look};
use crate::paint::palette::{Colour, Palette, mix};
use crate::recipe::{Choice, Style};

/// Computes the contrast of two colours by WCAG 2, from 1 to 21.
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

/// Lists all colours of a style's land, apart from light and shade.
fn grounds(palette: &Palette) -> Vec<Colour> {
    let relief = palette.relief.iter().flat_map(|relief| {
        let basins = relief.basins.iter().flat_map(|look| (0..=look.colours.len()).map(|number| look.tint(number)));
        relief.tints.stops.iter().map(|stop| stop.1).chain(basins)
    });
    [palette.lowland, palette.inland, palette.plain].into_iter().chain(relief).collect()
}

/// Checks figures on land and letters in the margin.
#[test]
fn heights_stand_out_from_the_land_and_from_the_margin() {
    let look = label_look(Style::Survey);
    let (halo, strength) = look.halo.unwrap();
    let under = grounds(palette(Style::Survey))
        .into_iter()
        .map(|ground| mix(ground, halo, look.need_of_halo(ground) * strength));
    for ground in under.chain([look.panel]) {
        assert!(contrast(look.mark, ground) >= 4.5, "{ground:x?}");
    }
}

#[test]
fn letters_stand_out_from_land_and_sea_of_their_style() {
    for &style in Style::ALL {
        let (look, palette) = (label_look(style), palette(style));
        for ground in grounds(palette) {
            let need = look.need_of_halo(ground);
            let under = look.halo.map_or(ground, |(colour, strength)| mix(ground, colour, need * strength));
            let contrast = contrast(look.ink, under);
            assert!(contrast >= 4.5, "{style:?}: {contrast:.1} : 1 on {ground:x?}");
        }
        for water in [palette.shallows, palette.deep] {
            let contrast = contrast(look.ink, water);
            assert!(contrast >= 4.5, "{style:?}: {contrast:.1} : 1 on water of {water:x?}");
        }
    }
}

/// Asks for 3 : 1, as for everything that is no text (WCAG 2, 1.4.11).
#[test]
fn trees_and_hills_stand_out_from_the_land_of_their_style() {
    for (style, look) in Style::ALL.iter().filter_map(|&style| Some((style, scenery_look(style)?))) {
        for ground in grounds(palette(style)) {
            let under = look.body.map_or(ground, |(colour, covers)| mix(ground, colour, covers));
            let contrast = contrast(look.ink, under);
            assert!(contrast >= 3.0, "{style:?}: {contrast:.1} : 1 on {ground:x?}");
        }
    }
}
