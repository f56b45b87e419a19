//! The colours of letters, style by style.

use super::palette;
use crate::paint::palette::Colour;
use crate::recipe::Style;

/// How letters are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LabelLook {
    pub ink: Colour,
    /// What lies around letters on land, and how much it covers, where the ground is too uneven for letters of one colour.
    pub halo: Option<(Colour, f32)>,
    /// What lies under type in a frame on land.
    pub panel: Colour,
    /// What there is besides names, and its colour.
    #[cfg_attr(not(feature = "names"), expect(dead_code, reason = "the module that places it asks"))]
    pub marks: Marks,
    pub mark: Colour,
}

/// What the labels of a style have besides names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Marks {
    /// Nothing.
    None,
    /// Heights beside summits, and letters along the edge for a grid whose lines are so many units apart.
    SpotHeights { grid: f32 },
    /// A box with title, scale and counts.
    Legend,
    /// A painter's seal.
    Seal,
}

impl LabelLook {
    /// What lies under type on land, and how much it covers; in a frame nearly all.
    pub fn under(self, is_panel: bool) -> Option<(Colour, f32)> {
        const PANEL: f32 = 0.88;
        if is_panel { Some((self.panel, PANEL)) } else { self.halo }
    }
}

/// How a style draws letters.
pub(crate) fn label_look(style: Style) -> LabelLook {
    let only = |ink: Colour, halo: Option<(Colour, f32)>, panel: Colour| LabelLook {
        ink,
        halo,
        panel,
        marks: Marks::None,
        mark: ink,
    };
    let on = |ink: Colour, halo: Colour, strength: f32| only(ink, Some((halo, strength)), halo);
    let bare = |ink: Colour| only(ink, None, palette(style).plain);
    match style {
        Style::Ink | Style::Dark => bare(palette(style).river),
        Style::Skeleton => bare([0xd0; 3]),
        Style::Basins => bare([0x3a, 0x33, 0x2b]),
        Style::Atlas => on([0x17, 0x3e, 0x68], [0xf4, 0xee, 0xd6], 0.5),
        Style::Survey => LabelLook {
            marks: Marks::SpotHeights { grid: 120.0 },
            mark: [0x4a, 0x33, 0x22],
            ..on([0x17, 0x3e, 0x68], [0xf4, 0xf1, 0xdc], 0.6)
        },
        Style::Night => on([0xe8, 0xf5, 0xfc], [0x14, 0x26, 0x28], 0.5),
        Style::Parchment => on([0x2f, 0x3a, 0x3f], [0xf1, 0xe4, 0xc3], 0.6),
        Style::PastCourses => on([0x2e, 0x2a, 0x26], [0xf1, 0xe9, 0xd6], 0.6),
        Style::InkWash => LabelLook {
            marks: Marks::Seal,
            mark: [0xa8, 0x32, 0x2a],
            ..on([0x1c, 0x36, 0x44], [0xf5, 0xf1, 0xe8], 0.6)
        },
        Style::Blueprint => LabelLook { marks: Marks::Legend, ..on(palette(style).river, palette(style).plain, 0.6) },
        Style::Orbit => on([0xf8, 0xf6, 0xee], [0x10, 0x18, 0x26], 0.62),
    }
}

#[cfg(test)]
mod tests {
    use super::super::contrast::{contrast, grounds};
    use super::*;
    use crate::paint::palette::mix;
    use crate::recipe::Choice;

    #[test]
    fn styles_have_the_marks_that_they_are_said_to_have() {
        for &style in Style::ALL {
            let marks = label_look(style).marks;
            assert_eq!(style.has_marks(), marks != Marks::None, "{style:?}");
        }
    }

    /// Figures on land, and letters in the margin.
    #[test]
    fn heights_stand_out_from_the_land_and_from_the_margin() {
        let look = label_look(Style::Survey);
        let (halo, strength) = look.halo.unwrap();
        let under = grounds(palette(Style::Survey)).into_iter().map(|ground| mix(ground, halo, strength));
        for ground in under.chain([look.panel]) {
            assert!(contrast(look.mark, ground) >= 4.5, "{ground:x?}");
        }
    }

    #[test]
    fn letters_stand_out_from_land_and_sea_of_their_style() {
        for &style in Style::ALL {
            let (look, palette) = (label_look(style), palette(style));
            for ground in grounds(palette) {
                let under = look.halo.map_or(ground, |(colour, strength)| mix(ground, colour, strength));
                let contrast = contrast(look.ink, under);
                assert!(contrast >= 4.5, "{style:?}: {contrast:.1} : 1 on {ground:x?}");
            }
            for water in [palette.shallows, palette.deep] {
                let contrast = contrast(look.ink, water);
                assert!(contrast >= 4.5, "{style:?}: {contrast:.1} : 1 on water of {water:x?}");
            }
        }
    }
}
