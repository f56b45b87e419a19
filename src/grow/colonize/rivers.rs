//! The rivers so far and their attractors: the parts of growth that do not depend on which attractors pull.

use std::sync::Arc;

use glam::Vec2;

use super::attractors::{Attractors, NO_NODE};
use super::changed::Changed;
use super::heading::{heading, is_duplicate};
use super::pull::Pull;
use super::waiting::Waiting;
use crate::base::geometry::{direction, length};
use crate::base::memory::{self, Refused};
use crate::grow::starts::PIECE;
use crate::grow::{Ending, GrowthSettings, Mouth};
use crate::tree::{NO_PARENT, Tree};

/// The number of nodes per attractor, besides a constant, that bounds the memory of a recipe. Ordinary trees have one
/// or two; the greatest number found within the ranges was seven and a half.
const MOST_NODES_PER_ATTRACTOR: usize = 10;
const MOST_NODES_BESIDES: usize = 10_000;

/// The tree with its attractors, and the data of each node that only growth needs.
#[derive(Clone, Debug)]
pub(super) struct Rivers {
    pub settings: GrowthSettings,
    pub attractors: Attractors,
    pub tree: Arc<Tree>,
    /// The number of steps from the mouth.
    pub from_mouth: Vec<u32>,
    /// The youngest child, and each child's elder sibling, to find twins.
    youngest: Vec<u32>,
    elder: Vec<u32>,
    /// The number of nodes that have looked for attractors.
    captured: usize,
    /// The number of attractors that are not used up.
    pub unreached: u32,
    pub node_limit: usize,
}

/// The receiver of attractors that change hands: their previous owners, or the queue of waiting attractors.
pub(super) enum Told<'a> {
    Owners { pull: &'a mut [Pull], changed: &'a mut Changed },
    Waiting(&'a mut Waiting),
}

/// The end of a river that nothing pulls yet: it runs straight inland.
#[derive(Clone, Copy, Debug)]
pub(super) struct StraightTip {
    pub tip: u32,
    pub inland: Vec2,
}

impl Rivers {
    /// Begins without nodes.
    pub fn new(settings: GrowthSettings, attractors: Attractors) -> Self {
        Self {
            tree: Arc::default(),
            from_mouth: Vec::new(),
            youngest: Vec::new(),
            elder: Vec::new(),
            captured: 0,
            unreached: attractors.count(),
            node_limit: MOST_NODES_PER_ATTRACTOR * settings.attractors as usize + MOST_NODES_BESIDES,
            attractors,
            settings,
        }
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.tree.len()
    }

    /// Adds a node.
    pub fn add(&mut self, at: Vec2, parent: u32) -> u32 {
        let node = self.len() as u32;
        let tree = Arc::make_mut(&mut self.tree);
        tree.at.push(at);
        tree.parent.push(parent);
        tree.drained.push(0);
        self.youngest.push(NO_NODE);
        let (elder, from_mouth) = match self.youngest.get_mut(parent as usize) {
            Some(youngest) => (std::mem::replace(youngest, node), self.from_mouth[parent as usize] + 1),
            None => (NO_NODE, 0),
        };
        self.elder.push(elder);
        self.from_mouth.push(from_mouth);
        node
    }

    /// Reserves memory for more nodes, if the limit leaves room for them.
    pub fn make_room(&mut self, nodes: usize) -> Result<(), Ending> {
        if self.len() + nodes > self.node_limit {
            return Err(Ending::NodeLimit);
        }
        self.reserve(nodes).map_err(|_| Ending::OutOfMemory)
    }

    /// Reserves memory for more nodes.
    pub fn reserve(&mut self, nodes: usize) -> Result<(), Refused> {
        let tree = Arc::make_mut(&mut self.tree);
        memory::reserve(&mut tree.at, nodes)?;
        memory::reserve(&mut tree.parent, nodes)?;
        memory::reserve(&mut tree.drained, nodes)?;
        memory::reserve(&mut self.from_mouth, nodes)?;
        memory::reserve(&mut self.youngest, nodes)?;
        memory::reserve(&mut self.elder, nodes)
    }

    /// Estimates the number of nodes in a tree, rather too high. By trials over reach 2.4 to 10, kill 0.5 to 2 and step
    /// 0.2 to 1, it is proportional to kill^−½ and step^−¾ (both in spacings). Drawn courses come in addition.
    pub fn usual_nodes(&self) -> usize {
        let GrowthSettings { attractors, spacing, kill, step, .. } = self.settings;
        let (kill, root) = (kill / spacing, (step / spacing).sqrt());
        let points: usize = self.settings.starts.iter().map(|start| start.course.len()).sum();
        (0.65 * attractors as f32 / (kill.sqrt() * root * root.sqrt())) as usize
            + (points as f32 * PIECE / step) as usize
    }
}

