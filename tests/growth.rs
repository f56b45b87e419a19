//! Promises of growth: the paper's procedure to the bit, valid trees, and an end.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::lands::every_land;
use crate::common::plain::plain;
use crate::common::property::{cases, large};
use crate::common::tier::{one_in, tiers};
use crate::common::{random_link, twin};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::grow::{Colonize, Ending, Growth, GrowthSettings, scatter};
use riverseed::land::Cell;
use riverseed::recipe::{Key, link, preset::PRESETS};
use riverseed::tree::Tree;

fn settings(link: &str) -> GrowthSettings {
    GrowthSettings::of(&link::read(&plain(link)).unwrap())
}

fn grown(link: &str) -> Colonize {
    grown_by(settings(link))
}

fn grown_by(settings: GrowthSettings) -> Colonize {
    let mut growth = Colonize::new(settings).unwrap();
    while growth.tick() {}
    growth
}

fn assert_equals_twin(link: &str) {
    let growth = grown(link);
    let tree = growth.tree();
    let twin = twin::grow(growth.settings());
    for (i, (node, tick)) in twin.iter().zip(tree.ticks()).enumerate() {
        // With valleys the twin has no ticks.
        let tick = if growth.settings().has_valleys() { node.tick } else { tick };
        let ours = (tree.at[i], tree.parent[i], tick, tree.drained[i]);
        assert_eq!(ours, (node.at, node.parent, node.tick, node.drained), "node {i} of {link}");
    }
    assert_eq!(tree.len(), twin.len(), "{link}");
}

#[test]
fn every_variant_equals_the_brute_force_twin_over_20_seeds() {
    for preset in PRESETS {
        for seed in 0..20 {
            assert_equals_twin(&format!("seed={seed}&preset={}&attractors=400&mouths={}", preset.name, 1 + seed % 4));
        }
    }
}

#[test]
fn a_river_that_nothing_reaches_runs_straight_inland() {
    let mut pilots = 0;
    for seed in 0..60 {
        // So few attractors, so short a reach and so many mouths that some see none.
        let link = format!("country=usual&seed={seed}&attractors=100&mouths=64&sides=nesw&reach=2.1&step=0.2&curl=1");
        assert_equals_twin(&link);
        let growth = grown(&link);
        let (settings, tree) = (growth.settings(), growth.tree());
        let attractors = scatter(settings);
        let is_reached = |at| attractors.iter().any(|&a| a.distance(at) < settings.reach * 0.999);
        let children_of = |node: usize| tree.parent.iter().filter(move |&&parent| parent == node as u32).count();
        // The end of a stem has all of its ancestors at tick 0 and no child there.
        for node in 0..tree.tick_starts[1] as usize {
            let is_end = node + 1 == tree.tick_starts[1] as usize || tree.parent_of(node + 1) != Some(node);
            if is_end && !is_reached(tree.at[node]) {
                pilots += 1;
                assert_eq!(children_of(node), 1, "node {node} of {link}");
            }
        }
    }
    assert!(pilots > 0, "all mouths are within reach: the test tests nothing");
}

#[test]
fn a_river_that_runs_through_the_land_unreached_stops_no_other() {
    for seed in [8311, 59489, 107513, 123817] {
        let link = format!("country=usual&seed={seed}&attractors=100&mouths=64&sides=ns&reach=2.1&aspect=4");
        assert_equals_twin(&link);
        assert!(grown(&link).unreached() < 50, "{link}");
    }
}

#[test]
fn a_reach_across_a_narrow_land_loses_no_attractor() {
    for seed in ["rc", "a", "b", "c"] {
        let link = format!(
            "country=usual&seed={seed}&land=valley&sea=0.1&roughness=0&aspect=0.25&sides=ne&mouths=1&attractors=100"
        );
        assert_equals_twin(&format!("{link}&reach=11.585&kill=0.5&step=0.2"));
    }
}

#[test]
fn growth_stops_before_its_limit_of_nodes() {
    let growth = Colonize::new(settings("attractors=1000")).unwrap();
    let mut growth = growth.with_node_limit(300);
    while growth.tick() {}
    assert_eq!(growth.ending(), Some(Ending::NodeLimit));
    assert!((200..=300).contains(&growth.tree().len()));
    let drained: u32 = growth.tree().drained.iter().sum();
    assert!(drained >= 1000 - growth.unreached());
}

