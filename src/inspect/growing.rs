//! What a map answers while it grows, or stands at a moment of its making.

use glam::Vec2;

use crate::session::Session;

/// The tips of a session's rivers, where they begin: those of the tree, trimmed as far as it has grown, until there are rivers.
pub fn tips(session: &Session) -> Vec<Vec2> {
    if let Some(network) = session.network() {
        return network.rivers.iter().map(|river| network.vertices[river.start as usize].at).collect();
    }
    let tree = session.pruned().tree;
    let mut is_tip = vec![true; tree.len()];
    for node in 0..tree.len() {
        if let Some(parent) = tree.parent_of(node) {
            is_tip[parent] = false;
        }
    }
    tree.at.iter().zip(is_tip).filter_map(|(&at, is_tip)| is_tip.then_some(at)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::distance;
    use crate::recipe::link;
    use crate::tree::Tree;

    fn grown(link: &str, ticks: u32) -> Session {
        let mut session = Session::new(link::read(&format!("seed=kea&attractors=900&{link}")).unwrap()).unwrap();
        session.advance(ticks).unwrap();
        session
    }

    fn sorted(mut places: Vec<Vec2>) -> Vec<Vec2> {
        places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        places
    }

    /// By looking for a child of each node among all nodes.
    fn childless(tree: &Tree) -> Vec<Vec2> {
        let has_child = |node: usize| (0..tree.len()).any(|other| tree.parent_of(other) == Some(node));
        (0..tree.len()).filter(|&node| !has_child(node)).map(|node| tree.at[node]).collect()
    }

    #[test]
    fn tips_are_the_nodes_without_a_child_of_what_is_left_by_trimming() {
        for link in ["growth=colonize&trim=0", "growth=colonize&trim=29", "growth=drainage", "growth=brownian&sensitivity=30"] {
            for ticks in [0, 5, 14] {
                let session = grown(link, ticks);
                assert_eq!(tips(&session), childless(&session.pruned().tree), "{link} after {ticks}");
            }
        }
    }

    #[test]
    fn every_river_has_one_tip() {
        for link in ["growth=colonize", "growth=drainage&meander-rounds=4"] {
            let mut session = grown(link, 0);
            while session.network().is_none() {
                session.advance(1).unwrap();
            }
            assert_eq!(tips(&session).len(), session.network().unwrap().rivers.len());
            session.finish().unwrap();
            assert_eq!(tips(&session).len(), session.summary().sources as usize);
        }
    }

    #[test]
    fn the_attractors_that_are_left_are_those_that_no_node_has_come_near() {
        for ticks in [1, 6, 20, 1000] {
            let session = grown("growth=colonize&land=rectangle&valleys=0", ticks);
            let growth = session.growth();
            let is_far = |at: &Vec2| growth.tree().at.iter().all(|&node| distance(node, *at) > growth.settings().kill);
            let far: Vec<Vec2> = growth.scattered().into_iter().filter(is_far).collect();
            assert_eq!(growth.left().len() as u32, growth.unreached());
            assert_eq!(sorted(growth.left()), sorted(far), "after {ticks}");
        }
    }

    #[test]
    fn the_parcels_that_are_left_are_those_without_a_node() {
        for ticks in [0, 3, 9, 1000] {
            let session = grown("growth=drainage&valleys=0", ticks);
            let (growth, at) = (session.growth(), &session.tree().at);
            let has_none: Vec<Vec2> = growth.scattered().into_iter().filter(|place| !at.contains(place)).collect();
            assert_eq!(growth.left(), has_none, "after {ticks}");
        }
    }
}
