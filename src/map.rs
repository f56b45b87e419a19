//! The finished map: what all stages before painting have made of a recipe, as plain data that does not change.
//!
//! [`Session::map`](crate::Session::map) hands it out. Files, names, labels, measures and queries are made of it alone; so it can go to another
//! thread, or to another wasm module (`wire.rs`), which then knows as much of it as the session did. Its large parts are shared: a clone
//! copies none of them.

mod read;
#[cfg(test)]
mod tests;
mod write;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::domain::Domain;
use crate::grow::Grown;
use crate::land::Land;
use crate::network::{Network, NetworkSettings, PastCourses, Reach};
use crate::prune::{self, Pruned, Trim};
use crate::recipe::{Recipe, Style};
use crate::relief::{Relief, ReliefError, ReliefSettings};
use crate::tree::{Hydrology, Tree};

/// A finished map.
///
/// ```
/// use riverseed::Session;
///
/// let map = Session::new("seed=kauri&curl=0.6".parse()?)?.finish()?;
/// assert!(map.network().rivers.len() > 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    pub(crate) id: MapId,
    pub(crate) recipe: Recipe,
    pub(crate) land: Option<Arc<Land>>,
    pub(crate) grown: Grown,
    pub(crate) tree: Arc<Tree>,
    pub(crate) trim: Trim,
    pub(crate) network: Arc<Network>,
    pub(crate) reaches: Arc<[Reach]>,
    pub(crate) rounds: u32,
    pub(crate) past: Arc<PastCourses>,
    pub(crate) relief: Option<Arc<Relief>>,
}

/// Tells maps apart. Maps of one program with the same id have the same land, rivers and names; they may differ in style, and in whether
/// their relief has been made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MapId(u64);

impl MapId {
    /// An id that no map of this program has yet.
    pub(crate) fn next() -> Self {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        Self(COUNT.fetch_add(1, Ordering::Relaxed))
    }
}

impl Map {
    /// Its id.
    pub fn id(&self) -> MapId {
        self.id
    }

    /// The recipe that it was made from.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// The rectangle that it shows.
    pub fn domain(&self) -> Domain {
        Domain::of(&self.recipe)
    }

    /// The land, given or the recipe's; `None` if all of the domain is land.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.land.as_ref()
    }

    /// How much of land and attractors the tree has reached, and the lengths by which it grew.
    pub fn grown(&self) -> Grown {
        self.grown
    }

    /// The untrimmed tree.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.tree
    }

    /// Which branches of the tree were short enough to be removed.
    pub fn trim(&self) -> Trim {
        self.trim
    }

    /// Trims the tree again, as rivers were made of it.
    pub fn pruned(&self) -> Pruned {
        prune::trim(&self.tree, &Hydrology::of(&self.tree), self.trim)
    }

    /// The rivers.
    pub fn network(&self) -> &Arc<Network> {
        &self.network
    }

    /// Where the great rivers are flat, and meander fully.
    pub fn reaches(&self) -> &[Reach] {
        &self.reaches
    }

    /// How many rounds the rivers have meandered.
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// The courses that great rivers had before.
    pub fn past(&self) -> &PastCourses {
        &self.past
    }

    /// The relief, in whatever style, if it has been made: always, where the style shows it.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        self.relief.as_ref()
    }

    /// The relief, if the style shows it.
    pub fn shown_relief(&self) -> Option<&Arc<Relief>> {
        self.relief.as_ref().filter(|_| self.recipe.get::<Style>().has_relief())
    }

    /// Returns the relief, or makes it at once. [`Session::raise_relief`](crate::Session::raise_relief) makes it in steps.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn make_relief(&self) -> Result<Arc<Relief>, ReliefError> {
        match &self.relief {
            Some(relief) => Ok(relief.clone()),
            None => Relief::of(&self.network, self.relief_settings()).map(Arc::new),
        }
    }

    /// The same map with its relief, in a style that shows none too.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn with_relief(self) -> Result<Self, ReliefError> {
        Ok(Self { relief: Some(self.make_relief()?), ..self })
    }

    /// The settings by which the rivers were made of the tree.
    pub fn network_settings(&self) -> NetworkSettings {
        let Grown { stream_spacing, total_discharge, .. } = self.grown;
        NetworkSettings::new(&self.recipe, self.land.clone(), stream_spacing, total_discharge)
    }

    /// The settings by which the relief is made of the rivers.
    pub fn relief_settings(&self) -> ReliefSettings {
        ReliefSettings::new(&self.recipe, self.land.clone(), self.grown.total_discharge)
    }
}
