//! The naming of a map's rivers, reaches and places.

use glam::Vec2;

use super::heads::Heads;
use super::kinds::{self, Size};
use super::language::Language;
use super::marks::{mark, numbers};
use super::places::{self, Place};
use super::regions::Found;
use super::word::Words;
use super::{Names, PlaceKind, PlaceName, ReachName, RiverName, reaches, title};
use crate::base::sort;
use crate::land::{Land, Region};
use crate::map::Map;
use crate::network::{Network, Reach};
use crate::recipe::{IntegerKey, Mark, OwnNames, Recipe};
use crate::scale::MapScale;

impl Names {
    /// Names the rivers of a map, and what lies around them.
    pub fn of(map: &Map) -> Self {
        Self::with_regions(map).0
    }

    /// Names the rivers of a map and what lies around them. Also returns the region of each place.
    #[doc(hidden)]
    pub fn with_regions(map: &Map) -> (Self, Vec<Region>) {
        let (network, all_reaches) = (map.network(), map.reaches());
        let namer = Namer::new(map.recipe());
        let facts = Rivers { heads: Heads::of(map.tree()), total: map.grown().total_discharge, scale: map.scale() };
        let (rivers, great) = namer.rivers(network, &facts);
        let water =
            |reach: &Reach| network.rivers.get(reach.river as usize).map_or(0, |river| network.discharge(river));
        let order = sort::argsort(all_reaches.iter().map(|reach| u32::MAX - water(reach)));
        let course = |i: usize| Some((all_reaches[i].river, reaches::course(network, &all_reaches[i])?));
        let reaches = namer.reaches(order.into_iter().filter_map(course).collect(), &facts, (&rivers, &great));
        let (places, regions) = map.land().map_or_else(Default::default, |land| namer.places(map, land));
        let title = namer.title();
        let subtitle = title::subtitle(&title, map.recipe().seed());
        (Self { rivers, reaches, places, title, subtitle }, regions)
    }

    /// Lists the names of a network's map, each with its mark: the map, then rivers, the greatest first, their reaches, and places.
    pub fn marked(&self, network: &Network) -> Vec<(Mark, &str)> {
        let by_discharge = sort::argsort(network.rivers.iter().map(|river| u32::MAX - network.discharge(river)));
        let river = |i: usize| self.rivers.get(i).map(|river| (Mark::River(river.identity), river.name.as_str()));
        let reaches = self.reaches.iter().map(|reach| (Mark::Reach(reach.identity), reach.name.as_str()));
        let places = self.places.iter().map(|place| (mark(place.kind, place.number), place.name.as_str()));
        let title = [(Mark::Title, self.title.as_str())];
        title.into_iter().chain(by_discharge.into_iter().filter_map(river)).chain(reaches).chain(places).collect()
    }

    /// Returns the marks of a recipe's own names that name nothing on this map.
    pub fn unused(&self, recipe: &Recipe) -> Vec<Mark> {
        let is_used = |own: &Mark| match *own {
            Mark::River(identity) => self.rivers.iter().any(|river| river.identity == identity),
            Mark::Reach(identity) => self.reaches.iter().any(|reach| reach.identity == identity),
            // The main land gives the map its name, even where it has no coast.
            Mark::Title | Mark::Island(0) => true,
            _ => self.places.iter().any(|place| mark(place.kind, place.number) == *own),
        };
        recipe.own_names().marks().filter(|own| !is_used(own)).collect()
    }
}

/// The words and the own names by which names are given.
struct Namer {
    words: Words,
    own: OwnNames,
    /// The name of the country unless an own name says otherwise: the seed, or a made-up word.
    country: String,
}

impl Namer {
    fn new(recipe: &Recipe) -> Self {
        let language = Language::new(recipe.seed(), recipe.integer(IntegerKey::Language));
        let country = title::country(recipe.seed());
        let words = Words::new(language, country.as_deref().unwrap_or_default());
        let country = country.unwrap_or_else(|| words.place(number_of_word(PlaceKind::Island, 0)));
        Self { words, own: recipe.own_names(), country }
    }

    /// Returns the recipe's own name for something, or another if it has none.
    fn name(&self, mark: Mark, other: impl FnOnce() -> String) -> String {
        self.own.get(mark).map_or_else(other, String::from)
    }

    /// Returns the word by which other things are named after something: its own name without an article, or another if it has none or an
    /// empty one.
    fn name_of_others(&self, mark: Mark, other: impl FnOnce() -> String) -> String {
        let own = self.own.get(mark).filter(|own| !own.is_empty());
        own.map_or_else(other, |own| own.strip_prefix("The ").unwrap_or(own).into())
    }

    fn rivers(&self, network: &Network, facts: &Rivers<'_>) -> (Vec<RiverName>, Vec<(u32, String)>) {
        let great = self.words.great(facts.heads.great(GREAT, facts.total));
        let name = |river: &crate::River| self.river(facts, &great, river.identity);
        let rivers = network.rivers.iter().map(name).collect();
        (rivers, great)
    }

