//! A grown map, as Python holds it. No other file knows how the library keeps one.

use std::num::NonZero;
use std::sync::{PoisonError, RwLock, RwLockReadGuard};

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use riverseed::paint::{Painted, View};
use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::session::{Session, SessionError, Summary};

use crate::failure::{Done, Failure};
use crate::file::{self, Options};
use crate::order::{self, Parameters};
use crate::{names, network, relief, steps, values};

/// A finished map, which any number of threads may read at the same time.
#[pyclass(frozen, module = "riverseed._native")]
pub struct Map {
    /// Finished. Only its relief is made later, where the style shows none and a file wants it; that changes no other result.
    session: RwLock<Session>,
    summary: Summary,
}

impl Map {
    /// Grows a map to its end.
    fn grow(py: Python<'_>, link: &str, parameters: Parameters) -> PyResult<Self> {
        let recipe = order::recipe(link, parameters)?;
        let mut session = py.detach(|| Session::new(recipe)).map_err(Failure::from)?;
        steps::run(py, || Ok(session.advance(1)?))?;
        let summary = session.summary();
        Ok(Self { session: RwLock::new(session), summary })
    }

    /// Makes something of the map, without the interpreter's lock.
    pub fn read<T: Send>(&self, py: Python<'_>, make: impl FnOnce(&riverseed::Map) -> Done<T> + Send) -> PyResult<T> {
        Ok(py.detach(|| make(&self.map()?))?)
    }

    /// The map as it is now, with its relief if that has been made.
    fn map(&self) -> Done<riverseed::Map> {
        self.session().map().ok_or_else(|| Failure::Refused("the map is not finished".into()))
    }

    /// Raises the relief, in a style that shows none too. It is made once. The map is locked for one step at a time and never while signals
    /// are heard, so a signal's handler may use it; threads that want the relief at the same time share the steps.
    pub fn raise_relief(&self, py: Python<'_>) -> PyResult<()> {
        steps::run(py, || Ok(self.session.write().unwrap_or_else(PoisonError::into_inner).raise_relief()?))
    }

    /// Paints a picture whose longer side has this many pixels.
    pub fn paint(&self, py: Python<'_>, size: u32, ratio: f32) -> PyResult<Picture> {
        let mut picture = self.read(py, |map| {
            let (width, height) = View::sides_for(&map.domain(), size);
            Ok(Picture::new(width, height)?.with_ratio(ratio))
        })?;
        let map = self.map()?;
        py.detach(|| picture.refine(&map, NonZero::<usize>::MIN).map_err(SessionError::from)).map_err(Failure::from)?;
        steps::run(py, || Ok(picture.paint_map_part(&map) == Painted::Part))?;
        Ok(picture)
    }

    /// No step leaves a session half changed, so that one is whole even if a thread has panicked.
    fn session(&self) -> RwLockReadGuard<'_, Session> {
        self.session.read().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Grows a map.
#[pyfunction]
pub fn grow(py: Python<'_>, link: &str, parameters: Parameters) -> PyResult<Map> {
    Map::grow(py, link, parameters)
}

/// The members of `riverseed.Map`, each made anew whenever it is asked for.
#[pymethods]
impl Map {
    fn file<'py>(
        &self,
        py: Python<'py>,
        form: &str,
        size: Option<u32>,
        ratio: Option<f32>,
        raster_size: Option<u32>,
        svg_text: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let options = Options::read(form, size, ratio, raster_size, svg_text)?;
        file::bytes(py, self, &options).map(|bytes| PyBytes::new(py, &bytes))
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

    fn names<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        names::list(py, self)
    }

    fn relief<'py>(&self, py: Python<'py>, raster_size: Option<u32>) -> PyResult<Bound<'py, PyDict>> {
        relief::cells(py, self, raster_size)
    }
}
