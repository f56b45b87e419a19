//! The amount of work done, in elementary steps: a bound on it limits how long a page waits, on any machine.
//!
//! An elementary step looks at one thing: a cell of land under a line, a cell of the index of attractors, a line piece or a
//! vertex of the index of lines, a move of a particle or a tile of the water around it. Whole loops are counted at once, so that
//! counting costs next to nothing, and it is always on: growth itself ends a search for a tick by it.

use std::cell::Cell;

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// How many elementary steps this thread has taken since it began. Only differences of it mean anything.
pub fn steps() -> u64 {
    STEPS.get()
}

/// Counts elementary steps that are being taken.
#[inline]
pub(crate) fn count(steps: usize) {
    STEPS.set(STEPS.get().wrapping_add(steps as u64));
}
