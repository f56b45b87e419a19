//! The names of a map but those of rivers, in the order of the JSON form.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::annotate::names::Names;
use riverseed::glam::Vec2;

use crate::arrays::put_rows;
use crate::map::Map;

/// Makes the fields of each `riverseed.Name`.
pub fn list<'py>(py: Python<'py>, map: &Map) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let Names { reaches, places, title, .. } = map.read(py, |map| Ok(Names::of(map)))?;
    let title = std::iter::once(name(py, "title", None, title, &[]));
    let reaches = reaches.into_iter().map(|reach| name(py, "reach", Some(reach.identity), reach.name, &reach.course));
    let places =
        places.into_iter().map(|place| name(py, place.kind.word(), Some(place.number), place.name, &[place.at]));
    title.chain(reaches).chain(places).collect()
}

fn name<'py>(
    py: Python<'py>,
    kind: &str,
    identity: Option<u32>,
    text: String,
    points: &[Vec2],
) -> PyResult<Bound<'py, PyDict>> {
    let fields = PyDict::new(py);
    fields.set_item("kind", kind)?;
    fields.set_item("identity", identity)?;
    fields.set_item("text", Some(text).filter(|text| !text.is_empty()))?;
    put_rows(&fields, "points", points.iter().flat_map(|at| at.to_array()).collect(), 2)?;
    Ok(fields)
}
