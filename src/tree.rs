//! The tree of rivers as arrays, and its hydrology.
//!
//! The parent of a node is the node downstream of it. Parents always precede their children in the list, so one pass
//! from the end to the start visits every node after all nodes that drain into it.

use glam::Vec2;

/// The parent of a mouth.
pub const NO_PARENT: u32 = u32::MAX;

/// The identity of a node that no grower made, such as the node at which two crossing rivers were joined.
pub const UNGROWN: u32 = u32::MAX;

/// The slope at the mouth of a river that drains the whole map: a few units in a thousand.
pub const LEAST_SLOPE: f32 = 0.055 / 14.0;

/// The nodes that grew from river mouths. Strictly a forest: one tree for each mouth.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Tree {
    /// The position of each node, in domain units.
    pub at: Vec<Vec2>,
    /// The node downstream, earlier in the list; [`NO_PARENT`] at a mouth.
    pub parent: Vec<u32>,
    /// The amount that each node itself drains: the number of attractors nearest to it when they were used up or growth
    /// ended; in a Brownian tree, one cell of river (see [`crate::grow::Brownian`]).
    pub drained: Vec<u32>,
    /// The number of nodes before each tick, from tick 0: the nodes of tick `t` start at `tick_starts[t]`.
    pub tick_starts: Vec<u32>,
    /// The elevation of each node above the sea, in units; every node is higher than its parent. Empty if the growth
    /// method gives no elevations, or has not yet.
    pub elevation: Vec<f32>,
    /// The identity of each node, which trimming does not change. All identities differ, except [`UNGROWN`]. If empty,
    /// a node's identity is its index.
    pub identity: Vec<u32>,
}

impl Tree {
    /// Returns the identity of a node; [`UNGROWN`] if it did not grow.
    pub fn identity_of(&self, node: usize) -> u32 {
        self.identity.get(node).copied().unwrap_or(node as u32)
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// Returns `true` if the tree has no nodes.
    pub fn is_empty(&self) -> bool {
        self.at.is_empty()
    }

    /// Returns the node downstream of a node; `None` at a mouth.
    #[inline]
    pub fn parent_of(&self, node: usize) -> Option<usize> {
        match self.parent[node] {
            NO_PARENT => None,
            parent => Some(parent as usize),
        }
    }

    /// Iterates over the tick in which each node grew; 0 at a mouth.
    pub fn ticks(&self) -> impl Iterator<Item = u32> {
        let ends = self.tick_starts.iter().skip(1).copied().chain([self.len() as u32]);
        (0u32..)
            .zip(self.tick_starts.iter().copied().zip(ends))
            .flat_map(|(tick, (start, end))| std::iter::repeat_n(tick, end.saturating_sub(start) as usize))
    }

    /// Returns the number of mouths.
    pub fn mouths(&self) -> usize {
        self.parent.iter().filter(|&&parent| parent == NO_PARENT).count()
    }
}

/// The hydrology of a tree, for each node.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Hydrology {
    /// The paper's depth (section 4.4): 0 at a source, otherwise one more than that of the deepest child.
    pub depth: Vec<u32>,
    /// Strahler's stream order: 1 at a source; otherwise the highest order among the children, plus one if two or more
    /// share it.
    pub order: Vec<u8>,
    /// Shreve's magnitude: the number of sources upstream; 1 at a source.
    pub magnitude: Vec<u32>,
    /// The amount drained at the node and upstream of it. Width is proportional to its square root (Leopold and Maddock
    /// 1953), so squared widths add up where rivers join.
    pub discharge: Vec<u32>,
}

impl Hydrology {
    /// Computes the hydrology of a tree in one pass, from the sources down.
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

    /// Returns, for each node, the child that continues its river upstream: the one with the greatest discharge; among
    /// equals the longest, then the first. [`NO_PARENT`] at a source.
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

    /// Settles order and magnitude of a node to which all children have been added.
    fn finish(&mut self, node: usize, highest_is_shared: bool) {
        self.order[node] += u8::from(highest_is_shared || self.order[node] == 0);
        self.magnitude[node] = self.magnitude[node].max(1);
    }

    /// Adds the depth, order, magnitude and discharge of a finished node to its parent.
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

    /// Builds a tree from its parents; each node drains one attractor.
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
