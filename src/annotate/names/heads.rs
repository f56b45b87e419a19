//! The facts about rivers that names rest on. They are taken from the untrimmed tree, and so stay the same whatever is trimmed and however
//! courses are made.

use glam::Vec2;

use crate::base::geometry::distance;
use crate::base::sort;
use crate::tree::{Hydrology, NO_PARENT, Tree};

/// The lowest nodes of rivers in an untrimmed tree.
pub(super) struct Heads<'a> {
    tree: &'a Tree,
    discharge: Vec<u32>,
    own_arm: Vec<u32>,
    /// The lowest node of the river that each node belongs to.
    lowest: Vec<u32>,
    /// The nodes in the order of their identities.
    by_identity: Vec<usize>,
}

impl<'a> Heads<'a> {
    pub fn of(tree: &'a Tree) -> Self {
        let hydrology = Hydrology::of(tree);
        let own_arm = hydrology.own_arms(tree);
        let mut lowest: Vec<u32> = (0..tree.len() as u32).collect();
        for node in 0..tree.len() {
            if let Some(parent) = tree.parent_of(node).filter(|&parent| own_arm[parent] == node as u32) {
                lowest[node] = lowest[parent];
            }
        }
        let by_identity = sort::argsort((0..tree.len()).map(|node| tree.identity_of(node)));
        Self { tree, discharge: hydrology.discharge, own_arm, lowest, by_identity }
    }

    /// Returns the node of the river with an identity; `None` if there is none.
    pub fn node(&self, identity: u32) -> Option<usize> {
        let identity_of = |node: &usize| self.tree.identity_of(*node);
        let place = self.by_identity.binary_search_by_key(&identity, identity_of).ok()?;
        self.by_identity.get(place).copied()
    }

    pub fn identity(&self, node: usize) -> u32 {
        self.tree.identity_of(node)
    }

    /// Returns the discharge of a node.
    pub fn discharge(&self, node: usize) -> u32 {
        self.discharge[node]
    }

    /// Returns the length of a river from its lowest node to the tip of the branch that it follows, in units.
    pub fn length(&self, lowest: usize) -> f32 {
        let arm = |node: &usize| Some(self.own_arm[*node]).filter(|&arm| arm != NO_PARENT).map(|arm| arm as usize);
        let nodes = std::iter::successors(Some(lowest), arm);
        nodes.clone().zip(nodes.skip(1)).map(|(from, to)| distance(self.tree.at[from], self.tree.at[to])).sum()
    }

    /// Returns the lowest node of the river that a river joins; `None` for a node that is not the lowest of its own river, as where rivers
    /// cross.
    pub fn parent(&self, node: usize) -> Option<usize> {
        let junction = self.tree.parent_of(node).filter(|_| self.lowest[node] == node as u32);
        junction.map(|junction| self.lowest[junction] as usize)
    }

    /// Returns the lowest nodes of all rivers of the untrimmed tree, the greatest first.
    pub fn rivers(&self) -> Vec<usize> {
        let is_lowest = |node: &usize| self.lowest[*node] == *node as u32;
        // Of those that drain as much, the one with the lower identity comes first.
        let rivers: Vec<usize> = self.by_identity.iter().copied().filter(is_lowest).collect();
        sort::sorted_by(&rivers, |&node| u32::MAX - self.discharge[node])
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.lowest.len()
    }

    /// Iterates over a river's nodes from one of them up to its source.
    fn upstream(&self, from: usize) -> impl Iterator<Item = usize> {
        let arm = |node: &usize| Some(self.own_arm[*node]).filter(|&arm| arm != NO_PARENT).map(|arm| arm as usize);
        std::iter::successors(Some(from), arm)
    }

    /// Iterates over the places through which a river runs, from one of its nodes up to its source.
    pub fn course(&self, from: usize) -> impl Iterator<Item = Vec2> {
        self.upstream(from).map(|node| self.tree.at[node])
    }

    /// Iterates over the places of the lower course of the river of a lowest node, where it has at least a quarter of its water, without
    /// its mouth, which lies where the coast does.
    pub fn lower_course(&self, lowest: usize) -> impl Iterator<Item = Vec2> {
        let is_mouth = self.tree.parent_of(lowest).is_none() && self.own_arm[lowest] != NO_PARENT;
        let first = if is_mouth { self.own_arm[lowest] as usize } else { lowest };
        let least = self.discharge[first] / 4;
        let lower = self.upstream(first).take_while(move |&node| self.discharge[node] >= least);
        lower.map(|node| self.tree.at[node])
    }

    /// Returns the way from the river that it joins to this one, both some nodes upstream of their junction: east and south, in units.
    pub fn side(&self, node: usize) -> [f32; 2] {
        /// The number of nodes upstream after which the way of a river can be told.
        const NODES: usize = 12;
        let up = |from: usize| self.course(from).take(NODES).last().unwrap_or_default();
        let Some(junction) = self.tree.parent_of(node) else { return [0.0, 0.0] };
        let own = self.own_arm.get(junction).map_or(junction, |&arm| arm as usize);
        (up(node) - up(own)).to_array()
    }
}
