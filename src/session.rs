//! A session. It holds one recipe and the result of each stage; after a change it runs again only the stages affected.

mod coasts;
mod deltas;
mod drafts;
mod error;
mod moments;
mod relief;
mod summary;
#[cfg(test)]
mod tests;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use self::coasts::Coasts;
use self::deltas::DeltaStage;
use self::relief::ReliefStage;
use crate::base::memory;
use crate::base::random::Seed;
use crate::domain::Domain;
use crate::drown::Transgression;
use crate::grow::{GrowError, Growth, GrowthSettings};
use crate::lakes::{LakeMaker, Lakes};
use crate::land::Land;
use crate::map::{Map, MapId, relief_settings};
use crate::network::{Meander, Network, NetworkSettings, PastCourses, ShapeError, Shaping, ask_for_memory};
use crate::prune::{self, Heads, Pruned, Trim};
use crate::recipe::{IntegerKey, NumberKey, Recipe, Stage, Style};
use crate::relief::Relief;
use crate::tree::{Hydrology, Tree};

pub(crate) use drafts::{OF_COASTS, OF_RELIEF, SessionDrafts};
pub use error::SessionError;
pub use moments::{Moment, Timeline};
pub use summary::{Shortfall, Summary};

/// A recipe with the results of its stages so far: land, tree, rivers.
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
    coasts: Coasts,
    growth: Growth,
    /// Number of ticks grown so far.
    ticks: u32,
    /// `None` until growth has ended.
    shaping: Option<Shaping>,
    /// The deltas of the finished rivers, if the recipe asks for any.
    deltas: DeltaStage,
    /// The relief of the finished rivers, made on demand.
    relief: ReliefStage,
    generation: Generation,
    /// Replaced whenever more than the style changes.
    map_id: MapId,
    /// Replaced whenever the trimmed tree is discarded.
    tree_generation: Generation,
}

/// The kind of a session's next step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Phase {
    /// A tick of growth.
    Growing,
    /// Part of the rise of the sea over land that rivers have cut, if the recipe has any: first the search for its level,
    /// then even steps to it, which a picture shows.
    Drowning,
    /// One of the few steps that make rivers from the tree.
    Shaping,
    /// A round of meandering.
    Meandering,
    /// Part of the deltas or the relief of the finished rivers.
    Relief,
    /// No step is left.
    Finished,
}

impl Phase {
    /// Returns the phase's name, lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Growing => "growing",
            Self::Drowning => "drowning",
            Self::Shaping => "shaping",
            Self::Meandering => "meandering",
            Self::Relief => "relief",
            Self::Finished => "finished",
        }
    }
}

