//! Promises about the relief that the sea rises over.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::grow::{Growth, GrowthSettings};
use crate::land::Cell;
use crate::recipe::link;

/// Grows the tree of a recipe's low stand, and begins the search for the level of its sea.
fn at_the_low_stand(text: &str) -> (Arc<LowStand>, Growth, Drowning) {
    let recipe = link::read(text).unwrap();
    let low_stand = Arc::new(LowStand::of(&recipe, CoastDistance::SPACING).unwrap());
    let mut growth = Growth::new(GrowthSettings::new(&recipe, Some(low_stand.land.clone()))).unwrap();
    while growth.tick() {}
    let drowning = Drowning::new(&recipe, low_stand.clone());
    (low_stand, growth, drowning)
}

/// Returns a recipe's low stand, and the heights of its corners after waves.
fn heights(text: &str) -> (Arc<LowStand>, Vec<f32>) {
    let (low_stand, growth, mut drowning) = at_the_low_stand(text);
    loop {
        drowning.step(growth.tree()).unwrap();
        if let Part::Level(_, level) = &drowning.next {
            return (low_stand, level.heights().to_vec());
        }
    }
}

/// Returns a recipe's low stand, and the sea about to rise from it.
fn transgression(text: &str) -> (Arc<LowStand>, Transgression) {
    let (low_stand, growth, mut drowning) = at_the_low_stand(text);
    loop {
        if let Some(transgression) = drowning.step(growth.tree()).unwrap() {
            return (low_stand, transgression);
        }
    }
}

/// Checks that one land lies within another, as exactly as coasts are traced.
fn assert_lies_in(land: &Land, before: &Land, what: &str) {
    let corners = before.coast_distance().heights().iter().zip(land.coast_distance().heights());
    // A former speck may be part of a cape.
    let risen = corners.filter(|(was, is)| **was <= 0.0 && **is > 0.0).count();
    assert!(risen < 4, "{risen} corners have come out of the sea {what}");
    // Between corners the coast is less exact.
    let cells = (0..land.rows()).flat_map(|row| (0..land.columns()).map(move |column| (column, row)));
    let is_new =
        |&(column, row): &(i32, i32)| before.cell(column, row) == Cell::Water && land.cell(column, row) != Cell::Water;
    let new = cells.filter(is_new).count();
    assert!(new < 100, "{new} cells have come out of the sea {what}");
}

/// Returns the land at the level where the sea covers a share of the domain.
fn at(low_stand: &LowStand, heights: &[f32], sea: f32) -> Land {
    let mut level = Level::new(&low_stand.land, heights.to_vec(), sea).unwrap();
    loop {
        if let Some((_, land)) = level.advance(&low_stand.land, &silt::GreatRivers::default()).unwrap() {
            return land;
        }
    }
}

#[test]
fn land_only_shrinks_as_the_sea_rises_on_one_low_stand() {
    for land in ["island", "archipelago", "valley&sea=0.4"] {
        let (low_stand, heights) =
            heights(&format!("country=usual&seed=kauri&attractors=4000&drowning=0.6&land={land}"));
        let mut before = low_stand.land.clone();
        for sea in [0.45, 0.6, 0.7, 0.8].into_iter().filter(|sea| *sea > low_stand.land.share_of_sea()) {
            let land = at(&low_stand, &heights, sea);
            assert_lies_in(&land, &before, &format!("at {sea}"));
            assert!((land.share_of_sea() - sea).abs() < 0.002, "{} for {sea}", land.share_of_sea());
            before = land.into();
        }
    }
}

#[test]
fn the_transgression_goes_from_the_low_stand_to_the_risen_sea_and_never_falls() {
    for land in ["island", "archipelago", "valley&sea=0.4"] {
        let (low_stand, mut transgression) =
            transgression(&format!("country=usual&seed=kauri&attractors=4000&drowning=0.6&land={land}"));
        let mut before = transgression.land();
        assert!(Arc::ptr_eq(&before, &low_stand.land), "{land}: it begins elsewhere");
        for step in 1..Transgression::STEPS {
            assert!(transgression.rise().is_none(), "{land}: it is over after {step} steps");
            let now = transgression.land();
            assert_lies_in(&now, &before, &format!("{land}, step {step}"));
            assert!(now.share_of_sea() > before.share_of_sea(), "{land}: nothing is seen of step {step}");
            before = now;
        }
        let left = transgression.rise().unwrap().land.clone();
        assert_lies_in(&left, &before, &format!("{land}, at the end"));
        assert!(Arc::ptr_eq(&transgression.land(), &left), "{land}: it ends elsewhere");
        let off = transgression.land_at(1.0).share_of_sea() - left.share_of_sea();
        assert!((-0.005..=0.0).contains(&off), "{land}: specks on the way are {off} of the map");
        assert!(transgression.rise().is_some(), "{land}: what has risen stays");
    }
}

