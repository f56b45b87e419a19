//! What a session's relief would be by another recipe, nearly, or its land, for a moment: while a slider moves.

use std::sync::Arc;

use super::{Phase, Session};
use crate::land::Land;
use crate::recipe::{Key, Recipe};
use crate::relief::{Relief, ReliefDrafts};

/// Drafts of the relief and the land of one session, and what they are made of.
#[derive(Clone, Debug, Default)]
pub(crate) struct SessionDrafts {
    /// The last relief that was seen solved, with its recipe.
    base: Option<(Recipe, Arc<ReliefDrafts>)>,
    /// The last draft, with its mountains and plains.
    last: Option<([f32; 2], Arc<Relief>)>,
    /// The last land, with its recipe.
    land: Option<(Recipe, Arc<Land>)>,
}

impl SessionDrafts {
    /// Looks at the relief of a session that is finished, unless it has. Returns whether it did; `None` if there can be no draft by another
    /// recipe: because it is another in more than mountains or plains, or because no relief of these rivers was seen solved.
    pub fn prepare(&mut self, session: &Session, wanted: &Recipe) -> Option<bool> {
        let recipe = session.recipe();
        if !recipe.differs_in(wanted, &OF_RELIEF) || !matches!(session.phase(), Phase::Relief | Phase::Finished) {
            return None;
        }
        if let Some(relief) = session.relief()
            && self.base.as_ref().is_none_or(|(of, _)| of != recipe)
        {
            (self.base, self.last) = (None, None);
            let map = session.map()?;
            let drafts = ReliefDrafts::new(relief, map.network(), map.relief_settings()).ok()?;
            self.base = Some((recipe.clone(), drafts.into()));
            return Some(true);
        }
        self.base.as_ref().is_some_and(|(of, _)| of.differs_in(wanted, &OF_RELIEF)).then_some(false)
    }

    /// The relief of the session for which that was prepared, by the other recipe: of its own the very one, if it is solved.
    pub fn relief(&mut self, session: &Session, wanted: &Recipe) -> Option<Arc<Relief>> {
        let (of, drafts) = self.base.as_ref()?;
        if let Some(relief) = session.relief().filter(|_| of == wanted) {
            return Some(relief.clone());
        }
        let [mountains, plains] = OF_RELIEF.map(|key| wanted.number(key));
        if self.last.as_ref().is_none_or(|(of, _)| *of != [mountains, plains]) {
            self.last = None;
            self.last = Some(([mountains, plains], drafts.draft(mountains, plains).ok()?.into()));
        }
        self.last.as_ref().map(|(_, relief)| relief.clone())
    }

    /// Nearly the land of a recipe that differs from the session's in its coasts alone; of its own, the very one. `None` if it differs in more, if
    /// there is no sea, or if the session's land is none of its recipe's.
    pub fn land(&mut self, session: &Session, wanted: &Recipe) -> Option<Arc<Land>> {
        let own =
            session.land().filter(|_| !session.is_land_given && session.recipe().differs_in(wanted, &OF_COASTS))?;
        if session.recipe() == wanted {
            return Some(own.clone());
        }
        if self.land.as_ref().is_none_or(|(of, _)| of != wanted) {
            self.land = Land::draft_of(wanted).map(|land| (wanted.clone(), land));
        }
        self.land.as_ref().map(|(_, land)| land.clone())
    }
}

pub(crate) const OF_RELIEF: [Key; 2] = [Key::Mountains, Key::Plains];
pub(crate) const OF_COASTS: [Key; 2] = [Key::Sea, Key::Roughness];
