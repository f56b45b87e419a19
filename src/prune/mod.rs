//! Trimming (section 4.4 of the paper): removes short side branches and keeps the end of each river.
//!
//! A node X is removed if depth(X) < t and depth(X) < depth(parent(X)) − 1, along with everything upstream of it. (Read
//! literally, the paper removes only the first node of a side branch and leaves the rest disconnected.) The second
//! condition spares the deepest branch of every fork. Therefore basins that meet do not draw apart, every remaining
//! node keeps its depth, and every source of the trimmed tree was a source before.
//!
//! A Brownian tree has a mouth wherever its particles met the coast, mostly of brooks. The sea then counts as one more
//! fork: basins whose longest river is short are removed, except the deepest basin. If the recipe asks for mouths, all
//! of them stay.
//!
//! Two further rules keep a trimmed tree from looking clipped: the threshold varies from branch to branch, and of
//! tributaries that crowd along a river only the greatest stay (`selection.rs`). Drainage is first cut back to its
//! channels (`heads.rs`).

mod heads;
mod selection;
#[cfg(test)]
mod tests;

pub use heads::Heads;

use crate::base::random::{Purpose, Seed};
use crate::tree::{Hydrology, Tree};

/// The branches to remove.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trim {
    /// The paper's t, in nodes: side branches with a lower depth are removed.
    pub nodes: u32,
    /// `true` if basins count as side branches of the sea.
    pub treats_sea_as_fork: bool,
    /// The deviation of the logarithm of that depth from branch to branch.
    pub variation: f32,
    /// The rule for channel heads. Whatever lies above them is hillside and is removed.
    pub heads: Heads,
    /// The distance that tributaries keep from greater ones, in units; 0 if they need not.
    pub tributary_spacing: f32,
    /// The seed of all variation.
    pub seed: Seed,
}

impl Trim {
    /// Trims side branches shorter than `length`, in a tree whose nodes are `node_length` apart. Both are in units; the
    /// length is rounded to whole nodes.
    pub fn new(length: f32, node_length: f32, treats_sea_as_fork: bool) -> Self {
        Self { nodes: (length / node_length).round() as u32, treats_sea_as_fork, ..Self::default() }
    }
}

/// A trimmed tree and its hydrology.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pruned {
    /// The nodes that stay, in their original order.
    pub tree: Tree,
    /// Depth, order and magnitude of the trimmed tree, and the discharge from before: water of removed branches still
    /// flows down the rivers that they joined.
    pub hydrology: Hydrology,
    /// The index of each node in the untrimmed tree.
    pub origin: Vec<u32>,
}

/// Trims a tree. A threshold of 0 leaves it unchanged.
pub fn trim(tree: &Tree, hydrology: &Hydrology, trim: Trim) -> Pruned {
    let stays = stays(tree, &hydrology.discharge, trim);
    let origin: Vec<u32> = (0u32..).zip(&stays).filter(|(_, stays)| **stays).map(|(node, _)| node).collect();
    let discharge: Vec<u32> = select(&hydrology.discharge, &origin);
    let tree = compact(tree, &stays, &origin, &discharge);
    let hydrology = Hydrology { discharge, ..Hydrology::of(&tree) };
    Pruned { tree, hydrology, origin }
}

/// Returns the depth of each node in the tree of channels; 0 at channel heads and on hillside.
pub fn channel_depth(tree: &Tree, channels: &[bool]) -> Vec<u32> {
    let mut depth = vec![0u32; tree.len()];
    for node in (0..tree.len()).rev().filter(|&node| channels[node]) {
        if let Some(parent) = tree.parent_of(node) {
            depth[parent] = depth[parent].max(depth[node] + 1);
        }
    }
    depth
}

/// Returns, for each node of a finished tree, `true` if it stays.
pub fn stays(tree: &Tree, discharge: &[u32], trim: Trim) -> Vec<bool> {
    let channels = trim.heads.channels(tree, discharge, trim.seed);
    let stays = without_short_branches(tree, &channels, trim);
    selection::select(tree, discharge, stays, trim)
}

/// Returns, for each node, `true` unless it is hillside or on a short side branch. Parents precede their children, so
/// in one pass a removal reaches everything upstream.
fn without_short_branches(tree: &Tree, channels: &[bool], trim: Trim) -> Vec<bool> {
    let depth = channel_depth(tree, channels);
    let chance = trim.seed.item_hash(Purpose::Trimming);
    let least = |node: usize| {
        if trim.variation == 0.0 {
            return trim.nodes as f32;
        }
        trim.nodes as f32 * libm::expf(trim.variation * chance.normal([tree.identity_of(node), 0, 0]))
    };
    let sea = if trim.treats_sea_as_fork { depth.iter().max().map_or(0, |deepest| deepest + 1) } else { 0 };
    let mut stays = vec![true; tree.len()];
    for node in 0..tree.len() {
        let (parent_stays, below) = tree.parent_of(node).map_or((true, sea), |parent| (stays[parent], depth[parent]));
        let is_side_branch = depth[node] + 1 < below;
        stays[node] = parent_stays && channels[node] && !(is_side_branch && (depth[node] as f32) < least(node));
    }
    stays
}

/// Copies the nodes that stay into a new tree.
fn compact(tree: &Tree, stays: &[bool], origin: &[u32], discharge: &[u32]) -> Tree {
    // The new index of each old node: the number of nodes before it that stay.
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

/// Returns the amount that each node drains itself: its discharge less that of its children. The water of a removed
/// branch counts as that of the node it joined.
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
