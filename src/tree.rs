//! The tree of rivers as arrays, and its hydrology.
//!
//! A node's parent, the node downstream of it, always stands earlier in the list, so one pass from the end to the
//! start visits every node after all that drain into it.

use glam::Vec2;

/// The parent of a mouth.
pub const NO_PARENT: u32 = u32::MAX;

/// The identity of a node that no grower made: where a river was made to join another that it crossed.
pub const UNGROWN: u32 = u32::MAX;

/// The slope at the mouth of a river that drains everything: a few units in a thousand.
pub const LEAST_SLOPE: f32 = 0.055 / 14.0;

/// Nodes that grew from river mouths. A forest, to be exact: one tree a mouth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tree {
    /// Where each node lies, in domain units.
    pub at: Vec<Vec2>,
    /// The node downstream, earlier in the list; [`NO_PARENT`] at a mouth.
    pub parent: Vec<u32>,
    /// How much each node itself drains: the attractors it was nearest to when they were used up or growth ended; of a
    /// Brownian tree itself, one cell of river (see [`crate::grow::Brownian`]).
    pub drained: Vec<u32>,
    /// The number of nodes before each tick, tick 0 first: the nodes of tick `t` start at `tick_starts[t]`.
    pub tick_starts: Vec<u32>,
    /// How high each node lies over the sea, in units: a node is higher than its parent. Empty if the way of growing knows no
    /// elevations, or not yet.
    pub elevation: Vec<f32>,
    /// The number by which each node is known however the tree is trimmed: no two have the same, [`UNGROWN`] apart. Empty if that is its
    /// place in this list.
    pub identity: Vec<u32>,
}

impl Tree {
    /// The number by which a node is known; [`UNGROWN`] if it never grew.
    pub fn identity_of(&self, node: usize) -> u32 {
        self.identity.get(node).copied().unwrap_or(node as u32)
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// Whether the tree has no nodes.
    pub fn is_empty(&self) -> bool {
        self.at.is_empty()
    }

    /// The node downstream; `None` at a mouth.
    #[inline]
    pub fn parent_of(&self, node: usize) -> Option<usize> {
        match self.parent[node] {
            NO_PARENT => None,
            parent => Some(parent as usize),
        }
    }

    /// The tick in which each node grew, 0 at a mouth.
    pub fn ticks(&self) -> impl Iterator<Item = u32> {
        let ends = self.tick_starts.iter().skip(1).copied().chain([self.len() as u32]);
        (0u32..)
            .zip(self.tick_starts.iter().copied().zip(ends))
            .flat_map(|(tick, (start, end))| std::iter::repeat_n(tick, end.saturating_sub(start) as usize))
    }

    /// How many nodes are mouths.
    pub fn mouths(&self) -> usize {
        self.parent.iter().filter(|&&parent| parent == NO_PARENT).count()
    }
}

/// The hydrology that follows from the shape of a tree, per node.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hydrology {
    /// The paper's depth (section 4.4): 0 at a source, else one more than the deepest child.
    pub depth: Vec<u32>,
    /// Strahler's stream order: 1 at a source; where two or more children share the highest order, one more than
    /// that, else the highest.
    pub order: Vec<u8>,
    /// Shreve's magnitude: the number of sources upstream, 1 at a source itself.
    pub magnitude: Vec<u32>,
    /// What is drained at and above the node. Width goes with its square root (Leopold and Maddock 1953), so
    /// that squared widths add where rivers join.
    pub discharge: Vec<u32>,
}

impl Hydrology {
    /// Reads a tree. One pass from the sources down.
    #[inline(never)] // one copy is enough
    pub fn of(tree: &Tree) -> Self {
        let count = tree.len();
        let mut this = Self {
            depth: vec![0; count],
            order: vec![0; count],
            magnitude: vec![0; count],
            discharge: tree.drained.clone(),
        };
        let mut highest_is_shared = vec![false; count];
        for node in (0..count).rev() {
            this.finish(node, highest_is_shared[node]);
            if let Some(parent) = tree.parent_of(node) {
                this.flow(node, parent, &mut highest_is_shared[parent]);
            }
        }
        this
    }

    /// Of each node's arms the one that is its river's own: that with the greatest discharge, of equal ones the longest, then the
    /// first; [`NO_PARENT`] at a source.
    pub fn own_arms(&self, tree: &Tree) -> Vec<u32> {
        let mut own_arm = vec![NO_PARENT; tree.len()];
        let size = |node: u32| (self.discharge[node as usize], self.depth[node as usize]);
        for node in 0..tree.len() as u32 {
            if let Some(arm) = own_arm.get_mut(tree.parent[node as usize] as usize)
                && (*arm == NO_PARENT || size(node) > size(*arm))
            {
                *arm = node;
            }
        }
        own_arm
    }

    /// All children have been added to a node: settle its order and magnitude.
    fn finish(&mut self, node: usize, highest_is_shared: bool) {
        self.order[node] += u8::from(highest_is_shared || self.order[node] == 0);
        self.magnitude[node] = self.magnitude[node].max(1);
    }

    /// Adds a node to the one downstream of it.
    fn flow(&mut self, node: usize, parent: usize, highest_is_shared: &mut bool) {
        self.depth[parent] = self.depth[parent].max(self.depth[node] + 1);
        self.magnitude[parent] += self.magnitude[node];
        self.discharge[parent] += self.discharge[node];
        match self.order[node].cmp(&self.order[parent]) {
            std::cmp::Ordering::Greater => {
                self.order[parent] = self.order[node];
                *highest_is_shared = false;
            }
            std::cmp::Ordering::Equal => *highest_is_shared = true,
            std::cmp::Ordering::Less => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tree of the given parents that drains one attractor a node.
    fn tree(parents: &[i32]) -> Tree {
        Tree {
            at: vec![Vec2::ZERO; parents.len()],
            parent: parents.iter().map(|&p| p as u32).collect(),
            drained: vec![1; parents.len()],
            tick_starts: vec![0, 1],
            ..Tree::default()
        }
    }

    #[test]
    fn a_lone_mouth_is_a_source() {
        let hydrology = Hydrology::of(&tree(&[-1]));
        assert_eq!((hydrology.depth[0], hydrology.order[0], hydrology.magnitude[0]), (0, 1, 1));
    }

    #[test]
    fn orders_follow_strahler_and_magnitudes_shreve() {
        // 0 ← 1 ← {2, 3}; 2 ← {4, 5}; 3 is a source: orders 4:1, 5:1, 2:2, 3:1, 1:2.
        let hydrology = Hydrology::of(&tree(&[-1, 0, 1, 1, 2, 2]));
        assert_eq!(hydrology.order, [2, 2, 2, 1, 1, 1]);
        assert_eq!(hydrology.magnitude, [3, 3, 2, 1, 1, 1]);
        assert_eq!(hydrology.depth, [3, 2, 1, 0, 0, 0]);
        assert_eq!(hydrology.discharge, [6, 5, 3, 1, 1, 1]);
    }

    #[test]
    fn three_equal_arms_raise_the_order_once() {
        assert_eq!(Hydrology::of(&tree(&[-1, 0, 0, 0])).order[0], 2);
    }

    #[test]
    fn ticks_are_read_from_their_starts() {
        let mut tree = tree(&[-1, 0, 0, 1]);
        tree.tick_starts = vec![0, 1, 3];
        assert_eq!(tree.ticks().collect::<Vec<_>>(), [0, 1, 1, 2]);
    }
}
