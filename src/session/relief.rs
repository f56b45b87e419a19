//! The relief of a session's rivers, and the lakes on it. It is made once a style shows it, lakes lie on it or a file needs it, and
//! kept until the rivers change.

use std::sync::Arc;

use crate::lakes::{LakeMaker, Lakes};
use crate::network::Network;
use crate::relief::{Relief, ReliefError, ReliefSettings, ReliefSolver};

/// The state of the relief. A copy shares what is finished, and makes again what is not.
#[derive(Debug, Default)]
pub(super) enum ReliefStage {
    /// Not needed so far.
    #[default]
    Waiting,
    Solving(Box<ReliefSolver>),
    Solved(Arc<Relief>, LakeStage),
}

/// The state of the lakes on a relief.
#[derive(Debug, Default)]
pub(super) enum LakeStage {
    #[default]
    Waiting,
    /// The solver of the relief knows the ways of water.
    Begun(Box<ReliefSolver>),
    Making(Box<LakeMaker>),
    Made(Arc<Lakes>),
}

impl Clone for ReliefStage {
    fn clone(&self) -> Self {
        match self {
            Self::Waiting | Self::Solving(_) => Self::Waiting,
            Self::Solved(relief, LakeStage::Made(lakes)) => {
                Self::Solved(relief.clone(), LakeStage::Made(lakes.clone()))
            }
            Self::Solved(relief, _) => Self::Solved(relief.clone(), LakeStage::Waiting),
        }
    }
}

impl ReliefStage {
    /// Makes a step. If there is not enough memory, the next call tries it again. `lakes` begins those that the recipe asks for;
    /// `None` if it asks for none.
    pub fn step(
        &mut self,
        network: &Network,
        settings: impl FnOnce() -> ReliefSettings,
        lakes: impl FnOnce() -> Option<LakeMaker>,
    ) -> Result<(), ReliefError> {
        match self {
            Self::Waiting => *self = Self::Solving(ReliefSolver::new(network, settings())?.into()),
            Self::Solving(solver) => {
                let Some(relief) = solver.step(network)? else { return Ok(()) };
                let Self::Solving(solver) = std::mem::take(self) else { return Ok(()) };
                let lakes = if lakes().is_some() { LakeStage::Begun(solver) } else { LakeStage::begin(None) };
                *self = Self::Solved(relief.into(), lakes);
            }
            Self::Solved(relief, stage) => stage.step(relief, network, settings, lakes)?,
        }
        Ok(())
    }

    /// Drops the lakes, which are made again on the same relief.
    pub fn forget_lakes(&mut self) {
        if let Self::Solved(_, lakes) = self {
            *lakes = LakeStage::Waiting;
        }
    }

    /// Returns the relief, or `None` until it is solved.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        match self {
            Self::Solved(relief, _) => Some(relief),
            Self::Waiting | Self::Solving(_) => None,
        }
    }

    /// Returns the lakes, or `None` until they are made.
    pub fn lakes(&self) -> Option<&Arc<Lakes>> {
        match self {
            Self::Solved(_, LakeStage::Made(lakes)) => Some(lakes),
            _ => None,
        }
    }

    /// Returns the progress of the relief and its lakes, from 0 to 1, which it reaches with the last of them.
    pub fn progress(&self) -> f32 {
        /// The share of the relief.
        const RELIEF: f32 = 0.95;
        match self {
            Self::Waiting => 0.0,
            Self::Solving(solver) => RELIEF * solver.progress(),
            Self::Solved(_, LakeStage::Made(_)) => 1.0,
            Self::Solved(..) => RELIEF,
        }
    }
}

impl LakeStage {
    fn begin(lakes: Option<LakeMaker>) -> Self {
        lakes.map_or_else(|| Self::Made(Arc::default()), |lakes| Self::Making(lakes.into()))
    }

    fn step(
        &mut self,
        relief: &Relief,
        network: &Network,
        settings: impl FnOnce() -> ReliefSettings,
        lakes: impl FnOnce() -> Option<LakeMaker>,
    ) -> Result<(), ReliefError> {
        match self {
            Self::Waiting => *self = Self::begin(lakes()),
            Self::Begun(solver) => {
                let ways = solver.ways(network)?;
                *self = Self::begin(lakes().map(|lakes| lakes.along(ways)));
            }
            Self::Making(maker) => {
                if let Some(made) = maker.step(relief, network, settings)? {
                    *self = Self::Made(made.into());
                }
            }
            Self::Made(_) => {}
        }
        Ok(())
    }
}