fn no_preset_and_no_default_runs_dry() {
    let bases = PRESETS.iter().map(|preset| plain(&format!("preset={}&mouths=1&attractors=3000", preset.name)));
    // The table's defaults, whatever they are, and the first ones.
    for base in bases.chain(["attractors=3000".into(), plain("mouths=1&attractors=3000")]) {
        for (seed, mouths) in one_in(5, (0..150).flat_map(|seed| [(seed, 1), (seed, 3)])) {
            let link = format!("country=usual&seed=w{seed}&{}", base.replace("mouths=1", &format!("mouths={mouths}")));
            let unreached = grown_by(GrowthSettings::of(&link::read(&link).unwrap())).unreached();
            assert!(unreached < 300, "{link} leaves {unreached} of 3000 unreached");
        }
    }
}

tiers!(no_preset_and_no_default_runs_dry);

#[test]
fn no_kind_of_land_is_left_dry() {
    let lands = every_land();
    for (land, seed) in lands.iter().flat_map(|land| (0..40).map(move |seed| (land, seed))) {
        let growth = grown(&format!("{land}&country=usual&seed={seed}&attractors=1500"));
        let (unreached, all) = (growth.unreached(), growth.attractors());
        assert!(unreached * 20 <= all, "{land}, seed {seed}: {unreached} of {all} are unreached");
    }
}

#[test]
fn every_island_of_some_size_has_rivers() {
    for seed in 0..10 {
        let settings = settings(&format!("land=archipelago&country=usual&seed={seed}&mouths=1"));
        let land = settings.land().unwrap().clone();
        let mouths = riverseed::grow::mouths(&settings);
        let all: u32 = land.regions().iter().map(|region| region.cells).sum();
        for region in land.regions().iter().filter(|region| region.cells * 100 >= all) {
            assert!(mouths.iter().any(|mouth| region.holds(mouth.at)), "seed {seed}: {} cells", region.cells);
        }
    }
}

#[test]
fn a_lake_has_thrice_the_mouths_and_from_every_side() {
    for seed in 0..8 {
        let settings = settings(&format!("land=basin&country=usual&seed={seed}&mouths=4&roughness=0.2"));
        let mouths = riverseed::grow::mouths(&settings);
        assert!(mouths.len() >= 12, "seed {seed}: {}", mouths.len());
        let centre = settings.domain.size / 2.0;
        for way in [Vec2::X, Vec2::NEG_X, Vec2::Y, Vec2::NEG_Y] {
            // A third of the way out at least, so that it is a side and not the middle.
            let is_there = |at: Vec2| ((at - centre) / settings.domain.size).dot(way) > 1.0 / 6.0;
            assert!(mouths.iter().any(|mouth| is_there(mouth.at)), "seed {seed}: none toward {way}");
        }
    }
}

#[test]
fn mouths_lie_on_the_chosen_shores() {
    for (kind, seed) in ["island", "basin"].iter().flat_map(|kind| (0..5).map(move |seed| (kind, seed))) {
        for (shores, way) in [("n", Vec2::NEG_Y), ("e", Vec2::X), ("s", Vec2::Y), ("w", Vec2::NEG_X)] {
            let link =
                format!("land={kind}&country=usual&seed={seed}&shores={shores}&mouths=5&attractors=1000&roughness=0.2");
            let growth = grown(&link);
            let (tree, centre) = (growth.tree(), growth.settings().domain.size / 2.0);
            for mouth in (0..tree.len()).filter(|&node| tree.parent_of(node).is_none()) {
                assert!((tree.at[mouth] - centre).dot(way) > 0.0, "{link}: {}", tree.at[mouth]);
            }
        }
    }
}

/// The points where a tree of drainage meets the coast.
fn mouths_of_drainage(link: &str) -> (Vec<Vec2>, GrowthSettings) {
    let mut growth = Growth::new(settings(&format!("growth=drainage&attractors=4000&{link}"))).unwrap();
    while growth.tick() {}
    let tree = growth.tree();
    let mouths = (0..tree.len()).filter(|&node| tree.parent_of(node).is_none()).map(|node| tree.at[node]).collect();
    (mouths, growth.settings().clone())
}

