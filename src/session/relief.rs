//! The relief of a session's rivers. It is made once a style shows it or a file needs it, and kept until the rivers
//! change.

use std::sync::Arc;

use crate::network::Network;
use crate::relief::{Relief, ReliefError, ReliefSettings, ReliefSolver};

/// The state of the relief.
#[derive(Clone, Debug, Default)]
pub(super) enum ReliefStage {
    /// Not needed so far.
    #[default]
    Waiting,
    Solving(Box<ReliefSolver>),
    Solved(Arc<Relief>),
}

impl ReliefStage {
    /// Makes a step. If there is not enough memory, the next call tries it again.
    pub fn step(&mut self, network: &Network, settings: impl FnOnce() -> ReliefSettings) -> Result<(), ReliefError> {
        match self {
            Self::Waiting => *self = Self::Solving(ReliefSolver::new(network, settings())?.into()),
            Self::Solving(solver) => {
                if let Some(relief) = solver.step(network)? {
                    *self = Self::Solved(relief.into());
                }
            }
            Self::Solved(_) => {}
        }
        Ok(())
    }

    /// Returns the relief, or `None` until it is solved.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        match self {
            Self::Solved(relief) => Some(relief),
            Self::Waiting | Self::Solving(_) => None,
        }
    }

    /// Returns the progress of the relief, from 0 to 1.
    pub fn progress(&self) -> f32 {
        match self {
            Self::Waiting => 0.0,
            Self::Solving(solver) => solver.progress(),
            Self::Solved(_) => 1.0,
        }
    }

    /// Returns the approximate memory of a copy of this state, in bytes. A solved relief is shared.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Solving(solver) => solver.bytes(),
            Self::Waiting | Self::Solved(_) => 0,
        }
    }
}
