//! The language in which rows say what a word may draw: items with blanks between them, each of a key or several.
//!
//! ```text
//! sea=0.6:0.7              any number from 0.6 to 0.7
//! mountains=2~0.3          about 2: 2·e^(0.3·g), where g is a normal deviate, at most 2 either way
//! bending~0.3              about the value that another item gives, or else the usual one
//! fall~0.3>0.2             the same, and 0.2 at least
//! sides=n|e|sw             one of these
//! sides,strike=e,16|n,75   one of these, for both keys
//! land=island              this
//! ```
//!
//! Of several items with one key the last counts; each key has a stream of its own, so that a new key shifts no other's draw.

use crate::base::random::ItemHash;
use crate::recipe::country::Parts;
use crate::recipe::key::Key;
use crate::recipe::parameter::Kind;
use crate::recipe::table::TABLE;
use crate::recipe::value::{Decimal, Value};

/// What is drawn for a key.
#[derive(Clone, Copy, Default)]
struct Draw {
    /// A value or a range; empty for the usual value.
    from: &'static str,
    /// The deviation of the logarithm.
    spread: f32,
    /// The least that is drawn, whatever the value.
    least: f32,
}

/// The draws of all keys.
pub(super) struct Draws {
    of: [Option<Draw>; TABLE.len()],
    chance: ItemHash,
}

/// The greatest deviate.
const FARTHEST: f32 = 2.0;

impl Draws {
    /// Makes draws of nothing, with a word's chance.
    pub fn new(chance: ItemHash) -> Self {
        Self { of: [None; TABLE.len()], chance }
    }

    /// Adds the items of a text.
    pub fn add(&mut self, items: &'static str) {
        for item in Parts::of(items, b' ') {
            match Parts::cut(item, b'=') {
                (keys, Some(from)) => self.add_values(keys, from),
                _ => self.add_spread(item),
            }
        }
    }

    /// Adds what stands for one key or several: one of some alternatives.
    fn add_values(&mut self, keys: &'static str, from: &'static str) {
        let alternatives: Vec<_> = Parts::of(from, b'|').collect();
        let chosen = (self.chance.of(keys).unit([0; 3]) * alternatives.len() as f32) as usize;
        let is_one_of_some = alternatives.len() > 1;
        for (key, from) in Parts::of(keys, b',').zip(Parts::of(alternatives[chosen], b',')) {
            self.add_value(key, from, is_one_of_some);
        }
    }

    fn add_value(&mut self, key: &str, from: &'static str, is_exact: bool) {
        let Some(draw) = self.draw_of(key) else { return };
        *draw = match Parts::cut(from, b'~') {
            (middle, Some(spread)) => Draw { from: middle, spread: number(spread), ..*draw },
            _ => Draw { from, spread: if is_exact { 0.0 } else { draw.spread }, ..*draw },
        };
    }

    fn add_spread(&mut self, item: &'static str) {
        if let (key, Some(spread)) = Parts::cut(item, b'~')
            && let Some(draw) = self.draw_of(key)
        {
            let (spread, least) = Parts::cut(spread, b'>');
            (draw.spread, draw.least) = (number(spread), least.map_or(0.0, number));
        }
    }

    fn draw_of(&mut self, key: &str) -> Option<&mut Draw> {
        Key::from_name(key).map(|key| self.of[key as usize].get_or_insert_default())
    }

    /// Draws the values, with their keys.
    pub fn values(&self) -> impl Iterator<Item = (Key, Value)> {
        TABLE.iter().zip(&self.of).filter_map(|(row, draw)| Some((row.key, self.value(row.key, (*draw)?)?)))
    }

    fn value(&self, key: Key, draw: Draw) -> Option<Value> {
        let row = key.parameter();
        let chance = self.chance.of(row.name);
        let (min, max, step) = match row.kind {
            Kind::Integer { min, max, .. } => (Decimal::whole(min), Decimal::whole(max), Decimal::whole(1)),
            Kind::Number { min, max, step, .. } => (min, max, step),
            _ => return row.parse(draw.from).ok(),
        };
        let drawn = match Parts::cut(draw.from, b':') {
            (least, Some(most)) => number(least) + (number(most) - number(least)) * chance.unit([0; 3]),
            _ => {
                let usual = || row.text_of(&row.default_value());
                let middle = if draw.from.is_empty() { number(&usual()) } else { number(draw.from) };
                let deviate = chance.normal([1, 0, 0]).clamp(-FARTHEST, FARTHEST);
                middle * libm::expf(draw.spread * deviate)
            }
        };
        let drawn = step.nearest_multiple(drawn.max(draw.least).into()).clamp(min, max);
        Some(match row.kind {
            Kind::Integer { .. } => Value::Integer(drawn.round()),
            _ => Value::Number(drawn),
        })
    }
}

/// Reads a number of a row. Tests read all rows.
fn number(text: &str) -> f32 {
    Decimal::parse(text).map_or(f32::NAN, |number| number.to_f64() as f32)
}
