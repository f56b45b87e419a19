//! A map in the making: the steps of its session, its relief and its picture.

use pyo3::prelude::*;
use riverseed::domain::Domain;
use riverseed::paint::{Painted, View};
use riverseed::picture::Picture;
use riverseed::recipe::Recipe;
use riverseed::session::Session;

use crate::failure::{Done, Failure};
use crate::steps;

/// Grows a recipe to its end.
pub fn grow(py: Python<'_>, recipe: Recipe) -> PyResult<Session> {
    let mut session = py.detach(|| Session::new(recipe)).map_err(Failure::from)?;
    steps::run(py, || Ok(session.advance(1)?))?;
    Ok(session)
}

/// Raises the relief of a finished map, also where its style shows none.
pub fn raise_relief(py: Python<'_>, session: &mut Session) -> PyResult<()> {
    steps::run(py, || Ok(session.raise_relief()?))
}

/// Room for a picture whose longer side is that long.
pub fn picture(recipe: &Recipe, size: u32, ratio: f32) -> Done<Picture> {
    let (width, height) = View::sides_for(&Domain::of(recipe), size);
    Ok(Picture::new(width, height)?.with_ratio(ratio))
}

/// Paints a finished map.
pub fn paint(py: Python<'_>, picture: &mut Picture, session: &Session) -> PyResult<()> {
    steps::run(py, || Ok(matches!(picture.paint_part(session), Painted::Part)))
}
