//! How styles draw woods and hills.

use super::palette;
use crate::paint::palette::Colour;
use crate::recipe::Style;

/// How trees and hills are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SceneryLook {
    pub ink: Colour,
    /// How much fainter strokes cover, those on the dark side.
    #[cfg_attr(not(feature = "names"), expect(dead_code, reason = "the module that draws them asks"))]
    pub shade: f32,
    /// What covers the ground behind them, and how much, where that is too uneven for strokes alone.
    pub body: Option<(Colour, f32)>,
}

/// How a style draws them; `None` if it has none.
pub(crate) fn scenery_look(style: Style) -> Option<SceneryLook> {
    let look = |ink: Colour, shade: f32| SceneryLook { ink, shade, body: None };
    let woods = |ink: Colour, body: Option<(Colour, f32)>| SceneryLook { body, ..look(ink, 0.7) };
    Some(match style {
        Style::Ink => look([0x5c, 0x54, 0x42], 0.7),
        Style::Dark => look([0x93, 0xa2, 0xad], 0.65),
        Style::Basins => look([0x50, 0x49, 0x3b], 0.7),
        Style::PastCourses => look([0x5a, 0x50, 0x3f], 0.7),
        Style::Atlas => woods([0x3a, 0x55, 0x32], None),
        Style::Survey => woods([0x2f, 0x6b, 0x35], Some(([0xee, 0xf0, 0xd0], 0.6))),
        Style::Night => woods([0xa9, 0xce, 0xbc], None),
        Style::Parchment => woods([0x4a, 0x38, 0x28], Some(([0xf1, 0xe4, 0xc3], 0.5))),
        Style::InkWash => woods([0x33, 0x3a, 0x3c], Some(([0xf5, 0xf1, 0xe8], 0.45))),
        Style::Blueprint => woods([0xbf, 0xe0, 0xff], Some((palette(style).plain, 0.5))),
        Style::Skeleton | Style::Orbit => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::super::contrast::{contrast, grounds};
    use super::*;
    use crate::paint::palette::mix;
    use crate::recipe::Choice;

    #[test]
    fn styles_draw_what_they_are_said_to_draw() {
        for &style in Style::ALL {
            assert_eq!(style.has_woods(), scenery_look(style).is_some(), "{style:?}");
            assert!(style.has_woods() || !style.has_hills(), "{style:?}");
        }
    }

    /// What is no text asks for 3 : 1 (WCAG 2, 1.4.11).
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
}
