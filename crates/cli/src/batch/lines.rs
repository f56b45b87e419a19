//! Lines on standard output, in the order of the seeds, whichever thread makes them.

use std::io::{self, Write};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// The turns of writing. Threads that are ahead wait, so there are never more lines in memory than threads.
#[derive(Default)]
pub struct Lines {
    /// The place of the next line; `CLOSED` if there are no more.
    next: Mutex<u64>,
    has_passed: Condvar,
}

/// The turn of a map. It passes when this is dropped, whether or not a line was written. Every place needs one;
/// otherwise the others wait for ever.
pub struct Turn<'a> {
    lines: &'a Lines,
    place: u64,
}

/// A place beyond all others, so that nobody waits.
const CLOSED: u64 = u64::MAX;

impl Lines {
    /// Returns the turn of the map in a place.
    pub fn turn(&self, place: u64) -> Turn<'_> {
        Turn { lines: self, place }
    }

    /// Drops all lines that have not been written.
    pub fn close(&self) {
        *self.next() = CLOSED;
        self.has_passed.notify_all();
    }

    /// Returns `true` while lines are written.
    pub fn is_open(&self) -> bool {
        *self.next() != CLOSED
    }

    fn next(&self) -> MutexGuard<'_, u64> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Turn<'_> {
    /// Waits for the turn and writes a line; does nothing if lines are closed.
    ///
    /// # Errors
    /// Fails with the errors of standard output.
    pub fn write(self, line: &[u8]) -> io::Result<()> {
        if *self.wait() == CLOSED {
            return Ok(());
        }
        let mut out = io::stdout().lock();
        out.write_all(line)?;
        out.flush()
    }

    fn wait(&self) -> MutexGuard<'_, u64> {
        let waited = self.lines.has_passed.wait_while(self.lines.next(), |next| *next < self.place);
        waited.unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        let mut next = self.wait();
        *next = next.saturating_add(1);
        self.lines.has_passed.notify_all();
    }
}
