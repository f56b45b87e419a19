//! Promises about channel heads, uneven trimming and the selection of tributaries.

use super::*;
use crate::base::geometry::distance;
use crate::base::random::DEVIATION;
use crate::property::cases;
use crate::recipe::link;
use crate::session::Session;
use crate::tree::NO_PARENT;
use proptest::prelude::*;

/// Grows a tree. Returns it with its discharge and the trimming of its recipe.
fn grown(text: &str) -> (Tree, Vec<u32>, Trim) {
    let mut session = Session::new(link::read(&format!("attractors=2000&{text}")).unwrap()).unwrap();
    while session.network().is_none() {
        session.advance(100).unwrap();
    }
    let tree = session.tree().clone();
    let discharge = Hydrology::of(&tree).discharge;
    (tree, discharge, session.trim())
}

const LINKS: [&str; 4] = [
    "growth=drainage&land=rectangle",
    "growth=drainage&land=island&channel-area=1&trim=5",
    "growth=colonize&land=rectangle&mouths=3",
    "growth=brownian&sensitivity=24",
];

#[test]
fn even_channels_begin_at_one_discharge_and_uneven_ones_around_it() {
    let (tree, discharge, trim) = grown(&format!("{}&channel-area=6&head-variation=0", LINKS[0]));
    let even = trim.heads.channels(&tree, &discharge, trim.seed);
    assert!(even.iter().zip(&discharge).all(|(is_channel, discharge)| *is_channel == (*discharge >= 6)));
    let heads = Heads { variation: 0.5, ..trim.heads };
    let channels = heads.channels(&tree, &discharge, trim.seed);
    let mut has_channel_above = vec![false; tree.len()];
    for node in (0..tree.len()).filter(|&node| channels[node]) {
        // Once begun, a channel goes on to the sea.
        assert!(tree.parent_of(node).is_none_or(|parent| channels[parent]), "{node}");
        if let Some(parent) = tree.parent_of(node) {
            has_channel_above[parent] = true;
        }
    }
    let of_heads = |node: &usize| channels[*node] && !has_channel_above[*node];
    let at_heads: Vec<u32> = (0..tree.len()).filter(of_heads).map(|node| discharge[node]).collect();
    let (early, late) = (at_heads.iter().filter(|area| **area < 6), (0..tree.len()).filter(|&i| discharge[i] >= 6));
    assert!(early.count() > at_heads.len() / 5, "{at_heads:?}");
    assert!(late.filter(|&node| !channels[node]).count() > 20);
    let least = 6.0 * libm::expf(-0.5 * DEVIATION);
    assert!(at_heads.iter().all(|area| *area as f32 >= least));
}

#[test]
fn no_map_loses_its_largest_river_to_uneven_heads() {
    for seed in 0..20 {
        let link =
            format!("attractors=100&channel-area=60&head-variation=1&land=archipelago&country=usual&seed={seed}");
        let network = Session::new(link::read(&link).unwrap()).unwrap().finish().unwrap();
        assert!(!network.network().rivers.is_empty(), "{link}");
    }
}

#[test]
fn uneven_trimming_spares_some_short_branches_and_takes_some_longer_ones() {
    const FARTHEST: f32 = 3.5;
    for link in LINKS {
        let (tree, discharge, trim) = grown(link);
        let trim = Trim { nodes: 3, variation: 0.8, tributary_spacing: 0.0, ..trim };
        let channels = trim.heads.channels(&tree, &discharge, trim.seed);
        let (depth, stays) = (channel_depth(&tree, &channels), stays(&tree, &discharge, trim));
        let (mut spared, mut taken) = (0, 0);
        for node in (0..tree.len()).filter(|&node| channels[node]) {
            let Some(parent) = tree.parent_of(node).filter(|&parent| stays[parent]) else { continue };
            let times = depth[node] as f32 / trim.nodes as f32;
            let is_side_branch = depth[node] + 1 < depth[parent];
            if !is_side_branch || times > libm::expf(FARTHEST * trim.variation) {
                assert!(stays[node], "{link}: {node}");
            }
            spared += u32::from(is_side_branch && stays[node] && times < 1.0);
            taken += u32::from(!stays[node] && times > 1.0);
        }
        assert!(spared > 0 && taken > 0, "{link}: {spared}, {taken}");
    }
}

