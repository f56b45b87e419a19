//! The arguments of a call: a link, and parameters that override it.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::recipe::{Recipe, link};

use crate::failure::Done;
use crate::values;

/// Names of parameters and the texts of their values.
pub type Parameters = Vec<(String, String)>;

/// Reads a link, then parameters, which override it. A preset among these comes before both, as on the command line.
pub fn recipe(link: &str, parameters: Parameters) -> Done<Recipe> {
    let (presets, parameters): (Vec<_>, Vec<_>) = parameters.into_iter().partition(|(name, _)| name == link::PRESET);
    let parts = [presets, link::pairs(link)?, parameters];
    Ok(parts.iter().try_fold(Recipe::default(), |recipe, pairs| link::apply(recipe, pairs))?)
}

/// Reads a recipe and grows nothing: its canonical link, and the values of all parameters.
#[pyfunction]
pub fn read<'py>(py: Python<'py>, link: &str, parameters: Parameters) -> PyResult<(String, Bound<'py, PyDict>)> {
    let recipe = recipe(link, parameters)?;
    Ok((link::write(&recipe), values::of_recipe(py, &recipe)?))
}
