//! The styles, each a file of its own and a line in both lists.

pub mod atlas;
mod basins;
mod blueprint;
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
mod skeleton;
mod survey;

pub(crate) use look::{LabelLook, SceneryLook};

use super::palette::Palette;
use crate::recipe::Style;
use look::Look;

/// Returns all that a style paints with.
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

/// Returns the colours and forms of a style.
pub(crate) fn palette(style: Style) -> &'static Palette {
    &look(style).palette
}

/// Returns the look of a style's letters.
pub(crate) fn label_look(style: Style) -> LabelLook {
    look(style).labels
}

/// Returns the look of a style's trees and hills; `None` if it has none.
pub(crate) fn scenery_look(style: Style) -> Option<SceneryLook> {
    look(style).scenery
}

#[cfg(test)]
mod tests {
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
            assert!(look.palette.neatline.is_some() || !style.shows(Shown::Neatline), "border of {style:?}");
        }
    }
}
