//! The dealing of words by chance: a thing draws the number of a word by the place where it lies, and no two things draw the same.

use std::collections::BTreeSet;

use super::anchors::Anchor;
use crate::base::random::ItemHash;

/// The numbers of words that have been drawn.
pub(super) struct Deal {
    chance: ItemHash,
    drawn: BTreeSet<u64>,
}

/// The most often that a thing draws before it gets a number of its own.
const TRIES: u32 = 12;

/// The first number that places draw: words below it are for the country. And the number of those that they draw from, most of which have
/// two syllables.
const FIRST: u64 = 8;
const PLACES: u64 = 512;

/// The numbers of short words of rivers and of all from which they draw, and the share of rivers, in sixteenths, that draw short ones.
const SHORT: u64 = 3000;
const ALL: u64 = 1 << 17;
const SHORT_SIXTEENTHS: u32 = 7;

/// The items of the chances of draws.
const DRAW: u32 = 1 << 20;

impl Deal {
    /// The number of the word for a country whose seed is no name.
    pub const COUNTRY: u64 = 3;

    pub fn new(chance: ItemHash) -> Self {
        Self { chance, drawn: BTreeSet::new() }
    }

    /// Draws the number of a word for the place with an anchor.
    pub fn place(&mut self, [anchor, kind]: Anchor) -> u64 {
        let draw = |bits| FIRST + u64::from(bits) % PLACES;
        self.draw([anchor, kind], draw, FIRST + PLACES + (u64::from(anchor) << 3 | u64::from(kind)))
    }

    /// Draws the number of a word for the river with a number.
    pub fn river(&mut self, number: u32) -> u64 {
        let draw = |bits: u32| {
            let rest = u64::from(bits >> 4);
            if bits % 16 < SHORT_SIXTEENTHS { rest % SHORT } else { SHORT + rest % (ALL - SHORT) }
        };
        self.draw([number, u32::MAX], draw, Self::own_of_river(number))
    }

    /// Returns the number that a river which draws none has.
    pub fn own_of_river(number: u32) -> u64 {
        ALL + u64::from(number)
    }

    fn draw(&mut self, [item, kind]: [u32; 2], number: impl Fn(u32) -> u64, last: u64) -> u64 {
        let chance = self.chance;
        let mut tries = (0..TRIES).map(|attempt| number(chance.bits([item, kind, DRAW + attempt])));
        tries.find(|&number| self.drawn.insert(number)).unwrap_or(last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::{Purpose, Seed};

    fn deal() -> Deal {
        Deal::new(Seed::from_text("kauri").item_hash(Purpose::Names))
    }

    #[test]
    fn no_two_things_draw_the_same_number() {
        let mut all: Vec<u64> = {
            let mut deal = deal();
            (0..40_000).map(|number| deal.river(number)).collect()
        };
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), 40_000);
        let mut places = deal();
        let all: BTreeSet<u64> = (0..1200).map(|anchor| places.place([anchor / 8, anchor % 8])).collect();
        assert!(all.len() == 1200 && all.first() >= Some(&FIRST));
    }

    #[test]
    fn what_others_draw_before_seldom_changes_a_number() {
        let (mut alone, mut after) = (deal(), deal());
        (1000..1300).for_each(|number| {
            after.river(number);
        });
        let same = (0..300).filter(|&number| alone.river(number) == after.river(number)).count();
        assert!(same >= 280, "{same}");
    }
}
