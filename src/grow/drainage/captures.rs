//! Captures of streams: the parcels that drain differently after a round than before it.

use super::directions::FlowDirections;
use crate::base::memory::{self, Refused};
use crate::tree::NO_PARENT;

/// A parcel that drains differently after a round than before it. Parcels are numbered as
/// [`Growth::scattered`](crate::grow::Growth::scattered) lists them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capture {
    /// The round that changed it, from 1. Round 0 is the one in which the tree grows.
    pub round: u32,
    /// The parcel.
    pub parcel: u32,
    /// The parcel that it drained to before; [`NO_PARENT`] for the sea.
    pub from: u32,
    /// The parcel that it drains to from then on; [`NO_PARENT`] for the sea.
    pub to: u32,
}

/// All captures so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Captures {
    /// The captures in the order of rounds, and within a round in the order of parcels.
    pub list: Vec<Capture>,
    /// The parcel that each parcel drained to after the last round.
    ways: Vec<u32>,
}

impl Captures {
    /// Records how parcels drain after a round.
    pub fn note(&mut self, round: u32, directions: FlowDirections) -> Result<(), Refused> {
        let before = std::mem::replace(&mut self.ways, directions.to);
        let changed = || (0..).zip(before.iter().zip(&self.ways)).filter(|(_, (from, to))| from != to);
        memory::reserve(&mut self.list, changed().count())?;
        let receiver = |way: u32| if way == FlowDirections::OUT { NO_PARENT } else { way };
        let capture = |(parcel, (&from, &to)): (u32, (&u32, &u32))| Capture {
            round,
            parcel,
            from: receiver(from),
            to: receiver(to),
        };
        self.list.extend(changed().map(capture));
        Ok(())
    }
}
