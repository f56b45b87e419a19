//! Pieces of maps beside pieces of real rivers, by the same measures. The world's 96 pieces are the family *carto* of
//! `tests/real-rivers/`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::io::Cursor;
use std::ops::RangeInclusive;

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
    let file = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/real-rivers/snippets.png")).unwrap();
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

/// The measures of a recipe's maps, by name: the medians of twelve.
fn usual(recipe: &str) -> impl Fn(&str) -> f64 + use<> {
    let of_seed = |seed: u32| {
        let mut session = Session::new(link::read(&format!("{recipe}&country=usual&seed=s{seed}")).unwrap()).unwrap();
        session.finish().unwrap();
        Measures::of(&session.map().unwrap())
    };
    let maps: Vec<Measures> = (0..12).map(of_seed).collect();
    let recipe = recipe.to_owned();
    move |name| {
        let measure = TABLE.iter().find(|measure| measure.name == name).unwrap();
        let mut values: Vec<f64> = maps.iter().filter_map(measure.value).collect();
        assert!(values.len() > 9, "{recipe}: {name} of {} maps", values.len());
        values.sort_by(f64::total_cmp);
        let median = (values[(values.len() - 1) / 2] + values[values.len() / 2]) / 2.0;
        println!("{recipe}: {name} {median:.3}");
        median
    }
}

/// Checks measures of a recipe's maps against the ranges that they should lie in.
fn assert_within(recipe: &str, ranges: &[(&str, RangeInclusive<f64>)]) {
    let median = usual(recipe);
    let astray = ranges.iter().map(|(name, range)| (name, median(name), range));
    let astray: Vec<_> = astray.filter(|(_, median, range)| !range.contains(median)).collect();
    assert!(astray.is_empty(), "{recipe}: {astray:?}");
}

/// The look of the default network is that of real rivers.
#[test]
#[ignore = "second tier"]
fn default_drainage_looks_like_the_world_s_rivers() {
    assert_within(
        "land=rectangle&sides=s",
        &[
            ("junction-spacing", 3.4..=4.2),
            ("nearest-line", -0.06..=0.08),
            ("turn-kurtosis", 3.7..=f64::MAX),
            ("turn-autocorrelation", -0.1..=0.1),
            ("gap-variation", 0.735..=0.769),
            ("anisotropy", 0.25..=0.36),
            ("sinuosity", 1.26..=1.45),
            ("knots", 0.0..=0.0),
        ],
    );
}

/// All its channels together branch like natural basins.
#[test]
#[ignore = "second tier"]
fn all_channels_of_drainage_branch_like_natural_basins() {
    assert_within(
        "land=rectangle&sides=s&valleys=0.3&channel-area=1&trim=0&tributary-spacing=0",
        &[
            ("bifurcation-ratio", 3.5..=5.2),
            ("length-ratio", 1.7..=2.4),
            ("tokunaga-c", 2.3..=3.3),
            ("hack-exponent", 0.6..=0.69),
            // Nature's is 0.43.
            ("area-exponent", 0.40..=0.52),
        ],
    );
}

/// Rivers wind like natural ones wherever the sea is, and nowhere do three or more lines lie within a spacing.
#[test]
#[ignore = "second tier"]
fn rivers_of_all_lands_wind_like_natural_ones_and_none_is_tangled() {
    for land in ["island", "continent", "archipelago", "valley", "basin"] {
        assert_within(&format!("land={land}"), &[("sinuosity", 1.21..=1.54), ("knots", 0.0..=0.3)]);
    }
}

/// Where the land falls steeply, as in a desert, rivers join at narrower angles than in humid country.
#[test]
#[ignore = "second tier"]
fn junctions_are_the_narrower_the_more_the_land_falls() {
    let angles =
        [0.0, 0.2, 0.8, 1.6].map(|fall| usual(&format!("land=rectangle&sides=s&fall={fall}"))("junction-angle"));
    assert!(angles.windows(2).all(|pair| pair[0] > pair[1] + 2.0), "{angles:?}");
    assert!((64.0..=74.0).contains(&angles[1]) && angles[2] < 60.0, "{angles:?}");
}

/// Drainage without a grain is dendritic, wherever the sea is.
#[test]
#[ignore = "second tier"]
fn default_drainage_is_named_dendritic() {
    for land in ["rectangle&sides=s", "rectangle", "island", "continent", "archipelago"] {
        for seed in 0..4 {
            let mut session =
                Session::new(link::read(&format!("land={land}&country=usual&seed=s{seed}")).unwrap()).unwrap();
            session.finish().unwrap();
            let pattern = Measures::of(&session.map().unwrap()).pattern().unwrap();
            assert_eq!(pattern.name(), "dendritic", "{land}, {seed}: {:?}", pattern.nearest_first());
        }
    }
}
