//! Trimming (section 4.4 of the paper), against the untrimmed tree.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::plain::plain;
use crate::common::property::cases;
use crate::common::random_link;
use crate::common::tier::{first, tiers};
use proptest::prelude::*;
use riverseed::grow::{Colonize, Growth, GrowthSettings};
use riverseed::prune::{Trim, trim};
use riverseed::recipe::{NumberKey, link};
use riverseed::tree::{Hydrology, Tree};

fn grown(link: &str) -> Tree {
    let mut growth = Colonize::new(GrowthSettings::of(&link::read(&plain(link)).unwrap())).unwrap();
    while growth.tick() {}
    Tree::clone(growth.tree())
}

fn nodes(nodes: u32) -> Trim {
    Trim { nodes, ..Trim::default() }
}

/// Depth by its recursive definition, from the children down.
fn depth_by_definition(children: &[Vec<usize>], node: usize) -> u32 {
    let mut deepest = 0;
    let mut stack = vec![(node, 0)];
    while let Some((node, distance)) = stack.pop() {
        deepest = deepest.max(distance);
        stack.extend(children[node].iter().map(|&child| (child, distance + 1)));
    }
    deepest
}

fn children(tree: &Tree) -> Vec<Vec<usize>> {
    let mut children = vec![Vec::new(); tree.len()];
    for node in 0..tree.len() {
        if let Some(parent) = tree.parent_of(node) {
            children[parent].push(node);
        }
    }
    children
}

proptest! {
    #![proptest_config(first(25, cases(150)))]

    fn a_node_goes_by_both_inequalities_or_with_its_parent(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let children = children(&tree);
        let depth: Vec<u32> = (0..tree.len()).map(|node| depth_by_definition(&children, node)).collect();
        let pruned = trim(&tree, &Hydrology::of(&tree), nodes(t));
        let stays = |node: usize| pruned.origin.binary_search(&(node as u32)).is_ok();
        for node in 0..tree.len() {
            let expected = match tree.parent_of(node) {
                None => true,
                Some(parent) => stays(parent) && !(depth[node] < t && i64::from(depth[node]) < i64::from(depth[parent]) - 1),
            };
            prop_assert_eq!(stays(node), expected, "node {} of {}, t {}", node, link, t);
        }
    }

    fn regular_endings_stay_and_no_river_ends_elsewhere(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let hydrology = Hydrology::of(&tree);
        let pruned = trim(&tree, &hydrology, nodes(t));
        for (node, &origin) in pruned.origin.iter().enumerate() {
            let origin = origin as usize;
            prop_assert_eq!(pruned.tree.at[node], tree.at[origin]);
            prop_assert_eq!(pruned.hydrology.depth[node], hydrology.depth[origin], "depth of {} in {}", origin, link);
            prop_assert_eq!(pruned.hydrology.discharge[node], hydrology.discharge[origin]);
            let parent = pruned.tree.parent_of(node).map(|parent| pruned.origin[parent] as usize);
            prop_assert_eq!(parent, tree.parent_of(origin));
        }
        prop_assert_eq!(pruned.tree.mouths(), tree.mouths());
    }

    fn water_is_neither_lost_nor_made(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let hydrology = Hydrology::of(&tree);
        let all_drained: u32 = tree.drained.iter().sum();
        let pruned = trim(&tree, &hydrology, nodes(t));
        for (tree, hydrology) in [(&tree, &hydrology), (&pruned.tree, &pruned.hydrology)] {
            let Hydrology { magnitude, order, discharge, depth, .. } = hydrology;
            prop_assert!(order.iter().zip(magnitude).all(|(&order, &magnitude)| magnitude >= 1 << (order - 1)));
            prop_assert!(depth.iter().zip(magnitude).all(|(&depth, &magnitude)| depth > 0 || magnitude == 1));
            let mouths = (0..tree.len()).filter(|&node| tree.parent_of(node).is_none());
            let at_mouths: u32 = mouths.map(|node| discharge[node]).sum();
            prop_assert_eq!(at_mouths, all_drained);
        }
        prop_assert_eq!(Hydrology::of(&pruned.tree).discharge, pruned.hydrology.discharge);
    }
}

