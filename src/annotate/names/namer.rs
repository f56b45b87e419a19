//! The naming of a map's rivers, reaches and places.

use glam::Vec2;

use super::anchors::{self, Anchor};
use super::deal::Deal;
use super::kinds;
use super::language::Language;
use super::marks::{mark, numbers};
use super::places::{self, Place};
use super::regions::Found;
use super::rivers::{RiverWords, Rivers};
use super::word::Words;
use super::{Names, PlaceName, ReachName, RiverName, reaches, title};
use crate::base::sort;
use crate::land::{Land, Region};
use crate::map::Map;
use crate::network::{Network, Reach};
use crate::recipe::{IntegerKey, Mark, OwnNames, Recipe};

impl Names {
    /// Names the rivers of a map, and what lies around them.
    pub fn of(map: &Map) -> Self {
        Self::with_regions(map).0
    }

    /// Returns the identities of a map's rivers, in their order, without naming anything.
    #[doc(hidden)]
    pub fn identities(map: &Map) -> Vec<u32> {
        let rivers = Rivers::of(map, &map.recipe().own_names());
        rivers.on_map().map(|river| river.map_or(0, |river| rivers.identity(river))).collect()
    }

    /// Names the rivers of a map and what lies around them. Also returns the region of each place.
    #[doc(hidden)]
    pub fn with_regions(map: &Map) -> (Self, Vec<Region>) {
        let (network, all_reaches) = (map.network(), map.reaches());
        let namer = Namer::new(map.recipe());
        let known = Rivers::of(map, &namer.own);
        let words = known.words(&namer.words);
        let rivers = known.on_map().map(|river| namer.river(river, &known, &words)).collect();
        let water =
            |reach: &Reach| network.rivers.get(reach.river as usize).map_or(0, |river| network.discharge(river));
        let order = sort::argsort(all_reaches.iter().map(|reach| u32::MAX - water(reach)));
        let course = |i: usize| Some((all_reaches[i].river, reaches::course(network, &all_reaches[i])?));
        let reaches = namer.reaches(order.into_iter().filter_map(course).collect(), &known, &words);
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
        let country = country.unwrap_or_else(|| words.place(Deal::COUNTRY));
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

    /// Names a river; one that did not grow has no name.
    fn river(&self, river: Option<usize>, rivers: &Rivers, words: &RiverWords) -> RiverName {
        let manner = self.words.language.manner;
        let Some(river) = river else {
            return RiverName { identity: 0, name: String::new(), short: String::new(), kind: String::new() };
        };
        let (name, short, kind) = match rivers.fork_of(river) {
            Some(parent) => {
                let parent = self.word_of(parent, rivers, words);
                let [name, short] = rivers.fork(river, &parent, manner);
                (name, short, "Fork")
            }
            None => {
                let (word, size) = (words.of(river, rivers, &self.words), rivers.size(river));
                (kinds::river(&word, size, manner), word, size.generic(manner))
            }
        };
        let (identity, kind) = (rivers.identity(river), kind.into());
        match self.own.get(Mark::River(identity)) {
            Some(own) => RiverName { identity, name: own.into(), short: own.into(), kind },
            None => RiverName { identity, name, short, kind },
        }
    }

    /// Returns the word by which other things are named after a river.
    fn word_of(&self, river: usize, rivers: &Rivers, words: &RiverWords) -> String {
        self.name_of_others(Mark::River(rivers.identity(river)), || words.of(river, rivers, &self.words))
    }

    /// Names reaches, which must come with the most water first. No two share the word for what winds.
    fn reaches(&self, reaches: Vec<(u32, Vec<Vec2>)>, rivers: &Rivers, words: &RiverWords) -> Vec<ReachName> {
        let on_map: Vec<Option<usize>> = rivers.on_map().collect();
        let (mut named, mut taken): (Vec<ReachName>, Vec<&str>) = Default::default();
        for (number, course) in reaches {
            let Some(river) = on_map.get(number as usize).copied().flatten() else { continue };
            let bits = self.words.language.chance.bits([rivers.address(river), 0, REACH]);
            let (winding, usual) = kinds::reach(bits, rivers.size(river), self.words.language.manner);
            let is_taken = taken.contains(&winding) || named.iter().any(|reach| reach.name == usual);
            let usual = if is_taken { format!("{} Meanders", self.word_of(river, rivers, words)) } else { usual };
            taken.push(winding);
            let identity = rivers.identity(river);
            let name = self.name(Mark::Reach(identity), || usual);
            named.push(ReachName { river: number, identity, name, course });
        }
        named
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
        let chance = self.words.language.chance;
        let anchors = anchors::of(&places, chance);
        let mut deal = Deal::new(chance);
        let (mut names, mut regions) = (Vec::new(), Vec::new());
        for ((place, number), anchor) in places.into_iter().zip(numbers).zip(anchors) {
            let kind = place.found.kind;
            let usual = self.usual(&place, anchor, deal.place(anchor));
            let name = if number == 0 { self.land() } else { self.name(mark(kind, number), || usual) };
            let Found { at, line, size, .. } = place.found;
            names.push(PlaceName { kind, number, name, at, line, size });
            regions.push(place.region);
        }
        (names, regions)
    }

    /// Makes up the name of a place with an anchor and the number of a word.
    fn usual(&self, place: &Place, [anchor, of]: Anchor, word: u64) -> String {
        let chance = self.words.language.chance.bits([anchor, of, PLACE]);
        kinds::place(place.found.kind, &self.words.place(word), place.extent, chance)
    }
}

/// The items of chances of reaches and of places; those of words are above.
const REACH: u32 = 1 << 15;
const PLACE: u32 = REACH + 1;
