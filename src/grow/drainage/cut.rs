//! The tree after the sea has risen: drowned parts are cut off, and their branches are rivers of their own.

use std::sync::Arc;

use glam::Vec2;

use super::directions::NONE;
use super::{Drainage, identities};
use crate::base::memory::{Refused, ask, reserve};
use crate::base::work;
use crate::land::{Cell, Land};
use crate::tree::{Hydrology, NO_PARENT, Tree};

/// A tree before it was cut, in case the sea rises otherwise.
#[derive(Debug)]
pub(super) struct Whole {
    tree: Arc<Tree>,
    node: Vec<u32>,
    mouths: u32,
    largest_basin: Option<u32>,
}

/// The parcels that the risen sea has left.
#[derive(Clone, Debug)]
pub(super) struct Left {
    /// The number of parcels on land.
    pub parcels: u32,
    /// The parcels on land from which no way leads to the sea.
    pub unreached: Vec<u32>,
}

impl Drainage {
    /// Cuts the finished tree where it meets the coast of a land that is smaller than the one it grew on. Nodes in the
    /// sea are removed. Every edge that crosses the coast gets a mouth there. Places and discharge stay.
    pub(in crate::grow) fn cut(&mut self, land: &Land) -> Result<(), Refused> {
        let Cut { tree, node, .. } = Cut::of(&self.tree, land)?;
        let (mouths, largest_basin) = (self.mouths, self.largest_basin);
        self.whole = Some(Whole { tree: self.tree.clone(), node: self.node.clone(), mouths, largest_basin }.into());
        let (mut reached, mut unreached) = (0, Vec::new());
        for (parcel, of) in (0..).zip(&mut self.node) {
            let had_none = std::mem::replace(of, node.get(*of as usize).copied().unwrap_or(NONE)) == NONE;
            reached += u32::from(*of != NONE);
            if had_none && land.at(self.parcels.at[parcel as usize]) == Cell::Land {
                unreached.push(parcel);
            }
        }
        self.mouths = tree.mouths() as u32;
        self.largest_basin = Hydrology::of(&tree).discharge.into_iter().max();
        self.tree = tree.into();
        self.left = Some(Left { parcels: reached + unreached.len() as u32, unreached });
        let middle = self.settings.domain.size / 2.0;
        identities::assign(Arc::make_mut(&mut self.tree), &self.parcels, &self.node, middle);
        Ok(())
    }

    /// Undoes the cut.
    pub(in crate::grow) fn heal(&mut self) {
        if let Some(whole) = self.whole.take() {
            let Whole { tree, node, mouths, largest_basin } = &*whole;
            (self.tree, self.node, self.mouths) = (tree.clone(), node.clone(), *mouths);
            (self.largest_basin, self.left) = (*largest_basin, None);
        }
    }
}

/// A tree in the making of another.
struct Cut<'a> {
    whole: &'a Tree,
    tree: Tree,
    /// The new number of each node of the whole tree; [`NONE`] if it has gone.
    node: Vec<u32>,
}

impl<'a> Cut<'a> {
    fn of(whole: &'a Tree, land: &Land) -> Result<Self, Refused> {
        /// The memory for a node, and for a mouth beside it.
        const BYTES_A_NODE: usize = 64;
        ask(whole.len() * BYTES_A_NODE)?;
        let mut this = Self { whole, tree: Tree::default(), node: Vec::new() };
        reserve(&mut this.node, whole.len())?;
        work::count(4 * whole.len());
        let mut starts = whole.tick_starts.iter().peekable();
        for node in 0..whole.len() {
            while starts.next_if(|start| **start as usize <= node).is_some() {
                this.tree.tick_starts.push(this.tree.len() as u32);
            }
            this.take(node, land);
        }
        let all = this.tree.len() as u32;
        this.tree.tick_starts.extend(starts.map(|_| all));
        Ok(this)
    }

    /// Takes over a node if it lies on land, and adds a mouth if it drains straight to the sea.
    fn take(&mut self, node: usize, land: &Land) {
        let at = self.whole.at[node];
        if land.at(at) == Cell::Water {
            return self.node.push(NONE);
        }
        let Some(parent) = self.whole.parent_of(node) else {
            let new = self.add(at, NO_PARENT, self.whole.drained[node], 0.0);
            return self.node.push(new);
        };
        let fall = self.whole.elevation.get(node).map(|height| height - self.whole.elevation[parent]);
        let below = match self.node[parent] {
            NONE => self.mouth(at, self.whole.at[parent], land),
            below if land.allows(self.tree.at[below as usize], at) => below,
            _ => self.mouth(at, self.whole.at[parent], land),
        };
        let height = fall.map_or(0.0, |fall| self.above(below, fall));
        let new = self.add(at, below, self.whole.drained[node], height);
        self.node.push(new);
    }

    /// Returns the elevation of a node that rises over another: higher, however small the rise.
    fn above(&self, below: u32, rise: f32) -> f32 {
        let below = self.tree.elevation.get(below as usize).copied().unwrap_or(0.0);
        (below + rise).max(below.next_up())
    }

    /// Adds the mouth of a node where the way to its former parent meets the sea; where none is met, halfway.
    fn mouth(&mut self, from: Vec2, to: Vec2, land: &Land) -> u32 {
        let at = land.coast_toward(from, to).unwrap_or_else(|| from.lerp(to, 0.5));
        self.add(at, NO_PARENT, 0, 0.0)
    }

    fn add(&mut self, at: Vec2, parent: u32, drained: u32, height: f32) -> u32 {
        let Tree { at: places, parent: parents, drained: all, elevation, .. } = &mut self.tree;
        places.push(at);
        parents.push(parent);
        all.push(drained);
        if !self.whole.elevation.is_empty() {
            elevation.push(height);
        }
        places.len() as u32 - 1
    }
}
