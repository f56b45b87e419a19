//! A parameter: its key, its stage and its kind of value, with reading, checking and writing of values.

use super::choice::Word;
use super::error::RecipeError;
use super::hidden::shown;
use super::key::Key;
use super::names::OwnNames;
use super::outline::Outline;
use super::value::{Decimal, Sides, Value};

/// A stage that parameters belong to. Stages run in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Stage {
    /// Shaping the land.
    Land,
    /// Growing the tree.
    Grow,
    /// Trimming the tree.
    Prune,
    /// Turning the tree into rivers: courses, widths, meanders.
    Shape,
    /// Giving the land heights that fit the rivers.
    Relief,
    /// Naming what is on the map.
    Name,
    /// Painting the map.
    Paint,
}

impl Stage {
    /// Returns the stage's name, lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Land => "land",
            Self::Grow => "grow",
            Self::Prune => "prune",
            Self::Shape => "shape",
            Self::Relief => "relief",
            Self::Name => "name",
            Self::Paint => "paint",
        }
    }
}

/// The kind of values that a parameter takes, and its default. Exhaustive, since whoever shows or draws recipes has a way for each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Text of at most `longest` characters.
    Text {
        /// The most characters.
        longest: usize,
        /// The value when nothing is given.
        default: &'static str,
    },
    /// A whole number.
    Integer {
        /// The least.
        min: u32,
        /// The most.
        max: u32,
        /// The value when nothing is given.
        default: u32,
    },
    /// A number.
    Number {
        /// The least.
        min: Decimal,
        /// The most.
        max: Decimal,
        /// The step of a slider; values between steps are allowed too.
        step: Decimal,
        /// The value when nothing is given.
        default: Decimal,
    },
    /// One word of a list.
    Choice {
        /// The words of one of the types in [`choice`](super::choice).
        choices: &'static [Word],
        /// The word when nothing is given.
        default: &'static str,
    },
    /// Some sides of the domain.
    Sides {
        /// The value when nothing is given.
        default: Sides,
    },
    /// A drawn land; nothing is drawn by default.
    Outline,
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Parameter {
    /// The key in code.
    pub key: Key,
    /// The key in links, attributes, options and JSON.
    pub name: &'static str,
    /// The name on the page. `label`, `help` and `group` are empty without the feature `texts`.
    pub label: &'static str,
    /// One line of explanation.
    pub help: &'static str,
    /// The unit of its numbers; empty for plain numbers.
    pub unit: &'static str,
    /// The heading on the page.
    pub group: &'static str,
    /// The first stage that runs again when the value changes.
    pub stage: Stage,
    /// `true` if a slider should be logarithmic.
    pub logarithmic: bool,
    /// The allowed values and the default.
    pub kind: Kind,
}

impl Parameter {
    /// Returns the default value.
    pub fn default_value(&self) -> Value {
        match self.kind {
            Kind::Text { default, .. } => Value::Text(default.into()),
            Kind::Integer { default, .. } => Value::Integer(default),
            Kind::Number { default, .. } => Value::Number(default),
            Kind::Choice { default, .. } => Value::Choice(default),
            Kind::Sides { default } => Value::Sides(default),
            Kind::Outline => Value::Outline(Outline::default()),
        }
    }

    /// Returns `true` if a value is of this parameter's kind and in its range.
    pub fn accepts(&self, value: &Value) -> bool {
        match (self.kind, value) {
            (Kind::Text { longest, .. }, Value::Text(text)) => text.chars().count() <= longest,
            (Kind::Integer { min, max, .. }, Value::Integer(n)) => (min..=max).contains(n),
            (Kind::Number { min, max, .. }, Value::Number(x)) => (min..=max).contains(x),
            (Kind::Choice { choices, .. }, Value::Choice(name)) => choices.iter().any(|word| word.name == *name),
            (Kind::Sides { .. }, Value::Sides(_)) | (Kind::Outline, Value::Outline(_)) => true,
            _ => false,
        }
    }

