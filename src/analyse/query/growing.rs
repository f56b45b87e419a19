//! Queries that also work on a map that still grows, or that is shown at a moment of its making.

use glam::Vec2;

use crate::prune::{channel_depth, trim};
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

/// Returns what trimming has cut from the grown tree of a session that has rivers: branches from their tips down to the river or
/// the branch that they joined. None before there are rivers.
pub fn cut(session: &Session) -> Vec<Vec<Vec2>> {
    if session.network().is_none() {
        return Vec::new();
    }
    let tree = session.tree();
    let mut is_drawn = vec![false; tree.len()];
    for kept in trim(tree, &Hydrology::of(tree), session.trim()).origin {
        is_drawn[kept as usize] = true;
    }
    let mut branches = Vec::new();
    // A tree's nodes come after those that they grew from, so what is not drawn yet is a tip.
    for tip in (0..tree.len()).rev() {
        if is_drawn[tip] {
            continue;
        }
        let mut branch = vec![tree.at[tip]];
        let mut node = tip;
        while !is_drawn[node] {
            is_drawn[node] = true;
            let Some(below) = tree.parent_of(node) else { break };
            branch.push(tree.at[below]);
            node = below;
        }
        branches.push(branch);
    }
    branches
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

    /// Returns the steps of a tree that no river is made of, by asking of each node whether it stays.
    fn steps_cut(session: &Session) -> Vec<[Vec2; 2]> {
        let tree = session.tree();
        let kept = trim(tree, &Hydrology::of(tree), session.trim()).origin;
        let cut = (0..tree.len()).filter(|&node| !kept.contains(&(node as u32)));
        cut.filter_map(|node| Some([tree.at[node], tree.at[tree.parent_of(node)?]])).collect()
    }

    #[test]
    fn all_that_trimming_cuts_is_told_once_and_nothing_that_stays() {
        for (method, is_cut) in
            [("colonize&trim=29", true), ("colonize&trim=0&tributary-spacing=0", false), ("drainage&trim=60", true)]
        {
            let mut session = grown(&format!("growth={method}"), 3);
            assert!(cut(&session).is_empty(), "{method}, which has no rivers yet");
            while session.advance(1000).unwrap() {}
            let branches = cut(&session);
            let mut steps: Vec<[Vec2; 2]> =
                branches.iter().flat_map(|branch| branch.windows(2).map(|step| [step[0], step[1]])).collect();
            let mut wanted = steps_cut(&session);
            let key = |step: &[Vec2; 2]| step.map(|at| (at.x.to_bits(), at.y.to_bits()));
            steps.sort_by_key(key);
            wanted.sort_by_key(key);
            assert_eq!(steps, wanted, "{method}");
            assert_eq!(!steps.is_empty(), is_cut, "{method}");
        }
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
