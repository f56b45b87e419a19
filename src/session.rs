//! A session: one recipe at a time, each stage's result kept, and after a change only what it touches run again.

#[cfg(feature = "controls")]
mod drafts;
mod error;
#[cfg(feature = "controls")]
mod moments;
mod relief;
mod summary;
#[cfg(test)]
mod tests;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use self::relief::ReliefStage;
use crate::base::memory;
use crate::domain::Domain;
use crate::grow::{GrowError, Growth, GrowthSettings};
use crate::land::Land;
use crate::map::{Map, MapId};
use crate::network::{Meander, Network, NetworkSettings, PastCourses, ShapeError, Shaping, ask_for_memory};
use crate::prune::{self, Pruned, Trim};
use crate::recipe::{Key, Recipe, Stage, Style};
use crate::relief::{Relief, ReliefSettings};
use crate::tree::{Hydrology, Tree};

#[cfg(feature = "controls")]
pub(crate) use drafts::{OF_COASTS, OF_RELIEF, SessionDrafts};
pub use error::SessionError;
#[cfg(feature = "controls")]
pub use moments::{Moment, Timeline};
pub use summary::{Shortfall, Summary};

/// A recipe with what its stages have made of it so far: land, tree, rivers.
///
/// ```
/// use riverseed::Session;
///
/// let mut session = Session::new("seed=kauri&curl=0.6".parse()?)?;
/// while session.advance(10)? {
///     println!("{:?}: {:.0} %", session.phase(), session.progress() * 100.0);
/// }
/// assert!(session.finish()?.network().rivers.len() > 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    recipe: Recipe,
    /// `None` if all of the domain is land.
    land: Option<Arc<Land>>,
    /// Whether the land was given, and is not the recipe's.
    is_land_given: bool,
    growth: Growth,
    /// How many ticks that has grown.
    #[cfg(feature = "controls")]
    ticks: u32,
    /// Once growth has ended.
    shaping: Option<Shaping>,
    /// Of finished rivers, once it was wanted.
    relief: ReliefStage,
    generation: Generation,
    /// Another one whenever more changes than the style.
    map_id: MapId,
    /// Another one whenever the trimmed tree is discarded.
    tree_generation: Generation,
}

/// The kind of step that a session makes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// A tick of growth.
    Growing,
    /// Rivers are made of the tree, in a few steps.
    Shaping,
    /// A round of meandering.
    Meandering,
    /// A part of the relief that belongs to the finished rivers.
    Relief,
    /// Nothing: there is nothing more to do.
    Finished,
}

