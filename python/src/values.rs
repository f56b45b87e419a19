//! The parameter table, the values of a recipe, and a map in numbers.

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::grow::Ending;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Kind, LONGEST_OUTLINE, Parameter, Recipe, Value};
use riverseed::session::{Shortfall, Summary};

/// Lists the parameter table: the fields of each `riverseed.Parameter`.
#[pyfunction]
pub fn parameters(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    TABLE.iter().map(|parameter| row(py, parameter)).collect()
}

fn row<'py>(py: Python<'py>, parameter: &Parameter) -> PyResult<Bound<'py, PyDict>> {
    let fields = PyDict::new(py);
    fields.set_item("name", parameter.name)?;
    fields.set_item("label", parameter.label)?;
    fields.set_item("help", parameter.help)?;
    fields.set_item("group", parameter.group)?;
    fields.set_item("unit", parameter.unit)?;
    fields.set_item("default", value(py, parameter, &parameter.default_value())?)?;
    let kind = match parameter.kind {
        Kind::Text { longest, .. } => {
            fields.set_item("longest", longest)?;
            "text"
        }
        Kind::Integer { min, max, .. } => {
            fields.set_item("minimum", min)?;
            fields.set_item("maximum", max)?;
            "integer"
        }
        Kind::Number { min, max, .. } => {
            fields.set_item("minimum", min.to_f64())?;
            fields.set_item("maximum", max.to_f64())?;
            "number"
        }
        Kind::Choice { choices, .. } => {
            let words = PyDict::new(py);
            choices.iter().try_for_each(|word| words.set_item(word.name, word.help))?;
            fields.set_item("choices", words)?;
            "choice"
        }
        Kind::Sides { .. } => "sides",
        Kind::Outline => {
            fields.set_item("longest", LONGEST_OUTLINE)?;
            "outline"
        }
    };
    fields.set_item("kind", kind)?;
    Ok(fields)
}

/// Returns all values of a recipe by the names of their parameters.
pub fn of_recipe<'py>(py: Python<'py>, recipe: &Recipe) -> PyResult<Bound<'py, PyDict>> {
    let values = PyDict::new(py);
    for parameter in &TABLE {
        values.set_item(parameter.name, value(py, parameter, recipe.value(parameter.key))?)?;
    }
    Ok(values)
}

/// Returns a number as a number, and anything else as its text in links.
fn value<'py>(py: Python<'py>, parameter: &Parameter, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Integer(number) => number.into_bound_py_any(py),
        Value::Number(number) => number.to_f64().into_bound_py_any(py),
        other => parameter.text_of(other).into_bound_py_any(py),
    }
}

/// Makes the fields of `riverseed.Summary`.
pub fn of_summary<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyDict>> {
    let shortfall = summary.shortfall().map(Shortfall::name);
    let fields = PyDict::new(py);
    fields.set_item("ticks", summary.ticks)?;
    fields.set_item("nodes", summary.nodes)?;
    fields.set_item("mouths", summary.mouths)?;
    fields.set_item("sources", summary.sources)?;
    fields.set_item("order", summary.order)?;
    fields.set_item("attractors", summary.attractors)?;
    fields.set_item("unreached", summary.unreached)?;
    fields.set_item("complete", summary.ending == Some(Ending::Complete))?;
    fields.set_item("rounds", summary.rounds)?;
    fields.set_item("oxbows", summary.oxbows)?;
    fields.set_item("shortfall", shortfall)?;
    Ok(fields)
}
