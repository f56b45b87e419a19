//! Promises of drawn rivers: every river starts where one is drawn, and a drawn course is the trunk of a river,
//! whatever grows.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::plain::plain;
use crate::common::property::large;
use crate::common::tier::{one_in, pairs, tiers};
use crate::common::{random_link, random_outline};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::grow::{Ending, Growth, GrowthSettings, Start};
use riverseed::recipe::{GrowthMethod, Key, Recipe, link};
use riverseed::tree::Tree;

const ALL: [&str; 3] = ["colonize", "brownian", "drainage"];

/// A coast of 24 points, an island in a square.
const ISLAND: &str =
    ".4UgA5qmw30r9yyxIsK2_lt6ggA5maS27T11VNNzDILtoGVmfHrgAKsZgNtSXQaM8T1KqZHJEf_Gam4FfsKJAvlO3ySUC1TZP";
/// A river with six bends, drawn from the sea in the east far inland, and a mouth in the north.
const RIVERS: &str = "...7gczzMa4sygAmZa4gAgAa4nrTMmZ...ZmGa";

fn grown(recipe: &Recipe) -> Growth {
    let mut growth = Growth::new(GrowthSettings::of(recipe)).unwrap();
    while growth.tick() {}
    growth
}

fn roots(tree: &Tree) -> impl Iterator<Item = Vec2> {
    (0..tree.len()).filter(|&node| tree.parent_of(node).is_none()).map(|node| tree.at[node])
}

/// Checks the position of a mouth: where it is drawn, in a cell of water beside it, or at an outlet of its land.
fn is_at(growth: &Growth, root: Vec2, start: &Start) -> bool {
    let away = root.distance(start.mouth.at);
    match growth.settings().method {
        GrowthMethod::Colonize => away == 0.0,
        GrowthMethod::Brownian => away < 2.0,
        _ => {
            let Some(land) = growth.settings().land() else { return true };
            land.regions().iter().any(|region| region.holds(root) && region.holds(start.mouth.at))
        }
    }
}

proptest! {
    #![proptest_config(large(1000))]

    #[test]
    fn rivers_begin_where_they_are_drawn_and_nowhere_else(link in random_link(400), outline in random_outline(), more in "([.]{3}([A-Za-z0-9_-]{4}){1,9}){1,3}") {
        let mut recipe = link::read(&link).unwrap();
        recipe.set(Key::Land, "drawn").unwrap();
        recipe.set(Key::Outline, &(outline + &more)).unwrap();
        prop_assert_eq!(&link::read(&link::write(&recipe)).unwrap(), &recipe);
        let growth = grown(&recipe);
        let (tree, starts) = (growth.tree(), &growth.settings().starts);
        prop_assert!(matches!(growth.ending(), Some(Ending::Complete | Ending::NodeLimit)));
        prop_assert!(starts.len() >= roots(tree).count() && growth.mouths() as usize == roots(tree).count());
        for root in roots(tree) {
            prop_assert!(starts.iter().any(|start| is_at(&growth, root, start)), "a river begins at {root}");
        }
    }
}

/// The position along a course of the point nearest to a place, and the distance between the two, in units.
fn along(course: &[Vec2], point: Vec2) -> (f32, f32) {
    let mut passed = 0.0;
    let pieces = course.windows(2).map(|pair| {
        let (way, length) = (pair[1] - pair[0], pair[0].distance(pair[1]));
        let share = ((point - pair[0]).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        passed += length;
        (passed - length * (1.0 - share), (pair[0] + way * share).distance(point))
    });
    pieces.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
}

/// The distance that a river may keep from its course, and from the ends of it: a piece; the cells by which it cuts
/// corners; or the distance to the next parcel, and where edges are broken to the one after it.
fn strays(settings: &GrowthSettings) -> f32 {
    match settings.method {
        GrowthMethod::Colonize => settings.step,
        GrowthMethod::Brownian => 4.0,
        _ => 1.6 * settings.drainage.spacing,
    }
}

fn a_drawn_course_is_the_trunk_of_its_river_in_its_order() {
    for ((growth, drawing), seed) in one_in(7, pairs(pairs(ALL, [ISLAND, ""]), 0..6)) {
        let link = format!(
            "land=drawn&growth={growth}&country=usual&seed={seed}&attractors=1500&roughness=0.4&outline={drawing}{RIVERS}"
        );
        let growth = grown(&link::read(&plain(&link)).unwrap());
        let (tree, settings) = (growth.tree(), growth.settings());
        let course = &settings.starts[0].course;
        let strays = strays(settings);
        let end = course[course.len() - 1];
        let mut node = (0..tree.len()).min_by(|&a, &b| tree.at[a].distance(end).total_cmp(&tree.at[b].distance(end)));
        let (mut last, mut first) = (f32::INFINITY, 0.0);
        let length = along(course, end).0;
        assert!(along(course, tree.at[node.unwrap()]).0 > length - 2.0 * strays, "{link}: it ends too early");
        while let Some(here) = node {
            let (passed, away) = along(course, tree.at[here]);
            assert!(away <= strays, "{link}: {} is {away} from the course", tree.at[here]);
            assert!(passed < last + strays, "{link}: the river turns back at {}", tree.at[here]);
            assert!(last > length || last - passed < 2.0 * strays, "{link}: nothing for {}", last - passed);
            (last, first, node) = (passed, passed, tree.parent_of(here));
        }
        assert!(first < 1.5 * strays, "{link}: its mouth is {first} up the course");
    }
}

tiers!(a_drawn_course_is_the_trunk_of_its_river_in_its_order);

#[test]
fn land_without_a_start_stays_dry() {
    // Two squares, one of them with a mouth.
    let squares = ".GZMzWZMzWZZmGZZm.jMMzzMMzzMZmjMZm";
    for growth in ALL {
        let link = format!("land=drawn&growth={growth}&aspect=1&roughness=0&attractors=600&outline={squares}...GZQA");
        let growth = grown(&link::read(&plain(&link)).unwrap());
        assert_eq!(growth.mouths(), 1, "{link}");
        assert!(growth.tree().at.len() > 20 && growth.tree().at.iter().all(|at| at.x < 450.0), "{link}");
        // Attractors lie where rivers run.
        let is_watered = growth.unreached() * 10 <= growth.attractors();
        assert!(is_watered, "{link}: {} of {}", growth.unreached(), growth.attractors());
    }
}

fn one_mouth_waters_the_whole_land() {
    // Near every place of the land there is a river, however far from the only mouth it is.
    for (growth, seed) in one_in(4, pairs(ALL, 0..5)) {
        let link =
            format!("land=drawn&growth={growth}&country=usual&seed={seed}&attractors=1500&outline={ISLAND}...ZmGa");
        let growth = grown(&link::read(&plain(&link)).unwrap());
        let land = growth.settings().land().unwrap();
        let places = (0..40 * 40).map(|i| Vec2::new((i % 40) as f32, (i / 40) as f32) / 40.0 * land.size());
        let inland: Vec<Vec2> = places.filter(|&at| land.coast_distance().height(at) > 40.0).collect();
        let is_watered = |at: &&Vec2| growth.tree().at.iter().any(|node| node.distance(**at) < 45.0);
        let watered = inland.iter().filter(is_watered).count();
        assert!(watered * 100 >= inland.len() * 98, "{link}: {watered} of {}", inland.len());
    }
}

tiers!(one_mouth_waters_the_whole_land);
