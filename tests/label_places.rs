//! Promises of labels over pictures of all sizes: places are chosen once a map, so larger pictures and views of parts have the labels of
//! smaller ones where those have them; a river's own name comes before others; no letter stands on its head.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::property::{cases, large};
use crate::common::random_link;
use crate::common::tier::{first, tiers};
use proptest::prelude::*;
use riverseed::annotate::labels;
use riverseed::annotate::place::{Kind, Label, Places, Raster, place};
use riverseed::glam::Vec2;
use riverseed::recipe::link;
use riverseed::{Map, Session};

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The labels of a picture that shows a part of the map with so many pixels to a unit.
fn placed(map: &Map, view: [Vec2; 2], scale: f32) -> Vec<Label> {
    labels::input(map, view, scale).map_or_else(Vec::new, |input| place(&input, &Raster::new(&input)))
}

/// The labels of a picture of the whole map.
fn of_width(map: &Map, width: f32) -> Vec<Label> {
    let size = map.domain().size;
    placed(map, [Vec2::ZERO, size], width / size.x)
}

/// Names of rivers and places: all that is neither in a block nor a mark.
fn names(labels: &[Label]) -> impl Iterator<Item = &Label> {
    labels.iter().filter(|label| !label.kind.is_block() && !label.kind.is_mark())
}

/// The middles of its first letter and its last.
fn ends(label: &Label) -> [Vec2; 2] {
    [label.letters.first(), label.letters.last()].map(|letter| letter.unwrap().around(label.em).middle)
}

fn middle(label: &Label) -> Vec2 {
    let [first, last] = ends(label);
    (first + last) * 0.5
}

fn length(label: &Label) -> f32 {
    let [first, last] = ends(label);
    first.distance(last)
}

/// Returns `true` if a label is one of those of a larger picture, no larger and in the same place: it may have drawn nearer to its river, or
/// to its island, and may be in full.
fn is_kept(label: &Label, larger: &[Label]) -> bool {
    is_kept_as_large_as(1.0001, label, larger)
}

/// The same, for a label that may have grown by a factor.
fn is_kept_as_large_as(growth: f32, label: &Label, larger: &[Label]) -> bool {
    names(larger).any(|other| {
        let reach = match label.kind {
            // It becomes shorter towards one end.
            Kind::Offshore | Kind::Cape | Kind::Tarn => 0.5 * length(label) + label.em,
            Kind::River => 1.2 * label.em,
            _ => 0.6 * label.em,
        };
        let is_same = other.kind == label.kind && other.river == label.river && other.em <= label.em * growth;
        is_same && middle(other).distance(middle(label)) <= reach && is_same_name(&label.text, &other.text)
    })
}

fn is_same_name(short: &str, long: &str) -> bool {
    long.contains(short) || short.contains(long)
}

proptest! {
    #![proptest_config(first(1, large(40)))]

    fn larger_pictures_have_the_labels_of_smaller_ones_in_their_places(
        link in random_link(1500), many in 0usize..3, widths in [200.0f32..1500.0, 200.0f32..1500.0],
    ) {
        let many = ["few", "some", "many"][many];
        let session = finished(&format!("{link}&labels={many}"));
        let map = session.map().unwrap();
        let [small, large] = [widths[0].min(widths[1]), widths[0].max(widths[1])].map(|width| of_width(&map, width));
        for label in names(&small) {
            prop_assert!(is_kept(label, &large), "{:?} {} of {:?}", label.kind, label.text, widths);
        }
    }

    fn labels_are_the_same_whatever_parts_of_the_map_were_shown_before(
        link in random_link(1500), many in 0usize..3,
        views in prop::collection::vec((0.8f32..8.0, [0.0f32..1.0, 0.0f32..1.0], 200.0f32..1500.0), 2..6),
    ) {
        let session = finished(&format!("{link}&labels={}", ["few", "some", "many"][many]));
        let map = session.map().unwrap();
        let (size, mut kept) = (map.domain().size, Places::default());
        for (zoom, at, width) in views {
            let corner = (size - size / zoom) * Vec2::from(at);
            let input = labels::input(&map, [corner, corner + size / zoom], width / size.x * zoom).unwrap();
            let raster = Raster::new(&input);
            prop_assert_eq!(kept.place(&input, &raster), place(&input, &raster), "{} times", zoom);
        }
    }

    fn parts_of_a_map_have_the_labels_of_the_whole_that_they_show(
        link in random_link(1500), zoom in 1.1f32..8.0, at in [0.0f32..1.0, 0.0f32..1.0],
    ) {
        let session = finished(&format!("{link}&labels=some"));
        let map = session.map().unwrap();
        let size = map.domain().size;
        let corner = (size - size / zoom) * Vec2::from(at);
        let view = [corner, corner + size / zoom];
        let (whole, part) = (of_width(&map, 1000.0), placed(&map, view, 1000.0 / size.x * zoom));
        let is_well_within = |label: &&Label| {
            let margin = 2.0 * label.em;
            let mut boxes = label.letters.iter().map(|letter| letter.around(label.em).middle);
            boxes.all(|at| at.cmpge(view[0] + margin).all() && at.cmple(view[1] - margin).all())
        };
        for label in names(&whole).filter(is_well_within) {
            prop_assert!(is_kept(label, &part), "{:?} {} at {zoom} times", label.kind, label.text);
        }
        let is_in_view = |at: Vec2| at.cmpge(view[0]).all() && at.cmple(view[1]).all();
        for label in names(&part) {
            let mut corners = label.letters.iter().flat_map(|letter| letter.around(label.em).corners());
            prop_assert!(corners.all(is_in_view), "{} is cut off", label.text);
        }
    }

    fn no_letter_stands_on_its_head(link in random_link(1500), width in 300.0f32..1500.0) {
        let session = finished(&format!("{link}&labels=many"));
        for label in of_width(&session.map().unwrap(), width) {
            for letter in &label.letters {
                let angle = libm::atan2f(letter.along.y, letter.along.x).to_degrees();
                prop_assert!((-100.1..80.1).contains(&angle), "a letter of {} stands at {angle} degrees", label.text);
            }
        }
    }
}

