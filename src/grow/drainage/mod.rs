//! Drainage: water goes where it costs least, and the more there is of it, the less it costs.
//!
//! The land is divided into parcels. Each finds the cheapest way to the sea along its neighbours; where much has drained, a step costs less
//! in the next round, so that streams capture one another until the network settles. Networks of least energy under that law are
//! known for natural statistics: optimal channel networks (Rodriguez-Iturbe, Rinaldo and others 1992). Here a handful of
//! rounds of shortest paths takes the place of annealing.
//!
//! Where it starts decides the large shape: from equal areas a calm network comes, from the areas of an invasion a wild one.

mod captures;
mod directions;
mod folds;
mod heights;
mod identities;
mod invasion;
mod lattice;
mod outlets;
mod parcels;
mod round;
mod settings;

pub use captures::Capture;
pub(super) use heights::attractors_by_height;
pub use settings::DrainageSettings;

use std::sync::Arc;

use super::{Ending, GrowError, GrowthSettings, front};
use crate::memory::{Refused, can_allocate};
use crate::tree::{LEAST_SLOPE, NO_PARENT, Tree};
use captures::Captures;
use directions::{FlowDirections, NONE};
use invasion::Invasion;
use lattice::Lattice;
use parcels::Parcels;
use round::Round;

/// What drainage takes for each cell of its lattice: by count 104, and room for lists that grow.
const BYTES_A_CELL: usize = 140;

/// The number of parcels that a tick deals with at most when it shows nothing: some milliseconds of work.
const PARCELS_A_TICK: usize = 20_000;

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Drainage {
    settings: GrowthSettings,
    parcels: Arc<Parcels>,
    /// What each parcel drained in the rounds so far, at least 1: the geometric mean of the last round and all before it.
    area: Vec<f32>,
    stage: Stage,
    tree: Arc<Tree>,
    /// The node of each parcel that has one.
    node: Vec<u32>,
    /// How many rounds are over.
    rounds: u32,
    captures: Captures,
    mouths: u32,
    /// How many parcels the largest river drains, once growth has ended.
    largest_basin: Option<u32>,
    ending: Option<Ending>,
}

#[derive(Clone, Debug)]
enum Stage {
    Invasion(Box<Invasion>),
    Round(Box<Round>),
    Over,
}

