//! A session ends whatever is done to it while it grows, holds only finite numbers, and equals a fresh session of its
//! recipe.
#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use riverseed::export::{geojson, json, svg};
use riverseed::network::Network;
use riverseed::picture::Picture;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Decimal, Key, Kind, Parameter, Recipe};
use riverseed::session::Session;

/// A recipe, and the acts on it.
#[derive(Arbitrary, Debug)]
struct Play {
    recipe: Vec<Choice>,
    acts: Vec<Act>,
}

#[derive(Arbitrary, Debug)]
enum Act {
    Advance(u8),
    Paint,
    Change(Choice),
    Resize(u8, u8),
    Restart,
}

/// A value of a parameter, given by the parameter's index in the table.
#[derive(Arbitrary, Debug)]
struct Choice {
    parameter: u8,
    value: Value,
}

#[derive(Arbitrary, Debug)]
enum Value {
    /// A share of the way from the smallest value to the greatest.
    Share(u16),
    /// A text, for a parameter that takes one.
    Text(String),
}

/// The greatest number of acts and choices, and of steps in any loop below.
const MOST_ACTS: usize = 12;
const MOST_STEPS: u32 = 100_000;

fuzz_target!(|play: Play| {
    let mut recipe = small();
    for choice in play.recipe.iter().take(MOST_ACTS) {
        choose(&mut recipe, choice);
    }
    let mut session = Session::new(recipe).expect("it is small");
    let mut picture = Picture::new(40, 30).expect("it is small");
    for act in play.acts.iter().take(MOST_ACTS) {
        take(&mut session, &mut picture, act);
    }
    finish(&mut session);
    picture.paint(&session);
    let mut fresh = Session::new(session.recipe().clone()).expect("it is small");
    finish(&mut fresh);
    let mut fresh_picture = Picture::new(picture.pixmap().width(), picture.pixmap().height()).expect("it is small");
    fresh_picture.paint(&fresh);
    assert!(session.tree() == fresh.tree(), "another tree");
    assert!(session.network() == fresh.network(), "other rivers");
    assert_eq!(session.summary(), fresh.summary());
    assert!(picture.pixmap().data() == fresh_picture.pixmap().data(), "another picture");
    check_files(&session);
});

/// Defaults, except for values that take long.
fn small() -> Recipe {
    let mut recipe = Recipe::default();
    recipe.set(Key::Attractors, "200").expect("it is in range");
    recipe.set(Key::Sensitivity, "50").expect("it is in range");
    recipe
}

fn choose(recipe: &mut Recipe, Choice { parameter, value }: &Choice) {
    let parameter = &TABLE[usize::from(*parameter) % TABLE.len()];
    // A text may be refused; everything else is in range.
    let _ = recipe.set(parameter.key, &text_of(parameter, value));
}

fn text_of(parameter: &Parameter, value: &Value) -> String {
    let share = match value {
        Value::Share(share) => *share,
        Value::Text(text) => return text.clone(),
    };
    let pick = |count: usize| usize::from(share) % count;
    match parameter.kind {
        Kind::Integer { min, max, .. } => {
            let (min, max) =
                most_work(parameter.key).map_or((min, max), |(least, most)| (min.max(least), max.min(most)));
            (min + (u64::from(max - min) * u64::from(share) / 65535) as u32).to_string()
        }
        Kind::Number { min, max, .. } => between(min, max, share),
        Kind::Choice { choices, .. } => choices[pick(choices.len())].name.into(),
        Kind::Sides { .. } => ["n", "e", "s", "w", "ns", "ew", "nesw"][pick(7)].into(),
        Kind::Outline => [".AgAg_gAg_g_gAg_g", ".MzMzzMMzzMzMMzzM..M1M1zKM1"][pick(2)].into(),
        Kind::Text { .. } => share.to_string(),
    }
}

/// Narrower ranges for parameters that take long.
fn most_work(key: Key) -> Option<(u32, u32)> {
    match key {
        Key::Attractors => Some((100, 400)),
        Key::Sensitivity => Some((40, 64)),
        Key::MeanderRounds => Some((0, 60)),
        _ => None,
    }
}

fn between(min: Decimal, max: Decimal, share: u16) -> String {
    let (min, max) = (min.to_f64(), max.to_f64());
    format!("{:.4}", min + (max - min) * f64::from(share) / 65535.0)
}

fn take(session: &mut Session, picture: &mut Picture, act: &Act) {
    match act {
        Act::Advance(steps) => {
            session.advance(u32::from(*steps)).expect("memory for a small tree");
        }
        Act::Paint => {
            picture.paint(session);
        }
        Act::Change(choice) => {
            let mut recipe = session.recipe().clone();
            choose(&mut recipe, choice);
            session.change(recipe).expect("it is small");
        }
        Act::Resize(width, height) => {
            *picture = Picture::new(u32::from(*width % 64) + 1, u32::from(*height % 64) + 1).expect("it is small");
        }
        Act::Restart => session.restart().expect("it is small"),
    }
}

fn finish(session: &mut Session) {
    assert!(!session.advance(MOST_STEPS).expect("memory for a small tree"), "it does not end");
    let at = &session.tree().at;
    assert!(at.iter().all(|at| at.is_finite()), "a tree");
    assert!(session.network().is_none_or(is_finite), "rivers");
}

fn is_finite(network: &Network) -> bool {
    network.vertices.iter().all(|v| v.at.is_finite() && v.left.is_finite() && v.right.is_finite())
}

/// Checks that all files can be written and hold only numbers.
fn check_files(session: &Session) {
    let map = session.map().expect("it is finished");
    let svg = svg::svg(&map).expect("it is finished");
    let paths = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
    assert!(paths.into_iter().all(|path| !path.contains("NaN") && !path.contains("inf")), "{svg}");
    let mut text = Vec::new();
    geojson::write(&mut text, &map).expect("it is finished");
    json::write(&mut text, &map, Some(&session.growth().scattered())).expect("it is finished");
    let text = String::from_utf8_lossy(&text);
    // A value that is not a number is written as null.
    assert!(!text.contains("[null") && !text.contains(",null"), "a column with a number that is none");
}
