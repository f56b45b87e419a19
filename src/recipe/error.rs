//! Errors of recipes, worded so that they help to correct the recipe.

use thiserror::Error;

use super::names::NamesError;
use super::outline::OutlineError;
use super::value::Decimal;

/// A recipe that cannot be read. The message names the key, the value and the allowed range or words.
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
    /// A value that is not a number, for a parameter that takes one.
    #[error("{key}: '{value}' is not a number in plain digits")]
    NotANumber {
        /// The parameter.
        key: &'static str,
        /// The given text.
        value: String,
    },
    /// A value that is not a whole number, for a parameter that takes one.
    #[error("{key}: '{value}' is not a whole number")]
    NotWhole {
        /// The parameter.
        key: &'static str,
        /// The given text.
        value: String,
    },
    /// A number outside its range.
    #[error("{key}: {value} is not between {min} and {max}")]
    OutOfRange {
        /// The parameter.
        key: &'static str,
        /// The given text.
        value: String,
        /// The smallest allowed number.
        min: Decimal,
        /// The largest allowed number.
        max: Decimal,
    },
    /// A word that is not one of the choices.
    #[error("{key}: '{value}' is not one of {choices}")]
    UnknownChoice {
        /// The parameter.
        key: &'static str,
        /// The given text.
        value: String,
        /// The choices, separated by commas.
        choices: String,
    },
    /// A text that is too long.
    #[error("{key}: the text has {length} characters, at most {max} are allowed")]
    TooLong {
        /// The parameter, or `link` or `recipe` for the whole.
        key: &'static str,
        /// Its length in characters, or in bytes for a link or a recipe.
        length: usize,
        /// The greatest allowed length.
        max: usize,
    },
    /// A text with control characters, or bytes that are not text.
    #[error("{key}: the text holds a character that cannot be shown")]
    NotText {
        /// The parameter.
        key: &'static str,
    },
    /// A text that is not an outline.
    #[error("{key}: {reason}")]
    Outline {
        /// The parameter.
        key: &'static str,
        /// The fault and its place in the text.
        reason: OutlineError,
    },
    /// A text that is not a list of names.
    #[error("{key}: {reason}")]
    Names {
        /// The parameter.
        key: &'static str,
        /// The fault.
        reason: NamesError,
    },
    /// No preset has this name.
    #[error("there is no preset '{name}': choose from {names}")]
    UnknownPreset {
        /// The given name.
        name: String,
        /// The names of all presets, separated by commas.
        names: String,
    },
    /// An edition that this version does not draw.
    #[error("edition: {value} is unknown here, this program draws edition {known}")]
    UnknownEdition {
        /// The given text.
        value: String,
        /// The edition that it draws.
        known: u32,
    },
    /// Text that is not JSON, or JSON that is neither a recipe nor a network.
    #[error("the recipe cannot be read: {reason}")]
    Json {
        /// The JSON reader's message, with line and column.
        reason: String,
    },
    /// A JSON value that is neither text nor a number.
    #[error("{key}: a text or a number is wanted, not {found}")]
    JsonType {
        /// The parameter.
        key: String,
        /// The type that was found.
        found: &'static str,
    },
}
