//! The coasts of a session: those that its tree is planted on, and those that the rising sea leaves.

use std::sync::Arc;

use crate::base::memory::Refused;
use crate::drown::{Drowned, Drowning, Silted, Transgression};
use crate::land::{CoastDistance, Land, LowStand};
use crate::recipe::Recipe;
use crate::relief::ReliefError;
use crate::tree::Tree;

/// The lands of a session. A copy shares them, and begins again to look for the level of the sea where that is not known.
#[derive(Debug)]
pub(super) struct Coasts {
    /// The land on which the tree grows; `None` if all of the domain is land.
    planted: Option<Arc<Land>>,
    /// `true` if the land was given instead of being shaped by the recipe.
    pub are_given: bool,
    /// The low stand from which the sea rises once the tree has grown; `None` if it does not.
    low_stand: Option<Arc<LowStand>>,
    rising: Option<Rise>,
    drowned: Option<Risen>,
}

/// The rise of the sea, in progress.
#[derive(Debug)]
enum Rise {
    /// The level is not known yet.
    Unknown(Box<Drowning>),
    /// The sea is on its way to the level.
    Seen(Transgression),
}

/// The coasts after the sea has risen.
#[derive(Clone, Debug)]
struct Risen {
    drowned: Drowned,
    from: Arc<CoastDistance>,
}

impl Clone for Coasts {
    fn clone(&self) -> Self {
        Self {
            planted: self.planted.clone(),
            are_given: self.are_given,
            low_stand: self.low_stand.clone(),
            rising: self.transgression().cloned().map(Rise::Seen),
            drowned: self.drowned.clone(),
        }
    }
}

impl Coasts {
    /// Shapes the coasts of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        let low_stand = LowStand::of(recipe, CoastDistance::SPACING).map(Arc::new);
        let planted = low_stand.as_ref().map(|low_stand| low_stand.land.clone()).or_else(|| Land::of(recipe));
        Self { planted, are_given: false, low_stand, rising: None, drowned: None }
    }

    /// Takes a land as it is.
    pub fn given(land: Arc<Land>) -> Self {
        Self { planted: Some(land), are_given: true, low_stand: None, rising: None, drowned: None }
    }

    /// Returns these coasts as they are before the sea has risen, for a recipe that differs in its growth at most.
    pub fn before_growth(&self, recipe: &Recipe) -> Self {
        if self.are_given || self.low_stand.is_some() == LowStand::is_wanted(recipe) {
            let (planted, low_stand) = (self.planted.clone(), self.low_stand.clone());
            return Self { planted, are_given: self.are_given, low_stand, rising: None, drowned: None };
        }
        Self::of(recipe)
    }

    /// Undoes the rise of the sea, for another one over the same tree. Returns `false` if it has not risen.
    pub fn undo_rise(&mut self) -> bool {
        let has_risen = self.drowned.is_some() || self.rising.is_some();
        (self.drowned, self.rising) = (None, None);
        has_risen
    }

    /// Returns what rivers have filled of the valleys that the sea rose into; `None` if it has not risen.
    pub fn silted(&self) -> Option<&Silted> {
        self.drowned.as_ref().map(|risen| &*risen.drowned.silted)
    }

    /// Returns the land that the tree is planted on; `None` if all of the domain is land.
    pub fn planted(&self) -> Option<&Arc<Land>> {
        self.planted.as_ref()
    }

    /// Returns the land at present.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.drowned.as_ref().map(|risen| &risen.drowned.land).or(self.planted.as_ref())
    }

    /// Returns the distances from the coast of the low stand; `None` if the sea has not risen.
    pub fn low_stand(&self) -> Option<&Arc<CoastDistance>> {
        self.drowned.as_ref().map(|risen| &risen.from)
    }

    /// Returns the land that the risen sea has left, and the land that it rose over.
    pub fn drowned(&self) -> Option<(&Drowned, &Land)> {
        Some((&self.drowned.as_ref()?.drowned, self.planted.as_deref()?))
    }

    /// Returns `true` if the sea is still to rise.
    pub fn are_to_drown(&self) -> bool {
        self.low_stand.is_some() && self.drowned.is_none()
    }

    /// Makes a step of the sea's rise over a grown tree. Returns what it has left, once it has reached its level, for
    /// [`Coasts::drown`].
    pub fn rise(&mut self, recipe: &Recipe, tree: &Tree) -> Result<Option<Drowned>, ReliefError> {
        let Some(low_stand) = &self.low_stand else { return Ok(None) };
        let begin = || Rise::Unknown(Drowning::new(recipe, low_stand.clone()).into());
        match self.rising.get_or_insert_with(begin) {
            Rise::Seen(transgression) => return Ok(transgression.rise().cloned()),
            Rise::Unknown(drowning) => {
                let refused = |Refused| ReliefError::OutOfMemory { megabytes: Drowning::MEGABYTES };
                if let Some(transgression) = drowning.step(tree).map_err(refused)? {
                    self.rising = Some(Rise::Seen(transgression));
                }
            }
        }
        Ok(None)
    }

    /// Takes over what the sea has left.
    pub fn drown(&mut self, drowned: Drowned) {
        let from = self.low_stand.as_ref().map(|low_stand| Arc::new(low_stand.land.coast_distance().clone()));
        (self.drowned, self.rising) = (from.map(|from| Risen { drowned, from }), None);
    }

    /// Returns the sea on its way to its level; `None` before that is known, and after it is reached.
    pub fn transgression(&self) -> Option<&Transgression> {
        match &self.rising {
            Some(Rise::Seen(transgression)) => Some(transgression),
            Some(Rise::Unknown(_)) | None => None,
        }
    }

    /// Returns the progress of the sea's rise, from 0 to 1.
    pub fn progress(&self) -> f32 {
        /// The share of the search for the level: in an animation it takes its time, and there is nothing to see.
        const SEARCH: f32 = 0.2;
        match &self.rising {
            None => 0.0,
            Some(Rise::Unknown(drowning)) => SEARCH * drowning.progress(),
            Some(Rise::Seen(transgression)) => SEARCH + (1.0 - SEARCH) * transgression.share(),
        }
    }

    /// Returns the approximate memory of a copy of these coasts, in bytes. Lands are shared.
    pub fn bytes(&self) -> usize {
        self.transgression().map_or(0, Transgression::bytes)
    }
}
