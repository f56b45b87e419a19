//! The shapes of land against those of nature.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use riverseed::recipe::link;
use riverseed::{Land, Session};

use crate::common::shape::{Measures, Raster, rank_slope};
use crate::common::tier::{Tier, one_in, pairs, tiers};

/// The columns of a raster: at least 15 for the ruler of a coast's length.
const COLUMNS: usize = 1300;

fn raster(link: &str) -> Raster {
    Raster::of(&Land::of(&link::read(link).unwrap()).unwrap(), COLUMNS)
}

/// The land of a finished map, after the sea has risen.
fn drowned(link: &str) -> Raster {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    Raster::of(session.land().unwrap(), COLUMNS)
}

/// The least, the median and the greatest of some measures.
fn spread(name: &str, values: impl Iterator<Item = f32>) -> [f32; 3] {
    let mut values: Vec<f32> = values.collect();
    values.sort_by(f32::total_cmp);
    let spread = [values[0], values[values.len() / 2], values[values.len() - 1]];
    println!("{name}: {spread:.3?}");
    spread
}

/// Real islands, measured in the same way, have medians of 0.51, 2.63, 0.144 and 0.060: 25 from Madagascar to Skye, from
/// GSHHS shorelines.
fn islands_are_shaped_like_those_of_nature() {
    let measures: Vec<Measures> = one_in(3, 0..36)
        .map(|seed| drowned(&format!("land=island&country=usual&seed=shape{seed}")).main_island().measures())
        .collect();
    let [narrowest, boxed, fullest] = spread("box", measures.iter().map(|island| island.boxed));
    let [_, coast, _] = spread("coast", measures.iter().map(|island| island.coast));
    let [_, peninsulas, _] = spread("peninsulas", measures.iter().map(|island| island.peninsulas));
    let [_, bays, _] = spread("bays", measures.iter().map(|island| island.bays));
    assert!((0.42..0.58).contains(&boxed) && fullest < 0.72, "box {boxed}, at most {fullest}");
    let least_spread = if Tier::here() == Tier::First { 0.12 } else { 0.17 };
    assert!(fullest - narrowest > least_spread, "all islands are alike: {narrowest} to {fullest}");
    assert!((2.2..3.2).contains(&coast), "coast {coast}");
    assert!((0.09..0.2).contains(&peninsulas), "peninsulas {peninsulas}");
    assert!((0.03..0.15).contains(&bays), "bays {bays}");
}

