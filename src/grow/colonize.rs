//! Space colonization (section 2.2 of the paper, after Runions, Lane and Prusinkiewicz 2007) as a stepper.
//!
//! Read literally, the procedure never ends: a node between balanced pulls makes the same child for ever. The rule
//! that ends it: a node tries to grow only when its set of attractors has changed since it last tried. Sets of old
//! nodes only shrink, so every node falls silent, and the few attractors that stay unreached are counted.

use std::collections::TryReserveError;

use glam::Vec2;

use super::attractors::{Attractors, NO_NODE};
use super::changed::Changed;
use super::{GrowError, Mouth, Parameters, Pull, heading, is_twin, mouths};
use crate::tree::{NO_PARENT, Tree};

/// How growth came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// No node could grow any more, as the paper intends.
    Complete,
    /// The tree reached [`Colonize::node_limit`].
    NodeLimit,
}

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Colonize {
    parameters: Parameters,
    attractors: Attractors,
    tree: Tree,
    shoots: Shoots,
    /// Nodes whose attractors have changed since they last tried to grow.
    changed: Changed,
    /// Room for one tick's work, kept between ticks.
    trying: Vec<u32>,
    /// Attractors that a river has come near enough to use up, not yet used up.
    doomed: Vec<u32>,
    /// The inland ends of mouths that no attractor has reached yet.
    pilots: Vec<Pilot>,
    unreached: u32,
    ending: Option<Ending>,
}

/// What growth, and nothing after it, has to know of each node.
#[derive(Clone, Debug, Default)]
struct Shoots {
    pull: Vec<Pull>,
    /// Steps from the mouth.
    from_mouth: Vec<u32>,
    /// The youngest child, and each child's elder sibling, to find twins.
    youngest: Vec<u32>,
    elder: Vec<u32>,
}

/// The end of a river that nothing pulls yet: it runs straight inland.
#[derive(Clone, Copy, Debug)]
struct Pilot {
    tip: u32,
    inland: Vec2,
}

impl Colonize {
    /// Plants the mouths of a recipe among its attractors: tick 0.
    ///
    /// # Errors
    /// If the memory is not to be had.
    pub fn new(parameters: Parameters) -> Result<Self, GrowError> {
        let attractors = Attractors::new(&parameters)?;
        let mut this = Self {
            unreached: attractors.count(),
            attractors,
            tree: Tree::default(),
            shoots: Shoots::default(),
            changed: Changed::default(),
            trying: Vec::new(),
            doomed: Vec::new(),
            pilots: Vec::new(),
            ending: None,
            parameters,
        };
        this.reserve().map_err(|_| GrowError::out_of_memory(&this.parameters))?;
        this.tree.tick_starts.push(0);
        for Mouth { at, inland } in mouths(&this.parameters) {
            let tip = this.add(at, NO_PARENT);
            if !this.attractors.any_within_reach(at) {
                this.pilots.push(Pilot { tip, inland });
            }
        }
        this.capture_from(0);
        Ok(this)
    }

    /// Grows by one tick, everywhere at once. Returns whether anything grew; if not, growth is over.
    pub fn tick(&mut self) -> bool {
        if self.ending.is_some() {
            return false;
        }
        let born_from = self.tree.len();
        self.tree.tick_starts.push(born_from as u32);
        if self.pilots.is_empty() {
            self.grow();
            self.capture_from(born_from);
            self.use_up();
        } else {
            self.extend_pilots();
            self.capture_from(born_from);
        }
        let grew = self.tree.len() > born_from;
        if !grew && self.pilots.is_empty() {
            self.tree.tick_starts.pop();
            self.finish();
        }
        self.ending.is_none()
    }

    /// Steps 3 and 4 of the paper: every node whose attractors have changed tries to grow.
    fn grow(&mut self) {
        let mut trying = std::mem::take(&mut self.trying);
        self.changed.drain_into(&mut trying);
        if self.tree.len() + trying.len() > self.node_limit() {
            self.ending = Some(Ending::NodeLimit);
        } else {
            let tick = self.tree.tick_starts.len() as u32 - 1;
            trying.iter().for_each(|&node| self.try_to_grow(node, tick));
        }
        self.trying = trying;
    }

    fn try_to_grow(&mut self, node: u32, tick: u32) {
        let index = node as usize;
        let Some(pull) = self.shoots.pull[index].direction() else { return };
        let at = self.tree.at[index];
        let came_from = self.tree.parent_of(index).map(|parent| self.tree.at[parent]);
        let child = heading(&self.parameters, at, came_from, pull, self.shoots.from_mouth[index], tick);
        if self.parameters.allows(at, child) && !self.has_twin(index, child) {
            self.add(child, node);
        }
    }