tiers!(
    a_node_goes_by_both_inequalities_or_with_its_parent,
    regular_endings_stay_and_no_river_ends_elsewhere,
    water_is_neither_lost_nor_made,
);

#[test]
fn trimming_takes_most_short_branches() {
    let tree = grown("country=usual&seed=kauri&kill=0.7");
    let sources = |t| {
        let pruned = trim(&tree, &Hydrology::of(&tree), nodes(t));
        pruned.hydrology.depth.iter().filter(|&&depth| depth == 0).count()
    };
    let counts = [0, 2, 4, 8, 20].map(sources);
    assert!(counts.is_sorted_by(|a, b| a > b), "{counts:?}");
}

/// A tree, and the trimming by its recipe.
fn grown_and_threshold(link: &str) -> (Tree, Trim) {
    let recipe = link::read(&plain(link)).unwrap();
    let mut growth = Growth::new(GrowthSettings::of(&recipe)).unwrap();
    while growth.tick() {}
    let threshold = Trim::new(recipe.number(NumberKey::Trim), growth.node_length(), !growth.mouths_are_chosen());
    (Tree::clone(growth.tree()), threshold)
}

const BROWNIAN: &str = "growth=brownian&land=island&sensitivity=20";

#[test]
fn of_a_brownian_tree_short_basins_go_but_not_the_longest() {
    for t in [0, 5, 20, 100, 300] {
        let (tree, threshold) = grown_and_threshold(&format!("{BROWNIAN}&trim={t}"));
        let hydrology = Hydrology::of(&tree);
        let pruned = trim(&tree, &hydrology, threshold);
        let mouths = |tree: &Tree| -> Vec<usize> { (0..tree.len()).filter(|&i| tree.parent_of(i).is_none()).collect() };
        let longest = mouths(&tree).into_iter().map(|mouth| hydrology.depth[mouth]).max().unwrap();
        let expected: Vec<u32> = mouths(&tree)
            .into_iter()
            .filter(|&mouth| hydrology.depth[mouth] >= threshold.nodes.min(longest))
            .map(|mouth| mouth as u32)
            .collect();
        let left: Vec<u32> = mouths(&pruned.tree).into_iter().map(|mouth| pruned.origin[mouth]).collect();
        assert_eq!(left, expected, "trim={t}");
        assert!(!left.is_empty());
        // What stays is as deep as it was: rivers end where they did.
        let depth = pruned.origin.iter().map(|&node| hydrology.depth[node as usize]);
        assert!(depth.eq(pruned.hydrology.depth.iter().copied()));
        assert_eq!(Hydrology::of(&pruned.tree), pruned.hydrology);
    }
}

#[test]
fn one_trim_is_one_length_whatever_rivers_grew_by() {
    let length_of_a_node = |tree: &Tree| {
        let lengths = (0..tree.len()).filter_map(|node| Some(tree.at[node].distance(tree.at[tree.parent_of(node)?])));
        lengths.sum::<f32>() / (tree.len() - tree.mouths()) as f32
    };
    let colonized = "growth=colonize&valleys=0&land=rectangle&attractors=6000&step=0.38&curl=0&momentum=0";
    for growth in [BROWNIAN, colonized] {
        // Mean over some trees: lengths of single ones stray by two or three in a hundred.
        let lengths = ["kauri", "rimu", "kea", "totara"].map(|seed| {
            let (tree, threshold) = grown_and_threshold(&format!("{growth}&trim=200&country=usual&seed={seed}"));
            threshold.nodes as f32 * length_of_a_node(&tree)
        });
        let mean = lengths.iter().sum::<f32>() / lengths.len() as f32;
        assert!((196.0..204.0).contains(&mean), "{growth}: {mean}");
    }
}