impl Drainage {
    /// Lays out the parcels of a recipe: tick 0.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(settings: GrowthSettings) -> Result<Self, GrowError> {
        let too_much = || GrowError::out_of_memory(&settings);
        if !can_lay_out(&settings) {
            return Err(too_much());
        }
        let parcels = Arc::new(Parcels::new(&settings));
        let area = vec![1.0; parcels.len()];
        let stage = if settings.drainage.valleys > 0.0 {
            Stage::Invasion(Invasion::new(&settings, &parcels).map_err(|_| too_much())?.into())
        } else {
            Stage::Round(Round::new(&parcels, &area, settings.drainage.concavity).map_err(|_| too_much())?.into())
        };
        let node = vec![NONE; parcels.len()];
        let tree = Tree { tick_starts: vec![0], ..Tree::default() };
        Ok(Self {
            settings,
            parcels,
            area,
            stage,
            tree: tree.into(),
            node,
            rounds: 0,
            captures: Captures::default(),
            mouths: 0,
            largest_basin: None,
            ending: None,
        })
    }

    /// Grows by one tick. Returns whether there is more to grow.
    pub fn tick(&mut self) -> bool {
        if self.ending.is_none() && self.advance().is_err() {
            self.ending = Some(Ending::OutOfMemory);
        }
        self.ending.is_none()
    }

    fn advance(&mut self) -> Result<(), Refused> {
        let Self { parcels, stage, .. } = self;
        match stage {
            Stage::Invasion(invasion) => {
                if !invasion.advance(parcels, PARCELS_A_TICK)? {
                    self.follow_valleys()?;
                }
            }
            Stage::Round(round) => {
                let count = if self.rounds == 0 { front(parcels.len()) } else { PARCELS_A_TICK };
                let goes_on = round.advance(parcels, count)?;
                if self.rounds == 0 {
                    self.grow();
                }
                if !goes_on {
                    self.end_round()?;
                }
            }
            Stage::Over => {}
        }
        Ok(())
    }

    /// Takes the areas of the invasion to begin with.
    fn follow_valleys(&mut self) -> Result<(), Refused> {
        let Stage::Invasion(invasion) = std::mem::replace(&mut self.stage, Stage::Over) else { return Ok(()) };
        let areas = invasion.into_directions().areas();
        let exponent = self.settings.drainage.valleys;
        self.area = areas.into_iter().map(|area| libm::powf(area.max(1) as f32, exponent)).collect();
        self.begin_round()
    }

    fn begin_round(&mut self) -> Result<(), Refused> {
        let round = Round::new(&self.parcels, &self.area, self.settings.drainage.concavity)?;
        self.stage = Stage::Round(round.into());
        Ok(())
    }

    /// All parcels have found their way: the next round knows how much water there is.
    fn end_round(&mut self) -> Result<(), Refused> {
        let Stage::Round(round) = std::mem::replace(&mut self.stage, Stage::Over) else { return Ok(()) };
        let directions = round.into_directions();
        let areas = directions.areas();
        if self.rounds > 0 {
            self.regrow(&directions);
        }
        self.rounds += 1;
        for (area, new) in self.area.iter_mut().zip(&areas) {
            // Without the mean the network would swing to and fro.
            *area = (*area * (*new).max(1) as f32).sqrt();
        }
        let is_last = self.rounds > self.settings.drainage.captures;
        if is_last {
            self.raise(&directions, &areas);
            identities::assign(
                Arc::make_mut(&mut self.tree),
                &self.parcels,
                &self.node,
                self.settings.domain.size / 2.0,
            );
            self.largest_basin = areas.iter().copied().max();
            self.ending = Some(Ending::Complete);
        }
        self.captures.note(self.rounds - 1, directions)?;
        if is_last { Ok(()) } else { self.begin_round() }
    }

    /// Adds a node for each parcel that was settled since the last tick.
    fn grow(&mut self) {
        let Self { parcels, stage: Stage::Round(round), tree, node, mouths, .. } = self else { return };
        let tree = Arc::make_mut(tree);
        let known = tree.len() - *mouths as usize;
        if round.directions().order.len() > known {
            tree.tick_starts.push(tree.len() as u32);
        }
        for &parcel in &round.directions().order[known..] {
            plant(parcels, round.directions(), parcel, tree, node, mouths);
        }
    }

    /// Makes another tree of the same parcels, with as many nodes in each tick.
    fn regrow(&mut self, directions: &FlowDirections) {
        let count = self.tree.len();
        let mut tree = Tree {
            at: Vec::with_capacity(count),
            parent: Vec::with_capacity(count),
            drained: Vec::with_capacity(count),
            ..Tree::default()
        };
        self.mouths = 0;
        for &parcel in &directions.order {
            plant(&self.parcels, directions, parcel, &mut tree, &mut self.node, &mut self.mouths);
        }
        let ticks = self.tree.tick_starts.iter().map(|&start| start.min(tree.len() as u32)).collect();
        self.tree = Arc::new(Tree { tick_starts: ticks, ..tree });
    }

    /// Gives the nodes of the finished tree their elevations: the cost of the way to the sea, by the areas that have come of it.
    fn raise(&mut self, directions: &FlowDirections, areas: &[u32]) {
        let Self { parcels, tree, node, settings, .. } = self;
        let tree = Arc::make_mut(tree);
        let concavity = settings.drainage.concavity;
        let steepness = steepness(parcels.len(), concavity);
        tree.elevation = vec![0.0; tree.len()];
        for &parcel in &directions.order {
            let here = parcel as usize;
            let (below, cost) = match directions.to[here] {
                FlowDirections::OUT => (0.0, parcels.cost_out(here)),
                to => (tree.elevation[node[to as usize] as usize], parcels.cost_to(here, to)),
            };
            let fall = steepness * cost * libm::powf(areas[here] as f32, -concavity);
            // However little, a river falls.
            tree.elevation[node[here] as usize] = (below + fall).max(f32::next_up(below));
        }
    }

    /// The tree so far. While streams capture one another ([`Drainage::trees`]) it is another one after each round.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.tree
    }

    pub(super) fn unshare(&mut self) {
        Arc::make_mut(&mut self.tree);
    }

    /// How many trees came before this one.
    pub fn trees(&self) -> u32 {
        self.rounds.saturating_sub(1)
    }

    /// The parcels that drained another way after a round than before it, round by round.
    pub fn captures(&self) -> &[Capture] {
        &self.captures.list
    }

    /// The node of each parcel; `u32::MAX` of those that have none yet.
    pub fn nodes(&self) -> &[u32] {
        &self.node
    }

    /// How many parcels there are.
    pub fn parcels(&self) -> u32 {
        self.parcels.len() as u32
    }

    /// Where the parcels lie.
    pub fn places(&self) -> &[glam::Vec2] {
        &self.parcels.at
    }

    /// How many parcels have found no way to the sea yet.
    pub fn unreached(&self) -> u32 {
        self.parcels() - (self.tree.len() as u32 - self.mouths)
    }

    /// Where parcels lie that have found no way to the sea yet.
    pub fn left(&self) -> Vec<glam::Vec2> {
        let mut left = Vec::new();
        for (&at, &node) in self.parcels.at.iter().zip(&self.node) {
            if node == NONE {
                left.push(at);
            }
        }
        left
    }

    /// How many river mouths there are so far.
    pub fn mouths(&self) -> u32 {
        self.mouths
    }

    /// How many parcels the largest river drains; `None` while growth goes on, and without any parcel.
    pub fn largest_basin(&self) -> Option<u32> {
        self.largest_basin
    }

    /// How growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }
}

/// Whether there is memory for the parcels of some settings.
pub(super) fn can_lay_out(settings: &GrowthSettings) -> bool {
    can_allocate(Lattice::count(&settings.domain, &settings.drainage).saturating_mul(BYTES_A_CELL))
}

/// The slope, beside that of the ground, where a river drains one parcel: a river that drains everything falls as gently as one of any
/// other tree does.
fn steepness(parcels: usize, concavity: f32) -> f32 {
    LEAST_SLOPE * libm::powf(parcels.max(1) as f32, concavity)
}

/// Adds a parcel's node, and the mouth that it flows to if that is its own.
fn plant(
    parcels: &Parcels,
    directions: &FlowDirections,
    parcel: u32,
    tree: &mut Tree,
    node: &mut [u32],
    mouths: &mut u32,
) {
    let mut add = |at, parent, drained| {
        tree.at.push(at);
        tree.parent.push(parent);
        tree.drained.push(drained);
        tree.at.len() as u32 - 1
    };
    let below = match directions.to[parcel as usize] {
        FlowDirections::OUT => {
            *mouths += 1;
            add(parcels.outlets[parcels.outlet_of[parcel as usize] as usize].at, NO_PARENT, 0)
        }
        below => node[below as usize],
    };
    node[parcel as usize] = add(parcels.at[parcel as usize], below, 1);
}

#[cfg(test)]
mod tests;
