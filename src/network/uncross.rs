//! A grown river that crosses another, or itself, is made to join it.
//!
//! Growth by space colonization does not look where older rivers run: with strong curl or momentum it steps across
//! them. In nature the two would join at the crossing. So steps are taken once more in the order in which they grew,
//! and one that meets an older step ends in it: the nodes beyond belong to the older river. The branch that led to the
//! crossing stays, as a river of its own. No discharge is lost.

use std::ops::Range;

use glam::Vec2;

use super::NONE;
use crate::base::geometry::{Segment, distance, height, meet, meeting};
use crate::base::work;
use crate::tree::UNGROWN;
use crate::tree::{NO_PARENT, Tree};

/// Makes a tree whose steps meet only at nodes. Its nodes are in another order than before, parents still first. A
/// branch that cannot be joined cleanly, for lack of room, is removed.
pub(super) fn uncross(tree: &Tree) -> Tree {
    let mut planar = Planar::new(tree);
    // The new index of each old node.
    let mut number = vec![NONE; tree.len()];
    for node in 0..tree.len() {
        number[node] = match tree.parent_of(node) {
            None => planar.push(tree.at[node], NO_PARENT, tree.drained[node]),
            Some(parent) if number[parent] == NONE => NONE,
            Some(parent) => planar.grow(tree.at[node], number[parent], tree.drained[node]).unwrap_or(NONE),
        };
        if let Some(identity) = planar.identity.get_mut(number[node] as usize) {
            *identity = tree.identity_of(node);
        }
    }
    planar.into_tree()
}

/// A growing tree with an index of its steps. A step is known by its upper node.
struct Planar {
    at: Vec<Vec2>,
    parent: Vec<u32>,
    drained: Vec<u32>,
    identity: Vec<u32>,
    /// A list of steps for each cell: its first entry, and for each entry the step and the next entry.
    first: Vec<u32>,
    entries: Vec<(u32, u32)>,
    columns: usize,
    rows: usize,
    side: f32,
    corner: Vec2,
    /// The length up to which a piece of a step does not count.
    tiny: f32,
}

impl Planar {
    fn new(tree: &Tree) -> Self {
        let steps = (0..tree.len()).filter_map(|node| Some(distance(tree.at[node], tree.at[tree.parent_of(node)?])));
        let (total, count) = steps.fold((0.0, 0), |(total, count), step| (total + step, count + 1));
        let mean: f32 = total / count.max(1) as f32;
        let corner = tree.at.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let size = tree.at.iter().copied().fold(corner, Vec2::max) - corner;
        // Large enough for a step to lie in a cell or two, and not so small that cells outnumber steps by far.
        let side = (mean * 1.5).max((size.x * size.y / (4 * tree.len() + 1) as f32).sqrt()).max(1e-3);
        let (columns, rows) = ((size.x / side) as usize + 1, (size.y / side) as usize + 1);
        let capacity = tree.len() + tree.len() / 8;
        let mut this = Self {
            at: Vec::with_capacity(capacity),
            parent: Vec::with_capacity(capacity),
            drained: Vec::with_capacity(capacity),
            identity: Vec::with_capacity(capacity),
            first: vec![NONE; columns * rows],
            entries: Vec::with_capacity(2 * capacity),
            columns,
            rows,
            side,
            corner,
            tiny: mean * 0.02,
        };
        this.entries.clear();
        this
    }

    fn push(&mut self, at: Vec2, parent: u32, drained: u32) -> u32 {
        let node = self.at.len() as u32;
        self.at.push(at);
        self.parent.push(parent);
        self.drained.push(drained);
        self.identity.push(UNGROWN);
        if parent != NO_PARENT {
            self.enter(node);
        }
        node
    }

