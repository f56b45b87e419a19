//! What can be wrong with a recipe, in words that help to correct it.

use thiserror::Error;

#[cfg(feature = "names")]
use super::names::NamesError;
use super::outline::OutlineError;
use super::value::Decimal;

/// A recipe that cannot be read: which key, which value, and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RecipeError {
    /// No parameter has this name.
    #[error("there is no parameter '{key}'")]
    UnknownKey {
        /// The name that was given.
        key: String,
    },
    /// A parameter is given more than once.
    #[error("'{key}' is given more than once")]
    Duplicate {
        /// The parameter.
        key: String,
    },
    /// A number was wanted.
    #[error("{key}: '{value}' is not a number in plain digits")]
    NotANumber {
        /// The parameter.
        key: &'static str,
        /// What was given.
        value: String,
    },
    /// A whole number was wanted.
    #[error("{key}: '{value}' is not a whole number")]
    NotWhole {
        /// The parameter.
        key: &'static str,
        /// What was given.
        value: String,
    },
    /// A number outside its range.
    #[error("{key}: {value} is not between {min} and {max}")]
    OutOfRange {
        /// The parameter.
        key: &'static str,
        /// What was given.
        value: String,
        /// The least that is allowed.
        min: Decimal,
        /// The most that is allowed.
        max: Decimal,
    },
    /// A word that is not one of the choices.
    #[error("{key}: '{value}' is none of {choices}")]
    UnknownChoice {
        /// The parameter.
        key: &'static str,
        /// What was given.
        value: String,
        /// The choices, with commas between.
        choices: String,
    },
    /// A text over its length.
    #[error("{key}: the text has {length} characters, at most {max} are allowed")]
    TooLong {
        /// The parameter, or `link` or `recipe` for the whole.
        key: &'static str,
        /// How long it was.
        length: usize,
        /// The most that is allowed.
        max: usize,
    },
    /// A text with control characters, or bytes that are no text at all.
    #[error("{key}: the text holds a character that cannot be shown")]
    NotText {
        /// The parameter.
        key: &'static str,
    },
    /// A text that is no outline.
    #[error("{key}: {reason}")]
    Outline {
        /// The parameter.
        key: &'static str,
        /// What is wrong with it, and where.
        reason: OutlineError,
    },
    /// A text that is no list of names.
    #[cfg(feature = "names")]
    #[error("{key}: {reason}")]
    Names {
        /// The parameter.
        key: &'static str,
        /// What is wrong with it.
        reason: NamesError,
    },
    /// No set of values has this name.
    #[error("there is no preset '{name}': choose from {names}")]
    UnknownPreset {
        /// What was given.
        name: String,
        /// The names there are, with commas between.
        names: String,
    },
    /// An edition that this program does not draw.
    #[error("edition: {value} is unknown here, this program draws edition {known}")]
    UnknownEdition {
        /// What was given.
        value: String,
        /// The edition that can be drawn.
        known: u32,
    },
    /// Text that is not JSON, or JSON that is neither a recipe nor a network.
    #[error("the recipe cannot be read: {reason}")]
    Json {
        /// What the JSON reader says, with line and column.
        reason: String,
    },
    /// A JSON value that is neither text nor number.
    #[error("{key}: a text or a number is wanted, not {found}")]
    JsonType {
        /// The parameter.
        key: String,
        /// What was found.
        found: &'static str,
    },
}
