//! Hypsometry: how much of the land is high.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::lands::every_land;
use riverseed::Session;
use riverseed::recipe::link;
use riverseed::scale::USUAL_METRES;

/// The hypsometric integral of a map, which is the mean height of its land as a share of the greatest (Strahler 1952), and
/// its highest land in metres.
fn integral_and_top(text: &str) -> (f64, f32) {
    let map = Session::new(link::read(text).unwrap()).unwrap().finish().unwrap();
    let relief = map.make_relief().unwrap();
    let (mut sum, mut count, mut top) = (0.0, 0.0, 0.0f32);
    for &height in relief.heights().iter().filter(|height| **height > 0.0) {
        (sum, count, top) = (sum + f64::from(height), count + 1.0, top.max(height));
    }
    (sum / count / f64::from(top), top * USUAL_METRES)
}

/// Strahler's basins in equilibrium have integrals of 0.35 to 0.6, worn ones with few hills left less. Once islands had 0.18.
#[test]
#[ignore = "second tier"]
fn land_has_the_hypsometry_of_natural_land() {
    const SEEDS: [&str; 8] = ["kauri", "skye", "galicia", "orinoco", "mara", "elbe", "tay", "rimu"];
    for land in every_land() {
        let mut all: Vec<(f64, f32)> =
            SEEDS.iter().map(|seed| integral_and_top(&format!("country=usual&seed={seed}&{land}"))).collect();
        all.sort_by(|one, other| one.0.total_cmp(&other.0));
        let median = f64::midpoint(all[3].0, all[4].0);
        // As measured: 0.193 in archipelagos, whose rivers are short and steep.
        assert!((0.19..0.5).contains(&median), "{land}: {median}");
        // In archipelagos a large island may stand high above small ones.
        assert!(all[0].0 > 0.14 && all[7].0 < 0.55, "{land}: {all:?}");
        assert!(all.iter().all(|(_, top)| (600.0..3400.0).contains(top)), "{land}: {all:?}");
    }
}