    /// Adds a step from a node, or from the last older step that it would meet. Returns the new node; `None` if neither
    /// is possible.
    fn grow(&mut self, at: Vec2, from: u32, drained: u32) -> Option<u32> {
        if self.folds_back(at, from) {
            return None;
        }
        let Some((step, share)) = self.last_met((at, self.at[from as usize]), from) else {
            return Some(self.push(at, from, drained));
        };
        let crossing = at.lerp(self.at[from as usize], share);
        let (upper, lower) = (step, self.parent[step as usize]);
        let ends = [upper, lower];
        if let Some(&end) = ends.iter().find(|&&end| distance(self.at[end as usize], crossing) <= self.tiny) {
            return self.is_free((at, self.at[end as usize]), &[end]).then(|| self.push(at, end, drained));
        }
        let halves = [(self.at[upper as usize], crossing), (crossing, self.at[lower as usize])];
        let is_clean = distance(at, crossing) > self.tiny
            && self.is_free((at, crossing), &ends)
            && halves.iter().all(|&half| self.is_free(half, &ends));
        is_clean.then(|| {
            let junction = self.push(crossing, lower, 0);
            self.parent[upper as usize] = junction;
            self.push(at, junction, drained)
        })
    }

    /// Returns `true` if a step from a node would lie upon another step that ends there.
    fn folds_back(&self, at: Vec2, from: u32) -> bool {
        let new = (at, self.at[from as usize]);
        let mut folds_back = false;
        self.visit(new, &mut |step| {
            let far_end = match (step == from, self.parent[step as usize] == from) {
                (true, _) => self.parent[step as usize],
                (_, true) => step,
                _ => return,
            };
            let far_end = self.at[far_end as usize];
            folds_back |= height(at, far_end, new.1) <= self.tiny || height(far_end, at, new.1) <= self.tiny;
        });
        folds_back
    }

    /// Finds the step that a new one meets last on its way from `from`, and the share of its way that is left then;
    /// `None` if it meets none.
    fn last_met(&self, new: Segment, from: u32) -> Option<(u32, f32)> {
        let mut met: Option<(u32, f32)> = None;
        self.visit(new, &mut |step| {
            let other = self.segment(step);
            if step == from || self.parent[step as usize] == from || !meet(new, other) {
                return;
            }
            let share = meeting(new, other);
            if met.is_none_or(|(_, least)| share < least) {
                met = Some((step, share));
            }
        });
        met
    }

    /// Returns `true` if a segment meets no step but those that end in one of some nodes.
    fn is_free(&self, new: Segment, ends: &[u32]) -> bool {
        let mut is_free = true;
        self.visit(new, &mut |step| {
            let is_end = ends.contains(&step) || ends.contains(&self.parent[step as usize]);
            is_free &= is_end || !meet(new, self.segment(step));
        });
        is_free
    }

    fn segment(&self, step: u32) -> Segment {
        (self.at[step as usize], self.at[self.parent[step as usize] as usize])
    }

    fn enter(&mut self, step: u32) {
        let (columns, rows) = self.cells(self.segment(step));
        for row in rows {
            for column in columns.clone() {
                let first = &mut self.first[row * self.columns + column];
                self.entries.push((step, std::mem::replace(first, self.entries.len() as u32)));
            }
        }
    }

    fn visit(&self, segment: Segment, visit: &mut dyn FnMut(u32)) {
        let (columns, rows) = self.cells(segment);
        for row in rows {
            for column in columns.clone() {
                let mut entry = self.first[row * self.columns + column];
                let mut visited = 1;
                while let Some(&(step, next)) = self.entries.get(entry as usize) {
                    visit(step);
                    entry = next;
                    visited += 1;
                }
                work::count(visited);
            }
        }
    }

    /// Returns the columns and rows of the cells that the box around a segment touches.
    fn cells(&self, (a, b): Segment) -> (Range<usize>, Range<usize>) {
        let place = |x: f32, end: usize| ((x / self.side) as usize).min(end - 1);
        let (least, most) = (a.min(b) - self.corner, a.max(b) - self.corner);
        let range = |least: f32, most: f32, end: usize| place(least, end)..place(most, end) + 1;
        (range(least.x, most.x, self.columns), range(least.y, most.y, self.rows))
    }