#[test]
fn no_corner_of_land_is_lower_than_all_around_it() {
    let (low_stand, heights) = heights("country=usual&seed=skye&attractors=4000&drowning=0.6&land=continent");
    let (columns, rows) = low_stand.land.coast_distance().size();
    let mut land = 0;
    for corner in (0..heights.len()).filter(|&corner| heights[corner] > 0.0) {
        let (column, row) = (corner % columns, corner / columns);
        let beside = [
            (column > 0).then(|| corner - 1),
            (column + 1 < columns).then_some(corner + 1),
            (row > 0).then(|| corner - columns),
            (row + 1 < rows).then_some(corner + columns),
        ];
        assert!(beside.into_iter().flatten().any(|beside| heights[beside] < heights[corner]), "a pit at {corner}");
        land += 1;
    }
    assert!(land > 10_000);
}

#[test]
fn greater_rivers_have_flatter_valleys() {
    let recipe = link::read("country=usual&seed=kauri&attractors=6000&drowning=0.5").unwrap();
    let low_stand = LowStand::of(&recipe, CoastDistance::SPACING).unwrap();
    let mut growth = Growth::new(GrowthSettings::new(&recipe, Some(low_stand.land.clone()))).unwrap();
    while growth.tick() {}
    let lattice = low_stand.land.coast_distance();
    let mut marking = Marking::new(growth.tree(), lattice, growth.stream_spacing()).unwrap();
    while marking.advance(growth.tree()) {}
    let valleys = marking.into_valleys();
    let corner = |at: glam::Vec2| {
        let [column, row] = (at / lattice.spacing() + 0.5).to_array().map(|of| of as usize);
        row * lattice.size().0 + column
    };
    let tree = growth.tree();
    let discharge = crate::tree::Hydrology::of(tree).discharge;
    let greatest = (0..tree.len()).max_by_key(|&node| discharge[node]).unwrap();
    let trunk = valleys.steepness(corner(tree.at[greatest]), 0.0);
    assert!(trunk < 0.05, "{trunk}");
    for node in (0..tree.len()).filter(|&node| tree.parent_of(node).is_some()) {
        assert!(valleys.steepness(corner(tree.at[node]), 0.0) <= 0.5, "a node is not in a valley");
    }
    let sea = lattice.heights().iter().position(|height| *height < -40.0).unwrap();
    assert!(valleys.steepness(sea, 0.0) > 1.0 && valleys.with_unknown(lattice).steepness(sea, 0.0) < 0.2);
}

/// Corners of floors are as low as the river between them, or nearly; so inlets are broad to their heads.
#[test]
fn troughs_of_hard_ground_are_broad_and_level_far_inland() {
    let (low_stand, heights) = heights("country=usual&seed=kauri&attractors=12000&drowning=0.6&land=continent");
    let recipe = link::read("country=usual&seed=kauri&attractors=12000&drowning=0.6&land=continent").unwrap();
    let mut growth = Growth::new(GrowthSettings::new(&recipe, Some(low_stand.land.clone()))).unwrap();
    while growth.tick() {}
    let drowning = Drowning::new(&recipe, low_stand.clone());
    let (rock, lattice) = (drowning.rock().unwrap(), low_stand.land.coast_distance());
    let mut marking = Marking::new(growth.tree(), lattice, growth.stream_spacing()).unwrap();
    while marking.advance(growth.tree()) {}
    let valleys = marking.into_valleys();
    let is_floor = |corner: &usize| {
        lattice.heights()[*corner] > 30.0 && rock[*corner] > 0.5 && valleys.steepness(*corner, rock[*corner]) < 0.006
    };
    let floors: Vec<usize> = (0..heights.len()).filter(is_floor).collect();
    let columns = lattice.size().0;
    let is_level = |corner: usize| {
        let beside = [corner - 1, corner + 1, corner - columns, corner + columns];
        beside.into_iter().filter(|&beside| (heights[beside] - heights[corner]).abs() < 0.1).count() >= 2
    };
    let level = floors.iter().filter(|&&corner| is_level(corner)).count();
    println!("{level} of {} corners", floors.len());
    assert!(floors.len() > 100 && level * 10 > floors.len() * 9, "{level} of {} corners", floors.len());
}
