//! The ground under a front: how high it stands by now, and how steeply it rises.

/// The steepness of cells that the front does not enter: the sea, what lies beyond the map, and the ring.
pub(super) const CLOSED: f32 = f32::INFINITY;

/// A cell of a tile. Whoever looks at its height looks at its steepness, so they lie together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// The least height found so far.
    pub height: f32,
    /// The height by which it rises above a neighbour, in units; [`CLOSED`] where the front does not enter.
    pub rise: f32,
}

impl Ground {
    pub fn is_open(self) -> bool {
        self.rise < CLOSED
    }
}
