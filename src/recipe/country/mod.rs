//! Countries: kinds of land, as a table of values that a word draws its own from.
//!
//! ```text
//! seed ─► country (a row of the table) ─► this word's values ─► what the link says, which always wins
//! ```

mod draws;
mod rows;
#[cfg(test)]
mod tests;

use super::choice::{GrowthMethod, Word};
use super::key::{IntegerKey, Key};
use super::parameter::Stage;
use super::texts::explained;
use super::value::Value;
use super::{Recipe, Style};
use crate::base::random::{ItemHash, Purpose, Seed};
use draws::Draws;
pub use rows::COUNTRIES;

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
    /// How many tickets it has in the draw of a word's country.
    weight: u32,
    /// The names of climates that its words draw from, with their shares.
    climates: &'static str,
    /// What its words draw.
    draws: &'static str,
    /// The style that is best on such a map, if it needs one: beside that style the page offers this country.
    pub style: Option<Style>,
}

/// The value of the key `country` if nothing is given: the word decides.
pub(super) const AUTO: &str = "auto";

/// The country of today's usual values, for every word the same.
const USUAL: &str = "usual";

/// The country of land that is in no row: the word's own values about the usual ones.
const OWN: &str = "own";

/// Words of the key `country` that are no rows.
const OTHERS: [Word; 3] = [
    Word { name: AUTO, label: "as the word decides", help: "A country that the seed draws from all of these." },
    Word { name: USUAL, label: "usual", help: "The usual values, the same for every word." },
    Word { name: OWN, label: "its own", help: "The word's own values, about the usual ones." },
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

/// The keys whose values, if a link leaves them out, are the country's.
const DECIDED: &[Key] = &[
    Key::Land,
    Key::Sea,
    Key::Drowning,
    Key::Roughness,
    Key::Mouths,
    Key::MouthSpacing,
    Key::Sides,
    Key::Growth,
    Key::Sensitivity,
    Key::Attractors,
    Key::Valleys,
    Key::ValleySpacing,
    Key::Concavity,
    Key::Captures,
    Key::Hardness,
    Key::HardnessScale,
    Key::Bending,
    Key::BendingVariation,
    Key::Pattern,
    Key::Strike,
    Key::CenterX,
    Key::CenterY,
    Key::Fall,
    Key::ChannelArea,
    Key::HeadVariation,
    Key::Trim,
    Key::TributarySpacing,
    Key::Simplify,
    Key::Width,
    Key::MeanderRounds,
    Key::MeanderElsewhere,
    Key::GreatRivers,
    Key::FlatShare,
    Key::Neck,
    Key::Oxbows,
    Key::Mountains,
    Key::Plains,
    Key::Rills,
    Key::Shade,
];

impl Country {
    pub(super) const WORDS: &'static [Word] = &WORDS;
    pub(super) const DEFAULT: &'static str = AUTO;

    const fn word(&self) -> Word {
        Word { name: self.name, label: self.label, help: self.help }
    }

    /// Returns `true` if some of its words have this value of a key.
    fn may_have(&self, key: Key, value: &Value) -> bool {
        let row = key.parameter();
        let is_key = |keys: &str| keys.split(',').position(|name| name == row.name);
        let item = self.draws.split_ascii_whitespace().find_map(|item| {
            let (keys, from) = item.split_once('=')?;
            Some((is_key(keys)?, from))
        });
        match item {
            Some((at, from)) => from.split('|').any(|one| one.split(',').nth(at) == Some(&row.text_of(value))),
            None => *value == row.default_value(),
        }
    }

    /// Returns the greatest of its tickets in the draw of a word. With as many random numbers as it has weight, a row wins
    /// in proportion to its weight, and another row later takes only the words that it wins (rendezvous hashing).
    fn best_ticket(&self, chance: ItemHash) -> u32 {
        let own = chance.of(self.name);
        (0..self.weight).map(|ticket| own.bits([ticket, 0, 0])).max().unwrap_or(0)
    }

    /// Draws one of its climates.
    fn climate(&self, chance: ItemHash) -> &'static str {
        let climates: Vec<_> = self.climates.split(' ').collect();
        let drawn = climates[(chance.of("climate").unit([0; 3]) * climates.len() as f32) as usize];
        rows::CLIMATES.iter().find(|(name, _)| *name == drawn).map_or("", |(_, draws)| draws)
    }
}

