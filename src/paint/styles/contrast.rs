//! The contrast of a style's inks with its grounds.

use super::climate::Climate;
use super::{Scheme, label_look, palette, scenery_look};
use crate::paint::palette::{Colour, Palette, mix};
use crate::recipe::{Choice, GroundKind, Style};

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

/// Lists a style in climates of every kind, or in one if it has the same colours in all.
fn schemes() -> impl Iterator<Item = Scheme> {
    let climates = || {
        let warmths = [0.0, 0.2, 0.35, 0.5, 1.0].into_iter();
        let of_rain = |warmth| [0.0, 0.25, 0.4, 0.5, 0.6, 0.75, 1.0].map(|rain| (warmth, rain));
        let of_ground = |(warmth, rain)| GroundKind::ALL.iter().map(move |&ground| Climate { warmth, rain, ground });
        warmths.flat_map(of_rain).flat_map(of_ground)
    };
    let schemes = move |&style: &Style| {
        let changing = climates().filter(move |_| style.has_climate());
        changing.chain([Climate::TEMPERATE]).map(move |climate| Scheme { style, climate })
    };
    Style::ALL.iter().flat_map(schemes)
}

/// Checks figures on land and letters in the margin.
#[test]
fn heights_stand_out_from_the_land_and_from_the_margin() {
    let look = label_look(Style::Survey.into());
    let (halo, strength) = look.halo.unwrap();
    let under = grounds(&palette(Style::Survey.into()))
        .into_iter()
        .map(|ground| mix(ground, halo, look.need_of_halo(ground) * strength));
    for ground in under.chain([look.panel]) {
        assert!(contrast(look.mark, ground) >= 4.5, "{ground:x?}");
    }
}

#[test]
fn letters_stand_out_from_land_and_sea_of_their_style() {
    for scheme in schemes() {
        let (look, palette) = (label_look(scheme), palette(scheme));
        for ground in grounds(&palette) {
            let need = look.need_of_halo(ground);
            let under = look.halo.map_or(ground, |(colour, strength)| mix(ground, colour, need * strength));
            let contrast = contrast(look.ink, under);
            assert!(contrast >= 4.5, "{scheme:?}: {contrast:.1} : 1 on {ground:x?}");
        }
        for water in [palette.shallows, palette.deep] {
            let contrast = contrast(look.ink, water);
            assert!(contrast >= 4.5, "{scheme:?}: {contrast:.1} : 1 on water of {water:x?}");
        }
    }
}

/// Asks for 3 : 1, as for everything that is no text (WCAG 2, 1.4.11).
#[test]
fn trees_and_hills_stand_out_from_the_land_of_their_style() {
    for (scheme, look) in schemes().filter_map(|scheme| Some((scheme, scenery_look(scheme)?))) {
        for ground in grounds(&palette(scheme)) {
            let under = look.body.map_or(ground, |(colour, covers)| mix(ground, colour, covers));
            let contrast = contrast(look.ink, under);
            assert!(contrast >= 3.0, "{scheme:?}: {contrast:.1} : 1 on {ground:x?}");
        }
    }
}

/// Asks for less than of what is no text: brooks are many, and should not shout. From orbit they are seen by the woods along them.
#[test]
fn rivers_stand_out_from_their_casing_in_every_climate() {
    let drawn = |scheme: &Scheme| scheme.style.has_climate() && scheme.style != Style::Orbit;
    for scheme in schemes().filter(drawn) {
        let palette = palette(scheme);
        let casing = palette.relief.unwrap().casing;
        for ground in grounds(&palette) {
            let contrast = contrast(palette.river, mix(ground, casing.colour, casing.strength));
            assert!(contrast >= 1.9, "{scheme:?}: {contrast:.2} : 1 on {ground:x?}");
        }
    }
}
