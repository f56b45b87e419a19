//! Pieces of maps beside pieces of real rivers, by the same measures. The world's 96 pieces are the family *carto* of
//! `tests/real-rivers/`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::io::Cursor;

use riverseed::analyse::statistics::{Look, Measures, TABLE};
use riverseed::import::png;
use riverseed::recipe::link;
use riverseed::session::Session;

const NAMES: [&str; 6] =
    ["junction-spacing", "nearest-line", "turn-kurtosis", "turn-autocorrelation", "gap-variation", "anisotropy"];

/// Number of pieces side by side in the picture.
const COLUMNS: usize = 12;

/// The looks of the world's pieces, in the order of the picture.
fn real() -> Vec<Look> {
    let file = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/real-rivers/snippets.png")).unwrap();
    let image = png::read(Cursor::new(file)).unwrap();
    let pixel = |x: usize, y: usize| u8::from(image.rgba[4 * (y * image.width as usize + x)] > 127);
    let piece = |tile: usize| -> Vec<u8> {
        let (left, top) = (tile % COLUMNS * 100, tile / COLUMNS * 100);
        (0..10_000).map(|i| pixel(left + i % 100, top + i / 100)).collect()
    };
    (0..96).map(|tile| Look::of_piece(&piece(tile)).unwrap()).collect()
}

/// The values of a look, in the order of the names.
fn values(look: Look) -> [f64; 6] {
    let Look { junction_spacing, nearest_line, turn_kurtosis, turn_autocorrelation, gap_variation, anisotropy, .. } =
        look;
    [junction_spacing, nearest_line, turn_kurtosis, turn_autocorrelation, gap_variation, anisotropy].map(Option::unwrap)
}

/// Checks values against expected ones, with the error allowed in each. Prints them.
fn assert_near(what: &str, values: [f64; 6], expected: [(f64, f64); 6]) {
    for ((name, value), (expected, error)) in NAMES.iter().zip(values).zip(expected) {
        println!("{what}: {name} {value:.3}, expected {expected:.3}");
        assert!((value - expected).abs() <= error, "{what}: {name} {value}, expected {expected}");
    }
}

/// The values that the study of networks found in these pieces by a program of its own. They are met within 5 %, and
/// within 0.02 where they are about 0.
#[test]
fn the_world_s_rivers_have_the_measures_that_a_study_found() {
    let study = [(3.85, 0.19), (0.0, 0.02), (4.35, 0.25), (-0.04, 0.02), (0.745, 0.01), (0.32, 0.016)];
    assert_near("the world", values(Look::typical(&real())), study);
}

/// Nature's ranges in the table are those of these pieces.
#[test]
fn nature_s_ranges_are_median_least_and_greatest_of_dozens_of_pieces() {
    let dozens: Vec<[f64; 6]> = real().chunks(COLUMNS).map(|dozen| values(Look::typical(dozen))).collect();
    for (i, name) in NAMES.iter().enumerate() {
        let mut of_dozens: Vec<f64> = dozens.iter().map(|values| values[i]).collect();
        of_dozens.sort_by(f64::total_cmp);
        let expected = [(of_dozens[3] + of_dozens[4]) / 2.0, of_dozens[0], of_dozens[7]];
        let measure = TABLE.iter().find(|measure| measure.name == *name).unwrap();
        let nature = measure.nature.unwrap();
        println!("{name}: {expected:.3?}");
        for (told, expected) in [nature.median.unwrap(), nature.least, nature.most].into_iter().zip(expected) {
            let half_a_place = (0..measure.places).fold(0.501, |half, _| half / 10.0);
            assert!((told - expected).abs() < half_a_place, "{name}: {told} is not {expected}");
        }
    }
}

/// What the study found in maps of the default drainage at that time, of the growth that they still have: the medians of
/// twelve maps.
#[test]
#[ignore = "second tier"]
fn maps_have_the_measures_that_the_study_found_in_them() {
    let of_seed = |seed: u32| {
        let recipe = link::read(&format!("land=rectangle&sides=s&seed=s{seed}")).unwrap();
        let mut session = Session::new(recipe).unwrap();
        session.finish().unwrap();
        let measures = Measures::of(&session.map().unwrap());
        values(measures.look)
    };
    let maps: Vec<[f64; 6]> = (0..12).map(of_seed).collect();
    let median = |i: usize| {
        let mut values: Vec<f64> = maps.iter().map(|values| values[i]).collect();
        values.sort_by(f64::total_cmp);
        (values[5] + values[6]) / 2.0
    };
    let study = [(2.7, 0.135), (-0.17, 0.02), (3.2, 0.16), (-0.16, 0.02), (0.706, 0.035), (0.22, 0.015)];
    assert_near("maps", std::array::from_fn(median), study);
}

/// Drainage without a grain is dendritic, wherever the sea is.
#[test]
#[ignore = "second tier"]
fn default_drainage_is_named_dendritic() {
    for land in ["rectangle&sides=s", "rectangle", "island", "continent", "archipelago"] {
        for seed in 0..4 {
            let mut session = Session::new(link::read(&format!("land={land}&seed=s{seed}")).unwrap()).unwrap();
            session.finish().unwrap();
            let pattern = Measures::of(&session.map().unwrap()).pattern().unwrap();
            assert_eq!(pattern.name(), "dendritic", "{land}, {seed}: {:?}", pattern.nearest_first());
        }
    }
}
