//! A finished map on its way to another module: what arrives is the same map, and what was damaged on the way is none, or is read without a
//! panic.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::sync::LazyLock;

use crate::common::finished;
use crate::common::property::cases;
use proptest::prelude::*;
use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::paint::View;
use riverseed::picture::builder::AnnotationBuilder;

#[test]
fn a_map_that_is_handed_over_has_the_same_names_and_labels() {
    for link in [
        "land=island&growth=drainage&attractors=3000",
        "land=archipelago&growth=colonize&attractors=4000&curl=0.8&meander-rounds=60&great-rivers=4",
        "land=basin&growth=brownian&trim=20&language=9",
        "land=rectangle&growth=colonize&mouths=3&attractors=2000",
        "land=drawn&outline=.MzMzzMMzzMzMMzzM&attractors=2000&names=t.Home_s0.Sea+of+Glass",
    ] {
        let session = finished(link, "seed=kauri&labels=many");
        let map = session.map().unwrap();
        let own = Map::from_wire(&map.to_wire()).unwrap();
        assert_eq!(Names::of(&own), Names::of(&map), "{link}");
        let view = View::new(&session.domain(), 500, 400).unwrap();
        let masks = AnnotationBuilder::whole(&own, &view, 1.0);
        assert!(masks == AnnotationBuilder::whole(&map, &view, 1.0) && !masks.letters.is_empty(), "{link}");
    }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_message_that_is_cut_off_is_no_map_and_an_altered_one_is_read_without_a_panic(at in 0usize..60_000, word in any::<u32>(), cut in any::<bool>()) {
        static MESSAGE: LazyLock<Vec<u32>> = LazyLock::new(|| {
            finished("land=island&growth=drainage&attractors=300", "seed=kauri&labels=many").map().unwrap().to_wire()
        });
        let mut data = MESSAGE.clone();
        let at = at % data.len();
        if cut { data.truncate(at) } else { data[at] = word }
        let read = Map::from_wire(&data);
        prop_assert!(read.is_none() || !cut);
    }
}
