//! Silt: what great rivers carry fills the inlet where they meet.
//!
//! Two rivers that met in ground that drowns would end side by side, at the head of one inlet. Such heads are the first
//! parts of drowned valleys to fill, since all that both rivers carry comes to rest there (bay-head deltas; Dalrymple, Zaitlin
//! and Boyd 1992). So the rivers meet on land, as they did before.

use glam::Vec2;

use crate::base::geometry::{distance, nearest};
use crate::base::parts::Parts;
use crate::base::work;
use crate::grow::DrainageSettings;
use crate::land::CoastDistance;
use crate::tree::Tree;

/// The greatest length of water between a river's end and the place where it met another, along its old course, in units:
/// that of a small river, and what is added as a share of the root of the area that it drains.
const REACH: f32 = 24.0;
const REACH_BY_AREA: f32 = 0.14;

/// The height of the plain along its rivers over the sea, in units. The sea rises a little to have its share again.
const HEIGHT: f32 = 6.0;

/// Half the width of the plain beside a river, in units: the least, the greatest, and as a share of the root of the area
/// that drains there.
const HALVES: (f32, f32) = (9.0, 18.0);
const BY_AREA: f32 = 0.04;

/// The length for which a plain goes on below a confluence, as a share of half its width.
const BEYOND: f32 = 1.5;

/// The great rivers of a tree, from their beginnings to the sea.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct GreatRivers {
    /// Nodes, each after those above it.
    pub nodes: Vec<Node>,
    /// The area that drains to the sea in all rivers, in square units.
    pub area: f32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    pub at: Vec2,
    /// The area that drains there, in square units.
    pub area: f32,
    /// The node below; itself at the end of a river.
    pub below: usize,
    /// The identity of the first node of its greatest river.
    pub identity: u32,
}

/// A piece of an old course that becomes land, with half the width of its plain, in units.
struct Fill {
    ends: [Vec2; 2],
    half: f32,
}

/// A node's place in the inlets of a sea.
#[derive(Clone, Copy)]
struct Reach {
    /// The least length of water from a great river's end down to the node, in units; 0 on land.
    far: f32,
    /// The number of great rivers whose ends are within reach above the node.
    arms: u32,
    /// The length for which the plain of a confluence above goes on below the node, in units.
    beyond: f32,
    is_filled: bool,
}

impl Node {
    /// Returns the length of water that a river fills here, in units.
    fn reach(&self) -> f32 {
        REACH + REACH_BY_AREA * self.area.sqrt()
    }

    /// Returns half the width of the plain that a river makes here, in units.
    fn half(&self) -> f32 {
        (BY_AREA * self.area.sqrt()).clamp(HALVES.0, HALVES.1)
    }
}

impl GreatRivers {
    /// Finds the great rivers of a tree, from the discharge of its nodes, in parcels of an area in square units.
    pub fn of(tree: &Tree, discharge: &[u32], parcel: f32) -> Self {
        work::count(tree.len());
        let mut nodes: Vec<Node> = Vec::new();
        let mut number = vec![usize::MAX; tree.len()];
        // Nodes below come first in a tree, so that of each river is known.
        let great = (0..tree.len()).filter(|&node| discharge[node] as f32 * parcel >= DrainageSettings::GREAT);
        for node in great {
            number[node] = nodes.len();
            let below = tree.parent_of(node).map_or(nodes.len(), |parent| number[parent]);
            let identity = tree.identity_of(node);
            nodes.push(Node { at: tree.at[node], area: discharge[node] as f32 * parcel, below, identity });
        }
        let last = nodes.len().wrapping_sub(1);
        nodes.reverse();
        nodes.iter_mut().for_each(|node| node.below = last - node.below);
        hand_down_identities(&mut nodes);
        Self { nodes, area: tree.drained.iter().map(|&drained| drained as f32).sum::<f32>() * parcel }
    }

    /// Raises the heights at the corners of a lattice where a sea at some level divides great rivers close above their
    /// confluence. Returns `true` if there is such a place.
    pub fn silt_up(&self, lattice: &CoastDistance, heights: &mut [f32], level: f32) -> bool {
        let index = |at: f32, count: usize| ((at / lattice.spacing() + 0.5).max(0.0) as usize).min(count - 1);
        let (columns, rows) = lattice.size();
        let corner = |at: Vec2| index(at.y, rows) * columns + index(at.x, columns);
        let is_land: Vec<bool> = self.nodes.iter().map(|node| heights[corner(node.at)] > level).collect();
        let fills = self.fills(&is_land);
        fills.iter().for_each(|fill| fill.raise(lattice, heights, level));
        !fills.is_empty()
    }