    fn river(&self, facts: &Rivers<'_>, great: &Great, identity: u32) -> RiverName {
        let (heads, manner) = (&facts.heads, self.words.language.manner);
        let Some(node) = heads.node(identity) else {
            return RiverName { identity, name: String::new(), short: String::new(), kind: String::new() };
        };
        let (name, short, kind) = match facts.fork_of(node) {
            Some(parent) => {
                let parent = heads.identity(parent);
                let parent = self.name_of_others(Mark::River(parent), || self.river_word(great, parent));
                let [name, short] = kinds::fork(&parent, heads.side(node), manner);
                (name, short, "Fork")
            }
            None => {
                let (word, size) = (self.river_word(great, identity), facts.size(node));
                (kinds::river(&word, size, manner), word, size.generic(manner))
            }
        };
        let kind = kind.into();
        match self.own.get(Mark::River(identity)) {
            Some(own) => RiverName { identity, name: own.into(), short: own.into(), kind },
            None => RiverName { identity, name, short, kind },
        }
    }

    /// Names reaches, which must come with the most water first.
    fn reaches(
        &self,
        reaches: Vec<(u32, Vec<Vec2>)>,
        facts: &Rivers<'_>,
        (rivers, great): (&[RiverName], &Great),
    ) -> Vec<ReachName> {
        let mut named: Vec<ReachName> = Vec::new();
        for (number, course) in reaches {
            let Some(river) = rivers.get(number as usize) else { continue };
            let bits = self.words.language.chance.bits([river.identity, 0, REACH]);
            let size = facts.heads.node(river.identity).map_or(Size::River, |node| facts.size(node));
            let usual = kinds::reach(bits, size, self.words.language.manner);
            let is_taken = named.iter().any(|reach| reach.name == usual);
            let word = || self.name_of_others(Mark::River(river.identity), || self.river_word(great, river.identity));
            let usual = if is_taken { format!("{} Meanders", word()) } else { usual };
            let name = self.name(Mark::Reach(river.identity), || usual);
            named.push(ReachName { river: number, identity: river.identity, name, course });
        }
        named
    }

    /// Returns the word of a river.
    fn river_word(&self, great: &Great, identity: u32) -> String {
        let great = great.iter().find(|(of, _)| *of == identity);
        great.map_or_else(|| self.words.other(identity.into()), |(_, word)| word.clone())
    }

    /// Returns the map's title: the recipe's own, or the main land's own name, or the country's.
    fn title(&self) -> String {
        let land = self.own.get(Mark::Island(0)).filter(|own| !own.is_empty());
        self.name(Mark::Title, || land.unwrap_or(&self.country).into())
    }

    /// Returns the name of the main land: the recipe's own, or the map's own title, or the country's.
    fn land(&self) -> String {
        let title = self.own.get(Mark::Title).filter(|own| !own.is_empty());
        self.name(Mark::Island(0), || title.unwrap_or(&self.country).into())
    }

    /// Names the places of a map. Returns each with its region, which parts of a coast and ranges do not have.
    fn places(&self, map: &Map, land: &Land) -> (Vec<PlaceName>, Vec<Region>) {
        let places = places::of(map, land);
        let numbers = numbers(&places, &self.own);
        let (mut names, mut regions) = (Vec::new(), Vec::new());
        for (place, number) in places.into_iter().zip(numbers) {
            let kind = place.found.kind;
            let name = if number == 0 { self.land() } else { self.name(mark(kind, number), || self.usual(&place)) };
            let Found { at, line, size, .. } = place.found;
            names.push(PlaceName { kind, number, name, at, line, size });
            regions.push(place.region);
        }
        (names, regions)
    }

    /// Makes up the name of a place, by its kind and rank.
    fn usual(&self, place: &Place) -> String {
        let (kind, rank) = (place.found.kind, place.rank);
        let chance = self.words.language.chance.bits([rank, kind as u32, PLACE]);
        kinds::place(kind, &self.words.place(number_of_word(kind, rank)), place.extent, chance)
    }
}

/// The words of great rivers, each with the river's identity.
type Great = [(u32, String)];

/// Returns the number of a place's word.
fn number_of_word(kind: PlaceKind, rank: u32) -> u64 {
    u64::from(rank) * 8 + kind as u64
}

/// The items of chances of reaches and of places; those of words are above.
const REACH: u32 = 1 << 15;
const PLACE: u32 = REACH + 1;

/// The least thousandths of all water of a great river.
const GREAT: u64 = 20;

/// The facts about a map's rivers that their names rest on.
struct Rivers<'a> {
    heads: Heads<'a>,
    /// The whole discharge.
    total: u32,
    scale: MapScale,
}

impl Rivers<'_> {
    /// Returns the size of a river, by its lowest node.
    fn size(&self, node: usize) -> Size {
        Size::of(self.scale.kilometres(self.heads.length(node)))
    }

    /// Returns the river that a river is a fork of; `None` if it is no fork. A fork brings over a third of the water of the river that it
    /// joins, which is great and no fork itself. No river has two forks: above the one too little is left for another.
    fn fork_of(&self, node: usize) -> Option<usize> {
        let heads = &self.heads;
        let parent = heads.parent(node)?;
        let is_great = || u64::from(heads.discharge(parent)) * 1000 / u64::from(self.total.max(1)) >= GREAT;
        let is_fork = u64::from(heads.discharge(node)) * 100 >= u64::from(heads.discharge(parent)) * 35
            && is_great()
            && self.fork_of(parent).is_none();
        is_fork.then_some(parent)
    }
}
