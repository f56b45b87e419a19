//! What a call asks for: a link, and parameters over it.

use riverseed::recipe::{Recipe, link};

use crate::failure::Done;

/// Names of parameters and the texts of their values.
pub type Parameters = Vec<(String, String)>;

/// Reads a link, then parameters, which override it. A preset among these comes before both, as on the command line.
pub fn recipe(link: &str, parameters: Parameters) -> Done<Recipe> {
    let (presets, parameters): (Vec<_>, Vec<_>) = parameters.into_iter().partition(|(name, _)| name == link::PRESET);
    let parts = [presets, link::pairs(link)?, parameters];
    Ok(parts.iter().try_fold(Recipe::default(), |recipe, pairs| link::apply(recipe, pairs))?)
}
