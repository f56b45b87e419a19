//! Space colonization (section 2.2 of the paper, after Runions, Lane and Prusinkiewicz 2007) as a stepper.
//!
//! Read literally, the procedure never ends: a node between balanced pulls makes the same child for ever. The rule
//! that ends it: a node tries to grow only when its set of attractors has changed since it last tried. Sets of old
//! nodes only shrink, so every node stops growing. Once all have, those that still have attractors reach out for the
//! nearest of them; when not even that makes a node, growth is over, and attractors that stay unreached are counted.
//! (Unless land is left over that no river sees, beyond an isthmus too narrow for a step: then it gets a mouth of its own. Or
//! unless most are: then a gap among the first attractors has cut the river off, and its last node runs straight on.)
//!
//! With valleys attractors have heights, and the lowest pulls first ([`valleys`]).

mod attractors;
mod changed;
mod driest;
mod everywhere;
mod heading;
mod pull;
mod rivers;
mod valleys;
mod waiting;

pub use heading::curl_toward;
pub use pull::Pull;
pub use rivers::stem_nodes;

use std::sync::Arc;

use glam::Vec2;

use super::drainage::can_lay_out;
use super::{BYTES_AN_ATTRACTOR, Ending, GrowError, GrowthSettings, Mouth, mouths, shores};
use crate::geometry::distance;
use crate::land::Shore;
use crate::memory::{self, Refused};
use crate::tree::Tree;
use crate::work;
use attractors::{Attractors, NO_NODE};
use driest::Search;
use everywhere::Everywhere;
use rivers::{Rivers, StraightTip};
use valleys::Valleys;

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Colonize {
    rivers: Rivers,
    pulling: Pulling,
    /// Rivers that no attractor has reached yet.
    pilots: Vec<StraightTip>,
    /// Where rivers reach the sea.
    mouths: Vec<Vec2>,
    /// The search for another mouth, once there has been one.
    search: Option<Box<Search>>,
    ending: Option<Ending>,
}

/// Which attractors pull.
#[derive(Clone, Debug)]
enum Pulling {
    /// All, each on the node that it is nearest to.
    Everywhere(Box<Everywhere>),
    /// The lowest within reach of any node, one at a time.
    LowestFirst(Box<Valleys>),
}

impl Pulling {
    fn new(settings: &GrowthSettings, places: Vec<u32>) -> Result<Self, Refused> {
        Ok(if settings.has_valleys() {
            Self::LowestFirst(Valleys::new(settings, places)?.into())
        } else {
            Self::Everywhere(Box::default())
        })
    }

    fn reserve(&mut self, nodes: usize) -> Result<(), Refused> {
        match self {
            Self::Everywhere(everywhere) => everywhere.reserve(nodes),
            Self::LowestFirst(_) => Ok(()),
        }
    }

    /// Grows by one tick, in which there are new nodes from some number on.
    fn grow(&mut self, rivers: &mut Rivers, born_from: usize) -> Result<(), Ending> {
        match self {
            Self::Everywhere(everywhere) => everywhere.grow(rivers, born_from),
            Self::LowestFirst(valleys) if rivers.len() == born_from => valleys.grow(rivers),
            Self::LowestFirst(_) => Ok(()),
        }
    }

    /// New nodes look for attractors.
    fn capture(&mut self, rivers: &mut Rivers) {
        match self {
            Self::Everywhere(everywhere) => everywhere.capture(rivers),
            Self::LowestFirst(valleys) => valleys.capture(rivers),
        }
    }

    /// Attractors that rivers have come near to are used up.
    fn use_up(&mut self, rivers: &mut Rivers) {
        match self {
            Self::Everywhere(everywhere) => everywhere.use_up(rivers),
            Self::LowestFirst(_) => valleys::use_up(rivers),
        }
    }
}

