//! Long work in steps. It runs without the interpreter's lock, so that other threads go on, and handles signals between
//! steps, so that Ctrl+C takes effect.

use std::time::Duration;
#[expect(clippy::disallowed_types, reason = "how long a person waits to be heard; no step depends on it")]
use std::time::Instant;

use pyo3::prelude::*;

use crate::failure::Done;

/// The greatest time that signals wait, apart from steps that take longer.
const MOMENT: Duration = Duration::from_millis(50);

/// Runs step after step until one returns that there is no more to do.
///
/// # Errors
/// Returns the error of a step, or that of a signal's handler, such as `KeyboardInterrupt`.
pub fn run(py: Python<'_>, mut step: impl FnMut() -> Done<bool> + Send) -> PyResult<()> {
    while py.detach(|| goes_on_after_a_moment(&mut step))? {
        py.check_signals()?;
    }
    py.check_signals()
}

fn goes_on_after_a_moment(step: &mut impl FnMut() -> Done<bool>) -> Done<bool> {
    #[expect(clippy::disallowed_types, reason = "as above")]
    let began = Instant::now();
    while step()? {
        if began.elapsed() >= MOMENT {
            return Ok(true);
        }
    }
    Ok(false)
}
