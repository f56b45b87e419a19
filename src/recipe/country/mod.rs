//! Kinds of country: a table of values, from which a word draws its own.
//!
//! ```text
//! seed ─► country (a row of the table) ─► this word's values ─► what the link says, which always wins
//! ```

mod parts;
mod rows;

use super::choice::Word;
use super::style::Style;
use super::texts::explained;
use crate::base::random::ItemHash;
pub(super) use parts::Parts;
pub use rows::COUNTRIES;
pub(super) use rows::{CLIMATES, COMMON, OWN as OWN_DRAWS};

/// A kind of country: a row of the table.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Country {
    /// The name in links.
    pub name: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// One line on its looks.
    pub help: &'static str,
    /// The number of its tickets in the draw of a word's country.
    pub(super) weight: u32,
    /// The names of the climates that its words draw from, with blanks between them. One that stands twice is drawn twice as often.
    pub(super) climates: &'static str,
    /// The draws of its words, in the language of `settling/draws.rs`.
    pub(super) draws: &'static str,
    /// The style that is best on such a map, if it needs one: beside that style the page offers this country.
    pub style: Option<Style>,
}

/// The value of the key `country` if nothing is given: the word decides.
pub(super) const AUTO: &str = "auto";

/// The country of the table's own values, the same for every word.
pub(super) const USUAL: &str = "usual";

/// The country of land that is in no row: the word's own values about the usual ones.
pub(super) const OWN: &str = "own";

/// Words of the key `country` that are no rows.
const OTHERS: [Word; 3] = [
    Word { name: AUTO, label: "as the word decides", help: "The word draws one of the kinds below." },
    Word {
        name: USUAL,
        label: "usual",
        help: "The default of each parameter, the same for every word: an island, unless another land is asked for.",
    },
    Word {
        name: OWN,
        label: "usual, varied by the word",
        help: "Values that the word varies around the usual ones, as for the whole rectangle and drawn land.",
    },
];

/// All words of the key `country`.
static WORDS: [Word; OTHERS.len() + COUNTRIES.len()] = words();

const fn words() -> [Word; OTHERS.len() + COUNTRIES.len()] {
    let mut words = [OTHERS[0]; OTHERS.len() + COUNTRIES.len()];
    let mut i = 0;
    while i < words.len() {
        words[i] = if i < OTHERS.len() { OTHERS[i] } else { COUNTRIES[i - OTHERS.len()].word() };
        words[i].label = explained(words[i].label);
        words[i].help = explained(words[i].help);
        i += 1;
    }
    words
}

impl Country {
    pub(super) const WORDS: &'static [Word] = &WORDS;
    pub(super) const DEFAULT: &'static str = AUTO;

    const fn word(&self) -> Word {
        Word { name: self.name, label: self.label, help: self.help }
    }

    /// Returns the greatest of its tickets in the draw of a word. With as many random numbers as it has weight, a row wins
    /// in proportion to its weight, and another row later takes only the words that it wins (rendezvous hashing).
    pub(super) fn best_ticket(&self, chance: ItemHash) -> u32 {
        let own = chance.of(self.name);
        (0..self.weight).map(|ticket| own.bits([ticket, 0, 0])).max().unwrap_or(0)
    }

    /// Draws one of its climates.
    pub(super) fn climate(&self, chance: ItemHash) -> &'static str {
        let climates: Vec<_> = Parts::of(self.climates, b' ').collect();
        let drawn = climates[(chance.of("climate").unit([0; 3]) * climates.len() as f32) as usize];
        CLIMATES.iter().find(|(name, _)| *name == drawn).map_or("", |(_, draws)| draws)
    }
}

/// Finds a country by its name in links.
pub fn find(name: &str) -> Option<&'static Country> {
    COUNTRIES.iter().find(|country| country.name == name)
}