/// Where the values of keys come from that a link leaves out.
enum Origin {
    Usual,
    Own,
    Row(&'static Country),
}

impl Recipe {
    /// Returns `true` if somebody gave a value to a parameter: another than the default or, where the country decides, any.
    pub fn is_named(&self, key: Key) -> bool {
        if is_decided(key) { self.named & bit(key) != 0 } else { *self.value(key) != key.parameter().default_value() }
    }

    /// Takes the value back that somebody gave to a parameter.
    pub fn forget(&mut self, key: Key) {
        self.named &= !bit(key);
        self.settle_all();
    }

    /// Returns the name of the country: that of a row of [`COUNTRIES`], `usual` or `own`.
    pub fn country(&self) -> &'static str {
        match self.origin() {
            Origin::Usual => USUAL,
            Origin::Own => OWN,
            Origin::Row(country) => country.name,
        }
    }

    /// Notes that somebody has given a parameter its value, and gives those that nobody named theirs.
    pub(super) fn settle(&mut self, key: Key) {
        if is_decided(key) {
            self.named |= bit(key);
        }
        if is_decided(key) || matches!(key, Key::Seed | Key::Country) {
            self.settle_all();
        }
    }

    /// Gives all parameters that the country decides, and nobody named, its values.
    pub(super) fn settle_all(&mut self) {
        let is_free = |recipe: &Self, key: Key| is_decided(key) && !recipe.is_named(key);
        for key in DECIDED.iter().copied() {
            if is_free(self, key) {
                self.values[key as usize] = key.parameter().default_value();
            }
        }
        let chance = self.chance();
        let mut draws = Draws::new(chance);
        match self.origin() {
            Origin::Usual => return,
            Origin::Own => draws.add(rows::OWN),
            Origin::Row(country) => {
                draws.add(rows::COMMON);
                draws.add(country.climate(chance));
                draws.add(country.draws);
            }
        }
        let gives_rivers = self.gives_rivers();
        for (key, value) in draws.values() {
            let is_river = matches!(key.parameter().stage, Stage::Grow | Stage::Prune | Stage::Shape);
            if is_free(self, key) && (gives_rivers || !is_river) {
                self.values[key as usize] = value;
            }
        }
        if is_free(self, Key::Attractors) {
            let most = super::reading::most_attractors(self);
            let drawn = self.integer(IntegerKey::Attractors);
            self.values[Key::Attractors as usize] = Value::Integer(drawn.min(most));
        }
    }

    fn origin(&self) -> Origin {
        let Value::Choice(name) = *self.value(Key::Country) else { return Origin::Usual };
        match name {
            USUAL => Origin::Usual,
            OWN => Origin::Own,
            AUTO => self.drawn_country().map_or(Origin::Own, Origin::Row),
            _ => find(name).map_or(Origin::Usual, Origin::Row),
        }
    }

    /// Draws a country among those that agree with what is named. `None` if none does.
    fn drawn_country(&self) -> Option<&'static Country> {
        let asked: &[Key] = if self.gives_rivers() { &[Key::Land, Key::Pattern, Key::Growth] } else { &[Key::Land] };
        let agrees = |country: &&Country| {
            asked.iter().all(|key| !self.is_named(*key) || country.may_have(*key, self.value(*key)))
        };
        let chance = self.chance();
        COUNTRIES.iter().filter(agrees).max_by_key(|country| country.best_ticket(chance))
    }

    /// Returns `true` if a country gives growth and rivers their values, too, and not the land alone: unless a way of growing is named
    /// that has usual values of its own.
    fn gives_rivers(&self) -> bool {
        !self.is_named(Key::Growth) || self.get::<GrowthMethod>() == GrowthMethod::Drainage
    }

    fn chance(&self) -> ItemHash {
        Seed::from_text(self.seed()).item_hash(Purpose::Kind)
    }
}

/// Returns `true` if a country decides the value of a parameter that a link leaves out.
pub fn is_decided(key: Key) -> bool {
    DECIDED.contains(&key)
}

/// Finds a country by its name in links.
pub fn find(name: &str) -> Option<&'static Country> {
    COUNTRIES.iter().find(|country| country.name == name)
}

/// Returns the bit of a key in a set of keys.
const fn bit(key: Key) -> u128 {
    1 << key as u32
}
