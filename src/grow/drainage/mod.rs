//! Drainage: water takes the cheapest way, and the more there is of it, the less it costs.
//!
//! The land is divided into parcels. Each finds the cheapest way to the sea through its neighbours. Where much has
//! drained, a step costs less in the next round, so that streams capture one another until the network settles.
//! Networks of least energy under this law are known for natural statistics: optimal channel networks
//! (Rodriguez-Iturbe, Rinaldo and others 1992). Here a few rounds of shortest paths replace annealing.
//!
//! The starting areas decide the large shape: equal areas give a calm network, those of an invasion a wild one.

mod adjacency;
mod bends;
mod captures;
mod country;
mod cut;
mod directions;
mod fall;
mod grain;
mod heights;
mod identities;
mod invasion;
mod lattice;
mod outlets;
mod parcels;
mod rivals;
mod round;
mod settings;

pub use captures::Capture;
pub(super) use heights::attractors_by_height;
pub use settings::DrainageSettings;

use std::sync::Arc;

use super::{Ending, GrowError, GrowthSettings, front};
use crate::base::memory::{Refused, can_allocate};
use crate::tree::{LEAST_SLOPE, NO_PARENT, Tree};
use captures::Captures;
use cut::{Left, Whole};
use directions::{FlowDirections, NONE};
use invasion::Invasion;
use lattice::Lattice;
use parcels::Parcels;
use rivals::Found;
use round::Round;

/// The memory of drainage for each cell of its lattice. Most of it is needed at the start, for the triangulation: 250 bytes
/// by count, and room for lists that grow.
const BYTES_A_CELL: usize = 320;

