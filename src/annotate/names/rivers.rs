//! The rivers of a map as names know them: by number, and by the words that chance deals to the numbers. Both rest on the untrimmed tree.

use super::addresses;
use super::deal::Deal;
use super::heads::Heads;
use super::kinds::{self, Size};
use super::word::Words;
use crate::base::random::{Purpose, Seed};
use crate::map::Map;
use crate::recipe::OwnNames;
use crate::scale::MapScale;

/// The least thousandths of all water of a great river.
const GREAT: u64 = 20;

/// The rivers of a map's untrimmed tree, by their lowest nodes.
pub(super) struct Rivers<'a> {
    heads: Heads<'a>,
    total_discharge: u32,
    scale: MapScale,
    /// The lowest nodes, those of the greatest rivers first.
    greatest: Vec<usize>,
    /// The number of each node, of which its word is made.
    addresses: Vec<u32>,
    /// The number of each node by which own names know it: nearly always the same.
    identities: Vec<u32>,
    /// The lowest node of each river on the map; `None` for one that did not grow.
    on_map: Vec<Option<usize>>,
}

impl<'a> Rivers<'a> {
    pub fn of(map: &'a Map, own: &OwnNames) -> Self {
        let heads = Heads::of(map.tree());
        let greatest = heads.rivers();
        let chance = Seed::from_text(map.recipe().seed()).item_hash(Purpose::Names);
        let addresses = addresses::of(&heads, &greatest, chance);
        let on_map: Vec<Option<usize>> = map.network().rivers.iter().map(|river| heads.node(river.identity)).collect();
        let mut identities = addresses.clone();
        let drawn: Vec<usize> = on_map.iter().copied().flatten().collect();
        addresses::follow(own, &heads, &drawn, &mut identities);
        Self {
            heads,
            total_discharge: map.grown().total_discharge,
            scale: map.scale(),
            greatest,
            addresses,
            identities,
            on_map,
        }
    }

    /// Iterates over the lowest nodes of the rivers on the map, in their order.
    pub fn on_map(&self) -> impl Iterator<Item = Option<usize>> {
        self.on_map.iter().copied()
    }

    /// Returns the number by which own names know a river.
    pub fn identity(&self, river: usize) -> u32 {
        self.identities[river]
    }

    /// Returns the number of which a river's word is made.
    pub fn address(&self, river: usize) -> u32 {
        self.addresses[river]
    }

    /// Returns a river's size by its length.
    pub fn size(&self, river: usize) -> Size {
        Size::of(self.scale.kilometres(self.heads.length(river)))
    }

    /// Returns the thousandths of all water that a river drains.
    fn thousandths(&self, river: usize) -> u64 {
        u64::from(self.heads.discharge(river)) * 1000 / u64::from(self.total_discharge.max(1))
    }

    /// Returns the river that a river is a fork of; `None` if it is no fork. A fork brings over a third of the water of the river that it
    /// joins, which is great and no fork itself. No river has two forks: above the one too little is left for another.
    pub fn fork_of(&self, river: usize) -> Option<usize> {
        let parent = self.heads.parent(river)?;
        let [own, all] = [river, parent].map(|river| u64::from(self.heads.discharge(river)));
        let is_fork = own * 100 >= all * 35 && self.thousandths(parent) >= GREAT && self.fork_of(parent).is_none();
        is_fork.then_some(parent)
    }

    /// Forms the name of a fork of a river with a name, and its short form.
    pub fn fork(&self, river: usize, parent: &str, manner: u32) -> [String; 2] {
        kinds::fork(parent, self.heads.side(river), manner)
    }

    /// Chooses the words of all rivers.
    pub fn words(&self, words: &Words) -> RiverWords {
        let mut deal = Deal::new(words.language.chance);
        let mut numbers: Vec<u64> = self.addresses.iter().map(|&address| Deal::own_of_river(address)).collect();
        for &river in &self.greatest {
            numbers[river] = deal.river(self.addresses[river]);
        }
        let great = self.greatest.iter().map(|&river| (river, self.thousandths(river)));
        let great = great.take_while(|(_, thousandths)| *thousandths >= GREAT);
        let great = words.great(great.map(|(river, thousandths)| (self.addresses[river], thousandths)).collect());
        RiverWords { great, numbers }
    }
}

/// The words of rivers.
pub(super) struct RiverWords {
    /// Those of great rivers, by the number that they are made of.
    great: Vec<(u32, String)>,
    /// The number of the word of each other river, by its lowest node.
    numbers: Vec<u64>,
}

impl RiverWords {
    /// Returns the word of a river.
    pub fn of(&self, river: usize, rivers: &Rivers, words: &Words) -> String {
        let great = self.great.iter().find(|(of, _)| *of == rivers.address(river));
        great.map_or_else(|| words.other(self.numbers[river]), |(_, word)| word.clone())
    }
}