    /// Lists what is filled, from the nodes that are on land.
    fn fills(&self, is_land: &[bool]) -> Vec<Fill> {
        work::count(4 * self.nodes.len());
        let mut reaches = self.reaches(is_land);
        let mut fills = Vec::new();
        for (i, node) in self.nodes.iter().enumerate().rev() {
            let far = reaches[i].far + self.step(i);
            if node.below != i && reaches[node.below].is_filled && far <= node.reach() {
                reaches[i].is_filled |= !is_land[i];
                fills.push(Fill { ends: [node.at, self.nodes[node.below].at], half: node.half() });
            }
        }
        fills
    }

    /// Finds the reach of each node. Nodes at sea are filled where great rivers meet within reach of their ends, and a
    /// little farther down.
    fn reaches(&self, is_land: &[bool]) -> Vec<Reach> {
        let none = Reach { far: f32::INFINITY, arms: 0, beyond: 0.0, is_filled: false };
        let mut reaches = vec![none; self.nodes.len()];
        for (i, node) in self.nodes.iter().enumerate() {
            let here = &mut reaches[i];
            if here.arms > 1 {
                here.beyond = here.beyond.max(BEYOND * node.half());
            }
            here.is_filled = here.beyond > 0.0 && !is_land[i];
            if is_land[i] || here.is_filled {
                here.far = 0.0;
            }
            let (far, beyond) = (here.far + self.step(i), here.beyond - self.step(i));
            let below = &mut reaches[node.below];
            if node.below != i && far <= node.reach() {
                below.arms += 1;
                below.far = below.far.min(far);
                below.beyond = below.beyond.max(beyond);
            }
        }
        reaches
    }

    /// Returns the distance from a node to the one below it, in units.
    fn step(&self, node: usize) -> f32 {
        distance(self.nodes[node].at, self.nodes[self.nodes[node].below].at)
    }
}

impl Fill {
    /// Raises the corners around a piece to a plain that falls toward its edges.
    fn raise(&self, lattice: &CoastDistance, heights: &mut [f32], level: f32) {
        let [from, to] = self.ends;
        let ((columns, rows), spacing) = (lattice.size(), lattice.spacing());
        let index = |at: f32, count: usize| ((at / spacing).max(0.0) as usize).min(count);
        let (first, last) = (from.min(to) - self.half, from.max(to) + self.half + spacing);
        for row in index(first.y, rows)..index(last.y, rows) {
            for column in index(first.x, columns)..index(last.x, columns) {
                work::count(1);
                let (corner, at) = (row * columns + column, Vec2::new(column as f32, row as f32) * spacing);
                let away = nearest(at, (from, to)).0 / self.half;
                // The rivers of the low stand end at its shore, so the plain does, too.
                let plain = level + (HEIGHT * (1.0 - away * away)).min(lattice.heights()[corner]);
                heights[corner] = heights[corner].max(plain);
            }
        }
    }
}

/// Gives each node the identity of the first node of the greatest river that comes to it, which stays wherever the sea ends.
fn hand_down_identities(nodes: &mut [Node]) {
    let mut greatest = vec![0.0; nodes.len()];
    for i in 0..nodes.len() {
        let Node { area, below, identity, .. } = nodes[i];
        if below != i && area > greatest[below] {
            (greatest[below], nodes[below].identity) = (area, identity);
        }
    }
}

