//! The identity of a river, on which its name depends: it stays the same, whatever is trimmed and however courses are
//! made.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use crate::common::property::large;
use crate::common::tier::{one_in, tiers};
use crate::common::{finished, lands, random_link};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::network::meet;
use riverseed::tree::{Hydrology, NO_PARENT};
use riverseed::{Network, Tree};

fn rivers(link: &str, over: &str) -> Network {
    finished(link, over).network().unwrap().clone()
}

fn identities(network: &Network) -> Vec<u32> {
    network.rivers.iter().map(|river| river.identity).collect()
}

/// The position of each river's lowest node and the amount it drains, by the river's identity.
fn lowest(network: &Network) -> BTreeMap<u32, (Vec2, u32)> {
    let lowest = |end: u32| (network.vertices[end as usize - 1].at, network.vertices[end as usize - 1].discharge);
    network.rivers.iter().map(|river| (river.identity, lowest(river.end))).collect()
}

/// Returns `true` if steps of the untrimmed tree cross or touch each other, so that a branch is removed.
fn crosses(link: &str, growth: &str) -> bool {
    let session = finished(link, &format!("{growth}&style=ink&courses=grown&trim=0"));
    let tree = session.tree();
    let is_parent: BTreeSet<u32> = tree.parent.iter().copied().collect();
    let lone = |node: &u32| tree.parent[*node as usize] == NO_PARENT && !is_parent.contains(node);
    let nodes = tree.len() - (0..tree.len() as u32).filter(lone).count();
    if growth.starts_with("growth=colonize") && session.network().unwrap().vertices.len() != nodes {
        return true;
    }
    let step = |node: usize| Some([tree.at[node], tree.at[tree.parent_of(node)?]]);
    let mut steps: Vec<[Vec2; 2]> = (0..tree.len()).filter_map(step).collect();
    let west = |[a, b]: &[Vec2; 2]| a.x.min(b.x);
    steps.sort_by(|a, b| west(a).total_cmp(&west(b)));
    steps.iter().enumerate().any(|(i, [a, b])| {
        let near = steps[i + 1..].iter().take_while(|other| west(other) <= a.x.max(b.x));
        near.filter(|[c, d]| ![c, d].into_iter().any(|end| end == a || end == b)).any(|&[c, d]| meet((*a, *b), (c, d)))
    })
}

/// The ends of arms with the same discharge as another arm of their fork. The longer of these continues the river, and
/// trimming may change which one that is.
fn tied(tree: &Tree) -> BTreeSet<[u32; 2]> {
    let discharge = Hydrology::of(tree).discharge;
    let mut arms: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
    (0..tree.len()).for_each(|node| arms.entry((tree.parent[node], discharge[node])).or_default().push(node));
    let tied = arms.into_iter().filter(|((parent, _), arms)| *parent != NO_PARENT && arms.len() > 1);
    tied.flat_map(|(_, arms)| arms).map(|node| tree.at[node].to_array().map(f32::to_bits)).collect()
}

/// The number of rivers of a trimmed tree that are rivers of the untrimmed one with the same identity, and the number
/// of all.
fn kept(link: &str, growth: &str, trim: u32, channel_area: u32) -> (usize, usize) {
    // Which deltas are built depends on all rivers around, and brooks run on over them.
    let of = |more: &str| lowest(&rivers(link, &format!("{growth}&deltas=0&courses=grown&style=ink&{more}")));
    let trimmed = of(&format!("trim={trim}&channel-area={channel_area}"));
    let whole = of("trim=0&channel-area=1&head-variation=0&tributary-spacing=0");
    let tied = tied(finished(link, &format!("{growth}&deltas=0&style=ink")).tree());
    let is_kept = |(identity, at): &(&u32, &(Vec2, u32))| {
        whole.get(identity) == Some(at) || tied.contains(&at.0.to_array().map(f32::to_bits))
    };
    (trimmed.iter().filter(is_kept).count(), trimmed.len())
}

