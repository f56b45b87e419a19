//! The members of `riverseed.Map`.

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use riverseed::recipe::link;
use riverseed::scale::{MapScale, figures};

use crate::map::Map;
use crate::order::Parameters;
use crate::{file, lakes, names, network, relief, values};

/// Grows a map.
#[pyfunction]
pub fn grow(py: Python<'_>, link: &str, parameters: Parameters) -> PyResult<Map> {
    Map::grow(py, link, parameters)
}

/// The members of `riverseed.Map`, each made anew whenever it is asked for.
#[pymethods]
impl Map {
    fn file<'py>(&self, py: Python<'py>, form: &str, options: file::Given) -> PyResult<Bound<'py, PyBytes>> {
        let options = options.read()?;
        let bytes = file::bytes(py, self, file::read(form, &options)?, options)?;
        Ok(PyBytes::new(py, &bytes))
    }

    fn link(&self, py: Python<'_>) -> PyResult<String> {
        self.read(py, |map| Ok(link::write(map.recipe())))
    }

    fn recipe<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        values::of_recipe(py, self.session().recipe())
    }

    fn size(&self) -> (f32, f32) {
        self.session().domain().size.into()
    }

    fn scale(&self) -> (f64, f32) {
        let scale = MapScale::of(self.session().recipe());
        (scale.metres_a_unit, scale.metres_up)
    }

    /// Writes a length as the map does, from units: in kilometres.
    fn kilometres(&self, units: f32) -> String {
        figures(MapScale::of(self.session().recipe()).kilometres(units))
    }

    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        values::of_summary(py, &self.summary)
    }

    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        network::measures(py, self)
    }

    fn nodes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        network::nodes(py, self)
    }

    fn rivers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        network::rivers(py, self)
    }

    fn oxbows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        network::oxbows(py, self)
    }

    fn distributaries<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        network::distributaries(py, self)
    }

    fn lakes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        lakes::lakes(py, self)
    }

    fn names<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        names::list(py, self)
    }

    fn relief<'py>(&self, py: Python<'py>, raster_size: Option<u32>) -> PyResult<Bound<'py, PyDict>> {
        relief::cells(py, self, raster_size)
    }
}
