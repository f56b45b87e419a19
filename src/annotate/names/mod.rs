//! Names of rivers, their meanders, seas, lakes and islands, in a made-up language.
//!
//! A river's name is made of its [identity](crate::River::identity) and the seed alone: it has the same name whatever is trimmed, however
//! it meanders and in whatever style it is drawn. Only that a fork is called after its river, and the second of two reaches with the
//! same word after its own, depends on others.
//!
//! ```text
//! identity ─► number ─► word (language, filter) ─► name (kinds), or one's own
//! ```

#[cfg(feature = "names")]
mod filter;
#[cfg(feature = "names")]
mod heads;
#[cfg(feature = "names")]
mod kinds;
#[cfg(feature = "names")]
mod language;
#[cfg(feature = "names")]
mod namer;
#[cfg(feature = "names")]
mod reaches;
#[cfg(feature = "names")]
mod regions;
#[cfg(feature = "names")]
mod word;

use glam::Vec2;

/// The name of a river.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RiverName {
    /// The river's identity.
    pub identity: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// The same without what kind of river it is.
    pub short: String,
    /// What kind of river it is, such as `River`, `Beck` or `Fork`.
    pub kind: String,
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

/// What else has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlaceKind {
    /// Water that reaches the frame of the map.
    Sea,
    /// Water that does not.
    Lake,
    /// Land with water around it, but for the main land.
    Island,
}

impl PlaceKind {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Sea => "sea",
            Self::Lake => "lake",
            Self::Island => "island",
        }
    }
}

/// The name of a sea, a lake or an island.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlaceName {
    /// What it is.
    pub kind: PlaceKind,
    /// Its number among its kind, the largest first; island 0 is the main land.
    pub number: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// A place in the midst of it.
    pub at: Vec2,
}

/// All names of a map.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Names {
    /// Of the rivers, in their order.
    pub rivers: Vec<RiverName>,
    /// Of their reaches, that with the most water first.
    pub reaches: Vec<ReachName>,
    /// Of seas, lakes and islands, by kind, the largest first.
    pub places: Vec<PlaceName>,
    /// Of the map.
    pub title: String,
}
