//! Names of rivers, their meanders, seas, lakes and islands, in a made-up language.
//!
//! A river's name is made of its [identity](crate::River::identity) and the seed alone: it has the same name whatever is trimmed, however
//! it meanders and in whatever style it is drawn. Only that a fork is called after its river, and the second of two reaches with the
//! same word after its own, depends on others.
//!
//! ```text
//! identity ─► number ─► word (language, filter) ─► name (kinds), or one's own
//! ```

mod filter;
mod heads;
mod kinds;
mod language;
mod reaches;
mod regions;
mod word;

use glam::Vec2;

use crate::land::{Land, Region};
use crate::network::Network;
use crate::recipe::{Key, Mark, OwnNames, Recipe};
use crate::session::Session;
use crate::tree::Tree;
use heads::Heads;
use kinds::Size;
use language::Language;

/// The name of a river.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RiverName {
    /// The river's identity.
    pub identity: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// The same without what kind of river it is.
    pub short: String,
    /// What kind of river it is, such as `River`, `Beck` or `Fork`.
    pub kind: &'static str,
}

/// The name of a stretch of a great river that winds.
#[derive(Clone, Debug, PartialEq)]
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
pub struct PlaceName {
    /// What it is.
    pub kind: PlaceKind,
    /// Its number among its kind, the largest first; island 0 is the main land.
    pub number: u32,
    /// Its name; empty if the recipe takes it away.
    pub name: String,
    /// A place in the midst of it.
    pub at: Vec2,
    /// The cells that it has.
    pub(crate) region: Region,
}

/// All names of a map.
#[derive(Clone, Debug, Default, PartialEq)]
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

impl Names {
    /// The names of a session's rivers as they are, and of what lies around them; none while there are no rivers.
    pub fn of(session: &Session) -> Self {
        let Some(network) = session.network() else { return Self::default() };
        let namer = Namer::new(session.recipe());
        let rivers = namer.rivers(network, session.tree(), session.growth().total_discharge());
        let mut reaches: Vec<_> = session
            .reaches()
            .iter()
            .filter_map(|reach| Some((reach.river, reaches::course(network, reach)?)))
            .collect();
        reaches.sort_by_key(|(river, _)| {
            network.rivers.get(*river as usize).map_or(0, |river| u32::MAX - network.discharge(river))
        });
        let reaches = namer.reaches(reaches, &rivers);
        let places = session.land().map_or(Vec::new(), |land| namer.places(land));
        Self { rivers, reaches, places, title: namer.title() }
    }

    /// The names of one's own in a recipe that name nothing on this map.
    pub fn unused(&self, recipe: &Recipe) -> Vec<Mark> {
        let is_place = |kind, number| self.places.iter().any(|place| place.kind == kind && place.number == number);
        let is_used = |mark: &Mark| match *mark {
            Mark::River(identity) => self.rivers.iter().any(|river| river.identity == identity),
            Mark::Reach(identity) => self.reaches.iter().any(|reach| reach.identity == identity),
            Mark::Sea(number) => is_place(PlaceKind::Sea, number),
            Mark::Lake(number) => is_place(PlaceKind::Lake, number),
            // The main land gives the map its name.
            Mark::Island(number) => number == 0 || is_place(PlaceKind::Island, number),
            Mark::Title => true,
        };
        own_names(recipe).marks().filter(|mark| !is_used(mark)).collect()
    }
}

/// The first words of a seed's own language, for those who look at many.
#[doc(hidden)]
pub fn words(seed: &str, count: u64) -> impl Iterator<Item = String> {
    let language = Language::new(seed, 0);
    (0..count).map(move |number| word::word(&language, number))
}

/// The names of one's own in a recipe.
fn own_names(recipe: &Recipe) -> OwnNames {
    let names = recipe.value(Key::Names);
    OwnNames::readable(&Key::Names.parameter().text_of(names))
}

/// Who gives names.
struct Namer {
    language: Language,
    own: OwnNames,
}

impl Namer {
    fn new(recipe: &Recipe) -> Self {
        let language = Language::new(recipe.seed(), recipe.integer(Key::Language));
        Self { language, own: own_names(recipe) }
    }

    /// One's own name for something, or another.
    fn name(&self, mark: Mark, other: impl FnOnce() -> String) -> String {
        self.own.get(mark).map_or_else(other, String::from)
    }

    /// The same for what is named after it, which has a name even if that has none; without an article.
    fn name_of_others(&self, mark: Mark, other: impl FnOnce() -> String) -> String {
        let own = self.own.get(mark).filter(|own| !own.is_empty());
        own.map_or_else(other, |own| own.strip_prefix("The ").unwrap_or(own).into())
    }