impl Session {
    /// Shapes the land of a recipe and plants its tree.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(recipe: Recipe) -> Result<Self, SessionError> {
        let coasts = Coasts::of(&recipe);
        Self::plant(recipe, coasts)
    }

    /// Plants the tree of a recipe on a given land, for example one from `Land::from_mask`. The session keeps this land
    /// when the recipe [changes](Session::change), so `land`, `sea`, `drowning`, `roughness` and `outline` have no effect. The
    /// recipe should name a drawn land with a similar outline, because links and files contain no more of the land than
    /// that.
    ///
    /// # Errors
    /// Fails if the land was made for another aspect than the recipe's, or if there is not enough memory.
    pub fn on_land(recipe: Recipe, land: Arc<Land>) -> Result<Self, SessionError> {
        check_map(&recipe, &land)?;
        Self::plant(recipe, Coasts::given(land))
    }

    fn plant(recipe: Recipe, coasts: Coasts) -> Result<Self, SessionError> {
        let growth = plant(&recipe, &coasts)?;
        Ok(Self {
            recipe,
            coasts,
            growth,
            ticks: 0,
            shaping: None,
            deltas: DeltaStage::default(),
            relief: ReliefStage::Waiting,
            generation: Generation::next(),
            map_id: MapId::next(),
            tree_generation: Generation::next(),
        })
    }

    /// Copies the session; the copies are independent. A copy begins a search for the sea's level, deltas, a relief or lakes again that
    /// are not finished, and ends the same. `clone` does all this too, but aborts the program if there is not enough memory.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn try_clone(&self) -> Result<Self, SessionError> {
        /// Measured per node or attractor: up to 92 bytes once there are rivers. The cells of a Brownian tree take 5 MB
        /// however many are filled, and former courses up to 0.9 MB.
        const BYTES: usize = 96;
        const BYTES_OF_CELLS: usize = 6_000_000;
        let items = self.tree().len() + self.growth.attractors() as usize;
        let bytes = items * BYTES + BYTES_OF_CELLS + self.coasts.bytes();
        if !memory::can_allocate(bytes) {
            return Err(SessionError::Copy { megabytes: (bytes / 1_000_000) as u32 + 1 });
        }
        let [generation, tree_generation] = [(); 2].map(|()| Generation::next());
        let mut copy = Self { generation, map_id: MapId::next(), tree_generation, ..self.clone() };
        // Copy now, while there is memory: later the first step of either session would copy the shared data.
        copy.growth.unshare();
        copy.shaping.iter_mut().for_each(Shaping::unshare);
        Ok(copy)
    }

    /// Returns the recipe that the session follows.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Returns the rectangle shown by the map.
    pub fn domain(&self) -> Domain {
        Domain::of(&self.recipe)
    }

    /// Returns the land, either given or shaped by the recipe; `None` if all of the domain is land. Where the sea drowns
    /// valleys, it is the land before that until [`Phase::Drowning`] has ended; where rivers build deltas, it is the land
    /// without them until the rivers are finished.
    pub fn land(&self) -> Option<&Arc<Land>> {
        self.deltas.land().or(self.coasts.land())
    }

    /// Changes to another recipe. Returns the earliest stage that has to run again, or `None` if nothing is different.
    /// Land and tree are replaced at once if the change affects them. Later stages run again in the next steps, and
    /// until then there are no rivers.
    ///
    /// # Errors
    /// Fails like [`Session::new`] and [`Session::on_land`]; the session is then unchanged.
    pub fn change(&mut self, recipe: Recipe) -> Result<Option<Stage>, SessionError> {
        let stage = self.recipe.first_difference(&recipe);
        let keeps_rivers = self.recipe.differs_in(&recipe, &[NumberKey::Deltas.into(), NumberKey::Waves.into()]);
        // Sediment in valleys decides where the sea ends, to which the tree is cut.
        let has_other_sediment = self.recipe.number(NumberKey::Deltas) != recipe.number(NumberKey::Deltas)
            && stage.is_some_and(|stage| stage > Stage::Grow);
        let keeps_relief = stage.is_some() && self.recipe.differs_in(&recipe, &[NumberKey::Lakes.into()]);
        if matches!(stage, Some(Stage::Land | Stage::Grow)) {
            let coasts = match (stage, self.coasts.planted()) {
                (_, Some(land)) if self.coasts.are_given => {
                    check_map(&recipe, land).map(|()| self.coasts.before_growth(&recipe))?
                }
                (Some(Stage::Land), _) => Coasts::of(&recipe),
                _ => self.coasts.before_growth(&recipe),
            };
            self.growth = plant(&recipe, &coasts)?;
            self.forget_ticks();
            self.coasts = coasts;
        }
        self.recipe = recipe;
        if keeps_relief {
            self.relief.forget_lakes();
        } else if stage.is_some_and(|stage| stage < Stage::Name) {
            self.relief = ReliefStage::Waiting;
        }
        if stage.is_some_and(|stage| stage <= Stage::Shape) {
            self.deltas.renew();
        }
        if !self.has_deltas() {
            self.deltas.forget();
        }
        if matches!(stage, Some(Stage::Land | Stage::Grow | Stage::Prune)) {
            self.discard_rivers();
        }
        if has_other_sediment && self.coasts.undo_rise() {
            self.growth.heal();
            self.discard_rivers();
        }
        if stage == Some(Stage::Shape) && !keeps_rivers && self.shaping.is_some() {
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

    /// Returns the factor by which rivers are wider under another recipe that differs at most in width; 1 if it does
    /// not differ. `None` if it differs in more than width, or if it differs while rivers still change their courses,
    /// which depend on the width.
    pub fn widening_to(&self, other: &Recipe) -> Option<f32> {
        let times = other.number(NumberKey::Width) / self.recipe.number(NumberKey::Width);
        let is_told = times == 1.0 || matches!(self.phase(), Phase::Relief | Phase::Finished);
        (is_told && self.recipe.differs_in(other, &[NumberKey::Width.into()])).then_some(times)
    }

    /// Goes back to tick 0.
    ///
    /// # Errors
    /// Fails if there is not enough memory; the session is then unchanged.
    pub fn restart(&mut self) -> Result<(), SessionError> {
        let coasts = self.coasts.before_growth(&self.recipe);
        self.growth = plant(&self.recipe, &coasts)?;
        self.coasts = coasts;
        self.forget_ticks();
        self.discard_rivers();
        (self.generation, self.map_id) = (Generation::next(), MapId::next());
        Ok(())
    }

    fn discard_rivers(&mut self) {
        self.shaping = None;
        self.deltas.forget();
        self.relief = ReliefStage::Waiting;
        self.tree_generation = Generation::next();
    }

    /// Returns the current generation. It is replaced whenever results are discarded, by [`Session::change`],
    /// [`Session::restart`], a round of drainage, the rise of the sea or new deltas. While it stays the same, the session only advances.
    pub(crate) fn generation(&self) -> Generation {
        self.generation
    }

    /// Returns the id of the map that this session makes or has made.
    pub(crate) fn map_id(&self) -> MapId {
        self.map_id
    }

    /// Returns the generation of the trimmed tree. It stays the same while rivers are made from the same trimmed tree,
    /// even repeatedly.
    pub(crate) fn tree_generation(&self) -> Generation {
        self.tree_generation
    }

    /// Makes up to `steps` steps: ticks of growth, then the rise of the sea if it drowns valleys, then a few steps that make rivers from the tree, then rounds of
    /// meandering, then the relief part by part if the style shows one. Returns `true` if there is more to do. In all
    /// known recipes a step takes up to 9.75 million elementary steps, as [`crate::base::work`] counts them, plus 250 for
    /// each attractor or cell of a Brownian tree.
    ///
    /// # Errors
    /// Fails if there is not enough memory for the rest of the tree, for its rivers, or for their relief. The session
    /// then does not show the whole recipe, and there are no rivers to export, or no relief. The next call meets the
    /// same error, or goes on if there is enough memory by then. An incomplete tree can only grow again from the start,
    /// after [`Session::restart`] or [`Session::change`].
    pub fn advance(&mut self, steps: u32) -> Result<bool, SessionError> {
        for _ in 0..steps {
            if !self.step()? {
                return Ok(false);
            }
        }
        Ok(!self.is_finished())
    }

    /// Runs all remaining steps and returns the finished map.
    ///
    /// # Errors
    /// Fails like [`Session::advance`].
    pub fn finish(&mut self) -> Result<Map, SessionError> {
        loop {
            if let Some(map) = self.map() {
                return Ok(map);
            }
            self.advance(u32::MAX)?;
        }
    }

    /// Returns the finished map, which shares its rivers with the session; `None` while there is more to do.
    pub fn map(&self) -> Option<Map> {
        let meander = self.meander().filter(|_| self.is_finished())?;
        Some(Map {
            id: self.map_id,
            recipe: self.recipe.clone(),
            land: self.land().cloned(),
            low_stand: self.coasts.low_stand().cloned(),
            grown: self.growth.grown()?,
            tree: self.growth.tree().clone(),
            trim: self.trim(),
            network: self.deltas.network().unwrap_or(meander.drawn()).clone(),
            reaches: meander.reaches().clone(),
            rounds: meander.rounds(),
            past: meander.past().clone(),
            relief: self.relief.relief().cloned(),
            lakes: self.lakes().cloned().unwrap_or_default(),
            deltas: self.deltas().cloned().unwrap_or_default(),
            flats: self.deltas.flats().cloned(),
        })
    }

    fn step(&mut self) -> Result<bool, SessionError> {
        if self.growth.ending().is_none() {
            let trees = self.growth.trees();
            self.growth.tick();
            self.count_tick();
            if self.growth.trees() != trees {
                self.generation = Generation::next();
            }
            return self.growth.failure().map_or(Ok(true), |failure| Err(failure.into()));
        }
        if let Some(failure) = self.growth.failure() {
            return Err(failure.into());
        }
        if self.coasts.are_to_drown() {
            return self.drown().map(|()| true);
        }
        match &mut self.shaping {
            None => self.shaping = Some(self.shape()?),
            Some(shaping) if shaping.is_finished() => {
                if self.needs_relief() || self.lacks_deltas() {
                    self.raise_relief()?;
                }
            }
            Some(shaping) => {
                shaping.step();
            }
        }
        Ok(!self.is_finished())
    }

    /// Makes a step of the sea's rise. At its end the tree is cut where it drowns.
    fn drown(&mut self) -> Result<(), SessionError> {
        if let Some(drowned) = self.coasts.rise(&self.recipe, self.growth.tree())? {
            self.growth.cut(&drowned.land)?;
            self.coasts.drown(drowned);
            [self.generation, self.tree_generation] = [(); 2].map(|()| Generation::next());
        }
        Ok(())
    }

    /// Trims the tree and begins to make rivers from it.
    fn shape(&self) -> Result<Shaping, ShapeError> {
        /// For the trimmed tree and the hydrology of both trees.
        const BYTES_A_NODE: usize = 64;
        ask_for_memory(self.tree().len(), BYTES_A_NODE, 0)?;
        let Pruned { tree, .. } = self.pruned();
        Shaping::new(&tree, self.growth.may_cross(), self.coasts.land().cloned(), self.network_settings())
    }

    /// Returns `true` if the style shows a relief, or lakes on one, that has not been made yet.
    fn wants_relief(&self) -> bool {
        self.needs_relief() && self.relief.lakes().is_none()
    }

    /// Returns `true` if the style shows a relief, or if there are lakes, which lie on one.
    fn needs_relief(&self) -> bool {
        self.shows_relief() || self.recipe.number(NumberKey::Lakes) > 0.0
    }

    fn shows_relief(&self) -> bool {
        self.recipe.get::<Style>().has_relief()
    }

    /// Makes a step of the relief of finished rivers, even if the style shows none, or of the deltas before it. Files use this
    /// relief as it is. Returns `true` if a step was left to make.
    ///
    /// # Errors
    /// Fails if there is not enough memory. The next call tries the same step again.
    pub fn raise_relief(&mut self) -> Result<bool, SessionError> {
        let shaping = self.shaping.as_ref().filter(|shaping| shaping.is_finished() && self.relief.lakes().is_none());
        let Some(shaping) = shaping else { return Ok(false) };
        if self.lacks_deltas() {
            return self.build_deltas().map(|()| true);
        }
        let land = self.land().cloned();
        let (recipe, coasts, growth, trim) = (&self.recipe, &self.coasts, &self.growth, self.trim());
        let deltas = &self.deltas;
        let settings = || {
            let coasts = (land.as_ref(), [coasts.low_stand(), deltas.flats()]);
            relief_settings(recipe, coasts, (growth.tree(), trim), growth.total_discharge())
        };
        let lakes = || {
            let share = recipe.number(NumberKey::Lakes);
            (share > 0.0).then(|| LakeMaker::new(share, Seed::from_text(recipe.seed())))
        };
        let rivers = deltas.network().or(shaping.meander().map(Meander::drawn)).map_or(Network::EMPTY, |rivers| rivers);
        self.relief.step(rivers, settings, lakes)?;
        Ok(true)
    }

    /// Returns the sea while it is to be seen rising, else `None`; its lands are for pictures alone.
    pub(crate) fn transgression(&self) -> Option<&Transgression> {
        self.coasts.transgression()
    }

    /// Returns the relief; `None` until rivers are finished, and in a style that shows none. It is kept for a later
    /// style that shows it.
    pub fn relief(&self) -> Option<&Arc<Relief>> {
        self.relief.relief().filter(|_| self.shows_relief())
    }

    /// Returns the lakes along rivers; `None` until they are made.
    pub fn lakes(&self) -> Option<&Arc<Lakes>> {
        self.relief.lakes()
    }

    /// Returns `true` if no step is left.
    pub fn is_finished(&self) -> bool {
        self.phase() == Phase::Finished
    }

    /// Returns the kind of the next step.
    pub fn phase(&self) -> Phase {
        match &self.shaping {
            Some(shaping) if shaping.is_finished() && (self.lacks_deltas() || self.wants_relief()) => Phase::Relief,
            Some(shaping) if shaping.is_finished() => Phase::Finished,
            Some(shaping) if shaping.network().is_some() => Phase::Meandering,
            Some(_) => Phase::Shaping,
            None if self.growth.ending().is_some() && self.coasts.are_to_drown() => Phase::Drowning,
            None if self.growth.ending().is_some() => Phase::Shaping,
            None => Phase::Growing,
        }
    }

    /// Returns the progress of the current phase, from 0 to 1. It never decreases. Growth is measured by the share that
    /// is drained, meandering by its rounds, relief by the land that is raised. It is 0 while rivers are made from the
    /// tree, and 1 once everything is finished.
    pub fn progress(&self) -> f32 {
        match (self.phase(), self.meander()) {
            (Phase::Growing, _) => self.growth.progress(),
            (Phase::Drowning, _) => self.coasts.progress(),
            (Phase::Meandering, Some(meander)) => meander.rounds() as f32 / meander.settings().rounds.max(1) as f32,
            (Phase::Relief, _) => self.relief.progress(),
            (Phase::Finished, _) => 1.0,
            (Phase::Shaping | Phase::Meandering, _) => 0.0,
        }
    }

    /// Returns the rivers; `None` until there are any.
    pub fn network(&self) -> Option<&Network> {
        self.deltas.network().or(self.meander().map(Meander::drawn)).map(|network| &**network)
    }

    fn meander(&self) -> Option<&Meander> {
        self.shaping.as_ref().and_then(Shaping::meander)
    }

    /// Returns the former courses of great rivers, as far as they have meandered; `None` until there are rivers.
    pub fn past(&self) -> Option<&PastCourses> {
        self.meander().map(|meander| &**meander.past())
    }

    /// Returns the number of rounds that the rivers have meandered; `None` until there are rivers.
    pub fn rounds(&self) -> Option<u32> {
        self.meander().map(Meander::rounds)
    }

    /// Returns the settings by which rivers are made from the tree of this recipe.
    pub fn network_settings(&self) -> NetworkSettings {
        let growth = &self.growth;
        NetworkSettings::new(&self.recipe, growth.stream_spacing(), growth.total_discharge())
    }

    /// Returns the untrimmed tree, as far as it has grown; after the sea has risen, what is left of it.
    pub fn tree(&self) -> &Tree {
        self.growth.tree()
    }

    /// Returns the growth in progress.
    pub fn growth(&self) -> &Growth {
        &self.growth
    }

    /// Returns the trimmed tree with its hydrology, as far as the tree has grown.
    pub fn pruned(&self) -> Pruned {
        let tree = self.growth.tree();
        prune::trim(tree, &Hydrology::of(tree), self.trim())
    }

    /// Returns the rule that decides which branches of the tree are trimmed.
    pub fn trim(&self) -> Trim {
        let trim =
            Trim::new(self.recipe.number(NumberKey::Trim), self.growth.node_length(), !self.growth.mouths_are_chosen());
        Trim {
            variation: self.recipe.number(NumberKey::TrimVariation),
            heads: self.heads(),
            tributary_spacing: self.recipe.number(NumberKey::TributarySpacing) * self.growth.stream_spacing(),
            seed: Seed::from_text(self.recipe.seed()),
            ..trim
        }
    }

    /// Returns the rule by which channels begin. Only drainage has hillsides without any.
    fn heads(&self) -> Heads {
        /// The wavelength of uneven heads, in spacings.
        const WAVELENGTH: f32 = 30.0;
        if !self.growth.covers_hillsides() {
            return Heads::default();
        }
        Heads {
            channel_area: self.recipe.integer(IntegerKey::ChannelArea),
            variation: self.recipe.number(NumberKey::HeadVariation),
            largest_basin: self.growth.largest_basin().unwrap_or(u32::MAX),
            wavelength: WAVELENGTH * self.growth.stream_spacing(),
        }
    }

    /// Summarises the rivers in numbers. During growth this costs nothing, and order and sources are still 0.
    pub fn summary(&self) -> Summary {
        let so_far = Summary::of_growth(&self.growth);
        match self.shaping.as_ref().zip(self.meander()) {
            Some((shaping, meander)) => so_far.with_rivers(shaping.nodes(), meander),
            None => so_far,
        }
    }
}

/// Identifies the results of a session since it was planted or last changed. No two are equal, even across sessions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Generation(u64);

impl Generation {
    pub(crate) fn next() -> Self {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        Self(COUNT.fetch_add(1, Ordering::Relaxed))
    }
}

/// Checks that a land fits the map of a recipe.
fn check_map(recipe: &Recipe, land: &Land) -> Result<(), SessionError> {
    let (size, wanted) = (land.size(), Domain::of(recipe).size);
    let [width, height, wanted_width, wanted_height] =
        [size.x, size.y, wanted.x, wanted.y].map(|length| length.round() as u32);
    let other = SessionError::OtherMap { width, height, wanted_width, wanted_height };
    if size == wanted { Ok(()) } else { Err(other) }
}

/// Begins the growth of a recipe on its land.
fn plant(recipe: &Recipe, coasts: &Coasts) -> Result<Growth, GrowError> {
    Growth::new(GrowthSettings::new(recipe, coasts.planted().cloned()))
}
