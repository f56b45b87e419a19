//! The parameters whose values are words. Each is declared once: a type, and the words, labels and help texts of its
//! values.

use super::key::Key;

/// A value of a parameter that is a choice among words.
pub trait Choice: Copy + PartialEq + 'static {
    /// The parameter.
    const KEY: Key;
    /// The word of the value when nothing is given.
    const DEFAULT: &'static str;
    /// All values, in the order in which people are offered them.
    const ALL: &'static [Self];
    /// The words of all values, in the same order.
    const WORDS: &'static [Word];
}

/// The word of a choice, with its label and help text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Word {
    /// The word in links, attributes, options and JSON.
    pub name: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// One line of explanation.
    pub help: &'static str,
}

impl Word {
    /// Empties label and help text unless the feature `texts` is on.
    const fn explained(self) -> Self {
        if cfg!(feature = "texts") { self } else { Self { label: "", help: "", ..self } }
    }
}

macro_rules! choices {
    ($(
        $(#[$attribute:meta])*
        $Choice:ident of $key:ident, $default:ident { $($(#[doc = $help:literal])+ $Value:ident = $name:literal, $label:literal;)+ }
    )+) => {$(
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $Choice {
            $($(#[doc = $help])+ $Value,)+
        }

        impl Choice for $Choice {
            const KEY: Key = Key::$key;
            const DEFAULT: &'static str = Self::$default.word().name;
            const ALL: &'static [Self] = &[$(Self::$Value),+];
            const WORDS: &'static [Word] = &[$(Self::$Value.word().explained()),+];
        }

        impl $Choice {
            /// Its word, label and help text.
            pub const fn word(self) -> Word {
                match self {
                    $(Self::$Value => Word { name: $name, label: $label, help: concat!($($help),+).trim_ascii() },)+
                }
            }
        }
    )+};
}

choices! {
    /// A shape of land.
    LandKind of Land, Island {
        /// One land mass, sea all around.
        Island = "island", "an island";
        /// A coast along the chosen sides.
        Continent = "continent", "a coast";
        /// Many islands.
        Archipelago = "archipelago", "an archipelago";
        /// A coast along the chosen sides, and two ridges that run inland from it.
        Valley = "valley", "a valley between ridges";
        /// A lake in the middle: rivers run inward.
        Basin = "basin", "around a lake";
        /// The whole domain, with the sea beyond its sides.
        Rectangle = "rectangle", "the whole rectangle";
        /// A hand-drawn land: the recipe's outline.
        Drawn = "drawn", "drawn by hand";
    }

    /// A method of growing a tree of rivers.
    GrowthMethod of Growth, Drainage {
        /// Drainage: water takes the cheapest way, and the more there is of it, the less it costs.
        Drainage = "drainage", "drainage";
        /// Space colonization: attractors draw rivers on.
        Colonize = "colonize", "space colonization";
        /// A Brownian tree of wandering particles, coarse to fine.
        Brownian = "brownian", "Brownian tree";
    }

    /// A pattern of drainage, as geologists name them (Twidale 2004).
    Pattern of Pattern, Dendritic {
        /// Like a tree, in country without a grain.
        Dendritic = "dendritic", "dendritic";
        /// Side by side down an even slope.
        Parallel = "parallel", "parallel";
        /// Along soft beds between ridges, with short tributaries at right angles.
        Trellis = "trellis", "trellis";
        /// Along joints that cross at right angles.
        Rectangular = "rectangular", "rectangular";
        /// Away from a high place.
        Radial = "radial", "radial";
        /// In arcs around a dome.
        Annular = "annular", "annular";
        /// Toward a low place.
        Centripetal = "centripetal", "centripetal";
        /// Without order, as on young ground.
        Deranged = "deranged", "deranged";
    }

    /// A way of placing attractors.
    Scatter of Scatter, Random {
        /// At random.
        Random = "random", "at random";
        /// One somewhere in each cell of a grid: an even network.
        Grid = "grid", "on a jittered grid";
    }

    /// The lines that rivers follow.
    CourseShape of Courses, Smooth {
        /// Simplified and smooth.
        Smooth = "smooth", "smooth";
        /// As the tree has grown, step by step.
        Grown = "grown", "as grown";
    }

    /// A model of meandering.
    MeanderModel of Meander, Bend {
        /// Each bend moves outward and downstream by its own curvature (Hodgin, Dragons Abound).
        Bend = "bend", "bends grow outward";
        /// Each bend also moves by the curvature upstream (Howard and Knutson 1984): bends skew and travel.
        Flow = "flow", "bends skew and travel";
        /// Not at all.
        None = "none", "none";
    }

    /// The amount of names on a map.
    Labels of Labels, Some {
        /// No names.
        None = "none", "none";
        /// Names on a fiftieth of the land.
        Few = "few", "few";
        /// Names on a twentieth of it.
        Some = "some", "some";
        /// Names on a tenth of it.
        Many = "many", "many";
    }

    /// The form of a map's title, and what stands with it.
    Cartouche of Cartouche, Auto {
        /// The title with a scale bar, on maps with names.
        Auto = "auto", "with names";
        /// No title.
        None = "none", "none";
        /// The title with a scale bar, with names or without.
        Plain = "plain", "plain";
        /// The same in a frame, on a sheet with a neat line.
        Framed = "framed", "framed";
        /// A plate of the longest rivers side by side, with the title as its heading.
        Lengths = "lengths", "lengths of rivers";
        /// A plate with the long profile of the greatest river.
        Profile = "profile", "long profile";
    }

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
    /// How high the land is.
    Relief,
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

impl LandKind {
    /// The share of the map that is water unless a recipe asks for another; 0 where the sea is drawn or there is none.
    /// Much water lets an island have lively coasts and lie free of the frame.
    pub fn usual_sea(self) -> f32 {
        match self {
            Self::Island => 0.72,
            Self::Archipelago => 0.78,
            Self::Continent => 0.35,
            Self::Valley => 0.15,
            Self::Basin => 0.18,
            Self::Rectangle | Self::Drawn => 0.0,
        }
    }
}

impl Style {
    /// The row of a style in the table of what styles show.
    const fn shown(self) -> &'static [Shown] {
        use Shown::{Beds, CompassRose, Hills, Legend, Neatline, NorthArrow, Relief, Seal, SpotHeights, Woods};
        match self {
            Self::Ink => &[Woods, Hills],
            Self::Skeleton => &[],
            Self::Atlas => &[Relief, Woods, Neatline],
            Self::Night => &[Relief, Woods, Neatline],
            Self::Survey => &[Relief, Woods, SpotHeights, NorthArrow, Neatline],
            Self::Basins => &[Relief, Woods, Hills, Neatline],
            Self::Parchment => &[Relief, Woods, Hills, CompassRose, Neatline],
            Self::PastCourses => &[Woods, Hills, Beds, NorthArrow],
            Self::InkWash => &[Relief, Woods, Hills, Seal, Neatline],
            Self::Orbit => &[Relief],
            Self::Blueprint => &[Relief, Woods, Legend, NorthArrow, Neatline],
            Self::Dark => &[Woods, Hills],
        }
    }

    /// Returns `true` if it shows a part of the map.
    pub(crate) fn shows(self, part: Shown) -> bool {
        self.shown().contains(&part)
    }

    /// Returns `true` if it shows how high the land is.
    pub fn has_relief(self) -> bool {
        self.shows(Shown::Relief)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::table::TABLE;
    use crate::recipe::{Kind, Recipe, Value, link};

    /// Checks one choice, and returns the parameter that it belongs to.
    fn check<C: Choice + std::fmt::Debug>() -> Key {
        let row = C::KEY.parameter();
        assert_eq!(row.kind, Kind::Choice { choices: C::WORDS, default: C::DEFAULT });
        assert_eq!(*Recipe::default().value(C::KEY), Value::Choice(C::DEFAULT));
        assert_eq!(C::ALL.len(), C::WORDS.len());
        for (&choice, word) in C::ALL.iter().zip(C::WORDS) {
            assert_eq!(link::read(&format!("{}={}", row.name, word.name)).unwrap().get::<C>(), choice);
            assert!(word.help.ends_with('.'), "{}", word.name);
        }
        C::KEY
    }

    #[test]
    fn each_word_of_every_choice_is_read_as_its_value() {
        let checked = [
            check::<LandKind>(),
            check::<GrowthMethod>(),
            check::<Pattern>(),
            check::<Scatter>(),
            check::<CourseShape>(),
            check::<MeanderModel>(),
            check::<Labels>(),
            check::<Cartouche>(),
            check::<Style>(),
        ];
        let choices = TABLE.iter().filter(|row| matches!(row.kind, Kind::Choice { .. }));
        for row in choices {
            assert!(checked.contains(&row.key), "'{}' is a choice that this test does not check", row.name);
        }
    }
}
