//! Space colonization (section 2.2 of the paper, after Runions, Lane and Prusinkiewicz 2007) as a stepper.
//!
//! Read literally, the procedure never ends: a node between balanced pulls makes the same child for ever. Therefore a
//! node tries to grow only if its set of attractors has changed since it last tried. The sets of old nodes only shrink,
//! so every node stops growing. Then the nodes that still have attractors reach out for the nearest of them. When even
//! that makes no node, growth is over, and unreached attractors are counted. There are two exceptions. If there is land
//! that no river sees, beyond an isthmus too narrow for a step, it gets its own mouth. And if most attractors are left
//! because a gap among the first ones has cut the river off, its last node runs straight on.
//!
//! With valleys, attractors have heights, and the lowest pulls first ([`valleys`]).

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
use crate::base::geometry::distance;
use crate::base::memory::{self, Refused};
use crate::base::work;
use crate::land::Shore;
use crate::tree::Tree;
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
    /// The positions of river mouths.
    mouths: Vec<Vec2>,
    /// The search for another mouth, once one has begun.
    search: Option<Box<Search>>,
    ending: Option<Ending>,
}

/// The attractors that pull.
#[derive(Clone, Debug)]
enum Pulling {
    /// All attractors, each on its nearest node.
    Everywhere(Box<Everywhere>),
    /// The lowest attractor within reach of any node, one at a time.
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

    /// Grows by one tick. New nodes are those from `born_from` on.
    fn grow(&mut self, rivers: &mut Rivers, born_from: usize) -> Result<(), Ending> {
        match self {
            Self::Everywhere(everywhere) => everywhere.grow(rivers, born_from),
            Self::LowestFirst(valleys) if rivers.len() == born_from => valleys.grow(rivers),
            Self::LowestFirst(_) => Ok(()),
        }
    }

    /// Lets new nodes look for attractors.
    fn capture(&mut self, rivers: &mut Rivers) {
        match self {
            Self::Everywhere(everywhere) => everywhere.capture(rivers),
            Self::LowestFirst(valleys) => valleys.capture(rivers),
        }
    }

    /// Uses up the attractors that rivers have come near to.
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
    /// Fails if there is not enough memory.
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
        // Reserves the memory of a usual tree at once, so that no frame waits for a long array to move.
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

    /// Grows by one tick, everywhere at once. Returns `true` if there is more to grow. A tick that only searches for a
    /// place to grow on, which takes long, does not count.
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

    /// Extends rivers that nothing reaches straight inland, until something does or the land ends.
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

    /// Plants another mouth, where it sees the most unseen land. This happens when no node grows and land is left over
    /// that no river sees. The mouth takes the attractors that it sees, so the number of such mouths is limited.
    fn seed_unreached_land(&mut self) {
        /// A patch is noticeable if one in this number of attractors lies in it, out of sight.
        const PATCH: u32 = 50;
        let is_patch = |lost: u32| lost > self.attractors() / PATCH;
        if (self.is_searching() || is_patch(self.unreached() - self.rivers.attractors.remaining().count() as u32))
            && let Some(Shore { at, inland }) = self.driest_shore()
        {
            self.plant(Mouth { at, inland }, &[]);
        }
    }

    /// Searches for the place on a coast with the most attractors within reach that no node has, apart from all mouths;
    /// the first among equals. `None` also while the search is under way.
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

    /// Returns `true` if most attractors are left.
    fn is_dry(&self) -> bool {
        self.ending.is_none() && self.unreached() > self.attractors() / 2
    }

    /// Extends the last node straight on, when a tree has died out among attractors that are all beyond its reach.
    fn extend_last_tip(&mut self) {
        let Rivers { tree, settings, .. } = &self.rivers;
        let Some(tip) = tree.len().checked_sub(1) else { return };
        let Some(parent) = tree.parent_of(tip) else { return };
        let onward = (tree.at[tip] - tree.at[parent]) / settings.step;
        self.extend(StraightTip { tip: tip as u32, inland: onward });
    }
}

impl Colonize {
    /// Returns the tree so far.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.rivers.tree
    }

    pub(super) fn unshare(&mut self) {
        Arc::make_mut(&mut self.rivers.tree);
    }

    /// Returns the settings of this growth.
    pub fn settings(&self) -> &GrowthSettings {
        &self.rivers.settings
    }

    /// Returns the way growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// Returns the number of planted mouths.
    pub fn mouths(&self) -> u32 {
        self.mouths.len() as u32
    }

    /// Returns the number of scattered attractors.
    pub fn attractors(&self) -> u32 {
        self.rivers.attractors.count()
    }

    /// Returns the number of attractors that are not used up, because no river has come near enough.
    pub fn unreached(&self) -> u32 {
        self.rivers.unreached
    }

    /// Returns the positions of attractors that are not used up, in no particular order.
    pub fn left(&self) -> Vec<Vec2> {
        self.rivers.attractors.left()
    }

    /// Limits the number of nodes, so that growth stops before the tree has more.
    #[must_use]
    pub fn with_node_limit(mut self, node_limit: usize) -> Self {
        self.rivers.node_limit = node_limit;
        self
    }
}