proptest! {
    #![proptest_config(large(500))]

    #[test]
    fn no_two_rivers_of_a_map_are_one_by_identity(link in random_link(600)) {
        let all = identities(&rivers(&link, "style=ink"));
        prop_assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), all.len(), "{}", link);
        prop_assert!(all.iter().all(|&identity| identity != u32::MAX));
    }

    #[test]
    fn identities_are_the_same_however_courses_are_made(
        link in random_link(400),
        simplify in 0u32..=95,
        width in 1u32..=40,
        rounds in 0u32..60,
        model in prop::sample::select(vec!["none", "bend", "flow"]),
    ) {
        let grown = identities(&rivers(&link, "style=ink&courses=grown"));
        let over = format!(
            "style=ink&courses=smooth&simplify={simplify}&width={width}&bank-variation=0.5&meander={model}\
             &meander-rounds={rounds}&great-rivers=5&meander-elsewhere=1"
        );
        prop_assert_eq!(identities(&rivers(&link, &over)), grown, "{}", link);
    }

    #[test]
    fn identities_are_the_same_however_much_is_trimmed(link in random_link(600), trim in 0u32..100, area in 1u32..30) {
        for growth in ["growth=drainage", "growth=colonize&curl=0&momentum=0"] {
            let (kept, all) = kept(&link, growth, trim, area);
            prop_assert!(kept == all || crosses(&link, growth), "{} of {} {} {}", kept, all, growth, link);
        }
    }
}

#[test]
fn where_rivers_cross_nearly_all_keep_their_identity() {
    let (mut kept_of_all, mut all_of_all) = (0, 0);
    for seed in 0..6 {
        for bends in ["curl=0.9", "curl=1.6&momentum=0.4", "curl=1&momentum=0.8"] {
            for trim in [10, 22, 60] {
                let growth = format!("growth=colonize&{bends}");
                let (kept, all) =
                    kept(&format!("land=rectangle&attractors=2000&country=usual&seed=s{seed}"), &growth, trim, 1);
                kept_of_all += kept;
                all_of_all += all;
            }
        }
    }
    assert!(kept_of_all * 100 >= all_of_all * 95, "{kept_of_all} of {all_of_all}");
}

#[test]
fn a_brownian_tree_keeps_its_identities() {
    for seed in 0..3 {
        let (kept, all) =
            kept(&format!("land=island&sensitivity=24&country=usual&seed=s{seed}"), "growth=brownian", 60, 1);
        assert!(all > 10 && kept == all, "{kept} of {all}");
    }
}

/// The number of the ten greatest rivers of a recipe without a river of the same identity near the same place in
/// another.
fn renamed(link: &str, notch: &str) -> usize {
    const NEAR: f32 = 80.0;
    let drawn = |over: &str| rivers(link, &format!("growth=drainage&courses=grown&style=ink{over}"));
    let other = lowest(&drawn(&format!("&{notch}")));
    let mut greatest: Vec<(u32, (Vec2, u32))> = lowest(&drawn("")).into_iter().collect();
    greatest.sort_by_key(|(_, (_, discharge))| u32::MAX - discharge);
    let is_there = |(identity, (at, _)): &&(u32, (Vec2, u32))| {
        other.get(identity).is_some_and(|(there, _)| there.distance(*at) < NEAR)
    };
    greatest.truncate(10);
    greatest.iter().filter(|river| !is_there(river)).count()
}

fn a_small_change_of_the_land_or_of_growth_renames_few_great_rivers() {
    let seeds = 3;
    for notch in one_in(3, ["sea=0.56", "roughness=0.99", "attractors=20400"]) {
        let lands = lands::every_land();
        let lost: usize = lands
            .iter()
            .map(|land| {
                (0..seeds)
                    .map(|seed| renamed(&format!("{land}&sea=0.55&country=usual&seed=s{seed}"), notch))
                    .sum::<usize>()
            })
            .sum();
        // A tenth; by land and over many seeds two tenths at most were seen.
        assert!(lost <= lands.len() * seeds, "{notch}: {lost} of {}", 10 * lands.len() * seeds);
    }
}

tiers!(a_small_change_of_the_land_or_of_growth_renames_few_great_rivers);