    /// Sorts the nodes so that parents come before their children, and returns them as a tree.
    fn into_tree(self) -> Tree {
        let count = self.at.len();
        let mut upper = vec![NONE; count];
        let mut sibling = vec![NONE; count];
        let mut order: Vec<u32> = Vec::with_capacity(count);
        for node in (0..count).rev() {
            match self.parent[node] {
                NO_PARENT => order.push(node as u32),
                parent => {
                    sibling[node] = upper[parent as usize];
                    upper[parent as usize] = node as u32;
                }
            }
        }
        order.reverse();
        let mut number = vec![NO_PARENT; count];
        let mut next = 0;
        while let Some(&node) = order.get(next) {
            number[node as usize] = next as u32;
            let mut child = upper[node as usize];
            while child != NONE {
                order.push(child);
                child = sibling[child as usize];
            }
            next += 1;
        }
        let parent = |node: u32| number.get(self.parent[node as usize] as usize).copied().unwrap_or(NO_PARENT);
        Tree {
            at: order.iter().map(|&node| self.at[node as usize]).collect(),
            parent: order.iter().map(|&node| parent(node)).collect(),
            drained: order.iter().map(|&node| self.drained[node as usize]).collect(),
            identity: order.iter().map(|&node| self.identity[node as usize]).collect(),
            tick_starts: vec![0, count as u32],
            ..Tree::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a river from (0, 0) eastward, and a later one from the south, with its last node at `last`.
    fn crossing(last: Vec2) -> Tree {
        let at = [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0), (14.0, 16.0), (14.0, 6.0)].map(Vec2::from);
        Tree {
            at: at.into_iter().chain([last]).collect(),
            parent: vec![NO_PARENT, 0, 1, NO_PARENT, 3, 4],
            drained: vec![1, 2, 3, 4, 5, 6],
            tick_starts: vec![0, 6],
            ..Tree::default()
        }
    }

    #[test]
    fn a_step_across_an_older_one_joins_it_there() {
        let tree = uncross(&crossing(Vec2::new(14.0, -6.0)));
        let junction = (0..tree.len()).find(|&node| tree.at[node].distance(Vec2::new(14.0, 0.0)) < 1e-4).unwrap();
        let upper: Vec<Vec2> =
            (0..tree.len()).filter(|&node| tree.parent_of(node) == Some(junction)).map(|node| tree.at[node]).collect();
        assert_eq!(tree.len(), 7);
        assert!(upper.contains(&Vec2::new(20.0, 0.0)) && upper.contains(&Vec2::new(14.0, -6.0)));
        assert_eq!(tree.at[tree.parent_of(junction).unwrap()], Vec2::new(10.0, 0.0));
        assert_eq!(tree.drained.iter().sum::<u32>(), 21, "nothing is lost of what they drain");
        let mut identities = tree.identity;
        assert_eq!(identities[junction], UNGROWN);
        identities.sort_unstable();
        assert_eq!(identities, [0, 1, 2, 3, 4, 5, UNGROWN]);
    }

    #[test]
    fn what_does_not_cross_stays() {
        let tree = crossing(Vec2::new(14.0, 2.0));
        let uncrossed = uncross(&tree);
        let sorted = |at: &[Vec2]| {
            let mut at: Vec<(u32, u32)> = at.iter().map(|at| (at.x.to_bits(), at.y.to_bits())).collect();
            at.sort_unstable();
            at
        };
        assert_eq!(sorted(&uncrossed.at), sorted(&tree.at));
    }

    #[test]
    fn a_crossing_beside_a_node_ends_in_the_node() {
        let tree = uncross(&crossing(Vec2::new(6.02, -6.0)));
        assert_eq!(tree.len(), 6);
        let last = (0..tree.len()).find(|&node| tree.at[node].y < 0.0).unwrap();
        assert_eq!(tree.at[tree.parent_of(last).unwrap()], Vec2::new(10.0, 0.0));
    }
}
