//! Promises of names that people give: they stand on the map, before any made-up one.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use riverseed::annotate::labels;
use riverseed::annotate::names::Names;
use riverseed::annotate::place::{Box, Kind, Label, Raster, Stroke, place};
use riverseed::glam::Vec2;
use riverseed::recipe::{Mark, link};
use riverseed::{Map, Session};

/// Seeds whose rivers are named, and the names of their three greatest.
const SEEDS: [&str; 8] = ["Veldemar", "kauri", "rimu", "Ardenmoor", "tay", "Thornwick", "new zealand", "anna"];
const NAMES: [&str; 3] = ["Silver Run", "The Long Grey", "Thessaly Water"];

/// Finishes the rivers of a link.
fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(link).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The labels of a picture of a map, so many pixels wide and high, which shows all of it.
fn on_picture(map: &Map, [width, height]: [f32; 2]) -> Vec<Label> {
    let size = map.domain().size;
    let scale = (width / size.x).min(height / size.y);
    let beyond = (Vec2::new(width, height) / scale - size) * 0.5;
    let input = labels::input(map, [-beyond, size + beyond], scale).unwrap();
    place(&input, &Raster::new(&input))
}

/// The recipe of a seed with its three greatest rivers named.
fn named(seed: &str) -> Session {
    let mut session = finished(&format!("country=usual&seed={seed}"));
    let map = session.map().unwrap();
    let rivers = |(mark, _): &(Mark, &str)| matches!(mark, Mark::River(_));
    let of = Names::of(&map);
    let marks = of.marked(map.network()).into_iter().filter(rivers).map(|(mark, _)| mark);
    let texts: Vec<String> = marks.zip(NAMES).map(|(mark, name)| format!("{mark}.{name}")).collect();
    session.change(link::read(&format!("country=usual&seed={seed}&names={}", texts.join("_"))).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The names that a picture of one of those maps does not have.
fn missing(session: &Session, size: [f32; 2]) -> Vec<&'static str> {
    let labels = on_picture(&session.map().unwrap(), size);
    let is_missing = |name: &&str| !labels.iter().any(|label| label.text == *name);
    NAMES.into_iter().filter(is_missing).collect()
}

/// Pictures 600 and 1200 pixels wide, and a sheet of A3 at 300 dots per inch.
const SIZES: [[f32; 2]; 3] = [[600.0, 375.0], [1200.0, 750.0], [4961.0, 3508.0]];

#[test]
fn two_word_names_of_the_greatest_rivers_stand_on_the_map() {
    for seed in SEEDS {
        let session = named(seed);
        SIZES.iter().for_each(|size| assert_eq!(missing(&session, *size), [""; 0], "{seed} at {size:?}"));
    }
}

#[test]
fn own_names_touch_no_other_label_and_not_their_river() {
    for seed in &SEEDS[..4] {
        let session = named(seed);
        let map = session.map().unwrap();
        for width in [600.0, 800.0, 1200.0, 3000.0] {
            let labels = on_picture(&map, [width, width / 1.6]);
            for label in labels.iter().filter(|label| NAMES.contains(&label.text.as_str())) {
                let others = labels.iter().filter(|other| !std::ptr::eq(*other, label));
                let is_met = |around: &Box| others.clone().flat_map(boxes).any(|other| around.meets(&other, 0.0));
                assert!(!boxes(label).any(|around| is_met(&around)), "{} of {seed} at {width}", label.text);
                let course = map.network().middle(&map.network().rivers[label.river.unwrap() as usize]);
                let touches = |around: Box| course.windows(2).any(|pair| around.meets_river(pair));
                assert!(!letters(label).any(touches), "{} of {seed} at {width} lies on its river", label.text);
            }
        }
    }
}

#[test]
fn a_map_without_names_has_no_own_ones() {
    let session =
        finished("country=usual&seed=tay&attractors=1000&labels=none&cartouche=plain&names=0.Silver+Run_i0.Home");
    let labels = on_picture(&session.map().unwrap(), [1200.0, 750.0]);
    assert!(!labels.is_empty() && labels.iter().all(|label| label.kind.is_block()));
}

/// The boxes of a label's letters.
fn letters(label: &Label) -> impl Iterator<Item = Box> + '_ {
    label.letters.iter().map(|letter| letter.around(label.em))
}

/// The boxes of its letters and of its hairline.
fn boxes(label: &Label) -> impl Iterator<Item = Box> + '_ {
    letters(label).chain(label.strokes.iter().filter(|_| label.kind == Kind::River).map(Stroke::box_along))
}
