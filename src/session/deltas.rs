//! The deltas at the mouths of a session's rivers. They are made once the rivers are finished, and kept until those change.

use std::sync::Arc;

use super::{Generation, Session, SessionError};
use crate::deltas::{DeltaMaker, DeltaSettings, Deltas, Distributary, Sediment, Shore};
use crate::land::{CoastDistance, Land};
use crate::network::{Network, Shaping};
use crate::recipe::NumberKey;
use crate::relief::ReliefError;

/// The deltas of a session, as far as they are made. A copy shares those that are finished, and makes others again.
#[derive(Debug, Default)]
pub(super) struct DeltaStage {
    maker: Option<Box<DeltaMaker>>,
    made: Option<Shore>,
    /// Those of the same tree's rivers before a change, which pictures show until there are others.
    former: Option<Shore>,
}

impl Clone for DeltaStage {
    fn clone(&self) -> Self {
        Self { maker: None, made: self.made.clone(), former: self.former.clone() }
    }
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
        if self.is_made() {
            return Ok(());
        }
        let Some(maker) = &mut self.maker else {
            self.maker = settings().map(|settings| DeltaMaker::new(settings, land.clone()).into());
            return Ok(());
        };
        if let Some(shore) = maker.step(network).map_err(refused)? {
            *self = Self { made: Some(shore), ..Self::default() };
        }
        Ok(())
    }

    /// Begins anew, because rivers have changed. What they had built is still shown.
    pub fn renew(&mut self) {
        *self = Self { former: self.made.take().or(self.former.take()), ..Self::default() };
    }

    /// Forgets all deltas, because there are none, or because other rivers will grow.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Returns `true` once they are made.
    pub fn is_made(&self) -> bool {
        self.made.is_some()
    }

    /// Returns the deltas, or `None` until they are made.
    pub fn deltas(&self) -> Option<&Arc<Deltas>> {
        self.made.as_ref().map(|shore| &shore.deltas)
    }

    /// Returns the land with deltas, or `None` until they are made.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.made.as_ref().map(|shore| &shore.land)
    }

    /// Returns the distance into flat ground that rivers have laid; `None` if there is none.
    pub fn flats(&self) -> Option<&Arc<CoastDistance>> {
        self.made.as_ref().and_then(|shore| shore.flats.as_ref())
    }

    /// Returns the rivers, if some of them run on over new land.
    pub fn network(&self) -> Option<&Arc<Network>> {
        self.made.as_ref().and_then(|shore| shore.network.as_ref())
    }

    /// Returns the deltas that pictures show, and the land with them: those of the rivers before until there are others.
    pub fn shown(&self) -> Option<(&Deltas, &Arc<Land>)> {
        self.made.as_ref().or(self.former.as_ref()).map(|shore| (&*shore.deltas, &shore.land))
    }
}

impl Session {
    /// Returns the deltas of rivers; `None` until they are made.
    pub fn deltas(&self) -> Option<&Arc<Deltas>> {
        self.deltas.deltas()
    }

    /// Returns the land and the branches of rivers that a picture shows. While the rivers of a tree are made again, their deltas
    /// stay as they were.
    pub(crate) fn shown_shore(&self) -> (Option<&Arc<Land>>, &[Distributary]) {
        let (deltas, land) = self.deltas.shown().unzip();
        (land.or(self.coasts.land()), deltas.map_or(&[], |deltas| &deltas.distributaries))
    }

    /// Returns `true` if rivers build deltas that have not been made yet.
    pub(super) fn lacks_deltas(&self) -> bool {
        self.has_deltas() && !self.deltas.is_made()
    }

    /// Returns `true` if rivers build deltas: there is a coast, and they carry sediment.
    pub(super) fn has_deltas(&self) -> bool {
        self.recipe.number(NumberKey::Deltas) > 0.0 && self.coasts.land().is_some()
    }

    /// Makes a step of the deltas of finished rivers.
    pub(super) fn build_deltas(&mut self) -> Result<(), SessionError> {
        let Some(land) = self.coasts.land() else { return Ok(()) };
        let (recipe, coasts, growth) = (&self.recipe, &self.coasts, &self.growth);
        let settings = || {
            let silted = coasts.silted();
            Some(DeltaSettings {
                sediment: Sediment::of(recipe)?,
                waves: recipe.number(NumberKey::Waves),
                total_discharge: growth.total_discharge(),
                loads: silted.map(|silted| silted.loads.clone()),
                plains: silted.map(|silted| silted.plains.clone()).unwrap_or_default(),
            })
        };
        let rivers =
            self.shaping.as_ref().and_then(Shaping::meander).map_or(Network::EMPTY, |meander| &**meander.drawn());
        self.deltas.step(rivers, land, settings)?;
        if self.deltas.is_made() {
            // There is another land now.
            self.generation = Generation::next();
        }
        Ok(())
    }
}