impl Colonize {
    /// Plants the mouths of a recipe among its attractors: tick 0.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(settings: GrowthSettings) -> Result<Self, GrowError> {
        let too_much = GrowError::out_of_memory(&settings);
        let has_room = memory::can_allocate(settings.attractors as usize * BYTES_AN_ATTRACTOR);
        if !has_room || (settings.has_valleys() && !can_lay_out(&settings)) {
            return Err(too_much);
        }
        let (attractors, places) = Attractors::new(&settings)?;
        Self::among(settings, attractors, places).map_err(|_| too_much)
    }

    fn among(settings: GrowthSettings, attractors: Attractors, places: Vec<u32>) -> Result<Self, Refused> {
        let pulling = Pulling::new(&settings, places)?;
        let rivers = Rivers::new(settings, attractors);
        let mut this = Self { rivers, pulling, pilots: Vec::new(), mouths: Vec::new(), search: None, ending: None };
        // A usual tree's memory at once, so that no frame waits for a long array to move.
        let nodes = this.rivers.usual_nodes();
        this.rivers.reserve(nodes)?;
        this.pulling.reserve(nodes)?;
        Arc::make_mut(&mut this.rivers.tree).tick_starts.push(0);
        let starts = this.settings().starts.clone();
        for (i, mouth) in mouths(this.settings()).into_iter().enumerate() {
            this.plant(mouth, starts.get(i).map_or(&[], |start| &start.course));
        }
        this.pulling.capture(&mut this.rivers);
        Ok(this)
    }

    fn plant(&mut self, mouth: Mouth, course: &[Vec2]) {
        self.pilots.push(self.rivers.plant(mouth, course));
        self.mouths.push(mouth.at);
    }

    /// Grows by one tick, everywhere at once. Returns whether there is more to grow. A tick that only searches for where
    /// to grow on, because that takes long, does not count.
    pub fn tick(&mut self) -> bool {
        if self.ending.is_some() {
            return false;
        }
        let born_from = self.rivers.len();
        Arc::make_mut(&mut self.rivers.tree).tick_starts.push(born_from as u32);
        if !self.is_searching() {
            self.extend_pilots();
            self.ending = self.pulling.grow(&mut self.rivers, born_from).err();
        }
        if self.rivers.len() == born_from && self.ending.is_none() {
            self.seed_unreached_land();
        }
        if self.is_searching() {
            Arc::make_mut(&mut self.rivers.tree).tick_starts.pop();
            return true;
        }
        if self.rivers.len() == born_from && self.is_dry() {
            self.extend_last_tip();
        }
        self.pulling.capture(&mut self.rivers);
        self.pulling.use_up(&mut self.rivers);
        if self.rivers.len() == born_from {
            Arc::make_mut(&mut self.rivers.tree).tick_starts.pop();
            self.ending.get_or_insert(Ending::Complete);
            self.rivers.drain_the_rest();
        }
        self.ending.is_none()
    }

    /// Rivers that nothing reaches run straight inland until something does, or the land ends.
    fn extend_pilots(&mut self) {
        for pilot in std::mem::take(&mut self.pilots) {
            let at = self.rivers.tree.at[pilot.tip as usize];
            if self.rivers.attractors.within_reach(at).next().is_none() {
                self.extend(pilot);
            }
        }
    }

    /// Extends a river straight inland, unless the land ends.
    fn extend(&mut self, pilot: StraightTip) {
        let tip = self.rivers.extend(pilot);
        self.pilots.extend(tip.map(|tip| StraightTip { tip, ..pilot }));
    }

    /// When no node grows and land is left over that no river sees: another mouth, where it sees the most of it. It takes what
    /// it sees, so there is an end to them.
    fn seed_unreached_land(&mut self) {
        /// A patch shows if one in this many attractors lies in it, out of sight.
        const PATCH: u32 = 50;
        let is_patch = |lost: u32| lost > self.attractors() / PATCH;
        if (self.is_searching() || is_patch(self.unreached() - self.rivers.attractors.remaining().count() as u32))
            && let Some(Shore { at, inland }) = self.driest_shore()
        {
            self.plant(Mouth { at, inland }, &[]);
        }
    }

    /// The place on a coast from which the most attractors are in reach that no node has, apart from all mouths; the first of
    /// equals. `None` also while the search for it is under way.
    fn driest_shore(&mut self) -> Option<Shore> {
        let Self { rivers: Rivers { settings, attractors, .. }, mouths, search, .. } = self;
        let seen_from = |shore: Vec2| {
            work::count(mouths.len());
            if mouths.iter().any(|mouth| distance(*mouth, shore) <= settings.mouth_spacing) {
                return 0;
            }
            let is_lost = |&(owner, place): &(u32, Vec2)| owner == NO_NODE && settings.sees(shore, place);
            attractors.within_reach(shore).filter(is_lost).count() as u32
        };
        search.get_or_insert_with(|| Box::new(Search::among(shores(settings)))).go_on(seen_from)
    }

    fn is_searching(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.is_under_way())
    }

    /// Whether most attractors are left.
    fn is_dry(&self) -> bool {
        self.ending.is_none() && self.unreached() > self.attractors() / 2
    }

    /// When a tree has died out among attractors that are all beyond its reach: its last node runs straight on, like a
    /// root that nothing reaches.
    fn extend_last_tip(&mut self) {
        let Rivers { tree, settings, .. } = &self.rivers;
        let Some(tip) = tree.len().checked_sub(1) else { return };
        let Some(parent) = tree.parent_of(tip) else { return };
        let onward = (tree.at[tip] - tree.at[parent]) / settings.step;
        self.extend(StraightTip { tip: tip as u32, inland: onward });
    }
}

impl Colonize {
    /// The tree so far.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.rivers.tree
    }

    pub(super) fn unshare(&mut self) {
        Arc::make_mut(&mut self.rivers.tree);
    }

    /// The settings it grows by.
    pub fn settings(&self) -> &GrowthSettings {
        &self.rivers.settings
    }

    /// How growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// How many mouths were planted.
    pub fn mouths(&self) -> u32 {
        self.mouths.len() as u32
    }

    /// How many attractors were scattered.
    pub fn attractors(&self) -> u32 {
        self.rivers.attractors.count()
    }

    /// How many attractors are not used up: no river has come near enough.
    pub fn unreached(&self) -> u32 {
        self.rivers.unreached
    }

    /// Where attractors lie that are not used up, in no order to rely on.
    pub fn left(&self) -> Vec<Vec2> {
        self.rivers.attractors.left()
    }

    /// Stops growth before the tree has more nodes than this.
    #[must_use]
    pub fn with_node_limit(mut self, node_limit: usize) -> Self {
        self.rivers.node_limit = node_limit;
        self
    }
}
