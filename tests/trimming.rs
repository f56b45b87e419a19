//! Trimming (section 4.4 of the paper), against the untrimmed tree.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::random_link;
use proptest::prelude::*;
use riverseed::grow::{Colonize, Parameters};
use riverseed::prune::trim;
use riverseed::recipe::link;
use riverseed::tree::{Hydrology, Tree};

fn grown(link: &str) -> Tree {
    let mut growth = Colonize::new(Parameters::of(&link::read(link).unwrap())).unwrap();
    while growth.tick() {}
    growth.tree().clone()
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
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn a_node_goes_by_both_inequalities_or_with_its_parent(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let children = children(&tree);
        let depth: Vec<u32> = (0..tree.len()).map(|node| depth_by_definition(&children, node)).collect();
        let pruned = trim(&tree, &Hydrology::of(&tree), t);
        let stays = |node: usize| pruned.origin.binary_search(&(node as u32)).is_ok();
        for node in 0..tree.len() {
            let expected = match tree.parent_of(node) {
                None => true,
                Some(parent) => stays(parent) && !(depth[node] < t && i64::from(depth[node]) < i64::from(depth[parent]) - 1),
            };
            prop_assert_eq!(stays(node), expected, "node {} of {}, t {}", node, link, t);
        }
    }

    #[test]
    fn regular_endings_stay_and_no_river_ends_anew(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let hydrology = Hydrology::of(&tree);
        let pruned = trim(&tree, &hydrology, t);
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

    #[test]
    fn water_is_neither_lost_nor_made(link in random_link(600), t in 0u32..40) {
        let tree = grown(&link);
        let hydrology = Hydrology::of(&tree);
        let all_drained: u32 = tree.drained.iter().sum();
        let pruned = trim(&tree, &hydrology, t);
        for (tree, hydrology) in [(&tree, &hydrology), (&pruned.tree, &pruned.hydrology)] {
            let Hydrology { magnitude, order, discharge, depth } = hydrology;
            prop_assert!(order.iter().zip(magnitude).all(|(&order, &magnitude)| magnitude >= 1 << (order - 1)));
            prop_assert!(depth.iter().zip(magnitude).all(|(&depth, &magnitude)| depth > 0 || magnitude == 1));
            let mouths = (0..tree.len()).filter(|&node| tree.parent_of(node).is_none());
            let at_mouths: u32 = mouths.map(|node| discharge[node]).sum();
            prop_assert_eq!(at_mouths, all_drained);
        }
        prop_assert_eq!(Hydrology::of(&pruned.tree).discharge, pruned.hydrology.discharge);
    }
}

#[test]
fn trimming_takes_most_short_branches() {
    let tree = grown("seed=kauri&kill=0.7");
    let sources = |t| {
        let pruned = trim(&tree, &Hydrology::of(&tree), t);
        pruned.hydrology.depth.iter().filter(|&&depth| depth == 0).count()
    };
    let counts = [0, 2, 4, 8, 20].map(sources);
    assert!(counts.is_sorted_by(|a, b| a > b), "{counts:?}");
}