/// Raises the waters that plains have cut off from the sea of the low stand, so that the sea is in one piece.
pub(super) fn fill_ponds(lattice: &CoastDistance, heights: &mut [f32], level: f32) {
    let is_water: Vec<bool> = heights.iter().map(|&height| height <= level).collect();
    let waters = Parts::of(&is_water, lattice.size().0);
    let is_cut_off = waters.all(|corner| lattice.heights()[corner] > 0.0);
    for (height, number) in heights.iter_mut().zip(waters.number).filter(|(_, number)| *number > 0) {
        if is_cut_off[number as usize] {
            *height = level + HEIGHT;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: usize = 52;

    /// A lattice of corners 4 units apart, and heights of 10 units over a sea and 10 units under it, south of `shore`.
    fn lattice(shore: f32) -> (CoastDistance, Vec<f32>) {
        let heights: Vec<f32> =
            (0..COLUMNS * COLUMNS).map(|i| if (i / COLUMNS) as f32 * 4.0 > shore { -10.0 } else { 10.0 }).collect();
        (of_heights(vec![10.0; COLUMNS * COLUMNS]), heights)
    }

    #[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
    fn of_heights(heights: Vec<f32>) -> CoastDistance {
        CoastDistance::of_heights(Vec2::splat(200.0), 4.0, heights).unwrap()
    }

    /// Two rivers of 100 parcels from the north, 20 units apart, that meet at y = `meet` and end at y = 200.
    fn rivers(meet: f32, areas: [u32; 2]) -> GreatRivers {
        let mut tree = Tree { at: Vec::new(), parent: Vec::new(), drained: Vec::new(), ..Tree::default() };
        let mut discharge = Vec::new();
        let mut add = |x: f32, y: f32, parent: u32, area: u32| {
            tree.at.push(Vec2::new(x, y));
            tree.parent.push(parent);
            tree.drained.push(1);
            discharge.push(area);
            tree.at.len() as u32 - 1
        };
        let [left, right] = areas;
        let mut below = crate::tree::NO_PARENT;
        for step in 0..=((200.0 - meet) / 5.0) as u32 {
            below = add(100.0, 200.0 - 5.0 * step as f32, below, left + right);
        }
        for (x, area) in [(90.0, left), (110.0, right)] {
            let mut above = below;
            for step in 1..=(meet / 5.0) as u32 {
                above = add(x, meet - 5.0 * step as f32, above, area);
            }
        }
        GreatRivers::of(&tree, &discharge, 100.0)
    }

    /// The height over a level sea of the corner at a place.
    fn at(heights: &[f32], x: f32, y: f32) -> f32 {
        heights[(y / 4.0) as usize * COLUMNS + (x / 4.0) as usize]
    }

    #[test]
    fn the_inlet_where_great_rivers_meet_becomes_a_plain() {
        let (lattice, mut heights) = lattice(80.0);
        assert!(rivers(100.0, [100, 90]).silt_up(&lattice, &mut heights, 0.0));
        for (x, y) in [(88.0, 92.0), (112.0, 92.0), (100.0, 100.0), (100.0, 108.0)] {
            assert!(at(&heights, x, y) > 0.0, "{x}, {y} is at sea");
        }
        for (x, y) in [(60.0, 92.0), (140.0, 92.0), (100.0, 140.0)] {
            assert_eq!(at(&heights, x, y), -10.0, "{x}, {y} is none of theirs");
        }
        assert_eq!(at(&heights, 100.0, 60.0), 10.0, "land stays as it was");
    }

    #[test]
    fn rivers_that_are_small_or_meet_far_out_leave_the_sea_alone() {
        for (meet, areas) in [(100.0, [100, 39]), (130.0, [100, 90]), (60.0, [100, 90])] {
            let (lattice, mut heights) = lattice(80.0);
            let before = heights.clone();
            assert!(!rivers(meet, areas).silt_up(&lattice, &mut heights, 0.0), "{meet}, {areas:?}");
            assert_eq!(heights, before);
        }
    }

    #[test]
    fn waters_that_are_cut_off_are_filled_and_those_of_the_low_stand_are_not() {
        let (corner, [pond, sea, lake]) = (|x: usize, y: usize| y * COLUMNS + x, [3, 20, 30]);
        let of = |x: usize| [corner(x, 10), corner(x + 1, 10), corner(x + 1, 11)];
        let (mut low, mut heights) = (vec![10.0; COLUMNS * COLUMNS], vec![5.0; COLUMNS * COLUMNS]);
        [pond, sea, lake].into_iter().flat_map(of).for_each(|corner| heights[corner] = -1.0);
        low[of(sea)[2]] = -3.0;
        of(lake).into_iter().for_each(|corner| low[corner] = -3.0);
        fill_ponds(&of_heights(low), &mut heights, 0.0);
        assert!(of(pond).into_iter().all(|corner| heights[corner] > 0.0));
        assert!([sea, lake].into_iter().flat_map(of).all(|corner| heights[corner] == -1.0));
    }
}
