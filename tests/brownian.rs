//! Promises of Brownian trees: the document's procedure to the cell, strands that never touch, and no bias.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::lands::every_land;
use crate::common::plain::plain;
use crate::common::property::large;
use crate::common::tier::{first, tiers};
use crate::common::{literal, random_link};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use riverseed::base::random::Seed;
use riverseed::grow::{Brownian, Ending, Growth, GrowthSettings, ParticleOrder, Raster};
use riverseed::land::Cell;
use riverseed::picture::Picture;
use riverseed::recipe::{Key, Sides, link};
use riverseed::session::Session;
use riverseed::tree::{NO_PARENT, Tree};

fn grown(raster: &Raster, seed: &str, sensitivity: f32) -> Brownian {
    grown_in(ParticleOrder::Shuffled, raster, seed, sensitivity)
}

fn grown_in(order: ParticleOrder, raster: &Raster, seed: &str, sensitivity: f32) -> Brownian {
    let mut growth = Brownian::with_order(raster.clone(), Seed::from_text(seed), sensitivity, order).unwrap();
    while growth.tick() {}
    assert_eq!(growth.ending(), Some(Ending::Complete));
    growth
}

/// A square with sea on all sides.
fn square(side: i32) -> Raster {
    Raster::with_sea(side, side, 1.0, Sides::parse("nesw").unwrap())
}

/// Small rasters of every kind: sea along sides or none, lakes (circles) and ridges (lines).
fn random_raster() -> impl Strategy<Value = Raster> {
    let sides = proptest::sample::select(vec!["n", "e", "sw", "ns", "nesw"]);
    let lakes = proptest::collection::vec((0i32..120, 0i32..120, 0i32..12), 0..4);
    let ridges = proptest::collection::vec((0i32..120, 0i32..120, -8i32..9, -8i32..9), 0..3);
    (5i32..120, 5i32..120, 0.5f32..4.0, sides, lakes, ridges).prop_map(|(columns, rows, side, sides, lakes, ridges)| {
        let sea = Raster::with_sea(columns, rows, side, Sides::parse(sides).unwrap());
        Raster::new(columns, rows, side, |x, y| {
            let is_lake = lakes.iter().any(|&(cx, cy, r)| (x - cx) * (x - cx) + (y - cy) * (y - cy) <= r * r);
            let on_ridge = |&(ax, ay, dx, dy): &(i32, i32, i32, i32)| {
                let (x, y) = (x - ax, y - ay);
                (x * dy - y * dx).abs() <= dx.abs().max(dy.abs()) && x * dx + y * dy >= 0 && x.abs().max(y.abs()) < 40
            };
            match sea.cells()[(y * columns + x) as usize] {
                Cell::Land if ridges.iter().any(on_ridge) => Cell::Ridge,
                Cell::Land if is_lake => Cell::Water,
                cell => cell,
            }
        })
    })
}

/// The cell that each node lies in; nodes at mouths lie in the sea.
fn cells_of(tree: &Tree, raster: &Raster) -> Vec<(i32, i32)> {
    let cell = |x: f32, cells: i32| ((x / raster.side() + 1e-4) as i32).min(cells - 1);
    tree.at.iter().map(|at| (cell(at.x, raster.columns()), cell(at.y, raster.rows()))).collect()
}

/// The node of each cell. Checks that no cell has two nodes.
fn nodes_by_cell(tree: &Tree, raster: &Raster) -> Vec<Option<usize>> {
    let mut nodes = vec![None; raster.cells().len()];
    for (node, (x, y)) in cells_of(tree, raster).into_iter().enumerate() {
        let node_here = &mut nodes[(y * raster.columns() + x) as usize];
        assert_eq!(*node_here, None, "two nodes in cell {x}, {y}");
        *node_here = Some(node);
    }
    nodes
}