/// Korčak's law: the sizes of islands fall with a power of their rank.
fn sizes_of_islands_in_an_archipelago_follow_a_power_law() {
    const LEAST: f32 = 500.0;
    let (mut counts, mut slopes, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    for seed in one_in(3, 0..24) {
        let raster = raster(&format!("land=archipelago&country=usual&seed=shape{seed}"));
        let square = raster.side * raster.side;
        let sizes: Vec<f32> = raster.islands().iter().map(|island| island.len() as f32 * square).collect();
        let sizes: Vec<f32> = sizes.into_iter().filter(|size| *size >= LEAST).collect();
        counts.push(sizes.len() as f32);
        slopes.push(rank_slope(&sizes));
        shares.push(sizes[0] / sizes.iter().sum::<f32>());
    }
    let [fewest, count, _] = spread("islands", counts.into_iter());
    let [steepest, slope, _] = spread("slope", slopes.into_iter());
    let [_, share, greatest] = spread("share of the largest", shares.into_iter());
    assert!(fewest >= 3.0 && (5.0..25.0).contains(&count), "{count} islands, at least {fewest}");
    assert!((-3.0..-1.0).contains(&slope) && steepest > -6.0, "slope {slope}, at least {steepest}");
    assert!(share < 0.65 && greatest < 0.97, "largest {share}, at most {greatest}");
}

/// The distance from a side within which a coast hugs it, in units, and the greatest share of the side along which one
/// may.
const BESIDE: f32 = 25.0;
const MOST: f32 = 0.1;

fn no_side_of_a_map_is_hugged() {
    for (land, seed) in one_in(3, pairs(["island", "archipelago"].into_iter().chain(FIGURES), 0..24)) {
        let raster = raster(&format!("land={land}&country=usual&seed=shape{seed}"));
        let (columns, rows) = (raster.columns, raster.rows);
        let beside = (BESIDE / raster.side) as usize;
        let is_land = |column: usize, row: usize| raster.is_land[row * columns + column];
        let upright = |from: usize| {
            let beside = |row: &usize| (from..from + beside).any(|column| is_land(column, *row));
            (0..rows).filter(beside).count() as f32 / rows as f32
        };
        let level = |from: usize| {
            let beside = |column: &usize| (from..from + beside).any(|row| is_land(*column, row));
            (0..columns).filter(beside).count() as f32 / columns as f32
        };
        let shares = [upright(0), upright(columns - beside), level(0), level(rows - beside)];
        assert!(shares.iter().all(|share| *share < MOST), "{land}, seed shape{seed}: {shares:?}");
    }
}

/// All lands whose share of sea is a parameter.
const LANDS: [&str; 10] =
    ["island", "archipelago", "crescent", "twins", "long", "arms", "continent", "valley", "basin", "gulf"];

/// A notch of `sea` or of `roughness` moves the coast a little. Drafts are chosen by neither.
fn small_changes_move_a_coast_a_little() {
    for (land, seed) in one_in(4, pairs(LANDS, 0..8)) {
        for [before, after] in [["sea=0.6", "sea=0.61"], ["sea=0.3", "sea=0.31"], ["roughness=0.6", "roughness=0.62"]] {
            let [one, other] =
                [before, after].map(|change| raster(&format!("land={land}&country=usual&seed=shape{seed}&{change}")));
            let changed = one.is_land.iter().zip(&other.is_land).filter(|(a, b)| a != b).count();
            let share = changed as f32 / one.is_land.len() as f32;
            // A fifth of a strait closing makes a pond, which is filled.
            assert!(share < 0.04, "{land}, seed shape{seed}, {before} to {after}: {share}");
        }
    }
}

/// The lands of a figure that the sea surrounds.
const FIGURES: [&str; 4] = ["crescent", "twins", "long", "arms"];

/// The proportions of sheets, from a banner that hangs to one that lies.
const ASPECTS: [f32; 6] = [0.25, 0.6, 1.0, 1.6, 2.5, 4.0];

/// The land of a link on so few squares that only its figure counts.
fn coarse(land: &Land) -> Raster {
    Raster::of(land, (land.size().x / 3.0) as usize)
}

/// The islands of a raster, as shares of all land, the largest first.
fn shares(raster: &Raster) -> Vec<f32> {
    let islands = raster.islands();
    let all: usize = islands.iter().map(Vec::len).sum();
    islands.iter().map(|island| island.len() as f32 / all as f32).collect()
}

/// The squares along the border of a raster, clockwise.
fn rim(raster: &Raster) -> Vec<bool> {
    let (columns, rows) = (raster.columns, raster.rows);
    let north = (0..columns).map(|column| (column, 0));
    let east = (0..rows).map(|row| (columns - 1, row));
    let south = (0..columns).rev().map(|column| (column, rows - 1));
    let west = (0..rows).rev().map(|row| (0, row));
    north.chain(east).chain(south).chain(west).map(|(column, row)| raster.is_land[row * columns + column]).collect()
}

/// Tells what a land lacks of the figure that its word promises; nothing if it has it.
fn lacks(land: &str, raster: &Raster) -> Option<String> {
    let rim = rim(raster);
    if land == "gulf" {
        // One strait: the border turns from land to water once, and back; twice if an islet lies in its mouth.
        let turns = rim.iter().zip(rim.iter().cycle().skip(1)).filter(|(here, next)| here != next).count();
        let wet = rim.iter().filter(|is_land| !**is_land).count() as f32 / rim.len() as f32;
        let sea = Raster { is_land: raster.is_land.iter().map(|land| !land).collect(), ..*raster };
        let whole = shares(&sea)[0];
        return (!(2..=4).contains(&turns) || wet > WIDEST_STRAIT || whole < WHOLE)
            .then(|| format!("{turns} turns, {wet}, {whole}"));
    }
    let shares = shares(raster);
    let main = raster.main_island();
    let (full, long) = (main.fullness(), main.elongation());
    let is_right = match (land, &shares[..]) {
        ("twins", [first, second, ..]) => first + second > WHOLE && *second > LEAST_TWIN,
        ("crescent", [first, ..]) => *first > MAIN && full < FULLEST_CRESCENT,
        ("long", [first, ..]) => *first > MAIN && long > SHORTEST,
        ("arms", [first, ..]) => *first > MAIN && full < FULLEST_ARMS,
        _ => false,
    };
    let is_free = !rim.contains(&true);
    (!is_right || !is_free).then(|| format!("islands {shares:.2?}, full {full:.2}, long {long:.2}, free {is_free}"))
}

/// The least share of the land that its one or two islands have, and of the water that a gulf has with its strait.
const MAIN: f32 = 0.75;
const WHOLE: f32 = 0.85;
/// The least share of the land that the lesser twin has.
const LEAST_TWIN: f32 = 0.15;
/// The greatest share of the border that a strait opens.
const WIDEST_STRAIT: f32 = 0.2;
/// The greatest shares of their convex hulls that a crescent and an island with arms fill: bays lie in the rest.
const FULLEST_CRESCENT: f32 = 0.8;
const FULLEST_ARMS: f32 = 0.9;
/// The least length of a long island over its breadth.
const SHORTEST: f32 = 1.4;

fn every_land_has_its_figure() {
    let cases = pairs(pairs(FIGURES.into_iter().chain(["gulf"]), ASPECTS), 0..36);
    let (mut count, mut without) = (0, Vec::new());
    for ((land, aspect), seed) in one_in(12, cases) {
        let link = format!("land={land}&aspect={aspect}&seed=figure{seed}");
        let lacking = lacks(land, &coarse(&Land::of(&link::read(&link).unwrap()).unwrap()));
        without.extend(lacking.map(|lacking| format!("{link}: {lacking}")));
        count += 1;
    }
    // A coast is chance's: here and there headlands meet across a strait, or a cape fills a bay.
    assert!(without.len() * 50 < count, "{} of {count}: {without:#?}", without.len());
}

/// The rivers of a low stand cut the land, but a sea that has risen leaves each of its pieces and bays.
fn a_risen_sea_leaves_the_figure() {
    let cases = pairs(pairs(FIGURES.into_iter().chain(["gulf"]), ["0.24", "0.6", "1"]), 0..12);
    let (mut without, mut count) = (Vec::new(), 0);
    for ((land, drowning), seed) in one_in(12, cases) {
        let link = format!("land={land}&drowning={drowning}&attractors=6000&seed=figure{seed}");
        let mut session = Session::new(link::read(&link).unwrap()).unwrap();
        session.finish().unwrap();
        let risen = coarse(session.land().unwrap());
        without.extend(lacks(land, &risen).map(|lacking| format!("{link}: {lacking}")));
        count += 1;
        let sea = 1.0 - risen.is_land.iter().filter(|&&land| land).count() as f32 / risen.is_land.len() as f32;
        let asked = link::read(&link).unwrap().sea();
        assert!((sea - asked).abs() < 0.01, "{link}: {sea} is not {asked}");
    }
    // Here and there a valley that is drowned divides a piece.
    assert!(without.len() * 50 < count, "{} of {count}: {without:#?}", without.len());
}

tiers!(
    islands_are_shaped_like_those_of_nature,
    sizes_of_islands_in_an_archipelago_follow_a_power_law,
    no_side_of_a_map_is_hugged,
    small_changes_move_a_coast_a_little,
    every_land_has_its_figure,
    a_risen_sea_leaves_the_figure,
);

/// The measures of shapes that are known.
#[test]
fn measures_are_those_of_a_disc_and_of_a_cross() {
    let drawn = |is_land: &dyn Fn(f32, f32) -> bool| {
        let at = |i: usize| is_land((i % 400) as f32 - 199.5, (i / 400) as f32 - 199.5);
        Raster { is_land: (0..160_000).map(at).collect(), columns: 400, rows: 400, side: 1.0 }.main_island().measures()
    };
    let disc = drawn(&|x, y| x * x + y * y < 150.0 * 150.0);
    assert!((disc.boxed - 0.785).abs() < 0.01 && (disc.coast - 1.0).abs() < 0.05, "{disc:?}");
    assert!(disc.peninsulas < 0.005 && disc.bays < 0.005, "{disc:?}");
    // The smallest rectangle around a cross stands on a corner. Arms 40 wide and 130 long at a square 40 wide: an opening by a disc of radius 13 cuts only their corners.
    let cross = drawn(&|x, y| x.abs().min(y.abs()) < 20.0 && x.abs().max(y.abs()) < 150.0);
    assert!((cross.boxed - 0.387).abs() < 0.01 && cross.coast > 2.0 && cross.peninsulas < 0.03, "{cross:?}");
    // A square with a peninsula narrower than the disc.
    let hand = drawn(&|x, y| (x.abs() < 100.0 && y.abs() < 100.0) || ((0.0..180.0).contains(&x) && y.abs() < 10.0));
    assert!((hand.peninsulas - 80.0 * 20.0 / hand.area).abs() < 0.01, "{hand:?}");
}
