//! Names of rivers, their meanders, seas, lands and parts of their coasts, in a made-up language; and the country's, which is the seed.
//!
//! Names are dealt by place, so that a thing which stays where it is keeps its name when the sea, the coast or its rank among its kind
//! changes a little: a river's comes from a square through which it runs, that of any other thing from an anchor in the plane near it. A
//! river's rests on the untrimmed tree alone: it has the same name whatever is trimmed, however it meanders and in whatever style it is
//! drawn. Few names depend on others: a fork is called after its river; the second of two reaches with the same name is called after its
//! own river; and of two things that draw one word or one place the smaller takes another.
//!
//! ```text
//! square (addresses) or anchor ─► number (deal) ─► word (language, filter) ─► name (kinds), or one's own
//! ```

mod addresses;
mod anchors;
mod crests;
mod deal;
mod filter;
mod heads;
mod kinds;
mod language;
mod lattice;
mod marks;
mod namer;
mod places;
mod ranges;
mod reaches;
mod regions;
mod rivers;
mod shores;
mod sounds;
mod squares;
mod syllables;
mod title;
mod word;

use glam::Vec2;

pub(crate) use title::on_map;

/// The name of a river.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RiverName {
    /// The number by which own names know it: that of a square through which it runs, or of an own name that was for it.
    pub identity: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// The name without the word for its kind.
    pub short: String,
    /// The word for its kind, such as `River`, `Beck` or `Fork`.
    pub kind: String,
}

impl RiverName {
    /// Returns its name, in full and in short.
    pub(crate) fn forms(&self) -> [&str; 2] {
        [&self.name, &self.short]
    }
}

/// The name of a stretch of a great river that winds.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReachName {
    /// The number of its river in the network.
    pub river: u32,
    /// The river's identity.
    pub identity: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// Its course.
    pub course: Vec<Vec2>,
}

/// A kind of place that has a name and is no river.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlaceKind {
    /// Water that reaches the frame of the map.
    Sea,
    /// A part of the sea with land on three sides, larger than a bay.
    Gulf,
    /// Water that does not reach the frame.
    Lake,
    /// Land with water around it; number 0 is the main land.
    Island,
    /// A small part of the sea with land on three sides.
    Bay,
    /// A point of land that juts out into the sea.
    Cape,
    /// Narrow water between two lands.
    Strait,
    /// A chain of mountains or hills.
    Range,
}

impl PlaceKind {
    /// Returns the kind's word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Sea => "sea",
            Self::Gulf => "gulf",
            Self::Lake => "lake",
            Self::Island => "island",
            Self::Bay => "bay",
            Self::Cape => "cape",
            Self::Strait => "strait",
            Self::Range => "range",
        }
    }
}

/// The name of a sea, a land, or a part of one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlaceName {
    /// The kind of place.
    pub kind: PlaceKind,
    /// The number in its mark; island 0 is the main land.
    pub number: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// A place in the midst of it, in units.
    pub at: Vec2,
    /// The line along which its name may run, in units: the course of a strait, the crest of a range, the axis of the main land from west
    /// to east. Empty for other places.
    pub line: Vec<Vec2>,
    /// Its size, in units: the width of the mouth of a bay or gulf, the length of a strait or range, the distance by which a cape juts out;
    /// for a sea, lake or island the side of a square of its area.
    pub size: f32,
}

impl PlaceName {
    /// Returns `true` if it names the main land.
    pub(crate) fn is_of_main_land(&self) -> bool {
        self.kind == PlaceKind::Island && self.number == 0
    }
}

/// Returns a name in full, and without its article.
pub(crate) fn forms(name: &str) -> [&str; 2] {
    [name, name.strip_prefix("The ").unwrap_or(name)]
}

/// All names of a map.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Names {
    /// The names of the rivers, in their order.
    pub rivers: Vec<RiverName>,
    /// The names of their reaches, the one with the most water first.
    pub reaches: Vec<ReachName>,
    /// The names of places, by kind, the largest of each first.
    pub places: Vec<PlaceName>,
    /// The name of the map.
    pub title: String,
    /// The finished line under the title, such as `from the word tay2`; empty if there is none.
    pub subtitle: String,
}