fn around(raster: &Raster, i: usize, corners: bool) -> impl Iterator<Item = usize> {
    let (columns, rows) = (raster.columns(), raster.rows());
    let (x, y) = (i as i32 % columns, i as i32 / columns);
    let gaps = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
    gaps.filter(move |&(dx, dy): &(i32, i32)| (dx, dy) != (0, 0) && (corners || dx * dy == 0))
        .map(move |(dx, dy)| (x + dx, y + dy))
        .filter(move |&(x, y)| (0..columns).contains(&x) && (0..rows).contains(&y))
        .map(move |(x, y)| (y * columns + x) as usize)
}

/// The number of pieces, connected by sides, of all cells that are not water. The border separates nothing: land that
/// reaches it is one piece.
fn pieces_of_land(raster: &Raster, is_land: impl Fn(usize) -> bool) -> usize {
    let mut seen: Vec<bool> = (0..raster.cells().len()).map(|i| !is_land(i)).collect();
    let on_border = |&i: &usize| around(raster, i, false).count() < 4;
    let mut open: Vec<usize> = (0..seen.len()).filter(on_border).collect();
    let mut pieces = 1;
    for start in 0..seen.len() {
        while let Some(i) = open.pop() {
            if !std::mem::replace(&mut seen[i], true) {
                open.extend(around(raster, i, false));
            }
        }
        if !seen[start] {
            pieces += 1;
            open.push(start);
        }
    }
    pieces
}

/// Rivers run on land from the sea, parents first; they touch neither each other, mouths included, nor the sea; no land
/// is cut off.
fn check(raster: &Raster, tree: &Tree) {
    let nodes = nodes_by_cell(tree, raster);
    let is_river = |i: usize| nodes[i].is_some_and(|node| tree.parent[node] != NO_PARENT);
    for (i, &cell) in raster.cells().iter().enumerate() {
        let Some(node) = nodes[i] else { continue };
        for other in around(raster, i, true).filter_map(|beside| nodes[beside]) {
            assert!(is_family(tree, node, other), "rivers touch: {node} and {other}");
        }
        let Some(parent) = tree.parent_of(node) else {
            assert_eq!(cell, Cell::Water, "the mouth {node} is not in the sea");
            continue;
        };
        assert_eq!(cell, Cell::Land, "node {node} is not on land");
        assert!(parent < node);
        assert!(around(raster, i, true).any(|i| nodes[i] == Some(parent)), "{node} is away from its parent");
        for beside in around(raster, i, true) {
            if raster.cells()[beside] == Cell::Water {
                let mouth = [parent, tree.parent_of(parent).unwrap_or(parent)];
                let is_mouth = |i: usize| nodes[i].is_some_and(|n| mouth.contains(&n) && !is_river(i));
                let is_beside_mouth = is_mouth(beside) || around(raster, beside, true).any(is_mouth);
                assert!(is_beside_mouth, "node {node} touches the sea");
            }
        }
    }
    let before = pieces_of_land(raster, |i| raster.cells()[i] != Cell::Water);
    let after = pieces_of_land(raster, |i| raster.cells()[i] != Cell::Water && !is_river(i));
    assert!(after <= before, "{after} pieces of land were {before}");
}

/// Returns `true` if one of two nodes is the other's parent or grandparent, or if both have the same parent.
fn is_family(tree: &Tree, a: usize, b: usize) -> bool {
    let line = |node: usize| [Some(node), tree.parent_of(node), tree.parent_of(node).and_then(|p| tree.parent_of(p))];
    let is_sister = tree.parent_of(a).is_some() && tree.parent[a] == tree.parent[b];
    line(a).contains(&Some(b)) || line(b).contains(&Some(a)) || is_sister
}

fn assert_equals_literal(raster: &Raster, seed: &str, sensitivity: f32) {
    let growth = grown(raster, seed, sensitivity);
    let tree = growth.tree();
    let literal = literal::grow(raster, Seed::from_text(seed), sensitivity);
    for (i, node) in literal.iter().enumerate() {
        assert_eq!(tree.parent.get(i), Some(&node.parent), "node {i}");
        if node.parent != NO_PARENT {
            assert_eq!(tree.at[i], literal::place(raster, node), "node {i}");
        }
    }
    assert_eq!(tree.len(), literal.len());
    let river = |node: &literal::Node| node.parent != NO_PARENT;
    assert_eq!(tree.drained.iter().sum::<u32>() as usize, literal.iter().filter(|node| river(node)).count());
    assert_eq!(growth.mouths() as usize, tree.mouths());
}