    /// Writes a value as text, which [`parse`](Self::parse) reads back to the same value.
    pub fn text_of(&self, value: &Value) -> String {
        match value {
            Value::Text(text) => text.clone(),
            Value::Integer(n) => n.to_string(),
            Value::Number(x) => x.to_string(),
            Value::Choice(name) => (*name).into(),
            Value::Sides(sides) => sides.to_string(),
            Value::Outline(outline) => outline.to_string(),
        }
    }

    /// Reads a value from its text.
    ///
    /// # Errors
    /// Names the key, the text and what is allowed.
    pub fn parse(&self, text: &str) -> Result<Value, RecipeError> {
        match self.kind {
            Kind::Text { .. } if self.key == Key::Names => OwnNames::parse(text)
                .map(|names| Value::Text(names.to_string()))
                .map_err(|reason| RecipeError::Names { key: self.name, reason }),
            Kind::Text { longest, .. } => self.parse_text(text, longest),
            Kind::Integer { min, max, .. } => self.parse_integer(text, min, max),
            Kind::Number { min, max, .. } => self.parse_number(text, min, max),
            Kind::Choice { choices, .. } => choices
                .iter()
                .find(|word| word.name == text)
                .map(|word| Value::Choice(word.name))
                .ok_or_else(|| self.unknown_choice(text)),
            Kind::Sides { .. } => Sides::parse(text).map(Value::Sides).ok_or_else(|| self.unknown_choice(text)),
            Kind::Outline => Outline::parse(text.trim())
                .map(Value::Outline)
                .map_err(|reason| RecipeError::Outline { key: self.name, reason }),
        }
    }

    fn parse_text(&self, text: &str, longest: usize) -> Result<Value, RecipeError> {
        let text = text.trim();
        let length = text.chars().count();
        if length > longest {
            return Err(RecipeError::TooLong { key: self.name, length, max: longest });
        }
        if text.chars().any(|c| c.is_control() || c == char::REPLACEMENT_CHARACTER) {
            return Err(RecipeError::NotText { key: self.name });
        }
        Ok(Value::Text(text.into()))
    }

    fn parse_integer(&self, text: &str, min: u32, max: u32) -> Result<Value, RecipeError> {
        let number = self.decimal(text)?;
        if !number.is_whole() {
            return Err(RecipeError::NotWhole { key: self.name, value: shown(text) });
        }
        if self.key == Key::Edition && number != Decimal::whole(super::EDITION) {
            return Err(RecipeError::UnknownEdition { value: shown(text), known: super::EDITION });
        }
        self.within(number, text, Decimal::whole(min), Decimal::whole(max)).map(|number| Value::Integer(number.round()))
    }

    fn parse_number(&self, text: &str, min: Decimal, max: Decimal) -> Result<Value, RecipeError> {
        self.within(self.decimal(text)?, text, min, max).map(Value::Number)
    }

    fn decimal(&self, text: &str) -> Result<Decimal, RecipeError> {
        Decimal::parse(text.trim()).ok_or_else(|| RecipeError::NotANumber { key: self.name, value: shown(text) })
    }

    fn within(&self, number: Decimal, text: &str, min: Decimal, max: Decimal) -> Result<Decimal, RecipeError> {
        if (min..=max).contains(&number) {
            Ok(number)
        } else {
            Err(RecipeError::OutOfRange { key: self.name, value: shown(text), min, max })
        }
    }

    fn unknown_choice(&self, text: &str) -> RecipeError {
        let choices = match self.kind {
            Kind::Choice { choices, .. } => choices.iter().map(|word| word.name).collect::<Vec<_>>().join(", "),
            _ => "the sides n, e, s, w, each once".into(),
        };
        RecipeError::UnknownChoice { key: self.name, value: shown(text), choices }
    }
}