#[test]
fn mouths_of_drainage_are_as_many_as_far_apart_and_on_the_shores_that_are_asked_for() {
    for (kind, seed) in ["island", "basin"].iter().flat_map(|kind| (0..4).map(move |seed| (kind, seed))) {
        let land = format!("land={kind}&country=usual&seed={seed}&roughness=0.2");
        let (all, _) = mouths_of_drainage(&format!("{land}&mouths=0"));
        let (chosen, settings) = mouths_of_drainage(&format!("{land}&mouths=5"));
        let asked: u32 = settings.basins.iter().sum();
        assert_eq!(chosen.len(), asked as usize, "{land}");
        assert!(asked >= 5 && all.len() > 2 * chosen.len(), "{land}: {}", all.len());
        let (apart, _) = mouths_of_drainage(&format!("{land}&mouths=0&mouth-spacing=150"));
        let pairs = apart.iter().enumerate().flat_map(|(i, a)| apart[..i].iter().map(move |b| a.distance(*b)));
        assert!(apart.len() > 3 && pairs.min_by(f32::total_cmp).unwrap() > 150.0, "{land}: {}", apart.len());
        for (shores, way) in [("n", Vec2::NEG_Y), ("e", Vec2::X), ("s", Vec2::Y), ("w", Vec2::NEG_X)] {
            let (mouths, settings) = mouths_of_drainage(&format!("{land}&mouths=0&shores={shores}"));
            let centre = settings.domain.size / 2.0;
            let is_there = |at: &Vec2| (*at - centre).dot(way) > 0.0;
            assert!(!mouths.is_empty() && mouths.iter().all(is_there), "{land}: not on {shores} alone");
        }
    }
}

#[test]
fn one_attractor_more_leaves_the_others_where_they_are() {
    let places = |n: u32| scatter(&settings(&format!("attractors={n}")));
    assert_eq!(places(500), places(501)[..500]);
}

#[test]
fn a_grid_has_one_attractor_in_every_cell_of_its_row() {
    for n in [100u32, 101, 997] {
        let settings = settings(&format!("attractors={n}&scatter=grid"));
        let places = scatter(&settings);
        assert_eq!(places.len(), n as usize);
        let rows = (settings.domain.size.y / settings.spacing).round();
        let row_of = |y: f32| (y / settings.domain.size.y * rows) as usize;
        for row in 0..rows as usize {
            let mut columns: Vec<f32> = places.iter().filter(|at| row_of(at.y) == row).map(|at| at.x).collect();
            columns.sort_by(f32::total_cmp);
            let width = settings.domain.size.x / columns.len() as f32;
            assert!(columns.iter().enumerate().all(|(i, x)| (x / width) as usize == i), "{n}, row {row}");
        }
    }
}

/// Checks that parents come first, that no step is too long, and that everything is finite and within the domain.
fn check_tree(tree: &Tree, settings: &GrowthSettings) -> Result<(), TestCaseError> {
    for node in 0..tree.len() {
        prop_assert!(settings.domain.contains(tree.at[node]) && is_land(settings, tree.at[node]));
        if let Some(parent) = tree.parent_of(node) {
            prop_assert!(parent < node);
            prop_assert!(settings.allows(tree.at[parent], tree.at[node]), "{parent} to {node} leaves the land");
            let length = tree.at[node].distance(tree.at[parent]);
            prop_assert!((length - settings.step).abs() < 1e-3 * settings.step, "{length}");
        }
    }
    let most = if settings.land().is_some() { usize::MAX } else { settings.mouths as usize };
    prop_assert!((1..=most).contains(&tree.mouths()));
    prop_assert_eq!(tree.ticks().count(), tree.len());
    Ok(())
}

/// Checks that growth ends, that its tree is valid, and that every attractor is drained or reported as unreached.
fn check_growth(link: &str) -> Result<(), TestCaseError> {
    let growth = grown(link);
    prop_assert_eq!(growth.ending(), Some(Ending::Complete), "{}", link);
    check_tree(growth.tree(), growth.settings())?;
    let drained: u32 = growth.tree().drained.iter().sum();
    let all = scatter(growth.settings()).len() as u32;
    prop_assert!((all - growth.unreached()..=all).contains(&drained));
    Ok(())
}

proptest! {
    #![proptest_config(large(200))]

    #[test]
    fn any_recipe_equals_the_brute_force_twin(link in random_link(300)) {
        assert_equals_twin(&link);
    }
}

proptest! {
    #![proptest_config(cases(80))]

    #[test]
    fn any_recipe_with_valleys_equals_its_brute_force_twin(link in random_link(300), valleys in 0.01f32..=1.0) {
        let mut recipe = link::read(&link).unwrap();
        recipe.set(Key::Growth, "colonize").unwrap();
        recipe.set(Key::Valleys, &format!("{valleys:.3}")).unwrap();
        assert_equals_twin(&link::write(&recipe));
    }
}

proptest! {
    #![proptest_config(large(2000))]

    #[test]
    fn any_recipe_grows_a_tree_and_ends(link in random_link(2000)) {
        check_growth(&link)?;
    }
}

