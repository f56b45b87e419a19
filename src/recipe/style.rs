//! The styles of painting, and the parts of a map that each shows.

use super::choice::{Choice, Word, choices};
use super::key::Key;
use super::texts::{Written, explained};

choices! {
    /// A style of painting.
    Style of Style, Atlas {
        /// An atlas page: green lowland, brown mountains, soft shade, blue rivers and sea.
        Atlas = "atlas", "atlas";
        /// The land by night, rivers shining.
        Night = "night", "night";
        /// An engraving on old paper: water lines, mountains in strokes on their dark side.
        Parchment = "parchment", "parchment";
        /// A survey sheet: contours in brown, index lines each fifth, depth lines at sea.
        Survey = "survey", "survey";
        /// A painting in ink and water: mountains on their dark side, mist along rivers.
        InkWash = "ink-wash", "ink wash";
        /// The land from orbit: forests, rock, snow, shallow water.
        Orbit = "orbit", "from orbit";
        /// Each river system in a colour of its own, and its basin in a tint of that; divides are left bare.
        Basins = "basins", "basins";
        /// A blueprint: rivers, coasts and contours in white on blue, over a grid.
        Blueprint = "blueprint", "blueprint";
        /// Past courses: where great rivers have run in bends before, a band for each time, after Fisk 1944.
        PastCourses = "past-courses", "past courses";
        /// Ink on paper, rivers as wide as their discharge asks.
        Ink = "ink", "ink";
        /// Light ink on dark paper.
        Dark = "dark", "dark";
        /// White lines one pixel wide on black, as in the study of the paper (figure 6.1).
        Skeleton = "skeleton", "skeleton";
    }
}

/// Parts of a map that only some styles show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    /// The heights of the land.
    Relief,
    /// The colours of the climate.
    Climate,
    Woods,
    /// Hills as symbols; most styles have their relief for that.
    Hills,
    /// Marks: heights beside summits, and letters along the edge for a grid.
    SpotHeights,
    /// A mark: a box with title, scale and counts.
    Legend,
    /// A mark: a painter's seal.
    Seal,
    /// A north point beside the title's scale bar.
    NorthArrow,
    /// A compass rose, and scrolls around a framed title.
    CompassRose,
    /// The beds in which great rivers ran before.
    Beds,
    /// A margin, with a line at which land that runs off the map ends, in pictures and files of the whole map too.
    Neatline,
}

impl Style {
    /// Returns the row of a style in the table of what styles show.
    const fn shown(self) -> &'static [Shown] {
        use Shown::{
            Beds, Climate, CompassRose, Hills, Legend, Neatline, NorthArrow, Relief, Seal, SpotHeights, Woods,
        };
        match self {
            Self::Ink => &[Woods, Hills],
            Self::Skeleton => &[],
            Self::Atlas => &[Relief, Climate, Woods, Neatline],
            Self::Night => &[Relief, Climate, Woods, Neatline],
            Self::Survey => &[Relief, Woods, SpotHeights, NorthArrow, Neatline],
            Self::Basins => &[Relief, Woods, Hills, Neatline],
            Self::Parchment => &[Relief, Climate, Woods, Hills, CompassRose, Neatline],
            Self::PastCourses => &[Woods, Hills, Beds, NorthArrow],
            Self::InkWash => &[Relief, Woods, Hills, Seal, Neatline],
            Self::Orbit => &[Relief, Climate],
            Self::Blueprint => &[Relief, Woods, Legend, NorthArrow, Neatline],
            Self::Dark => &[Woods, Hills],
        }
    }

    /// Returns `true` if it shows a part of the map.
    pub(crate) const fn shows(self, part: Shown) -> bool {
        let mut shown = self.shown();
        while let [first, rest @ ..] = shown {
            if *first as u8 == part as u8 {
                return true;
            }
            shown = rest;
        }
        false
    }

    /// Returns `true` if it shows how high the land is.
    pub fn has_relief(self) -> bool {
        self.shows(Shown::Relief)
    }

    /// Returns `true` if its colours change with the climate.
    pub fn has_climate(self) -> bool {
        self.shows(Shown::Climate)
    }

    /// Returns `true` if woods can be drawn in it.
    pub fn has_woods(self) -> bool {
        self.shows(Shown::Woods)
    }

    /// Returns `true` if hills can be drawn in it.
    pub fn has_hills(self) -> bool {
        self.shows(Shown::Hills)
    }

    /// Returns `true` if it has labels that are no names: spot heights and grid letters, a legend, or a seal.
    pub fn has_marks(self) -> bool {
        self.shown().iter().any(|part| matches!(part, Shown::SpotHeights | Shown::Legend | Shown::Seal))
    }

    /// Returns `true` if it shows the beds in which great rivers ran before.
    pub fn has_beds(self) -> bool {
        self.shows(Shown::Beds)
    }
}

/// The end of the help of `style`.
pub(super) static RELIEF: Written =
    and_styles(Written::new().and("All but "), Shown::Relief, false).and(" show relief, once the rivers are finished.");

/// The end of the help of climate.
pub(super) static CLIMATE: Written =
    and_styles(Written::new().and("Colours follow it in the styles "), Shown::Climate, true).and(".");

/// The end of the help of `labels`.
pub(super) static MARKS: Written = {
    let heights =
        and_styles(Written::new().and("Labels include spot heights and a grid in "), Shown::SpotHeights, true);
    let legend = and_styles(heights.and(", a legend in "), Shown::Legend, true);
    and_styles(legend.and(" and a seal in "), Shown::Seal, true).and(".")
};

/// The end of the help of `hills`.
pub(super) static HILLS: Written = and_styles(Written::new().and("Shown in the styles "), Shown::Hills, true).and(".");

/// Appends the words of all styles that show a part of the map, or of all that do not.
const fn and_styles(mut text: Written, part: Shown, is_shown: bool) -> Written {
    let (mut style, mut found, mut count) = (0, 0, 0);
    while style < Style::ALL.len() {
        count += (Style::ALL[style].shows(part) == is_shown) as usize;
        style += 1;
    }
    style = 0;
    while found < count {
        if Style::ALL[style].shows(part) == is_shown {
            text = text.and_item(found, count, Style::ALL[style].word().name);
            found += 1;
        }
        style += 1;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_names_the_styles_that_show_a_part() {
        for (key, part, is_shown) in
            [(Key::Style, Shown::Relief, false), (Key::Labels, Shown::Seal, true), (Key::Hills, Shown::Hills, true)]
        {
            let help = key.parameter().help;
            for style in Style::ALL.iter().filter(|style| style.shows(part) == is_shown) {
                assert!(help.contains(style.word().name), "{help}: {style:?}");
            }
        }
        let hills = "Shown in the styles parchment, ink-wash, basins, past-courses, ink and dark.";
        assert!(Key::Hills.parameter().help.ends_with(hills));
    }
}
