//! `riverseed.relief`: heights, flow, basins and rivers on the cells of a map.

use numpy::{Element, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::relief::METRES;

use crate::form::{check_raster_size, rasters};
use crate::map;
use crate::network::array;
use crate::order::{self, Parameters};

/// Makes the arrays of a relief, by the names of the fields of `riverseed.Relief`.
#[pyfunction]
pub fn relief<'py>(
    py: Python<'py>,
    link: &str,
    parameters: Parameters,
    raster_size: Option<u32>,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = order::recipe(link, parameters)?;
    check_raster_size(&recipe, raster_size)?;
    let mut session = map::grow(py, recipe)?;
    let rasters = rasters(py, &mut session, raster_size)?;
    let columns = py.detach(|| Columns::of(&rasters));
    let sides = [rasters.rows, rasters.columns];
    let fields = PyDict::new(py);
    fields.set_item("link", &rasters.link)?;
    fields.set_item("size", (rasters.size.x, rasters.size.y))?;
    fields.set_item("cell_size", rasters.cell_size)?;
    fields.set_item("heights", grid(py, columns.heights, sides)?)?;
    fields.set_item("widths", grid(py, columns.widths, sides)?)?;
    fields.set_item("flow", grid(py, columns.flow, sides)?)?;
    fields.set_item("basins", grid(py, columns.basins, sides)?)?;
    Ok(fields)
}

/// What is known of each cell, row by row.
struct Columns {
    heights: Vec<f32>,
    widths: Vec<f32>,
    flow: Vec<u8>,
    basins: Vec<u32>,
}

impl Columns {
    fn of(rasters: &Rasters) -> Self {
        Self {
            heights: rasters.relief().heights().iter().map(|height| height * METRES).collect(),
            widths: widths(rasters),
            flow: rasters.flow().directions.clone(),
            basins: rasters.flow().basins.clone(),
        }
    }
}

/// Widths of rivers in units, of the thousandths that files have.
fn widths(rasters: &Rasters) -> Vec<f32> {
    match rasters.values(Layer::Rivers) {
        Values::Words(thousandths) => thousandths.into_iter().map(|width| f32::from(width) / 1000.0).collect(),
        Values::Bytes(_) => Vec::new(),
    }
}

/// A list as rows of an array of the same memory.
fn grid<T: Element>(py: Python<'_>, cells: Vec<T>, sides: [usize; 2]) -> PyResult<Bound<'_, PyArray2<T>>> {
    array(py, cells).reshape(sides)
}
