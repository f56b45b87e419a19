//! The relief of a map: heights, flow, basins and rivers on its cells.

use numpy::{Element, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::lakes::Lakes;
use riverseed::network::NONE;

use crate::arrays::{array, ask_for_memory, or_minus_one};
use crate::failure::{Done, Failure};
use crate::map::Map;

/// Makes the rasters of a map, on its own grid unless a longer side is asked for.
pub fn rasters(py: Python<'_>, map: &Map, size: Option<u32>) -> PyResult<Rasters> {
    let refused = |error| Failure::from(error).of_option("raster_size");
    // Before the relief is raised.
    map.read(py, |map| size.map_or(Ok(()), |size| Rasters::grid(&map.domain(), size).map(drop).map_err(refused)))?;
    map.raise_relief(py)?;
    map.read(py, |map| size.map_or_else(|| Rasters::new(map), |size| Rasters::with_size(map, size)).map_err(refused))
}

/// Makes the fields of `riverseed.Relief`.
pub fn cells<'py>(py: Python<'py>, map: &Map, raster_size: Option<u32>) -> PyResult<Bound<'py, PyDict>> {
    let rasters = rasters(py, map, raster_size)?;
    let lakes = map.read(py, |map| Ok(map.lakes().clone()))?;
    let columns = py.detach(|| Columns::of(&rasters, &lakes))?;
    let sides = [rasters.rows, rasters.columns];
    let fields = PyDict::new(py);
    fields.set_item("link", &rasters.link)?;
    fields.set_item("size", (rasters.size.x, rasters.size.y))?;
    fields.set_item("cell_size", rasters.cell_size)?;
    fields.set_item("heights", grid(py, columns.heights, sides)?)?;
    fields.set_item("depths", grid(py, columns.depths, sides)?)?;
    fields.set_item("lakes", grid(py, columns.lakes, sides)?)?;
    fields.set_item("widths", grid(py, columns.widths, sides)?)?;
    fields.set_item("flow", grid(py, columns.flow, sides)?)?;
    fields.set_item("basins", grid(py, columns.basins, sides)?)?;
    Ok(fields)
}

/// The columns of a map's cells, row by row.
struct Columns {
    heights: Vec<f32>,
    depths: Vec<f32>,
    lakes: Vec<i32>,
    widths: Vec<f32>,
    flow: Vec<u8>,
    basins: Vec<u32>,
}

impl Columns {
    fn of(rasters: &Rasters, lakes: &Lakes) -> Done<Self> {
        const BYTES_A_CELL: usize = 23;
        let cells = rasters.columns * rasters.rows;
        ask_for_memory(cells, BYTES_A_CELL)?;
        let metres_up = rasters.map_scale.metres_up;
        Ok(Self {
            heights: rasters.relief().heights().iter().map(|height| height * metres_up).collect(),
            depths: (0..cells).map(|cell| rasters.depth(cell) * metres_up).collect(),
            lakes: if lakes.is_empty() {
                vec![-1; cells]
            } else {
                or_minus_one(lakes.on(&rasters.relief().grid()), NONE)
            },
            widths: widths(rasters),
            flow: rasters.flow().directions.clone(),
            basins: rasters.flow().basins.clone(),
        })
    }
}

/// Returns the widths of rivers in units, in the thousandths that files have.
fn widths(rasters: &Rasters) -> Vec<f32> {
    match rasters.values(Layer::Rivers) {
        Values::Words(thousandths) => thousandths.into_iter().map(|width| f32::from(width) / 1000.0).collect(),
        Values::Bytes(_) => Vec::new(),
    }
}

/// Hands a list over as rows of an array of the same memory.
fn grid<T: Element>(py: Python<'_>, cells: Vec<T>, sides: [usize; 2]) -> PyResult<Bound<'_, PyArray2<T>>> {
    array(py, cells)?.reshape(sides)
}