proptest! {
    #![proptest_config(large(300))]

    #[test]
    fn any_raster_grows_the_literal_tree(raster in random_raster(), seed in "[a-z]{1,8}", sensitivity in 3f32..40.0) {
        assert_equals_literal(&raster, &seed, sensitivity);
    }
}

proptest! {
    #![proptest_config(large(1000))]

    #[test]
    fn strands_never_touch_and_no_land_is_cut_off(raster in random_raster(), seed in "[a-z]{1,8}", sensitivity in 3f32..20.0) {
        check(&raster, grown(&raster, &seed, sensitivity).tree());
    }
}

proptest! {
    #![proptest_config(first(4, large(250)))]

    fn any_recipe_grows_a_tree_that_keeps_every_promise(link in random_link(100), sensitivity in prop_oneof![1 => 8u32..16, 4 => 16u32..=64]) {
        let mut recipe = link::read(&link).unwrap();
        recipe.set(Key::Growth, "brownian").unwrap();
        recipe.set(Key::Sensitivity, &sensitivity.to_string()).unwrap();
        let mut growth = Growth::new(GrowthSettings::of(&recipe)).unwrap();
        while growth.tick() {}
        prop_assert_eq!(growth.ending(), Some(Ending::Complete));
        check(&Raster::of(growth.settings()), growth.tree());
    }
}

tiers!(any_recipe_grows_a_tree_that_keeps_every_promise);

#[test]
fn every_kind_of_land_grows_the_literal_tree() {
    for (land, aspect) in every_land().iter().zip([1.0, 2.0, 0.5, 1.5].into_iter().cycle()) {
        let recipe =
            link::read(&plain(&format!("growth=brownian&{land}&aspect={aspect}&sides=nw&country=usual&seed=k")))
                .unwrap();
        let settings = GrowthSettings::of(&recipe);
        let whole = Raster::of(&settings);
        // Every eighth cell, so that a literal search ends today.
        let coarse = Raster::new(whole.columns() / 8, whole.rows() / 8, whole.side() * 8.0, |x, y| {
            whole.cells()[(y * 8 * whole.columns() + x * 8) as usize]
        });
        assert_equals_literal(&coarse, land, 4.5);
        check(&coarse, grown(&coarse, land, 4.5).tree());
    }
}

#[test]
fn recipes_grow_on_all_their_land() {
    for land in every_land() {
        let recipe = link::read(&plain(&format!("growth=brownian&{land}&sensitivity=24"))).unwrap();
        let mut growth = Growth::new(GrowthSettings::of(&recipe)).unwrap();
        while growth.tick() {}
        let raster = Raster::of(growth.settings());
        check(&raster, growth.tree());
        let (total_discharge, drained) = (growth.total_discharge() as f32, growth.tree().len() as f32);
        assert!((0.7..1.3).contains(&(drained / total_discharge)), "{land}: {drained} of {total_discharge}");
        assert!(growth.tree().at.iter().all(|&at| growth.settings().domain.contains(at)));
    }
}

/// A round island with a ring of ridge along its coast, which is open to the east over some cells.
fn ringed(side: i32, gap: i32) -> Raster {
    let island = disc(side);
    Raster::new(side, side, 1.0, |x, y| {
        let cell = island.cells()[(y * side + x) as usize];
        let is_open = x > side / 2 && (2 * y - side).abs() < gap;
        if cell == Cell::Land && !is_open && is_on_ring(side, x, y) { Cell::Ridge } else { cell }
    })
}

fn squared_from_middle(side: i32, x: i32, y: i32) -> i32 {
    (x - side / 2) * (x - side / 2) + (y - side / 2) * (y - side / 2)
}

