//! The deltas at the mouths of a session's rivers. They are made once the rivers are finished, and kept until those change.

use std::sync::Arc;

use crate::deltas::{DeltaMaker, DeltaSettings, Deltas, Shore};
use crate::land::{CoastDistance, Land};
use crate::network::Network;
use crate::relief::ReliefError;

/// The state of deltas.
#[derive(Clone, Debug, Default)]
pub(super) enum DeltaStage {
    /// Not begun, or not asked for.
    #[default]
    Waiting,
    Making(Box<DeltaMaker>),
    Made(Shore),
}

impl DeltaStage {
    /// Makes a step. If there is not enough memory, the next call tries it again.
    pub fn step(
        &mut self,
        network: &Network,
        land: &Arc<Land>,
        settings: impl FnOnce() -> Option<DeltaSettings>,
    ) -> Result<(), ReliefError> {
        let refused = |_| ReliefError::OutOfMemory { megabytes: DeltaMaker::MEGABYTES };
        match self {
            Self::Waiting => {
                if let Some(settings) = settings() {
                    *self = Self::Making(DeltaMaker::new(settings, land.clone()).into());
                }
            }
            Self::Making(maker) => {
                if let Some(shore) = maker.step(network).map_err(refused)? {
                    *self = Self::Made(shore);
                }
            }
            Self::Made(_) => {}
        }
        Ok(())
    }

    /// Returns `true` once they are made.
    pub fn is_made(&self) -> bool {
        self.shore().is_some()
    }

    fn shore(&self) -> Option<&Shore> {
        match self {
            Self::Made(shore) => Some(shore),
            Self::Waiting | Self::Making(_) => None,
        }
    }

    /// Returns the deltas, or `None` until they are made.
    pub fn deltas(&self) -> Option<&Arc<Deltas>> {
        self.shore().map(|shore| &shore.deltas)
    }

    /// Returns the land with deltas, or `None` until they are made.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.shore().map(|shore| &shore.land)
    }

    /// Returns the distance into flat ground that rivers have laid; `None` if there is none.
    pub fn flats(&self) -> Option<&Arc<CoastDistance>> {
        self.shore().and_then(|shore| shore.flats.as_ref())
    }

    /// Returns the rivers, if some of them run on over new land.
    pub fn network(&self) -> Option<&Arc<Network>> {
        self.shore().and_then(|shore| shore.network.as_ref())
    }

    /// Returns the approximate memory of a copy of this state, in bytes. What is made is shared.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Making(maker) => maker.bytes(),
            Self::Waiting | Self::Made(_) => 0,
        }
    }
}
