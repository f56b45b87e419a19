//! The styles, each a file of its own and a line in this list.

mod atlas;
mod basins;
mod blueprint;
#[cfg(all(test, feature = "names"))]
mod contrast;
mod dark;
mod ink;
mod ink_wash;
pub(crate) mod labels;
mod night;
mod orbit;
mod parchment;
mod past_courses;
pub(crate) mod scenery;
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
    use crate::recipe::Choice;

    #[test]
    fn styles_that_show_relief_have_tints_for_it_and_no_others() {
        for &style in Style::ALL {
            assert_eq!(style.has_relief(), palette(style).relief.is_some(), "{style:?}");
        }
    }
}