/// Steps.
impl Rivers {
    /// Returns the possible positions of a node's child: bent by momentum and curl, or straight. A bend that would
    /// leave the land is not used, so that a river beside the coast does not stop growing.
    pub fn steps(&self, node: usize, pull: Vec2, clockwise: bool, identity: [u32; 3]) -> [Vec2; 2] {
        let at = self.tree.at[node];
        let came_from = self.tree.parent_of(node).map(|parent| self.tree.at[parent]);
        let bent = heading(&self.settings, at, came_from, pull, clockwise, identity);
        [bent, at + pull * self.settings.step]
    }

    /// Returns `true` if a child would coincide with another one of its parent.
    pub fn has_twin(&self, node: usize, child: Vec2) -> bool {
        let mut sibling = self.youngest[node];
        while sibling != NO_NODE {
            if is_duplicate(child, self.tree.at[sibling as usize], self.settings.step) {
                return true;
            }
            sibling = self.elder[sibling as usize];
        }
        false
    }

    /// Adds a node straight inland; `None` where the land ends.
    pub fn extend(&mut self, StraightTip { tip, inland }: StraightTip) -> Option<u32> {
        let from = self.tree.at[tip as usize];
        let at = from + inland * self.settings.step;
        self.settings.allows(from, at).then(|| self.add(at, tip))
    }

    /// Plants a mouth and its stem, the start nodes of the paper: along the drawn course of its river or, without one,
    /// about a spacing straight inland, so that no river starts along the coast. Returns its end.
    pub fn plant(&mut self, Mouth { at, inland }: Mouth, course: &[Vec2]) -> StraightTip {
        let mouth = self.add(at, NO_PARENT);
        let mut pilot = self.follow(course, StraightTip { tip: mouth, inland });
        if pilot.tip == mouth {
            for _ in 0..stem_nodes(&self.settings) {
                pilot.tip = self.extend(pilot).unwrap_or(pilot.tip);
            }
        }
        pilot
    }

    /// Extends a river along a course, step by step, until the course or the land ends.
    fn follow(&mut self, course: &[Vec2], mut pilot: StraightTip) -> StraightTip {
        for &ahead in course {
            loop {
                let way = ahead - self.tree.at[pilot.tip as usize];
                if length(way) < self.settings.step {
                    break;
                }
                let onward = StraightTip { inland: direction(way), ..pilot };
                let Some(tip) = self.extend(onward) else { return pilot };
                pilot = StraightTip { tip, ..onward };
            }
        }
        pilot
    }
}

/// Attractors.
impl Rivers {
    /// Returns the nodes that have not looked for attractors yet, which count as having looked from now on.
    pub fn newcomers(&mut self) -> std::ops::Range<u32> {
        let first = std::mem::replace(&mut self.captured, self.tree.len());
        first as u32..self.captured as u32
    }

    /// Gives a new node the attractors that are now nearest to it (step 2 of the paper, for this node only). Returns
    /// their pull.
    #[inline(never)] // each copy would weigh kilobytes
    pub fn capture(&mut self, node: u32, told: &mut Told<'_>) -> Pull {
        let at = self.tree.at[node as usize];
        self.attractors.capture(node, at, self.settings.hidden_from(at), |place, owner, lost| match told {
            Told::Owners { pull, changed } if owner != NO_NODE => {
                pull[owner as usize].subtract(lost);
                changed.insert(owner);
            }
            Told::Owners { .. } => {}
            Told::Waiting(waiting) => waiting.join(place),
        })
    }

    /// Uses up the attractors that a river has come near to, which drain into it (step 5 of the paper). Calls
    /// `released` with the owner of each and its pull.
    #[inline]
    pub fn use_up(&mut self, mut released: impl FnMut(u32, Pull)) {
        let Self { attractors, tree, unreached, .. } = self;
        let tree = Arc::make_mut(tree);
        attractors.use_up(|owner, pull| {
            tree.drained[owner as usize] += 1;
            *unreached -= 1;
            released(owner, pull);
        });
    }

    /// Drains attractors that pull to the end without being reached to their nearest node.
    pub fn drain_the_rest(&mut self) {
        let tree = Arc::make_mut(&mut self.tree);
        for (owner, _) in self.attractors.remaining() {
            tree.drained[owner as usize] += 1;
        }
    }
}

/// Returns the number of nodes of a stem about one spacing long.
pub fn stem_nodes(settings: &GrowthSettings) -> u32 {
    ((settings.spacing / settings.step + 0.5) as u32).max(1)
}
