//! The recipe: everything that decides a picture.
//!
//! Same recipe, same picture, on every machine. A [`Recipe`] cannot hold an invalid value: it is parsed once, at the
//! edge, from link text ([`link`]), from JSON (`json`) or from command-line options, and all of them go through
//! [`Recipe::set`], so that they agree on names, ranges and errors.
//!
//! The parameters themselves stand in one table, [`table::TABLE`].

mod annotation;
pub mod choice;
pub mod country;
mod error;
pub mod given;
mod hidden;
mod inactive;
#[cfg(feature = "json")]
pub mod json;
mod key;
pub mod link;
mod names;
mod outline;
mod parameter;
mod parcels;
pub mod preset;
pub mod reading;
mod rows;
mod settling;
mod style;
pub mod table;
mod texts;
mod value;

pub use choice::{
    Cartouche, Choice, CourseShape, GroundKind, GrowthMethod, Labels, LandKind, MeanderModel, Pattern, Scatter, Word,
};
pub use error::RecipeError;
pub(crate) use hidden::is_hidden;
pub use hidden::{shown, visible};
pub use key::{IntegerKey, Key, NumberKey};
pub use names::{Mark, NamesError, OwnNames};
pub use outline::{GridPoint, LONGEST as LONGEST_OUTLINE, LineKind, Outline, OutlineError};
pub use parameter::{Kind, Parameter, Stage};
pub use settling::is_decided;
pub(crate) use style::Shown;
pub use style::Style;
pub use value::{Decimal, Sides, Value};

use key::COUNT;
use table::TABLE;

/// The number of the algorithm set that this crate draws. Once released, an edition's pictures never change.
pub const EDITION: u32 = 1;

/// Everything that decides a picture: a seed and a value, within its range, for each parameter of the table. What nobody
/// named has the value of its [country](country::COUNTRIES).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// The values that are drawn.
    values: [Value; COUNT],
    /// The keys that somebody named, of those that the country decides.
    named: u128,
}

impl Default for Recipe {
    fn default() -> Self {
        let mut recipe = Self { values: std::array::from_fn(|i| TABLE[i].default_value()), named: 0 };
        recipe.settle();
        recipe
    }
}

impl Recipe {
    /// Returns the recipe of the table's own values, in the usual country.
    pub(crate) fn usual() -> Self {
        let mut usual = Self::default();
        usual.put(Key::Country, Value::Choice(country::USUAL));
        usual
    }

    /// Returns the value of a parameter.
    pub fn value(&self, key: Key) -> &Value {
        &self.values[key as usize]
    }

    /// Returns the seed text.
    pub fn seed(&self) -> &str {
        match self.value(Key::Seed) {
            Value::Text(text) => text,
            _ => "",
        }
    }

    /// Writes the words for readers who do not see the picture, where its author gives none. They hold the seed as it is.
    ///
    /// ```
    /// use riverseed::recipe::link;
    ///
    /// assert_eq!(link::read("seed=rimu")?.alternative(), "Rivers grown from “rimu”");
    /// assert_eq!(link::read("seed=")?.alternative(), "Rivers");
    /// # Ok::<(), riverseed::recipe::RecipeError>(())
    /// ```
    pub fn alternative(&self) -> String {
        match self.seed() {
            "" => "Rivers".into(),
            seed => format!("Rivers grown from “{seed}”"),
        }
    }

    /// Returns a number, in the parameter's unit.
    ///
    /// ```
    /// use riverseed::recipe::{NumberKey, link};
    ///
    /// assert_eq!(link::read("width=12.5")?.number(NumberKey::Width), 12.5);
    /// # Ok::<(), riverseed::recipe::RecipeError>(())
    /// ```
    #[inline(never)] // each copy weighs a hundred bytes
    pub fn number(&self, key: NumberKey) -> f32 {
        match &self.values[key as usize] {
            Value::Number(number) => number.to_f64() as f32,
            _ => f32::NAN, // never: the row of such a key holds numbers
        }
    }

    /// Returns a whole number.
    pub fn integer(&self, key: IntegerKey) -> u32 {
        match &self.values[key as usize] {
            Value::Integer(integer) => *integer,
            _ => 0, // never: the row of such a key holds whole numbers
        }
    }

    /// Returns the value of a parameter that is a choice among words.
    ///
    /// ```
    /// use riverseed::recipe::{Style, link};
    ///
    /// assert_eq!(link::read("style=atlas")?.get::<Style>(), Style::Atlas);
    /// # Ok::<(), riverseed::recipe::RecipeError>(())
    /// ```
    pub fn get<C: Choice>(&self) -> C {
        C::ALL[self.chosen(C::KEY, C::WORDS)]
    }

