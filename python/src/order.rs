//! The arguments of a call: a link, and parameters that override it.

use std::ffi::CString;

use pyo3::PyTypeInfo;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::recipe::{Recipe, given, link};

use crate::failure::Failure;
use crate::values;

/// Names of parameters and the texts of their values.
pub type Parameters = Vec<(String, String)>;

/// Reads a link, an address or a word, then parameters, which override it. A preset among these comes before both, as on the
/// command line. Warns of what had to be mended.
pub fn recipe(py: Python<'_>, link: &str, parameters: Parameters) -> PyResult<Recipe> {
    let (presets, parameters): (Vec<_>, Vec<_>) = parameters.into_iter().partition(|(name, _)| name == link::PRESET);
    let is_address = |(name, value): &(String, String)| name == "seed" && given::is_address(value);
    let (addresses, parameters): (Vec<_>, Vec<_>) = parameters.into_iter().partition(is_address);
    // An address in place of the seed is a whole link.
    let link = addresses.first().map_or(link, |(_, address)| address);
    let parts = [presets, handed_over(py, link)?, parameters];
    Ok(parts.iter().try_fold(Recipe::default(), |recipe, pairs| link::apply(recipe, pairs)).map_err(Failure::from)?)
}

/// Reads what was handed over as a link.
fn handed_over(py: Python<'_>, text: &str) -> PyResult<Parameters> {
    /// The caller of the package's function.
    const CALLER: i32 = 2;
    let (pairs, notices) = given::pairs(text).map_err(Failure::from)?;
    for notice in notices {
        let message = CString::new(notice.message).unwrap_or_default();
        PyErr::warn(py, &PyUserWarning::type_object(py), &message, CALLER)?;
    }
    Ok(pairs)
}

/// Reads a recipe and grows nothing: its canonical link, and the values of all parameters.
#[pyfunction]
pub fn read<'py>(py: Python<'py>, link: &str, parameters: Parameters) -> PyResult<(String, Bound<'py, PyDict>)> {
    let recipe = recipe(py, link, parameters)?;
    Ok((link::write(&recipe), values::of_recipe(py, &recipe)?))
}
