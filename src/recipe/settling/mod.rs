//! The values of a recipe: what is named, and for the rest what the country gives.

mod draws;
#[cfg(test)]
mod tests;

use super::Recipe;
use super::choice::GrowthMethod;
use super::country::{self, COUNTRIES, Country, Parts};
use super::key::{IntegerKey, Key};
use super::parameter::Stage;
use super::parcels::most_attractors;
use super::table::TABLE;
use super::value::Value;
use crate::base::random::{ItemHash, Purpose, Seed};
use draws::Draws;

/// The keys whose values, if a link leaves them out, are the country's, as a set.
const DECIDED: u128 = set(&[
    Key::Span,
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
    Key::Deltas,
    Key::Waves,
    Key::MeanderRounds,
    Key::MeanderElsewhere,
    Key::GreatRivers,
    Key::FlatShare,
    Key::Neck,
    Key::Oxbows,
    Key::Mountains,
    Key::Plains,
    Key::Rills,
    Key::Lakes,
    Key::Shade,
    Key::Warmth,
    Key::Rain,
    Key::RainShadow,
    Key::Ground,
    Key::Woods,
]);

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

    /// Leaves a parameter to the country, once all are [settled](Self::settle).
    pub(super) fn forget(&mut self, key: Key) {
        self.named &= !bit(key);
    }

    /// Notes that somebody has given a parameter its value.
    pub(super) fn note(&mut self, key: Key) {
        self.named |= bit(key) & DECIDED;
    }

    /// Returns the name of the country: that of a row of [`COUNTRIES`], `usual` or `own`.
    pub fn country(&self) -> &'static str {
        match self.origin() {
            Origin::Usual => country::USUAL,
            Origin::Own => country::OWN,
            Origin::Row(row) => row.name,
        }
    }

    /// Gives all parameters that the country decides, and nobody named, its values.
    pub(super) fn settle(&mut self) {
        let free = DECIDED & !self.named;
        let is_free = |key: Key| free & bit(key) != 0;
        for row in TABLE.iter().filter(|row| is_free(row.key)) {
            self.values[row.key as usize] = row.default_value();
        }
        let chance = self.chance();
        let mut draws = Draws::new(chance);
        match self.origin() {
            Origin::Usual => return,
            Origin::Own => draws.add(country::OWN_DRAWS),
            Origin::Row(row) => {
                draws.add(country::COMMON);
                draws.add(row.climate(chance));
                draws.add(row.draws);
            }
        }
        let gives_rivers = self.gives_rivers();
        for (key, value) in draws.values() {
            let is_river = matches!(key.parameter().stage, Stage::Grow | Stage::Prune | Stage::Shape);
            if is_free(key) && (gives_rivers || !is_river) {
                self.values[key as usize] = value;
            }
        }
        if is_free(Key::Attractors) {
            let most = most_attractors(self);
            let drawn = self.integer(IntegerKey::Attractors);
            self.values[Key::Attractors as usize] = Value::Integer(drawn.min(most));
        }
    }

    fn origin(&self) -> Origin {
        let Value::Choice(name) = *self.value(Key::Country) else { return Origin::Usual };
        match name {
            country::USUAL => Origin::Usual,
            country::OWN => Origin::Own,
            country::AUTO => self.drawn_country().map_or(Origin::Own, Origin::Row),
            _ => country::find(name).map_or(Origin::Usual, Origin::Row),
        }
    }

    /// Draws a country among those that agree with what is named. `None` if none does.
    fn drawn_country(&self) -> Option<&'static Country> {
        let asked: &[Key] = if self.gives_rivers() { &[Key::Land, Key::Pattern, Key::Growth] } else { &[Key::Land] };
        let agrees = |country: &&Country| {
            asked.iter().all(|key| !self.is_named(*key) || may_have(country, *key, self.value(*key)))
        };
        let chance = self.chance();
        COUNTRIES.iter().filter(agrees).max_by_key(|country| country.best_ticket(chance))
    }

    /// Returns `true` if the country decides growth and rivers, too: always, unless a way of growing other than drainage is named. Land,
    /// relief, climate, woods and span are its in any case.
    fn gives_rivers(&self) -> bool {
        !self.is_named(Key::Growth) || self.get::<GrowthMethod>() == GrowthMethod::Drainage
    }

    fn chance(&self) -> ItemHash {
        Seed::from_text(self.seed()).item_hash(Purpose::Kind)
    }
}

/// Returns `true` if some words of a country have this value of a key.
#[inline(never)] // one copy
fn may_have(country: &Country, key: Key, value: &Value) -> bool {
    let row = key.parameter();
    let text = row.text_of(value);
    for item in Parts::of(country.draws, b' ') {
        let (keys, from) = Parts::cut(item, b'=');
        if let Some(at) = Parts::of(keys, b',').position(|name| name == row.name) {
            let is_it = |one| Parts::of(one, b',').nth(at).is_some_and(|one| one == text);
            return Parts::of(from.unwrap_or_default(), b'|').any(is_it);
        }
    }
    *value == row.default_value()
}

/// Returns `true` if a country decides the value of a parameter that a link leaves out.
pub fn is_decided(key: Key) -> bool {
    DECIDED & bit(key) != 0
}

/// Returns the bit of a key in a set of keys.
const fn bit(key: Key) -> u128 {
    1 << key as u32
}

const fn set(keys: &[Key]) -> u128 {
    let (mut set, mut i) = (0, 0);
    while i < keys.len() {
        set |= bit(keys[i]);
        i += 1;
    }
    set
}