tiers!(
    larger_pictures_have_the_labels_of_smaller_ones_in_their_places,
    parts_of_a_map_have_the_labels_of_the_whole_that_they_show,
    labels_are_the_same_whatever_parts_of_the_map_were_shown_before,
    no_letter_stands_on_its_head
);

/// Winding rivers on four lands, on which names of stretches ask for room.
fn winding(seed: u32, land: &str, labels: &str) -> Session {
    finished(&format!(
        "land={land}&attractors=2000&great-rivers=3&meander-rounds=40&country=usual&seed={seed}&labels={labels}"
    ))
}

const LANDS: [&str; 4] = ["island", "continent", "rectangle", "valley"];

#[test]
fn a_stretch_has_its_name_only_beside_that_of_its_river_and_with_few_no_river_has_two() {
    let mut stretches = 0;
    for (seed, land) in (0..).zip(LANDS) {
        let many = of_width(&winding(seed, land, "many").map().unwrap(), 1400.0);
        for reach in many.iter().filter(|label| label.kind == Kind::Reach) {
            stretches += 1;
            let is_named = many.iter().any(|label| label.kind == Kind::River && label.river == reach.river);
            assert!(is_named, "{land}: {} has driven out its river's name", reach.text);
        }
        let mut counts: BTreeMap<u32, u32> = BTreeMap::new();
        let few = of_width(&winding(seed, land, "few").map().unwrap(), 1400.0);
        few.iter().filter_map(|label| label.river).for_each(|river| *counts.entry(river).or_default() += 1);
        assert!(!counts.is_empty() && counts.values().all(|count| *count == 1), "{land}: {counts:?}");
    }
    assert!(stretches > 4, "{stretches}");
}

proptest! {
    #![proptest_config(first(2, cases(8)))]

    fn the_greatest_river_has_its_name_at_any_number_of_rounds(
        land in 0usize..4, seed in 0u32..1000, rounds in 0u32..300, labels in 0usize..3,
    ) {
        let labels = ["few", "some", "many"][labels];
        let land = LANDS[land];
        let session = finished(&format!(
            "land={land}&attractors=2000&great-rivers=2&meander-rounds={rounds}&country=usual&seed={seed}&labels={labels}"
        ));
        let network = session.network().unwrap();
        let greatest = (0..network.rivers.len()).max_by_key(|&i| network.discharge(&network.rivers[i])).unwrap();
        let labels = of_width(&session.map().unwrap(), 1400.0);
        let has_name = labels.iter().any(|label| label.kind == Kind::River && label.river == Some(greatest as u32));
        prop_assert!(has_name, "{land}");
    }
}

tiers!(the_greatest_river_has_its_name_at_any_number_of_rounds);

/// Small survey sheets have no grid, and larger ones a margin of letters around the map, which leaves out what would reach into it.
#[test]
fn a_survey_sheet_has_the_labels_of_smaller_ones_in_their_places_with_its_grid_and_without() {
    /// Letters become smaller from one step of sizes to the next, but not where they would meet their river: there they stay as large as
    /// on the step, also if those of a picture between two steps had room. No step is larger than this.
    const STEP: f32 = 1.41;
    let (mut kept, mut grown) = (0, 0);
    for (seed, land) in (0..6).zip(["island", "archipelago", "continent"].into_iter().cycle()) {
        let session =
            finished(&format!("land={land}&attractors=1500&country=usual&seed={seed}&style=survey&labels=some"));
        let map = session.map().unwrap();
        let size = map.domain().size;
        let picture = |width: f32| {
            let input = labels::input(&map, [Vec2::ZERO, size], width / size.x).unwrap();
            (place(&input, &Raster::new(&input)), input.view)
        };
        let pictures = [380.0, 440.0, 470.0, 700.0, 1400.0].map(picture);
        for pair in pictures.windows(2) {
            let ((small, _), (large, [least, most])) = (&pair[0], &pair[1]);
            let is_within = |label: &&Label| {
                let mut corners = label.letters.iter().flat_map(|letter| letter.around(label.em).corners());
                corners.all(|at| at.cmpge(*least).all() && at.cmple(*most).all())
            };
            for label in names(small).filter(is_within) {
                let is_there = is_kept_as_large_as(STEP, label, large);
                assert!(is_there, "{land} {seed}: {:?} {}", label.kind, label.text);
                kept += 1;
                grown += usize::from(!is_kept(label, large));
            }
        }
    }
    assert!(kept > 60 && grown * 50 < kept, "{grown} of {kept}");
}
