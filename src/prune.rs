//! Trimming (section 4.4 of the paper): short side branches go, a river's own ending stays.
//!
//! A node X goes when depth(X) < t and depth(X) < depth(parent(X)) − 1, and with it everything upstream: read
//! literally, the paper would take only the first node of a side branch and leave the rest hanging in the air.
//! The second inequality spares the deepest arm of every fork, so basins that meet do not draw apart, every node
//! that stays keeps its depth, and every source of the trimmed tree was a source before.
//!
//! A Brownian tree has a mouth wherever its particles met the coast, most of them a brook's, so the sea counts as one more fork:
//! basins go whose longest river is short, but not the deepest of all. Where mouths were asked for, each of them stays.

use crate::tree::{Hydrology, Tree};

/// Which branches are short enough to be removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trim {
    /// The paper's t, in nodes: a side branch that is less deep goes.
    pub nodes: u32,
    /// Whether basins are side branches of the sea.
    pub treats_sea_as_fork: bool,
    /// The discharge with which a river begins: what drains less is hillside, and no part of the tree that is trimmed.
    pub channel_area: u32,
}

impl Trim {
    /// The trimming of side branches shorter than a length, of a tree whose nodes lie so far apart, both in units: as many nodes as
    /// are nearest to that.
    pub fn new(length: f32, node_length: f32, treats_sea_as_fork: bool) -> Self {
        Self { nodes: (length / node_length).round() as u32, treats_sea_as_fork, channel_area: 0 }
    }
}

/// A trimmed tree and what is left of the hydrology.
#[derive(Clone, Debug, PartialEq)]
pub struct Pruned {
    /// The nodes that stay, in their old order.
    pub tree: Tree,
    /// Depth and discharge as before (what fell on a trimmed branch still comes down the river it joined); order and magnitude of
    /// the rivers that are left.
    pub hydrology: Hydrology,
    /// Each node's place in the untrimmed tree.
    pub origin: Vec<u32>,
}

/// Trims a tree; a threshold of 0 leaves it as it is.
pub fn trim(tree: &Tree, hydrology: &Hydrology, trim: Trim) -> Pruned {
    let depth = channel_depth(tree, &hydrology.discharge, trim.channel_area);
    let stays = stays(tree, &depth, &hydrology.discharge, trim);
    let origin: Vec<u32> = (0u32..).zip(&stays).filter(|(_, stays)| **stays).map(|(node, _)| node).collect();
    let discharge: Vec<u32> = select(&hydrology.discharge, &origin);
    let tree = compact(tree, &stays, &origin, &discharge);
    let hydrology = Hydrology { discharge, ..Hydrology::of(&tree) };
    Pruned { tree, hydrology, origin }
}

/// The depth of each node in the tree of channels: 0 at a channel head, and on hillside.
pub fn channel_depth(tree: &Tree, discharge: &[u32], channel_area: u32) -> Vec<u32> {
    let mut depth = vec![0u32; tree.len()];
    for node in (0..tree.len()).rev().filter(|&node| discharge[node] >= channel_area) {
        if let Some(parent) = tree.parent_of(node) {
            depth[parent] = depth[parent].max(depth[node] + 1);
        }
    }
    depth
}

/// Whether each node stays. A parent stands before its children, so one pass lets a removal take all upstream of it.
pub fn stays(tree: &Tree, depth: &[u32], discharge: &[u32], trim: Trim) -> Vec<bool> {
    let sea = if trim.treats_sea_as_fork { depth.iter().max().map_or(0, |deepest| deepest + 1) } else { 0 };
    let mut stays = vec![true; tree.len()];
    for node in 0..tree.len() {
        let (parent_stays, below) = tree.parent_of(node).map_or((true, sea), |parent| (stays[parent], depth[parent]));
        let is_short = depth[node] < trim.nodes;
        let is_side_branch = depth[node] + 1 < below;
        stays[node] = parent_stays && discharge[node] >= trim.channel_area && !(is_short && is_side_branch);
    }
    stays
}

/// The nodes that stay, as a tree of their own.
fn compact(tree: &Tree, stays: &[bool], origin: &[u32], discharge: &[u32]) -> Tree {
    // The new number of each old node: how many stay before it.
    let mut before = Vec::with_capacity(tree.len() + 1);
    let mut count = 0u32;
    for &stays in stays {
        before.push(count);
        count += u32::from(stays);
    }
    before.push(count);
    let parent: Vec<u32> = origin
        .iter()
        .map(|&node| tree.parent_of(node as usize).map_or(crate::tree::NO_PARENT, |parent| before[parent]))
        .collect();
    Tree {
        at: select(&tree.at, origin),
        drained: own_share(&parent, discharge),
        parent,
        tick_starts: tree.tick_starts.iter().map(|&start| before[start as usize]).collect(),
        elevation: if tree.elevation.is_empty() { Vec::new() } else { select(&tree.elevation, origin) },
        identity: origin.iter().map(|&node| tree.identity_of(node as usize)).collect(),
    }
}

/// What each node drains besides its children: its discharge less theirs. A trimmed branch's water counts as the
/// node's own that it joined.
fn own_share(parent: &[u32], discharge: &[u32]) -> Vec<u32> {
    let mut drained = discharge.to_vec();
    for (&parent, &discharge) in parent.iter().zip(discharge) {
        if let Some(own) = drained.get_mut(parent as usize) {
            *own -= discharge;
        }
    }
    drained
}

fn select<T: Copy>(all: &[T], origin: &[u32]) -> Vec<T> {
    origin.iter().map(|&node| all[node as usize]).collect()
}