/// Each of these once broke a promise.
const FOUND_BY_CHANCE: [&str; 5] = [
    "country=usual&seed=Jc-%F0%9F%9F%A2%C3%9Dxs%F0%9F%95%B2%27%60%E1%A6%B27%24%F0%90%A3%A9ML%28%F0%90%9D%A4%C2%A3%E1%A7%95%E0%A7%9C%3D%E0%A7%9D%F0%9F%81%86.%5C-%5C%F0%91%A3%9B&growth=colonize&valleys=0.01&sensitivity=40&mouth-spacing=0&shores=nesw&land=archipelago&outline=&sea=0.657&roughness=0.325&aspect=2.908&mouths=1&sides=n&attractors=223&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&courses=smooth&simplify=0&bank-variation=0.000&meander=bend&meander-rounds=0&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=0&flat-share=0.000&neck=1.00&clearance=0.00&taper=1.00",
    "country=usual&seed=a&land=island&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=n&attractors=100&scatter=grid&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink",
    "country=usual&seed=h&land=island&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=n&attractors=100&scatter=grid&reach=2.100&kill=1.4&step=1.021&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink",
    "country=usual&seed=sxpmpaa&land=continent&sea=0.211&roughness=0.678&aspect=2.350&mouths=2&sides=n&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink",
    "country=usual&seed=unbisoy&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=277&shores=sw&land=continent&outline=&sea=0.674&roughness=0.124&aspect=1.991&mouths=3&sides=esw&attractors=133&scatter=random&reach=6.194&kill=0.500&step=0.745&momentum=0.729&curl=0.239&stretch=6&trim=0&width=1.00&style=ink&simplify=0&bank-variation=0.000&meander=bend&meander-rounds=0&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=0&flat-share=0.000&neck=1.00&clearance=0.00&taper=1.00",
];

#[test]
fn recipes_that_once_failed_grow_as_promised() {
    for link in FOUND_BY_CHANCE {
        assert_equals_twin(link);
        check_growth(link).unwrap();
    }
}

fn is_land(settings: &GrowthSettings, point: Vec2) -> bool {
    settings.land().is_none_or(|land| land.at(point) == Cell::Land)
}

/// An island whose ridge, drawn twice, shuts all its land off from its coast.
const SHUT_OFF: &str =
    "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1..M4M4zHM4zHzHM4zHM4M4";

#[test]
fn land_shut_off_from_its_coast_takes_few_attractors_and_little_time() {
    for (change, asked) in
        [("", 6000), ("&scatter=grid", 6000), ("&attractors=1000000", 1_000_000), ("&reach=12&attractors=100", 100)]
    {
        let growth = grown(&format!("{SHUT_OFF}{change}"));
        assert_eq!(growth.ending(), Some(Ending::Complete), "{change}");
        // Only what lies between the coast and the ridge, under a hundredth of the domain, has a mouth.
        assert!(growth.attractors() * 5 < asked, "{change}: {}", growth.attractors());
    }
}

#[test]
fn mouths_are_counted_as_they_are_planted() {
    for link in
        ["land=island&mouths=64&mouth-spacing=400", "land=archipelago&mouths=40", "land=basin&mouths=9&scatter=grid"]
    {
        let growth = grown(&format!("{link}&attractors=900"));
        assert_eq!(growth.mouths() as usize, growth.tree().mouths(), "{link}");
        assert!(growth.attractors() >= growth.unreached(), "{link}");
    }
}

/// Returns `true` if two straight pieces cross, judged by the sides on which their ends lie.
fn cross(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> bool {
    let side = |from: Vec2, to: Vec2, at: Vec2| (to - from).perp_dot(at - from);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[test]
fn no_river_crosses_a_ridge_however_it_grows() {
    for (seed, growth) in (0..6).flat_map(|seed| ["colonize", "brownian", "drainage"].map(|growth| (seed, growth))) {
        let link =
            format!("country=usual&seed={seed}&growth={growth}&sensitivity=40&land=valley&roughness=1&attractors=1500");
        let mut grown = Growth::new(settings(&link)).unwrap();
        while grown.tick() {}
        let (tree, land) = (grown.tree(), grown.settings().land().unwrap().clone());
        let ridges: Vec<&[Vec2]> = land.ridges().iter().flat_map(|ridge| ridge.windows(2)).collect();
        assert!(tree.len() > 100 && !ridges.is_empty(), "{link}");
        for node in 0..tree.len() {
            let Some(parent) = tree.parent_of(node) else { continue };
            let (from, to) = (tree.at[parent], tree.at[node]);
            assert!(!ridges.iter().any(|ridge| cross(from, to, ridge[0], ridge[1])), "node {node} of {link}");
        }
    }
}