/// Selects tributaries by comparing each with everything that stays.
fn selected_one_by_one(tree: &Tree, discharge: &[u32], trim: Trim) -> Vec<bool> {
    let stays = stays(tree, discharge, Trim { tributary_spacing: 0.0, ..trim });
    let arm = |node: usize| {
        let arms = (0..tree.len()).filter(|&arm| stays[arm] && tree.parent_of(arm) == Some(node));
        arms.fold(None, |best: Option<usize>, arm| match best {
            Some(best) if discharge[best] >= discharge[arm] => Some(best),
            _ => Some(arm),
        })
    };
    let arms: Vec<Option<usize>> = (0..tree.len()).map(arm).collect();
    let begins = |&node: &usize| stays[node] && tree.parent_of(node).is_none_or(|parent| arms[parent] != Some(node));
    let mut firsts: Vec<usize> = (0..tree.len()).filter(begins).collect();
    firsts.sort_by_key(|&node| (std::cmp::Reverse(discharge[node]), node));
    let course = |first: usize| std::iter::successors(Some(first), |&node| arms[node]).collect::<Vec<_>>();
    let apart = 0.7 * trim.tributary_spacing;
    let samples = |course: &[usize]| {
        let mut samples = Vec::new();
        for &node in course {
            let to = tree.at[node];
            let is_mouth = node == course[0] && tree.parent_of(node).is_none();
            let from = if is_mouth { to } else { tree.at[tree.parent_of(node).unwrap()] };
            let pieces = (distance(from, to) / (0.5 * apart)) as u32 + 1;
            samples.extend((1..=pieces).map(|piece| from.lerp(to, piece as f32 / pieces as f32)));
        }
        samples
    };
    let mut kept = vec![false; tree.len()];
    let mut places: Vec<glam::Vec2> = Vec::new();
    // For each kept river, its course and the nodes at its junctions and ends.
    let mut rivers: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
    for first in firsts {
        let course = course(first);
        let own = samples(&course);
        let mut ends = vec![*course.last().unwrap()];
        if let Some(parent) = tree.parent_of(first) {
            let Some(river) = rivers.iter_mut().find(|(course, _)| course.contains(&parent)) else { continue };
            let chance = trim.seed.item_hash(Purpose::Trimming);
            let room = trim.tributary_spacing * libm::expf(0.8 * chance.normal([tree.identity_of(first), 1, 0]));
            let along = |node: usize| {
                let mut far = 0.0;
                let mut before = tree.at[river.0[0]];
                for &other in &river.0[..=river.0.iter().position(|&other| other == node).unwrap()] {
                    far += distance(before, tree.at[other]);
                    before = tree.at[other];
                }
                far
            };
            let is_near = |&node: &usize| {
                (along(node) - along(parent)).abs() < room || distance(tree.at[node], tree.at[parent]) < room
            };
            let far: Vec<_> = own.iter().filter(|at| distance(**at, tree.at[parent]) > 2.2 * apart).collect();
            let beside = far.iter().filter(|at| places.iter().any(|place| distance(*place, ***at) < apart)).count();
            let length: f32 = course.windows(2).map(|pair| distance(tree.at[pair[0]], tree.at[pair[1]])).sum();
            let is_crowded = length <= 8.0 * trim.tributary_spacing && river.1.iter().any(is_near);
            if is_crowded || 5 * beside > far.len() {
                continue;
            }
            river.1.push(parent);
            ends.push(first);
        }
        course.iter().for_each(|&node| kept[node] = true);
        places.extend(own);
        rivers.push((course, ends));
    }
    kept
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn tributaries_are_selected_as_by_comparing_each_with_all(
        link in prop::sample::select(LINKS.to_vec()), seed in 0u32..1000, nodes in 0u32..4, spacings in 0.1f32..6.0,
    ) {
        let mut session = Session::new(link::read(&format!("attractors=400&{link}&country=usual&seed=s{seed}")).unwrap()).unwrap();
        while session.network().is_none() {
            session.advance(100).unwrap();
        }
        let (tree, spacing) = (session.tree(), session.growth().stream_spacing());
        let discharge = Hydrology::of(tree).discharge;
        let trim = Trim { nodes, tributary_spacing: spacings * spacing, ..session.trim() };
        prop_assert_eq!(stays(tree, &discharge, trim), selected_one_by_one(tree, &discharge, trim), "{}", link);
    }
}

#[test]
fn selected_tributaries_leave_the_greatest_rivers_and_all_of_their_water() {
    for link in LINKS {
        let (tree, discharge, trim) = grown(link);
        let hydrology = Hydrology::of(&tree);
        let all = super::trim(&tree, &hydrology, Trim { tributary_spacing: 0.0, ..trim });
        let spacing = 2.0 * distance(tree.at[tree.len() - 1], tree.at[tree.parent[tree.len() - 1] as usize]);
        let chosen = super::trim(&tree, &hydrology, Trim { tributary_spacing: spacing, ..trim });
        assert!(chosen.tree.len() < all.tree.len(), "{link}");
        assert!(chosen.origin.iter().all(|node| all.origin.contains(node)), "{link}");
        let kept: Vec<u32> = chosen.origin.iter().map(|&node| discharge[node as usize]).collect();
        assert_eq!(chosen.hydrology.discharge, kept, "{link}");
        let mouths = |pruned: &Pruned| pruned.tree.parent.iter().filter(|parent| **parent == NO_PARENT).count();
        assert_eq!(mouths(&chosen), mouths(&all), "{link}");
    }
}
