//! From a tree to courses: at each confluence a river continues up the arm with the greatest discharge, and every other
//! arm is a river that joins it.

use super::ranking;
use super::uncross::uncross;
use super::{NONE, Network, River, Vertex};
use crate::land::Land;
use crate::tree::{Hydrology, NO_PARENT, Tree};

/// The courses of a tree as it grew, and the order in which their vertices go when they are simplified.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Courses {
    /// The courses, with a vertex for each node and no widths yet.
    pub network: Network,
    /// The vertices that can go, in the order in which they do.
    pub ranking: Vec<u32>,
}

impl Courses {
    /// Reads the courses of a trimmed tree, and ranks their vertices. `may_cross` says whether its steps may cross each
    /// other; `land` is where simplified courses have to stay.
    pub fn of(tree: &Tree, may_cross: bool, land: Option<&Land>) -> Self {
        Self::ranked(Self::unranked(tree, may_cross), land)
    }

    /// Reads the courses of a trimmed tree without ranking their vertices: the first half of [`Self::of`].
    pub fn unranked(tree: &Tree, may_cross: bool) -> Network {
        if may_cross { courses(&uncross(tree)) } else { courses(tree) }
    }

    /// Ranks the vertices of courses: the second half of [`Self::of`].
    pub fn ranked(network: Network, land: Option<&Land>) -> Self {
        let ranking = ranking::rank(&network, land);
        Self { network, ranking }
    }
}

/// Makes the courses of a tree, with a vertex for each node. Each river comes after the one that it joins. A mouth from
/// which nothing grew makes no river.
fn courses(tree: &Tree) -> Network {
    let hydrology = Hydrology::of(tree);
    let own_arm = hydrology.own_arms(tree);
    let mut network = Network { vertices: Vec::with_capacity(tree.len()), ..Network::default() };
    let mut river_of = vec![NONE; tree.len()];
    let mut place = vec![NONE; tree.len()];
    for lowest in 0..tree.len() {
        let parent = tree.parent[lowest];
        let begins = parent == NO_PARENT || own_arm[parent as usize] != lowest as u32;
        if !begins || (parent == NO_PARENT && own_arm[lowest] == NONE) {
            continue;
        }
        let number = network.rivers.len() as u32;
        let upstream: Vec<u32> =
            std::iter::successors(Some(lowest as u32), |&node| Some(own_arm[node as usize]).filter(|&arm| arm != NONE))
                .collect();
        let start = network.vertices.len() as u32;
        for &node in upstream.iter().rev() {
            place[node as usize] = network.vertices.len() as u32;
            river_of[node as usize] = number;
            network.vertices.push(Vertex {
                at: tree.at[node as usize],
                discharge: hydrology.discharge[node as usize],
                elevation: tree.elevation.get(node as usize).copied().unwrap_or(0.0),
                ..Vertex::default()
            });
        }
        network.rivers.push(River {
            start,
            end: network.vertices.len() as u32,
            junction: place.get(parent as usize).copied().unwrap_or(NONE),
            parent: river_of.get(parent as usize).copied().unwrap_or(NONE),
            order: hydrology.order[lowest],
            magnitude: hydrology.magnitude[lowest],
            identity: identity(tree, &upstream),
        });
    }
    network
}

/// Returns the identity of the lowest node of a river that grew; there is one, since sources always grew.
fn identity(tree: &Tree, upstream: &[u32]) -> u32 {
    let identities = upstream.iter().map(|&node| tree.identity_of(node as usize));
    identities.into_iter().find(|&identity| identity != crate::tree::UNGROWN).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    #[test]
    fn main_stem_follows_the_discharge() {
        // 0 ← 1 ← {2, 3}; 3 ← 4: the arm of 2 drains more, the arm of 3 is longer.
        let tree = Tree {
            at: (0..5).map(|i| Vec2::new(i as f32, (i * i) as f32)).collect(),
            parent: vec![NO_PARENT, 0, 1, 1, 3],
            drained: vec![1, 1, 9, 2, 3],
            tick_starts: vec![0, 1],
            ..Tree::default()
        };
        let network = courses(&tree);
        let own = |river: usize| {
            network.vertices[network.rivers[river].vertex_range()].iter().map(|v| v.at.x).collect::<Vec<_>>()
        };
        assert_eq!((own(0), own(1)), (vec![2.0, 1.0, 0.0], vec![4.0, 3.0]));
        assert_eq!((network.rivers[0].junction, network.rivers[0].parent), (NONE, NONE));
        assert_eq!((network.rivers[1].junction, network.rivers[1].parent), (1, 0));
        assert_eq!(network.vertices[2].discharge, 16);
        assert_eq!(network.rivers[1].magnitude, 1);
    }

    #[test]
    fn lone_mouth_is_no_river() {
        let tree = Tree {
            at: vec![Vec2::ZERO],
            parent: vec![NO_PARENT],
            drained: vec![1],
            tick_starts: vec![0, 1],
            ..Tree::default()
        };
        assert_eq!(courses(&tree), Network::default());
    }
}