    /// Returns the index of a parameter's value in `words`; 0 if it is not in them.
    #[inline(never)] // one copy for all choices
    fn chosen(&self, key: Key, words: &[Word]) -> usize {
        let is_chosen = |word: &Word| matches!(self.value(key), Value::Choice(name) if *name == word.name);
        words.iter().position(is_chosen).unwrap_or(0)
    }

    /// Returns the share of the map that is water: the one asked for or, at 0, the one that suits the kind of land. 0
    /// for a drawn land and for the whole rectangle, where the recipe does not determine it.
    pub fn sea(&self) -> f32 {
        let (asked, usual) = (self.number(NumberKey::Sea), self.get::<LandKind>().usual_sea());
        if asked > 0.0 && usual > 0.0 { asked } else { usual }
    }

    /// Returns the sides beyond which the sea lies.
    pub fn sides(&self) -> Sides {
        self.sides_of(Key::Sides)
    }

    /// Returns the directions in which river mouths may lie.
    pub fn shores(&self) -> Sides {
        self.sides_of(Key::Shores)
    }

    fn sides_of(&self, key: Key) -> Sides {
        match self.value(key) {
            Value::Sides(sides) => *sides,
            _ => Sides::ALL,
        }
    }

    /// Returns the drawn land; `None` if nothing is drawn.
    pub fn outline(&self) -> Option<&Outline> {
        match self.value(Key::Outline) {
            Value::Outline(outline) if !outline.is_empty() => Some(outline),
            _ => None,
        }
    }

    /// Returns the drawn courses of rivers; empty unless the land is drawn.
    pub fn rivers(&self) -> &[Vec<GridPoint>] {
        let outline = self.outline().filter(|_| self.get::<LandKind>() == LandKind::Drawn);
        outline.map_or(&[], Outline::rivers)
    }

    /// Returns the sides of a plain rectangle beyond which the sea lies: the chosen ones or, where rivers are drawn,
    /// all, because drawn rivers leave the map wherever they begin.
    pub fn open_sides(&self) -> Sides {
        if self.rivers().is_empty() { self.sides() } else { Sides::ALL }
    }

    /// Sets a parameter from text, spelled as in a link, an option or a JSON string. `auto` takes back the value of one that
    /// the country decides.
    ///
    /// # Errors
    /// Names the key, the value and the allowed range or words; the recipe is then unchanged.
    pub fn set(&mut self, key: Key, text: &str) -> Result<(), RecipeError> {
        self.assign_text(key, text)?;
        self.settle();
        Ok(())
    }

    /// Sets a parameter as [`set`](Self::set) does, but leaves all others as they are until they are [settled](Self::settle).
    fn assign_text(&mut self, key: Key, text: &str) -> Result<(), RecipeError> {
        if text.trim() == country::AUTO && is_decided(key) {
            self.forget(key);
        } else {
            self.assign(key, key.parameter().parse(text)?);
        }
        Ok(())
    }

    /// Sets a parameter to a value that is known to be of its kind and in its range.
    pub(crate) fn put(&mut self, key: Key, value: Value) {
        self.assign(key, value);
        self.settle();
    }

    /// Sets a parameter as [`put`](Self::put) does, but leaves all others as they are until they are [settled](Self::settle).
    fn assign(&mut self, key: Key, value: Value) {
        debug_assert!(key.parameter().accepts(&value), "{key:?} cannot be {value:?}");
        self.values[key as usize] = value;
        self.note(key);
    }

    /// Returns `true` if another recipe has the same values for all parameters but these.
    #[inline(never)] // one copy
    pub(crate) fn differs_in(&self, other: &Self, keys: &[Key]) -> bool {
        TABLE.iter().all(|Parameter { key, .. }| keys.contains(key) || self.value(*key) == other.value(*key))
    }

    /// Returns the earliest stage that has to run again to get from this recipe to another; `None` if they are equal.
    pub fn first_difference(&self, other: &Self) -> Option<Stage> {
        TABLE
            .iter()
            .filter(|parameter| self.value(parameter.key) != other.value(parameter.key))
            .map(|parameter| parameter.stage)
            .min()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_difference_is_the_earliest_stage() {
        let plain = Recipe::default();
        let mut other = plain.clone();
        assert_eq!(plain.first_difference(&other), None);
        other.set(Key::Style, "skeleton").unwrap();
        assert_eq!(plain.first_difference(&other), Some(Stage::Paint));
        other.set(Key::Trim, "9").unwrap();
        assert_eq!(plain.first_difference(&other), Some(Stage::Prune));
        other.set(Key::Seed, "rimu").unwrap();
        assert_eq!(plain.first_difference(&other), Some(Stage::Land));
    }

    #[test]
    fn refused_value_leaves_the_recipe_alone() {
        let mut recipe = Recipe::default();
        assert!(recipe.set(Key::Curl, "many").is_err());
        assert_eq!(recipe, Recipe::default());
    }
}