    fn has_twin(&self, node: usize, child: Vec2) -> bool {
        let mut sibling = self.shoots.youngest[node];
        while sibling != NO_NODE {
            if is_twin(child, self.tree.at[sibling as usize], self.parameters.step) {
                return true;
            }
            sibling = self.shoots.elder[sibling as usize];
        }
        false
    }

    fn add(&mut self, at: Vec2, parent: u32) -> u32 {
        let node = self.tree.len() as u32;
        self.tree.at.push(at);
        self.tree.parent.push(parent);
        self.tree.drained.push(0);
        self.shoots.pull.push(Pull::default());
        self.shoots.youngest.push(NO_NODE);
        let (elder, from_mouth) = match self.shoots.youngest.get_mut(parent as usize) {
            Some(youngest) => (std::mem::replace(youngest, node), self.shoots.from_mouth[parent as usize] + 1),
            None => (NO_NODE, 0),
        };
        self.shoots.elder.push(elder);
        self.shoots.from_mouth.push(from_mouth);
        node
    }

    /// Step 2 of the paper, for new nodes only: attractors that are now nearer to one of them change hands.
    fn capture_from(&mut self, first: usize) {
        self.changed.grow(self.tree.len());
        let squared_kill = self.parameters.kill * self.parameters.kill;
        let Self { parameters, attractors, tree, shoots, changed, doomed, .. } = self;
        for node in first..tree.len() {
            let at = tree.at[node];
            let mut gained = Pull::default();
            let sees = |node, attractor| parameters.sees(node, attractor);
            attractors.capture(node as u32, at, sees, |capture| {
                gained.add(Pull::toward(at, capture.at));
                if let Some(pull) = shoots.pull.get_mut(capture.previous_owner as usize) {
                    pull.subtract(Pull::toward(tree.at[capture.previous_owner as usize], capture.at));
                    changed.insert(capture.previous_owner);
                }
                if capture.squared_distance < squared_kill {
                    doomed.push(capture.attractor);
                }
            });
            shoots.pull[node].add(gained);
            changed.insert(node as u32);
        }
    }

    /// Step 5 of the paper: attractors that a river has come near to are used up, and drain into it.
    fn use_up(&mut self) {
        for attractor in self.doomed.drain(..) {
            if let Some((at, owner)) = self.attractors.use_up(attractor) {
                let node = owner as usize;
                self.shoots.pull[node].subtract(Pull::toward(self.tree.at[node], at));
                self.tree.drained[node] += 1;
                self.unreached -= 1;
                self.changed.insert(owner);
            }
        }
    }

    /// Before anything else grows: rivers that nothing reaches run straight inland until something does.
    fn extend_pilots(&mut self) {
        for Pilot { tip, inland } in std::mem::take(&mut self.pilots) {
            let from = self.tree.at[tip as usize];
            let at = from + inland * self.parameters.step;
            if self.parameters.allows(from, at) {
                let tip = self.add(at, tip);
                if !self.attractors.any_within_reach(at) {
                    self.pilots.push(Pilot { tip, inland });
                }
            }
        }
    }

    /// Attractors that pull to the end, but were never come near to, drain to their nearest node all the same.
    fn finish(&mut self) {
        self.ending.get_or_insert(Ending::Complete);
        for owner in self.attractors.remaining_owners() {
            self.tree.drained[owner as usize] += 1;
        }
    }
}

impl Colonize {
    /// The tree so far.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The parameters it grows by.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// How growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// How many attractors are not used up: no river has come near enough.
    pub fn unreached(&self) -> u32 {
        self.unreached
    }

    /// Growth stops before the tree has more nodes than this, so that memory is bounded by the recipe. Ordinary trees
    /// have one or two nodes an attractor; the wildest that the ranges allow were found to have seven.
    pub fn node_limit(&self) -> usize {
        8 * self.parameters.attractors as usize + 10_000
    }

    /// Asks for the memory of a usual tree at once, so that no frame waits for a long array to move.
    fn reserve(&mut self) -> Result<(), TryReserveError> {
        let usual = self.usual_nodes();
        self.tree.at.try_reserve_exact(usual)?;
        self.tree.parent.try_reserve_exact(usual)?;
        self.tree.drained.try_reserve_exact(usual)?;
        self.shoots.pull.try_reserve_exact(usual)?;
        self.shoots.from_mouth.try_reserve_exact(usual)?;
        self.shoots.youngest.try_reserve_exact(usual)?;
        self.shoots.elder.try_reserve_exact(usual)
    }

    /// About how many nodes a tree has, rather too many: by trials over reach 2.4 to 10, kill 0.5 to 2 and step 0.2 to 1
    /// the number goes with kill^−½ and step^−¾ (both in spacings).
    fn usual_nodes(&self) -> usize {
        let Parameters { attractors, spacing, kill, step, .. } = self.parameters;
        let (kill, step) = (kill / spacing, (step / spacing).sqrt());
        (0.65 * attractors as f32 / (kill.sqrt() * step * step.sqrt())) as usize
    }
}