impl Session {
    /// Shapes the land of a recipe and plants its tree.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(recipe: Recipe) -> Result<Self, SessionError> {
        let land = Land::of(&recipe);
        Self::plant(recipe, land, false)
    }

    /// Plants the tree of a recipe on a land of its own, `Land::from_mask`, say. The land stays, whatever recipe the session is
    /// [changed](Session::change) to: of `land`, `sea`, `roughness` and `outline` nothing is seen. The recipe should name a drawn land,
    /// with an outline that is like this one: links and files say no more of it than that.
    ///
    /// # Errors
    /// If the land is for a map of another aspect than the recipe's, or there is not enough memory.
    pub fn on_land(recipe: Recipe, land: Arc<Land>) -> Result<Self, SessionError> {
        check_map(&recipe, &land)?;
        Self::plant(recipe, Some(land), true)
    }

    fn plant(recipe: Recipe, land: Option<Arc<Land>>, is_land_given: bool) -> Result<Self, SessionError> {
        let growth = plant(&recipe, &land)?;
        Ok(Self {
            recipe,
            land,
            is_land_given,
            growth,
            #[cfg(feature = "controls")]
            ticks: 0,
            shaping: None,
            relief: ReliefStage::Waiting,
            generation: Generation::next(),
            map_id: MapId::next(),
            tree_generation: Generation::next(),
        })
    }

    /// Another session that has come as far: what becomes of one does not touch the other. `clone` does the same, but ends the
    /// program where there is not enough memory.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn try_clone(&self) -> Result<Self, SessionError> {
        /// As measured: 92 at most, once there are rivers. The cells of a Brownian tree take 5 MB, however many it fills,
        /// and former courses 0.9 at most.
        const BYTES: usize = 96;
        const BYTES_OF_CELLS: usize = 6_000_000;
        let items = self.tree().len() + self.growth.attractors() as usize;
        let bytes = items * BYTES + BYTES_OF_CELLS + self.relief.bytes();
        if !memory::can_allocate(bytes) {
            return Err(SessionError::Copy { megabytes: (bytes / 1_000_000) as u32 + 1 });
        }
        let [generation, tree_generation] = [(); 2].map(|()| Generation::next());
        let mut copy = Self { generation, map_id: MapId::next(), tree_generation, ..self.clone() };
        // While there is memory for it: steps of either would copy what both share.
        copy.growth.unshare();
        copy.shaping.iter_mut().for_each(Shaping::unshare);
        Ok(copy)
    }

    /// The recipe.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// The rectangle that the map shows.
    pub fn domain(&self) -> Domain {
        Domain::of(&self.recipe)
    }

    /// The land, given or the recipe's; `None` if all of the domain is.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.land.as_ref()
    }

    /// Changes to another recipe. Returns the earliest stage that has to run again, `None` if nothing is different. Land is
    /// shaped and a tree is planted at once, if it is one of theirs; a later stage runs again with the next steps, and until
    /// then there are no rivers.
    ///
    /// # Errors
    /// As [`Session::new`] and [`Session::on_land`]; everything is then as before.
    pub fn change(&mut self, recipe: Recipe) -> Result<Option<Stage>, SessionError> {
        let stage = self.recipe.first_difference(&recipe);
        if matches!(stage, Some(Stage::Land | Stage::Grow)) {
            let land = match (stage, &self.land) {
                (_, Some(land)) if self.is_land_given => check_map(&recipe, land).map(|()| Some(land.clone()))?,
                (Some(Stage::Land), _) => Land::of(&recipe),
                (_, land) => land.clone(),
            };
            self.growth = plant(&recipe, &land)?;
            #[cfg(feature = "controls")]
            self.forget_ticks();
            self.land = land;
        }
        self.recipe = recipe;
        if stage.is_some_and(|stage| stage < Stage::Name) {
            self.relief = ReliefStage::Waiting;
        }
        if matches!(stage, Some(Stage::Land | Stage::Grow | Stage::Prune)) {
            self.discard_rivers();
        }
        if stage == Some(Stage::Shape) && self.shaping.is_some() {
            let settings = self.network_settings();
            self.shaping.iter_mut().for_each(|shaping| shaping.change(settings.clone()));
        }
        if stage.is_some() {
            self.generation = Generation::next();
        }
        if stage.is_some_and(|stage| stage < Stage::Paint) {
            self.map_id = MapId::next();
        }
        Ok(stage)
    }

    /// How many times as wide rivers are by another recipe that has but another width than this one: 1 if it has not. `None` if it is
    /// another in more than that, or as long as rivers still change their courses, which another width would change as well.
    #[cfg(feature = "controls")]
    pub fn widening_to(&self, other: &Recipe) -> Option<f32> {
        let times = other.number(Key::Width) / self.recipe.number(Key::Width);
        let is_told = times == 1.0 || matches!(self.phase(), Phase::Relief | Phase::Finished);
        (is_told && self.recipe.differs_in(other, &[Key::Width])).then_some(times)
    }

    /// Goes back to tick 0.
    ///
    /// # Errors
    /// If there is not enough memory; everything is then as before.
    pub fn restart(&mut self) -> Result<(), SessionError> {
        self.growth = plant(&self.recipe, &self.land)?;
        #[cfg(feature = "controls")]
        self.forget_ticks();
        self.discard_rivers();
        (self.generation, self.map_id) = (Generation::next(), MapId::next());
        Ok(())
    }

    fn discard_rivers(&mut self) {
        self.shaping = None;
        self.relief = ReliefStage::Waiting;
        self.tree_generation = Generation::next();
    }

    /// Another one whenever results are discarded, by [`Session::change`], [`Session::restart`] or a round of drainage: while it
    /// stays the same the session only advances.
    pub(crate) fn generation(&self) -> Generation {
        self.generation
    }

    /// The id of the map that this is becoming, or has become.
    pub(crate) fn map_id(&self) -> MapId {
        self.map_id
    }

    /// The same for as long as the rivers, made once or several times, are those of one trimmed tree.
    pub(crate) fn tree_generation(&self) -> Generation {
        self.tree_generation
    }

    /// Makes at most this many steps: ticks of growth, then a few that make rivers of the tree, then rounds of meandering, then
    /// the relief part by part, if the style shows one. Returns whether there is more to do. No recipe is known of which a step takes
    /// more than 8 million elementary steps, as [`crate::base::work`] counts them, and 250 for each attractor or cell of a Brownian tree.
    ///
    /// # Errors
    /// If there is not enough memory for the rest of the tree, for its rivers, or for their relief. The session then does not show
    /// the whole recipe, and there are no rivers to export, or no relief. A further call meets the same error, or goes on if there is
    /// memory by then; a tree that is not whole only grows again from the start, after [`Session::restart`] or [`Session::change`].
    pub fn advance(&mut self, steps: u32) -> Result<bool, SessionError> {
        for _ in 0..steps {
            if !self.step()? {
                return Ok(false);
            }
        }
        Ok(!self.is_finished())
    }

    /// Goes on to the end, and returns the finished map.
    ///
    /// # Errors
    /// As [`Session::advance`].
    pub fn finish(&mut self) -> Result<Map, SessionError> {
        loop {
            if let Some(map) = self.map() {
                return Ok(map);
            }
            self.advance(u32::MAX)?;
        }
    }

    /// The finished map, which shares its rivers with the session; `None` as long as there is more to do.
    pub fn map(&self) -> Option<Map> {
        let meander = self.meander().filter(|_| self.is_finished())?;
        Some(Map {
            id: self.map_id,
            recipe: self.recipe.clone(),
            land: self.land.clone(),
            grown: self.growth.grown()?,
            tree: self.growth.tree().clone(),
            trim: self.trim(),
            network: meander.network().clone(),
            reaches: meander.reaches().clone(),
            rounds: meander.rounds(),
            past: meander.past().clone(),
            relief: self.relief.relief().cloned(),
        })
    }

    fn step(&mut self) -> Result<bool, SessionError> {
        if self.growth.ending().is_none() {
            let trees = self.growth.trees();
            self.growth.tick();
            #[cfg(feature = "controls")]
            self.count_tick();
            if self.growth.trees() != trees {
                self.generation = Generation::next();
            }
            return self.growth.failure().map_or(Ok(true), |failure| Err(failure.into()));
        }
        if let Some(failure) = self.growth.failure() {
            return Err(failure.into());
        }
        match &mut self.shaping {
            None => self.shaping = Some(self.shape()?),
            Some(shaping) if shaping.is_finished() => {
                if self.shows_relief() {
                    self.raise_relief()?;
                }
            }
            Some(shaping) => {
                shaping.step();
            }
        }
        Ok(!self.is_finished())
    }

    /// Trims the tree, and begins to make rivers of it.
    fn shape(&self) -> Result<Shaping, ShapeError> {
        /// Of the trimmed tree, and both trees' hydrology.
        const BYTES_A_NODE: usize = 64;
        ask_for_memory(self.tree().len(), BYTES_A_NODE, 0)?;
        let Pruned { tree, .. } = self.pruned();
        Shaping::new(&tree, self.growth.may_cross(), self.network_settings())
    }

    /// Whether the style shows a relief that is not there yet.
    fn wants_relief(&self) -> bool {
        self.shows_relief() && self.relief().is_none()
    }

    fn shows_relief(&self) -> bool {
        self.recipe.get::<Style>().has_relief()
    }

    /// Makes a step of the relief of finished rivers, in a style that shows none too: for files, which then take it as it is. Returns
    /// whether one was left to make.
    ///
    /// # Errors
    /// If there is not enough memory. A further call tries the same step again.
    pub fn raise_relief(&mut self) -> Result<bool, SessionError> {
        let shaping = self.shaping.as_ref().filter(|shaping| shaping.is_finished() && self.relief.relief().is_none());
        let Some(shaping) = shaping else { return Ok(false) };
        let (recipe, land, growth) = (&self.recipe, &self.land, &self.growth);
        let settings = || ReliefSettings::new(recipe, land.clone(), growth.total_discharge());
        self.relief.step(shaping.network().unwrap_or(Network::EMPTY), settings)?;
        Ok(true)
    }

    /// The relief; `None` as long as rivers are not finished, and in a style that shows none. It is kept for a later style that
    /// does.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        self.relief.relief().filter(|_| self.shows_relief())
    }

    /// Whether there is nothing more to do.
    pub fn is_finished(&self) -> bool {
        self.phase() == Phase::Finished
    }

    /// The kind of step that comes next.
    pub fn phase(&self) -> Phase {
        match &self.shaping {
            Some(shaping) if shaping.is_finished() && self.wants_relief() => Phase::Relief,
            Some(shaping) if shaping.is_finished() => Phase::Finished,
            Some(shaping) if shaping.network().is_some() => Phase::Meandering,
            Some(_) => Phase::Shaping,
            None if self.growth.ending().is_some() => Phase::Shaping,
            None => Phase::Growing,
        }
    }

    /// How far the current phase has come, from 0 to 1, and never back: growth by the share that is drained, meandering by its
    /// rounds, relief by the land that is raised. 0 while rivers are made of the tree; 1 once everything is finished.
    pub fn progress(&self) -> f32 {
        match (self.phase(), self.meander()) {
            (Phase::Growing, _) => self.growth.progress(),
            (Phase::Meandering, Some(meander)) => meander.rounds() as f32 / meander.settings().rounds.max(1) as f32,
            (Phase::Relief, _) => self.relief.progress(),
            (Phase::Finished, _) => 1.0,
            (Phase::Shaping | Phase::Meandering, _) => 0.0,
        }
    }

    /// The rivers; `None` while there are none yet.
    pub fn network(&self) -> Option<&Network> {
        self.meander().map(|meander| &**meander.network())
    }

    fn meander(&self) -> Option<&Meander> {
        self.shaping.as_ref().and_then(Shaping::meander)
    }

    /// The courses that great rivers had before, as far as they have meandered; `None` while there are no rivers yet.
    pub fn past(&self) -> Option<&PastCourses> {
        self.meander().map(|meander| &**meander.past())
    }

    /// How many rounds the rivers have meandered; `None` while there are none yet.
    pub fn rounds(&self) -> Option<u32> {
        self.meander().map(Meander::rounds)
    }

    /// How the rivers of this recipe are made of its tree.
    pub fn network_settings(&self) -> NetworkSettings {
        let growth = &self.growth;
        NetworkSettings::new(&self.recipe, self.land.clone(), growth.stream_spacing(), growth.total_discharge())
    }

    /// The untrimmed tree, as far as it has grown.
    pub fn tree(&self) -> &Tree {
        self.growth.tree()
    }

    /// Growth in progress.
    pub fn growth(&self) -> &Growth {
        &self.growth
    }

    /// The trimmed tree with its hydrology, as things stand.
    pub fn pruned(&self) -> Pruned {
        let tree = self.growth.tree();
        prune::trim(tree, &Hydrology::of(tree), self.trim())
    }

    /// What of the tree is short enough to be trimmed.
    pub fn trim(&self) -> Trim {
        let length = self.recipe.number(Key::Trim);
        let channel_area = if self.growth.covers_hillsides() { self.channel_area() } else { 0 };
        let trim = Trim::new(length, self.growth.node_length(), !self.growth.mouths_are_chosen());
        Trim { channel_area, ..trim }
    }

    /// The area with which rivers begin: where no basin is as large, that of the largest, so that no map is bare for it.
    fn channel_area(&self) -> u32 {
        let asked = self.recipe.integer(Key::ChannelArea);
        self.growth.largest_basin().map_or(asked, |largest| asked.min(largest))
    }

    /// The picture in numbers. While growth goes on this costs nothing, and does not know order and sources yet.
    pub fn summary(&self) -> Summary {
        let so_far = Summary::of_growth(&self.growth);
        match self.shaping.as_ref().zip(self.meander()) {
            Some((shaping, meander)) => so_far.with_rivers(shaping.nodes(), meander),
            None => so_far,
        }
    }
}

/// The results of a session since it was planted or last changed. No two are equal, not even of different sessions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Generation(u64);

impl Generation {
    pub(crate) fn next() -> Self {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        Self(COUNT.fetch_add(1, Ordering::Relaxed))
    }
}

/// Whether a land lies on the map of a recipe.
fn check_map(recipe: &Recipe, land: &Land) -> Result<(), SessionError> {
    let (size, wanted) = (land.size(), Domain::of(recipe).size);
    let [width, height, wanted_width, wanted_height] =
        [size.x, size.y, wanted.x, wanted.y].map(|length| length.round() as u32);
    let other = SessionError::OtherMap { width, height, wanted_width, wanted_height };
    if size == wanted { Ok(()) } else { Err(other) }
}

/// Begins the growth of a recipe on its land.
fn plant(recipe: &Recipe, land: &Option<Arc<Land>>) -> Result<Growth, GrowError> {
    Growth::new(GrowthSettings::new(recipe, land.clone()))
}
