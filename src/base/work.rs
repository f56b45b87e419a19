//! The amount of work in elementary steps. A bound on it limits the time that a page waits, on any machine.
//!
//! An elementary step looks at one thing: a cell of land under a line, a cell of the index of attractors, a line piece
//! or a vertex of the index of lines, a move of a particle or a tile of the water around it. Whole loops are counted at
//! once, so counting costs next to nothing. It is always on, because growth itself uses it to limit the search in one
//! tick.

use std::cell::Cell;

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// Returns the number of elementary steps that this thread has taken since it began. Only differences are meaningful.
pub fn steps() -> u64 {
    STEPS.get()
}

/// Adds to the number of elementary steps.
#[inline(never)] // each copy weighs a hundred bytes
pub(crate) fn count(steps: usize) {
    STEPS.set(STEPS.get().wrapping_add(steps as u64));
}
