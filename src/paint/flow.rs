//! Depth, discharge and drawn radius of the nodes of a growing tree.
//!
//! All nodes are measured again, in one pass over the tree, when enough has grown: trunks need not widen in every
//! frame. In between, only depth follows the new nodes, from each tip downstream, because it decides what may be drawn.

use super::strokes::{Pen, TAPER_NODES};
use crate::prune::Trim;
use crate::tree::Tree;

/// Discharge is measured again when one node in this many is new.
const NEWS: usize = 32;

/// Depth, radius and discharge of each node.
#[derive(Clone, Debug, Default)]
pub(super) struct Flow {
    /// The depth, as in [`crate::tree::Hydrology`].
    pub depth: Vec<u32>,
    /// The radii in sixteenths of a pixel, at the last measurement.
    pub radii: Vec<u16>,
    /// The discharges at the last measurement.
    pub discharge: Vec<u32>,
    /// `true` for nodes of channels, at the last measurement.
    pub channels: Vec<bool>,
    /// The number of nodes at the last measurement.
    measured: usize,
}

impl Flow {
    /// Updates depths after growth. Returns the nodes near growing tips whose depth has changed and is at least
    /// `least`; their radii are up to date.
    pub fn follow(&mut self, tree: &Tree, pen: &Pen, least: u32) -> Vec<u32> {
        let mut near_tip = Vec::new();
        let known = self.depth.len();
        self.depth.resize(tree.len(), 0);
        self.discharge.resize(tree.len(), 0);
        self.radii.resize(tree.len(), 0);
        for tip in known..tree.len() {
            let (mut node, mut depth) = (tip, 0);
            loop {
                self.depth[node] = depth;
                if (least..least + TAPER_NODES).contains(&depth) {
                    let discharge = self.discharge[node].max(tree.drained[node]);
                    self.radii[node] = self.radii[node].max(pen.radius(depth, discharge));
                    near_tip.push(node as u32);
                }
                depth += 1;
                match tree.parent_of(node) {
                    Some(parent) if self.depth[parent] < depth => node = parent,
                    _ => break,
                }
            }
        }
        near_tip
    }

    /// Returns `true` if enough has grown for another measurement.
    pub fn is_stale(&self, tree: &Tree) -> bool {
        tree.len() > self.measured + self.measured / NEWS
    }

    /// Measures every node in one pass from the sources down. Nodes above the heads of channels have no depth.
    pub fn measure(&mut self, tree: &Tree, pen: &Pen, trim: Trim) {
        self.depth.clear();
        self.depth.resize(tree.len(), 0);
        self.channels.clear();
        self.channels.resize(tree.len(), false);
        self.radii.resize(tree.len(), 0);
        self.discharge.clear();
        self.discharge.extend_from_slice(&tree.drained);
        let is_head = trim.heads.is_head(tree, trim.seed);
        for node in (0..tree.len()).rev() {
            let (depth, discharge) = (self.depth[node], self.discharge[node]);
            self.radii[node] = pen.radius(depth, discharge);
            self.channels[node] = self.channels[node] || is_head(node, discharge);
            if let Some(parent) = tree.parent_of(node) {
                if self.channels[node] {
                    self.channels[parent] = true;
                    self.depth[parent] = self.depth[parent].max(depth + 1);
                }
                self.discharge[parent] += discharge;
            }
        }
        self.measured = tree.len();
    }
}
