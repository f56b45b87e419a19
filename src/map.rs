//! The finished map: the results of all stages before painting, as plain, immutable data.
//!
//! [`Session::map`](crate::Session::map) returns it. Files, names, labels, measures and queries need nothing else. It
//! can therefore be moved to another thread. Large parts are shared: a clone copies none of them.

#[cfg(test)]
mod tests;

use std::num::NonZero;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::deltas::Deltas;
use crate::domain::Domain;
use crate::grow::{DrainageSettings, Grown};
use crate::lakes::Lakes;
use crate::land::{CoastDistance, Land};
use crate::network::{Network, NetworkSettings, PastCourses, Reach};
use crate::prune::{self, Pruned, Trim};
use crate::recipe::{GrowthMethod, Recipe, Style};
use crate::relief::{Grid, Relief, ReliefError, ReliefSettings, Rills};
use crate::scale::MapScale;
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
    /// The distances from the coast before the sea rose; `None` if it has not risen.
    pub(crate) low_stand: Option<Arc<CoastDistance>>,
    pub(crate) grown: Grown,
    pub(crate) tree: Arc<Tree>,
    pub(crate) trim: Trim,
    pub(crate) network: Arc<Network>,
    pub(crate) reaches: Arc<[Reach]>,
    pub(crate) rounds: u32,
    pub(crate) past: Arc<PastCourses>,
    pub(crate) relief: Option<Arc<Relief>>,
    pub(crate) lakes: Arc<Lakes>,
    pub(crate) deltas: Arc<Deltas>,
    /// The distance into flat ground that rivers have laid; `None` if there is none.
    pub(crate) flats: Option<Arc<CoastDistance>>,
}

/// The number of pixels on a side of a cell of a relief for pictures.
const PIXELS_A_CELL: u32 = 2;

/// The cell size, as a share of that of the map's own relief, from which another one is worth solving.
const FINER: f32 = 0.5;

/// Returns the settings of the relief on some land, with the low stand before it if the sea has risen and the ground that rivers have
/// laid, and of the rivers that trimming makes of a tree.
pub(crate) fn relief_settings(
    recipe: &Recipe,
    (land, [low_stand, flats]): (Option<&Arc<Land>>, [Option<&Arc<CoastDistance>>; 2]),
    (tree, trim): (&Tree, Trim),
    total_discharge: u32,
) -> ReliefSettings {
    let grows_on_rock = recipe.get::<GrowthMethod>() == GrowthMethod::Drainage;
    let drainage = grows_on_rock.then(|| DrainageSettings::new(recipe));
    ReliefSettings::new(recipe, land.cloned(), total_discharge)
        .with_low_stand(low_stand.cloned())
        .with_flats(flats.cloned())
        .with_rock(drainage.map(|drainage| (drainage.hardness_scale, drainage.hardness)))
        .with_rills(|| Rills::of(tree, trim, total_discharge))
}

/// Identifies a map. Maps of one program with the same id have the same land, rivers and names; they may differ in
/// style, and in whether their relief has been made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MapId(u64);

impl MapId {
    /// Makes an id that no map of this program has yet.
    pub(crate) fn next() -> Self {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        Self(COUNT.fetch_add(1, Ordering::Relaxed))
    }
}

impl Map {
    /// Returns the map's id.
    pub fn id(&self) -> MapId {
        self.id
    }

    /// Returns the recipe that the map was made from.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Returns the rectangle shown by the map.
    pub fn domain(&self) -> Domain {
        Domain::of(&self.recipe)
    }

    /// Returns the real sizes of what is on the map.
    pub fn scale(&self) -> MapScale {
        MapScale::of(&self.recipe)
    }

    /// Returns the land, either given or shaped by the recipe; `None` if all of the domain is land.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.land.as_ref()
    }

    /// Returns the results of growth: the attractors reached, the way it ended, and the lengths that it used.
    pub fn grown(&self) -> Grown {
        self.grown
    }

    /// Returns the untrimmed tree; where the sea has risen, what is left of it.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.tree
    }

    /// Returns the rule by which branches of the tree were trimmed.
    pub fn trim(&self) -> Trim {
        self.trim
    }

    /// Trims the tree again, exactly as when rivers were made from it.
    pub fn pruned(&self) -> Pruned {
        prune::trim(&self.tree, &Hydrology::of(&self.tree), self.trim)
    }

    /// Returns the map's rivers.
    pub fn network(&self) -> &Arc<Network> {
        &self.network
    }

    /// Returns the stretches where great rivers are flat and meander fully.
    pub fn reaches(&self) -> &[Reach] {
        &self.reaches
    }

    /// Returns the number of rounds that the rivers have meandered.
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// Returns the former courses of great rivers.
    pub fn past(&self) -> &PastCourses {
        &self.past
    }

    /// Returns the lakes along rivers.
    pub fn lakes(&self) -> &Arc<Lakes> {
        &self.lakes
    }

    /// Returns the deltas of rivers.
    pub fn deltas(&self) -> &Arc<Deltas> {
        &self.deltas
    }

    /// Returns the relief, if it has been made, in any style. A style that shows it always has it.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        self.relief.as_ref()
    }

    /// Returns the relief, if the style shows it.
    pub fn shown_relief(&self) -> Option<&Arc<Relief>> {
        self.relief.as_ref().filter(|_| self.recipe.get::<Style>().has_relief())
    }

    /// Returns the relief, or makes it now. [`Session::raise_relief`](crate::Session::raise_relief) makes it in steps.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn make_relief(&self) -> Result<Arc<Relief>, ReliefError> {
        match &self.relief {
            Some(relief) => Ok(relief.clone()),
            None => Relief::of(&self.network, self.relief_settings()).map(Arc::new),
        }
    }

    /// Adds the relief to the map, even if its style shows none.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn with_relief(self) -> Result<Self, ReliefError> {
        Ok(Self { relief: Some(self.make_relief()?), ..self })
    }

    /// Makes the shown relief on a grid fine enough for a picture with so many pixels on its longer side: two to a cell,
    /// up to [`Grid::MOST`] cells. `None` if the style shows no relief, or if the map's own is about as fine. The result
    /// does not depend on the number of threads.
    pub(crate) fn relief_for_picture(
        &self,
        pixels: u32,
        threads: NonZero<usize>,
    ) -> Option<Result<Relief, ReliefError>> {
        let own = self.shown_relief()?;
        let mut settings = self.relief_settings();
        let grid = Grid::with_longer_side(&settings.domain, (pixels / PIXELS_A_CELL).min(Grid::MOST))?;
        if grid.cell_size > FINER * settings.grid.cell_size {
            return None;
        }
        (settings.grid, settings.threads) = (grid, threads);
        Some(own.on_grid_of(&self.network, settings))
    }

    /// Returns the settings by which the rivers were made from the tree.
    pub fn network_settings(&self) -> NetworkSettings {
        let Grown { stream_spacing, total_discharge, .. } = self.grown;
        NetworkSettings::new(&self.recipe, stream_spacing, total_discharge)
    }

    /// Returns the settings by which the relief is made from the rivers.
    pub fn relief_settings(&self) -> ReliefSettings {
        let coasts = (self.land.as_ref(), [self.low_stand.as_ref(), self.flats.as_ref()]);
        relief_settings(&self.recipe, coasts, (&self.tree, self.trim), self.grown.total_discharge)
    }
}
