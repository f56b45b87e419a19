//! Who gives names.

use glam::Vec2;

use super::heads::Heads;
use super::kinds::{self, Size};
use super::language::Language;
use super::{Names, PlaceKind, PlaceName, ReachName, RiverName, reaches, regions, word};
use crate::base::sort;
use crate::land::{Land, Region};
use crate::map::Map;
use crate::network::{Network, Reach};
use crate::recipe::{IntegerKey, Mark, OwnNames, Recipe};
use crate::tree::Tree;

impl Names {
    /// Names the rivers of a map, and what lies around them.
    pub fn of(map: &Map) -> Self {
        Self::with_regions(map).0
    }

    /// The same, with the region of each place.
    pub(crate) fn with_regions(map: &Map) -> (Self, Vec<Region>) {
        let (network, all_reaches) = (map.network(), map.reaches());
        let namer = Namer::new(map.recipe());
        let rivers = namer.rivers(network, map.tree(), map.grown().total_discharge);
        let water =
            |reach: &Reach| network.rivers.get(reach.river as usize).map_or(0, |river| network.discharge(river));
        let order = sort::argsort(all_reaches.iter().map(|reach| u32::MAX - water(reach)));
        let course = |i: usize| Some((all_reaches[i].river, reaches::course(network, &all_reaches[i])?));
        let reaches = namer.reaches(order.into_iter().filter_map(course).collect(), &rivers);
        let places = map.land().map_or(Vec::new(), |land| namer.places(land));
        let (places, regions) = places.into_iter().unzip();
        (Self { rivers, reaches, places, title: namer.title(), subtitle: String::new() }, regions)
    }

    /// What each name of a network's map is known by, and the name: rivers, the greatest first, then their reaches, seas, lakes and islands,
    /// and the map.
    pub fn marked(&self, network: &Network) -> Vec<(Mark, &str)> {
        let by_discharge = sort::argsort(network.rivers.iter().map(|river| u32::MAX - network.discharge(river)));
        let river = |i: usize| self.rivers.get(i).map(|river| (Mark::River(river.identity), river.name.as_str()));
        let reaches = self.reaches.iter().map(|reach| (Mark::Reach(reach.identity), reach.name.as_str()));
        let places = self.places.iter().filter_map(|place| {
            let mark = match place.kind {
                PlaceKind::Sea => Mark::Sea(place.number),
                PlaceKind::Lake => Mark::Lake(place.number),
                PlaceKind::Island => Mark::Island(place.number),
                _ => return None,
            };
            Some((mark, place.name.as_str()))
        });
        let title = [(Mark::Title, self.title.as_str())];
        by_discharge.into_iter().filter_map(river).chain(reaches).chain(places).chain(title).collect()
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
        recipe.own_names().marks().filter(|mark| !is_used(mark)).collect()
    }
}

/// The language and the names of one's own by which names are given.
struct Namer {
    language: Language,
    own: OwnNames,
}

impl Namer {
    fn new(recipe: &Recipe) -> Self {
        let language = Language::new(recipe.seed(), recipe.integer(IntegerKey::Language));
        Self { language, own: recipe.own_names() }
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
            return RiverName { identity, name: String::new(), short: String::new(), kind: String::new() };
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
        let kind = kind.into();
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

    fn places(&self, land: &Land) -> Vec<(PlaceName, Region)> {
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
                _ => self.name(Mark::Island(number), || kinds::island(&word(), area)),
            };
            (area >= least).then(|| {
                (
                    PlaceName { kind, number, name, at: tract.midst(land), line: Vec::new(), size: area.sqrt() },
                    tract.region,
                )
            })
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
