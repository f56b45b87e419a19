//! Long work, step by step: without the interpreter's lock, so that other threads go on, and with an ear for signals, so that a person
//! who presses Ctrl+C is heard.

use std::time::Duration;
#[expect(clippy::disallowed_types, reason = "how long a person waits to be heard; no step depends on it")]
use std::time::Instant;

use pyo3::prelude::*;

use crate::failure::Done;

/// How long signals wait at most, but for a step that takes longer.
const MOMENT: Duration = Duration::from_millis(50);

/// Makes step after step until one says that there is no more to do.
///
/// # Errors
/// That of a step, or of the handler of a signal, `KeyboardInterrupt` for one.
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