fn is_on_ring(side: i32, x: i32, y: i32) -> bool {
    let inner = side / 2 - 16;
    (inner * inner..(inner + 2) * (inner + 2)).contains(&squared_from_middle(side, x, y))
}

#[test]
fn land_behind_a_ridge_fills_through_its_gap() {
    const SIDE: i32 = 240;
    let inside = SIDE / 2 - 20;
    for (gap, sensitivity) in [(80, 8.0), (80, 16.0), (24, 8.0), (24, 5.0)] {
        let raster = ringed(SIDE, gap);
        for seed in ["kauri", "rimu", "totara"] {
            let growth = grown(&raster, seed, sensitivity);
            check(&raster, growth.tree());
            let cells = cells_of(growth.tree(), &raster);
            let river = cells.iter().filter(|&&(x, y)| squared_from_middle(SIDE, x, y) < inside * inside).count();
            let density = river as f32 * sensitivity / (std::f32::consts::PI * (inside * inside) as f32);
            assert!((0.7..1.2).contains(&density), "a gap of {gap}, sensitivity {sensitivity}: {density}");
        }
    }
}

#[test]
fn land_that_a_ridge_shuts_off_stays_dry() {
    let raster = ringed(160, 0);
    let growth = grown(&raster, "kauri", 8.0);
    let inside = |&&(x, y): &&(i32, i32)| squared_from_middle(160, x, y) < 60 * 60;
    assert_eq!(cells_of(growth.tree(), &raster).iter().filter(inside).count(), 0);
}

#[test]
fn any_two_sensitivities_draw_different_trees_evenly_dense() {
    let raster = square(192);
    let land = raster.available() as f32;
    let trees: Vec<(f32, Tree)> = (8..=49)
        .map(|i| i as f32 / 2.0)
        .map(|sensitivity| (sensitivity, Tree::clone(grown(&raster, "kauri", sensitivity).tree())))
        .collect();
    let share = |tree: &Tree| tree.len() as f32 / land;
    for pair in trees.windows(2) {
        let [(fine, finer_tree), (coarse, coarser_tree)] = pair else { continue };
        assert!(finer_tree != coarser_tree, "{fine} and {coarse} draw the same");
    }
    // One tree a sensitivity is a small sample: two that lie close may be the wrong way round.
    for pair in trees.windows(9) {
        assert!(share(&pair[8].1) < share(&pair[0].1), "{} is denser than {}", pair[8].0, pair[0].0);
    }
    for (sensitivity, tree) in trees {
        let density = share(&tree) * sensitivity;
        assert!((0.75..1.2).contains(&density), "{sensitivity}: {density}");
    }
}

#[test]
fn a_finer_sensitivity_keeps_the_coarser_tree_of_its_octave() {
    let raster = square(192);
    let coarse = grown(&raster, "kauri", 24.0).tree().clone();
    for sensitivity in [23.0, 17.0, 12.0, 5.0] {
        let fine = grown(&raster, "kauri", sensitivity);
        assert!(
            fine.tree().at.starts_with(&coarse.at) && fine.tree().parent.starts_with(&coarse.parent),
            "{sensitivity}"
        );
    }
}

/// The mean over all seeds, in standard errors of it.
fn mean_in_errors(seeds: usize, of_seed: impl Fn(usize) -> Vec2) -> Vec2 {
    let all: Vec<Vec2> = (0..seeds).map(of_seed).collect();
    let mean = all.iter().sum::<Vec2>() / seeds as f32;
    let variance = all.iter().map(|&one| (one - mean) * (one - mean)).sum::<Vec2>() / seeds as f32;
    mean / (variance / seeds as f32).map(f32::sqrt)
}

/// The overall direction of rivers: the mean direction from a node to its parent.
fn bias(order: ParticleOrder) -> Vec2 {
    let raster = square(96);
    mean_in_errors(300, |seed| {
        let growth = grown_in(order, &raster, &format!("w{seed}"), 6.0);
        let tree = growth.tree();
        let rivers = (0..tree.len()).filter_map(|node| Some((node, tree.parent_of(node)?)));
        let directions: Vec<Vec2> =
            rivers.map(|(node, parent)| (tree.at[parent] - tree.at[node]).normalize()).collect();
        directions.iter().sum::<Vec2>() / directions.len() as f32
    })
}

