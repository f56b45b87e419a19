//! A grown map, as Python holds it. No other file knows how the library keeps one.

use std::sync::{PoisonError, RwLock, RwLockReadGuard};

use pyo3::prelude::*;
use riverseed::session::{Session, Summary};

use crate::failure::{Done, Failure};
use crate::order::{self, Parameters};
use crate::steps;

/// A finished map, which any number of threads may read at the same time.
#[pyclass(frozen, module = "riverseed._native")]
pub struct Map {
    /// Finished. Only its relief is made later, where the style shows none and a file wants it; that changes no other result.
    session: RwLock<Session>,
    pub(crate) summary: Summary,
}

impl Map {
    /// Grows a map to its end.
    pub fn grow(py: Python<'_>, link: &str, parameters: Parameters) -> PyResult<Self> {
        let recipe = order::recipe(py, link, parameters)?;
        let mut session = py.detach(|| Session::new(recipe)).map_err(Failure::from)?;
        steps::run(py, || Ok(session.advance(1)?))?;
        let summary = session.summary();
        Ok(Self { session: RwLock::new(session), summary })
    }

    /// Makes something of the map, without the interpreter's lock.
    pub fn read<T: Send>(&self, py: Python<'_>, make: impl FnOnce(&riverseed::Map) -> Done<T> + Send) -> PyResult<T> {
        Ok(py.detach(|| make(&self.map()?))?)
    }

    /// Returns the map as it is now, with its relief if that has been made.
    fn map(&self) -> Done<riverseed::Map> {
        self.session().map().ok_or_else(|| Failure::Refused("the map is not finished".into()))
    }

    /// Raises the relief, in a style that shows none too. It is made once. The map is locked for one step at a time and never while signals
    /// are heard, so a signal's handler may use it; threads that want the relief at the same time share the steps.
    pub fn raise_relief(&self, py: Python<'_>) -> PyResult<()> {
        steps::run(py, || Ok(self.session.write().unwrap_or_else(PoisonError::into_inner).raise_relief()?))
    }

    /// Borrows the session. No step leaves it half changed, so it is whole even if a thread has panicked.
    pub fn session(&self) -> RwLockReadGuard<'_, Session> {
        self.session.read().unwrap_or_else(PoisonError::into_inner)
    }
}
