//! The parameters whose values are words. Each is declared once: a type, and the words, labels and help texts of its
//! values.

use super::key::Key;
use super::texts::explained;

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

/// Declares types of choices: for each its parameter, its default, and its values with help text, word and label.
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
            const WORDS: &'static [Word] = &[$({
                let word = Self::$Value.word();
                Word { name: word.name, label: explained(word.label), help: explained(word.help) }
            }),+];
        }

        impl $Choice {
            /// Returns the word, label and help text of a value.
            pub const fn word(self) -> Word {
                match self {
                    $(Self::$Value => Word { name: $name, label: $label, help: concat!($($help),+).trim_ascii() },)+
                }
            }
        }
    )+};
}

pub(super) use choices;

choices! {
    /// A shape of land.
    LandKind of Land, Island {
        /// One land mass, sea all around.
        Island = "island", "an island";
        /// A coast along the chosen sides.
        Continent = "continent", "a coast";
        /// Many islands.
        Archipelago = "archipelago", "an archipelago";
        /// An island that bends around a bay.
        Crescent = "crescent", "a crescent";
        /// Two islands on either side of a strait.
        Twins = "twins", "twin islands";
        /// One island, long and narrow.
        Long = "long", "a long island";
        /// An island whose three or four arms reach out from its middle.
        Arms = "arms", "an island with arms";
        /// A coast along the chosen sides, and two ridges that run inland from it.
        Valley = "valley", "a valley between ridges";
        /// A lake in the middle: rivers run inward.
        Basin = "basin", "around a lake";
        /// Land all around an inland sea, which a strait joins to the ocean beyond the map.
        Gulf = "gulf", "around a gulf";
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

    /// What land consists of.
    GroundKind of Ground, Soil {
        /// Soil, green or brown as the climate has it.
        Soil = "soil", "soil";
        /// Dark volcanic rock, on which little grows.
        Lava = "lava", "lava";
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
        /// The title with a scale bar in a frame, on a sheet with a neat line.
        Framed = "framed", "framed";
        /// A plate of the longest rivers side by side, with the title as its heading.
        Lengths = "lengths", "lengths of rivers";
        /// A plate with the long profile of the greatest river.
        Profile = "profile", "long profile";
    }
}

impl LandKind {
    /// Returns `true` if the sea lies all around land of a figure that it always has.
    pub(crate) fn is_figure(self) -> bool {
        matches!(self, Self::Crescent | Self::Twins | Self::Long | Self::Arms)
    }

    /// Returns `true` if land lies all around the water in the middle of the map.
    pub(crate) fn holds_water(self) -> bool {
        matches!(self, Self::Basin | Self::Gulf)
    }

    /// Returns the share of the map that is water unless a recipe asks for another; 0 where the sea is drawn or there
    /// is none. Much water lets an island have lively coasts and lie free of the frame.
    pub fn usual_sea(self) -> f32 {
        match self {
            Self::Island => 0.72,
            Self::Archipelago => 0.78,
            Self::Crescent | Self::Arms => 0.76,
            Self::Twins => 0.7,
            Self::Long => 0.8,
            Self::Continent => 0.35,
            Self::Valley => 0.15,
            Self::Basin => 0.18,
            Self::Gulf => 0.24,
            Self::Rectangle | Self::Drawn => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::table::TABLE;
    use crate::recipe::{Kind, Parameter, Style, Value, link};

    /// Checks one choice, and returns the parameter that it belongs to.
    fn check<C: Choice + std::fmt::Debug>() -> Key {
        let row = C::KEY.parameter();
        assert_eq!(row.kind, Kind::Choice { choices: C::WORDS, default: C::DEFAULT });
        assert_eq!(*link::read("country=usual").unwrap().value(C::KEY), Value::Choice(C::DEFAULT));
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
            check::<GroundKind>(),
            check::<Labels>(),
            check::<Cartouche>(),
            check::<Style>(),
        ];
        // Countries are rows of a table.
        let is_choice = |row: &&Parameter| matches!(row.kind, Kind::Choice { .. }) && row.key != Key::Country;
        let choices = TABLE.iter().filter(is_choice);
        for row in choices {
            assert!(checked.contains(&row.key), "'{}' is a choice that this test does not check", row.name);
        }
    }
}
