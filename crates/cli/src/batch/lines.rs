//! Lines on standard output, in the order of the seeds whatever the threads.

use std::io::{self, Write};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Whose turn it is to write. Who is ahead waits, so no more lines are in memory than there are threads.
#[derive(Default)]
pub struct Lines {
    /// The place of the next line; `CLOSED` if there is none any more.
    next: Mutex<u64>,
    has_passed: Condvar,
}

/// The turn of a map; it passes when this is dropped, written or not. Every place has to be given one, or the others wait for ever.
pub struct Turn<'a> {
    lines: &'a Lines,
    place: u64,
}

/// Behind all places: nobody waits.
const CLOSED: u64 = u64::MAX;

impl Lines {
    /// The turn of the map in a place.
    pub fn turn(&self, place: u64) -> Turn<'_> {
        Turn { lines: self, place }
    }

    /// Leaves all lines out that have not been written.
    pub fn close(&self) {
        *self.next() = CLOSED;
        self.has_passed.notify_all();
    }

    /// Whether lines are still written.
    pub fn is_open(&self) -> bool {
        *self.next() != CLOSED
    }

    fn next(&self) -> MutexGuard<'_, u64> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Turn<'_> {
    /// Waits for its turn, and writes, whole as far as it is for the reader to say; nothing if lines are closed.
    ///
    /// # Errors
    /// Those of standard output.
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
