//! The styles, each a file of its own and a line in both lists.

pub mod atlas;
mod basins;
mod blueprint;
mod climate;
mod coloured;
#[cfg(test)]
mod contrast;
mod dark;
mod ink;
mod ink_wash;
mod look;
mod night;
mod orbit;
mod parchment;
mod past_courses;
#[cfg(test)]
mod ramps;
mod scheme;
mod skeleton;
mod survey;

pub(crate) use look::{LabelLook, SceneryLook};
pub(crate) use scheme::Scheme;

use super::palette::Palette;
use crate::recipe::Style;
use look::Look;

/// Returns all that a style paints with, in a temperate climate.
fn look(style: Style) -> &'static Look {
    match style {
        Style::Ink => &ink::STYLE,
        Style::Dark => &dark::STYLE,
        Style::Atlas => &atlas::STYLE,
        Style::Night => &night::STYLE,
        Style::Survey => &survey::STYLE,
        Style::Basins => &basins::STYLE,
        Style::Parchment => &parchment::STYLE,
        Style::PastCourses => &past_courses::STYLE,
        Style::InkWash => &ink_wash::STYLE,
        Style::Orbit => &orbit::STYLE,
        Style::Blueprint => &blueprint::STYLE,
        Style::Skeleton => &skeleton::STYLE,
    }
}

/// Mixes all that a scheme paints with.
#[inline(never)] // one copy
fn look_of(scheme: Scheme) -> Look {
    look(scheme.style).in_climate(scheme.climate)
}

/// Returns the colours and forms of a scheme.
#[inline(never)] // each copy weighs a thousand bytes
pub(crate) fn palette(scheme: Scheme) -> Palette {
    look_of(scheme).palette
}

/// Returns the look of a scheme's letters.
#[inline(never)] // each copy weighs a thousand bytes
pub(crate) fn label_look(scheme: Scheme) -> LabelLook {
    look_of(scheme).labels
}

/// Returns the look of a scheme's trees and hills; `None` if its style has none.
#[inline(never)] // each copy weighs a thousand bytes
pub(crate) fn scenery_look(scheme: Scheme) -> Option<SceneryLook> {
    look_of(scheme).scenery
}

#[cfg(test)]
mod tests {
    use super::climate::Climates;
    use super::*;
    use crate::recipe::Choice;
    use crate::recipe::Shown;

    #[test]
    fn styles_show_what_they_have_colours_for_and_no_more() {
        for &style in Style::ALL {
            let look = look(style);
            assert_eq!(style.has_relief(), look.palette.relief.is_some(), "relief of {style:?}");
            assert_eq!(style.has_beds(), look.palette.beds.is_some(), "beds of {style:?}");
            assert_eq!(style.has_woods(), look.scenery.is_some(), "woods of {style:?}");
            assert!(style.has_woods() || !style.has_hills(), "hills of {style:?}");
            assert_eq!(style.has_climate(), !matches!(look.climates, Climates::Alike), "climate of {style:?}");
            assert!(look.palette.neatline.is_some() || !style.shows(Shown::Neatline), "border of {style:?}");
        }
    }
}