    /// The word of a river. Every eighth number is left to what is no river.
    fn river_word(&self, identity: u32) -> String {
        let identity = u64::from(identity);
        word::word(&self.language, identity + identity / 7)
    }

    fn place_word(&self, kind: PlaceKind, number: u32) -> String {
        word::word(&self.language, (u64::from(number) * 3 + kind as u64) * 8 + 7)
    }

    fn rivers(&self, network: &Network, tree: &Tree, total: u32) -> Vec<RiverName> {
        let heads = Heads::of(tree);
        let name = |river: &crate::River| self.river(&heads, river.identity, total);
        network.rivers.iter().map(name).collect()
    }

    fn river(&self, heads: &Heads, identity: u32, total: u32) -> RiverName {
        let manner = self.language.manner;
        let Some(node) = heads.node(identity) else {
            return RiverName { identity, name: String::new(), short: String::new(), kind: "" };
        };
        let (name, short, kind) = match fork_of(heads, node, total) {
            Some(parent) => {
                let parent = heads.identity(parent);
                let parent = self.name_of_others(Mark::River(parent), || self.river_word(parent));
                let [name, short] = kinds::fork(&parent, heads.side(node), manner);
                (name, short, "Fork")
            }
            None => {
                let (word, size) = (self.river_word(identity), Size::of(heads.discharge(node), total));
                (kinds::river(&word, size, manner), word, size.generic(manner))
            }
        };
        match self.own.get(Mark::River(identity)) {
            Some(own) => RiverName { identity, name: own.into(), short: own.into(), kind },
            None => RiverName { identity, name, short, kind },
        }
    }

    /// Of reaches, that with the most water first.
    fn reaches(&self, reaches: Vec<(u32, Vec<Vec2>)>, rivers: &[RiverName]) -> Vec<ReachName> {
        let mut named: Vec<ReachName> = Vec::new();
        for (number, course) in reaches {
            let Some(river) = rivers.get(number as usize) else { continue };
            let bits = self.language.chance.bits([river.identity, 0, REACH]);
            let usual = kinds::reach(bits, self.language.manner);
            let is_taken = named.iter().any(|reach| reach.name == usual);
            let word = || self.name_of_others(Mark::River(river.identity), || self.river_word(river.identity));
            let usual = if is_taken { format!("{} Meanders", word()) } else { usual };
            let name = self.name(Mark::Reach(river.identity), || usual);
            named.push(ReachName { river: number, identity: river.identity, name, course });
        }
        named
    }

    fn places(&self, land: &Land) -> Vec<PlaceName> {
        /// In square units: smaller ones have no names.
        const LEAST_SEA: f32 = 10_000.0;
        const LEAST_LAKE: f32 = 400.0;
        const LEAST_ISLAND: f32 = 150.0;
        let manner = self.language.manner;
        let [seas, lakes, islands] = regions::tracts(land);
        let place = |kind, least: f32, tract: regions::Tract| {
            let (number, area) = (tract.number, tract.area);
            let word = || self.place_word(kind, number);
            let name = match kind {
                PlaceKind::Sea => self.name(Mark::Sea(number), || kinds::sea(&word(), area, manner)),
                PlaceKind::Lake => self.name(Mark::Lake(number), || kinds::lake(&word(), area)),
                PlaceKind::Island => self.name(Mark::Island(number), || kinds::island(&word(), area)),
            };
            (area >= least).then(|| PlaceName { kind, number, name, at: tract.midst(land), region: tract.region })
        };
        let seas = seas.into_iter().filter_map(|tract| place(PlaceKind::Sea, LEAST_SEA, tract));
        let lakes = lakes.into_iter().filter_map(|tract| place(PlaceKind::Lake, LEAST_LAKE, tract));
        // The main land gives the map its name.
        let islands = islands.into_iter().skip(1).filter_map(|tract| place(PlaceKind::Island, LEAST_ISLAND, tract));
        seas.chain(lakes).chain(islands).collect()
    }

    fn title(&self) -> String {
        let land = || self.name_of_others(Mark::Island(0), || self.place_word(PlaceKind::Island, 0));
        self.name(Mark::Title, || kinds::title(&land(), self.language.manner))
    }
}

/// Chances of reaches; those of words are above.
const REACH: u32 = 1 << 15;

/// The river that one is a fork of: it brings over a third of that one's water, and that one is great and no fork itself. No river has two
/// forks: above the one too little is left for another.
fn fork_of(heads: &Heads, node: usize, total: u32) -> Option<usize> {
    let parent = heads.parent(node)?;
    let is_fork = u64::from(heads.discharge(node)) * 100 >= u64::from(heads.discharge(parent)) * 35
        && Size::of(heads.discharge(parent), total) == Size::River
        && fork_of(heads, parent, total).is_none();
    is_fork.then_some(parent)
}
