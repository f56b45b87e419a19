//! Previews of a session's relief or land under another recipe, shown while a slider moves.

use std::sync::Arc;

use super::{Phase, Session};
use crate::drown::Drowning;
use crate::lakes::Lakes;
use crate::land::{CoastDistance, Land, LowStand};
use crate::recipe::{Key, NumberKey, Recipe};
use crate::relief::{Relief, ReliefDrafts};

/// Previews of one session's relief and land, with the data that they are made from.
#[derive(Clone, Debug, Default)]
pub(crate) struct SessionDrafts {
    /// The last solved relief that was seen, with its recipe, and the lakes on it.
    base: Option<(Recipe, Arc<ReliefDrafts>, Arc<Lakes>)>,
    /// The last preview, with its values of mountains and plains.
    last: Option<([f32; 2], Arc<Relief>)>,
    /// The last land, with its recipe.
    land: Option<(Recipe, Arc<Land>)>,
}

impl SessionDrafts {
    /// Stores the solved relief of a session as the base of previews. Returns `true` if it was stored now, `false` if
    /// the base was already there. `None` if no preview of the other recipe is possible: it differs in more than
    /// mountains and plains, or no solved relief of these rivers has been seen.
    pub fn prepare(&mut self, session: &Session, wanted: &Recipe) -> Option<bool> {
        let recipe = session.recipe();
        if !recipe.differs_in(wanted, &OF_RELIEF) || !matches!(session.phase(), Phase::Relief | Phase::Finished) {
            return None;
        }
        if let Some(relief) = session.relief()
            && self.base.as_ref().is_none_or(|(of, ..)| of != recipe)
        {
            (self.base, self.last) = (None, None);
            let map = session.map()?;
            let drafts = ReliefDrafts::new(relief, map.relief_settings()).ok()?;
            self.base = Some((recipe.clone(), drafts.into(), map.lakes().clone()));
            return Some(true);
        }
        self.base.as_ref().is_some_and(|(of, ..)| of.differs_in(wanted, &OF_RELIEF)).then_some(false)
    }

    /// Makes a preview of the relief under another recipe, for which `prepare` has been called; the exact relief, once
    /// it is solved, for the session's own recipe.
    pub fn relief(&mut self, session: &Session, wanted: &Recipe) -> Option<Arc<Relief>> {
        let (of, drafts, _) = self.base.as_ref()?;
        if let Some(relief) = session.relief().filter(|_| of == wanted) {
            return Some(relief.clone());
        }
        let [mountains, plains] = [NumberKey::Mountains, NumberKey::Plains].map(|key| wanted.number(key));
        if self.last.as_ref().is_none_or(|(of, _)| *of != [mountains, plains]) {
            self.last = None;
            self.last = Some(([mountains, plains], drafts.draft(mountains, plains).ok()?.into()));
        }
        self.last.as_ref().map(|(_, relief)| relief.clone())
    }

    /// Returns the lakes of a preview of the relief: those that were last seen. Where others will be is known once the relief is.
    pub fn lakes(&self) -> Option<&Arc<Lakes>> {
        self.base.as_ref().map(|(.., lakes)| lakes)
    }

    /// Makes a preview of the land under a recipe that differs from the session's in its coasts alone, over the valleys of its tree
    /// where the sea rises; the exact land for the session's own recipe. `None` if the recipe differs in more, if there is no sea, or
    /// if the session's land was given.
    pub fn land(&mut self, session: &Session, wanted: &Recipe) -> Option<Arc<Land>> {
        let has_draft = !session.coasts.are_given && session.recipe().differs_in(wanted, &OF_COASTS);
        let own = session.shown_shore().0.filter(|_| has_draft)?;
        if session.recipe() == wanted {
            return Some(own.clone());
        }
        if self.land.as_ref().is_none_or(|(of, _)| of != wanted) {
            let land = session.drowned_draft(wanted).or_else(|| Land::draft_of(wanted));
            self.land = land.map(|land| (wanted.clone(), land));
        }
        self.land.as_ref().map(|(_, land)| land.clone())
    }
}

impl Session {
    /// Approximates the land of a recipe with other coasts after the sea has risen: over the valleys of this session's
    /// tree, which does not grow anew. `None` if the sea does not rise, or there is not enough memory.
    fn drowned_draft(&self, wanted: &Recipe) -> Option<Arc<Land>> {
        let low_stand = Arc::new(LowStand::of(wanted, CoastDistance::SPACING)?);
        let mut drowning = match self.coasts.drowned() {
            Some((drowned, land)) => {
                Drowning::over(wanted, low_stand, drowned.valleys.with_unknown(land.coast_distance()).into())
            }
            None => Drowning::new(wanted, low_stand),
        };
        loop {
            if let Some(transgression) = drowning.step(self.tree()).ok()? {
                return Some(transgression.into_drowned().land);
            }
        }
    }
}

pub(crate) const OF_RELIEF: [Key; 2] = [Key::Mountains, Key::Plains];
pub(crate) const OF_COASTS: [Key; 3] = [Key::Sea, Key::Drowning, Key::Roughness];
