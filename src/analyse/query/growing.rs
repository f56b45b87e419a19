//! Queries that also work on a map that still grows, or that is shown at a moment of its making.

use glam::Vec2;

use crate::prune::channel_depth;
use crate::session::Session;
use crate::tree::Hydrology;

/// Returns the sources of a session's rivers. While the tree grows, these are the ends of the part that is longer than
/// even trimming removes, which is also the part that pictures show.
pub fn tips(session: &Session) -> Vec<Vec2> {
    let mut tips = Vec::new();
    if let Some(network) = session.network() {
        for river in &network.rivers {
            tips.push(network.vertices[river.start as usize].at);
        }
        return tips;
    }
    let (tree, trim) = (session.tree(), session.trim());
    let discharge = Hydrology::of(tree).discharge;
    let channels = trim.heads.channels(tree, &discharge, trim.seed);
    let depth = channel_depth(tree, &channels);
    for (node, &at) in tree.at.iter().enumerate() {
        // Every deeper node has an arm that is certain, too.
        if depth[node] == trim.nodes && channels[node] {
            tips.push(at);
        }
    }
    tips
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::geometry::distance;
    use crate::prune::Trim;
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

    /// Finds the nodes that are certain to stay and have no such node above them, by walking down from every node.
    fn certain_tips(tree: &Tree, trim: Trim) -> Vec<Vec2> {
        let mut discharge = vec![0; tree.len()];
        let below = |node: usize| std::iter::successors(Some(node), |&node| tree.parent_of(node));
        for node in 0..tree.len() {
            below(node).for_each(|lower| discharge[lower] += tree.drained[node]);
        }
        let channels = trim.heads.channels(tree, &discharge, trim.seed);
        let is_channel = |node: usize| channels[node];
        let mut depth = vec![0; tree.len()];
        for node in (0..tree.len()).filter(|&node| is_channel(node)) {
            for (steps, lower) in below(node).enumerate() {
                depth[lower] = depth[lower].max(steps as u32);
            }
        }
        let is_certain = |node: usize| depth[node] >= trim.nodes && is_channel(node);
        let has_certain = |node: usize| (0..tree.len()).any(|arm| tree.parent_of(arm) == Some(node) && is_certain(arm));
        (0..tree.len()).filter(|&node| is_certain(node) && !has_certain(node)).map(|node| tree.at[node]).collect()
    }

    #[test]
    fn the_tips_of_a_tree_are_where_what_is_certain_to_stay_of_it_begins() {
        let methods = [
            "colonize&trim=0",
            "colonize&trim=29",
            "drainage",
            "drainage&trim=60",
            "drainage&head-variation=1",
            "brownian&sensitivity=30",
        ];
        for method in methods {
            let mut most = 0;
            for ticks in [0, 5, 14] {
                let session = grown(&format!("growth={method}"), ticks);
                let found = tips(&session);
                assert_eq!(found, certain_tips(session.tree(), session.trim()), "{method} after {ticks}");
                most = most.max(found.len());
            }
            assert!(most > 0, "{method}");
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
            let session = grown("growth=drainage&valleys=0&drowning=0", ticks);
            let (growth, at) = (session.growth(), &session.tree().at);
            let has_none: Vec<Vec2> = growth.scattered().into_iter().filter(|place| !at.contains(place)).collect();
            assert_eq!(growth.left(), has_none, "after {ticks}");
        }
    }
}