/// If of equally near water the first were taken, row by row, this would be 7.
#[test]
fn rivers_favour_no_direction() {
    let bias = bias(ParticleOrder::Shuffled);
    assert!(bias.abs().max_element() < 4.0, "{bias}");
}

/// A round island: unlike a square it has no direction of its own.
fn disc(side: i32) -> Raster {
    Raster::new(side, side, 1.0, |x, y| {
        let (x, y) = (2 * x + 1 - side, 2 * y + 1 - side);
        if x * x + y * y < (side - 4) * (side - 4) { Cell::Land } else { Cell::Water }
    })
}

/// The node a good ten cells down a river, as the water runs; none if the river is shorter. So many nodes would not do:
/// those on a diagonal lie farther apart.
fn ten_cells_down(tree: &Tree, node: usize) -> Option<usize> {
    let (mut at, mut length) = (node, 0.0);
    while length < 10.0 {
        let parent = tree.parent_of(at)?;
        length += tree.at[parent].distance(tree.at[at]);
        at = parent;
    }
    Some(at)
}

/// The tendency of rivers to follow rows, columns or diagonals: the mean cosines of four and eight times the angle of
/// their direction, weighted by length, over many seeds, in standard errors. The first is 1 along an axis and -1 along
/// a diagonal; the second is 1 along both and -1 between them.
fn grain() -> Vec2 {
    let raster = disc(256);
    mean_in_errors(200, |seed| {
        let growth = grown(&raster, &format!("d{seed}"), 12.0);
        let tree = growth.tree();
        let rivers =
            (0..tree.len()).filter_map(|node| Some((node, tree.parent_of(node)?, ten_cells_down(tree, node)?)));
        let cosines = rivers.map(|(node, parent, down)| {
            let (way, weight) = (tree.at[down] - tree.at[node], tree.at[parent].distance(tree.at[node]));
            let doubled = |cosine: f32| 2.0 * cosine * cosine - 1.0;
            let cos4 = doubled(doubled(way.normalize().x));
            Vec3::new(cos4, doubled(cos4), 1.0) * weight
        });
        let sum: Vec3 = cosines.sum();
        sum.truncate() / sum.z
    })
}

/// Were strands of five cells' length on a diagonal, which are seven long, the first would be -24.
#[test]
fn rivers_follow_neither_rows_and_columns_nor_diagonals() {
    let grain = grain();
    assert!(grain.abs().max_element() < 4.0, "{grain}");
}

#[test]
fn the_test_of_directions_sees_the_bias_of_particles_in_rows() {
    let bias = bias(ParticleOrder::Rows);
    assert!(bias.max_element() < -8.0, "{bias}");
}

#[test]
fn slices_of_any_length_grow_the_same_tree() {
    let recipe = link::read(&plain("growth=brownian&land=island&sensitivity=16")).unwrap();
    let grown = |ticks: u32| {
        let mut session = Session::new(recipe.clone()).unwrap();
        let mut picture = Picture::new(200, 200).unwrap();
        while session.advance(ticks).unwrap() {
            picture.paint(&session);
        }
        picture.paint(&session);
        (session.tree().clone(), picture.pixmap().data().to_vec())
    };
    let at_once = grown(u32::MAX);
    assert!(grown(1) == at_once && grown(7) == at_once);
    assert_eq!(at_once.0.ticks().count(), at_once.0.len());
    assert!(at_once.0.tick_starts.is_sorted());
}

#[test]
fn rasters_without_land_or_without_water_end_empty() {
    for cell in [Cell::Land, Cell::Water, Cell::Ridge] {
        for (columns, rows) in [(1, 1), (1, 90), (40, 40)] {
            let growth = grown(&Raster::new(columns, rows, 1.0, |_, _| cell), "kauri", 6.0);
            assert!(growth.tree().is_empty(), "{cell:?}, {columns} by {rows}");
        }
    }
}