/// The greatest number of parcels in a tick that shows nothing: some milliseconds of work.
const PARCELS_A_TICK: usize = 20_000;

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Drainage {
    settings: GrowthSettings,
    parcels: Arc<Parcels>,
    /// The area that each parcel drained in the rounds so far, 1 or more: the geometric mean of the last round and the
    /// mean before it.
    area: Vec<f32>,
    /// `true` for outlets that are closed, since they are too near that of a greater river ([`rivals`]).
    is_closed: Vec<bool>,
    stage: Stage,
    tree: Arc<Tree>,
    /// The node of each parcel that has one.
    node: Vec<u32>,
    /// The number of completed rounds.
    rounds: u32,
    captures: Captures,
    mouths: u32,
    /// The number of parcels that the largest river drains, once growth has ended.
    largest_basin: Option<u32>,
    ending: Option<Ending>,
    /// The land that the risen sea has left; `None` if it has not risen.
    left: Option<Left>,
    /// The tree before that.
    whole: Option<Arc<Whole>>,
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
    /// Fails if there is not enough memory.
    pub fn new(settings: GrowthSettings) -> Result<Self, GrowError> {
        let too_much = || GrowError::out_of_memory(&settings);
        if !can_lay_out(&settings) {
            return Err(too_much());
        }
        let parcels = Arc::new(Parcels::new(&settings));
        let area = vec![1.0; parcels.len()];
        let is_closed = vec![false; parcels.outlets.len()];
        let stage = if settings.drainage.valleys > 0.0 {
            Stage::Invasion(Invasion::new(&settings, &parcels).map_err(|_| too_much())?.into())
        } else {
            Stage::Round(
                Round::new(&parcels, &area, &is_closed, settings.drainage.concavity).map_err(|_| too_much())?.into(),
            )
        };
        let node = vec![NONE; parcels.len()];
        let tree = Tree { tick_starts: vec![0], ..Tree::default() };
        Ok(Self {
            settings,
            parcels,
            area,
            is_closed,
            stage,
            tree: tree.into(),
            node,
            rounds: 0,
            captures: Captures::default(),
            mouths: 0,
            largest_basin: None,
            ending: None,
            left: None,
            whole: None,
        })
    }

    /// Grows by one tick. Returns `true` if there is more to grow.
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

    /// Ends the invasion and begins with its areas.
    fn follow_valleys(&mut self) -> Result<(), Refused> {
        let Stage::Invasion(invasion) = std::mem::replace(&mut self.stage, Stage::Over) else { return Ok(()) };
        let areas = invasion.into_directions().areas();
        let exponent = self.settings.drainage.valleys;
        self.area = areas.into_iter().map(|area| libm::powf(area.max(1) as f32, exponent)).collect();
        self.begin_round()
    }

    fn begin_round(&mut self) -> Result<(), Refused> {
        let round = Round::new(&self.parcels, &self.area, &self.is_closed, self.settings.drainage.concavity)?;
        self.stage = Stage::Round(round.into());
        Ok(())
    }

    /// Ends a round in which all parcels have found their way. The next round uses the new areas.
    fn end_round(&mut self) -> Result<(), Refused> {
        let Stage::Round(round) = std::mem::replace(&mut self.stage, Stage::Over) else { return Ok(()) };
        let directions = round.into_directions();
        let areas = directions.areas();
        if self.rounds > 0 {
            self.regrow(&directions);
        }
        self.rounds += 1;
        for (area, new) in self.area.iter_mut().zip(&areas) {
            // Without the mean, the network would swing back and forth.
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
        if !is_last {
            self.part_rivals(&directions, &areas);
        }
        self.captures.note(self.rounds - 1, directions)?;
        if is_last { Ok(()) } else { self.begin_round() }
    }

    /// Makes the ways of rivals dear in the next round: their outlets, and their last reaches.
    fn part_rivals(&mut self, directions: &FlowDirections, areas: &[u32]) {
        let found = Found { settings: &self.settings, parcels: &self.parcels, directions, areas };
        found.rival_outlets().into_iter().for_each(|outlet| self.is_closed[outlet] = true);
        found.rival_reaches().into_iter().for_each(|parcel| self.area[parcel] = 1.0);
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

    /// Makes another tree from the same parcels, with the same number of nodes in each tick.
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

    /// Gives the nodes of the finished tree their elevations: the cost of the way to the sea, with the final areas.
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
            let fall = steepness * cost * round::slope(areas[here] as f32, concavity);
            // A river falls everywhere, however little.
            tree.elevation[node[here] as usize] = (below + fall).max(f32::next_up(below));
        }
    }

    /// Returns the tree so far. While streams capture one another, each round makes another tree ([`Drainage::trees`]).
    pub fn tree(&self) -> &Arc<Tree> {
        &self.tree
    }

    pub(super) fn unshare(&mut self) {
        Arc::make_mut(&mut self.tree);
    }

    /// Returns the number of trees before the current one.
    pub fn trees(&self) -> u32 {
        self.rounds.saturating_sub(1)
    }

    /// Returns the parcels that drain differently after a round than before it, round by round.
    pub fn captures(&self) -> &[Capture] {
        &self.captures.list
    }

    /// Returns the node of each parcel; `u32::MAX` for parcels that have none yet.
    pub fn nodes(&self) -> &[u32] {
        &self.node
    }

    /// Returns the number of parcels; after the sea has risen, of those left on land.
    pub fn parcels(&self) -> u32 {
        self.left.as_ref().map_or(self.parcels.len() as u32, |left| left.parcels)
    }

    /// Returns `true` if the sea has risen over part of the tree.
    pub fn is_cut(&self) -> bool {
        self.left.is_some()
    }

    /// Returns the positions of the parcels.
    pub fn places(&self) -> &[glam::Vec2] {
        &self.parcels.at
    }

    /// Returns the number of parcels without a way to the sea so far.
    pub fn unreached(&self) -> u32 {
        match &self.left {
            Some(left) => left.unreached.len() as u32,
            None => self.parcels() - (self.tree.len() as u32 - self.mouths),
        }
    }

    /// Returns the positions of parcels without a way to the sea so far.
    pub fn left(&self) -> Vec<glam::Vec2> {
        if let Some(left) = &self.left {
            return left.unreached.iter().map(|&parcel| self.parcels.at[parcel as usize]).collect();
        }
        let mut left = Vec::new();
        for (&at, &node) in self.parcels.at.iter().zip(&self.node) {
            if node == NONE {
                left.push(at);
            }
        }
        left
    }

    /// Returns the number of river mouths so far.
    pub fn mouths(&self) -> u32 {
        self.mouths
    }

    /// Returns the number of parcels that the largest river drains; `None` while growth goes on, and if there are no parcels.
    pub fn largest_basin(&self) -> Option<u32> {
        self.largest_basin
    }

    /// Returns the way growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }
}

/// Returns `true` if there is memory for the parcels of some settings.
pub(super) fn can_lay_out(settings: &GrowthSettings) -> bool {
    can_allocate(Lattice::count(&settings.domain, &settings.drainage).saturating_mul(BYTES_A_CELL))
}

/// Returns the factor for the slope where a river drains one parcel. A river that drains the whole map then falls as
/// gently as in any other tree.
fn steepness(parcels: usize, concavity: f32) -> f32 {
    LEAST_SLOPE * libm::powf(parcels.max(1) as f32, concavity)
}

/// Adds a parcel's node, and its mouth if the parcel has an outlet.
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
