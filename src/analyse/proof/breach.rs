//! A place where a promise is broken, in words.

use glam::Vec2;

use crate::scale::MapScale;

/// A place where a promise is broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breach {
    /// The index of the river.
    pub river: u32,
    /// The place, in units.
    pub at: Vec2,
    /// What is wrong there.
    pub fault: Fault,
}

/// What is wrong at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fault {
    /// The ground does not fall along the river: the next cell is so many units higher, 0 if it is level.
    Rises(f32),
    /// The river crosses another one, or itself.
    Crosses {
        /// The index of the other river.
        other: u32,
    },
    /// The river ends so many units from the course of the river that it joins.
    Detached(f32),
    /// A branch of the river begins so many units from where it should.
    Parted(f32),
    /// The mouth lies so many units from the coast: positive inland, negative in the sea.
    OffCoast(f32),
    /// The river joins none and has no mouth, or comes back to itself.
    Lost,
    /// The river carries less than what flows into it there.
    Carries {
        /// Its discharge below the place.
        discharge: u32,
        /// The sum of the discharges right above.
        inflow: u64,
    },
    /// Strahler's order at the river's end is another than a count from the sources finds.
    Order {
        /// The order that it has.
        has: u8,
        /// The order that was counted.
        counted: u8,
    },
    /// The magnitude at the river's end is another than the number of sources.
    Magnitude {
        /// The magnitude that it has.
        has: u32,
        /// The number of sources.
        counted: u32,
    },
}

impl Fault {
    /// Tells the fault in words that follow the river's name, with lengths and heights in metres.
    pub fn told(&self, scale: &MapScale) -> String {
        match *self {
            Self::Rises(up) => format!("rises by {:.2} m", up * scale.metres_up),
            Self::Crosses { other } => format!("crosses river {other}"),
            Self::Detached(far) => format!("ends {:.0} m from the river that it joins", scale.metres(far)),
            Self::Parted(far) => format!("has a branch that begins {:.0} m away", scale.metres(far)),
            Self::OffCoast(inland) if inland < 0.0 => format!("ends {:.0} m out in the sea", scale.metres(-inland)),
            Self::OffCoast(inland) => format!("ends {:.0} m inland", scale.metres(inland)),
            Self::Lost => "comes to no mouth".into(),
            Self::Carries { discharge, inflow } => format!("carries {discharge}, and {inflow} flow into it"),
            Self::Order { has, counted } => format!("has order {has}, not {counted}"),
            Self::Magnitude { has, counted } => format!("has magnitude {has}, with {counted} sources"),
        }
    }
}
