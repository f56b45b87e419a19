//! Sliders that keep the map: after a small change (more sea, rougher coasts, or a few more parcels or attractors), the
//! greater rivers of drainage, and of space colonization along valleys, stay where they are. Medians over eight fixed
//! seeds; `cargo test --test all steady -- --nocapture --include-ignored` prints them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::tier::{one_in, pairs, tiers};
use glam::Vec2;
use riverseed::domain::AREA;
use riverseed::network::{NONE, Network};
use riverseed::recipe::link;
use riverseed::session::Session;
use riverseed::{IntegerKey, Key, Recipe};

/// The table's defaults, written out as they were when these bars were set. Courses are what growth and shaping make:
/// no meanders.
const DEFAULTS: &str = "attractors=12000&aspect=1.6&roughness=1&mouths=0&mouth-spacing=0&shores=nesw&sides=s&scatter=random&reach=2.3\
                        &kill=1.1&step=0.38&momentum=0&curl=0.7&stretch=8&valley-spacing=32&concavity=0.5&captures=5&hardness=0.5\
                        &hardness-scale=36&bending=2&channel-area=8&trim=7&simplify=60&width=16&meander=none";

/// A river counts where it drains this number of parcels.
const GREATER: u32 = 60;

/// The least share that is kept.
const BAR: f64 = 0.7;

/// A notch of each slider.
const NOTCHES: [(Key, &str); 3] = [(Key::Sea, "+0.01"), (Key::Roughness, "-0.01"), (Key::Attractors, "+10")];

/// Those that move drowned coasts.
const NOTCHES_OF_THE_SEA: [(Key, &str); 2] = [(Key::Sea, "+0.01"), (Key::Drowning, "+0.02")];

/// Points along the greater rivers of a map, evenly.
struct Courses {
    spacing: f32,
    points: Vec<Vec2>,
}

impl Courses {
    fn of(recipe: Recipe) -> Self {
        let spacing = (AREA / recipe.integer(IntegerKey::Attractors) as f32).sqrt();
        let mut session = Session::new(recipe).unwrap();
        Self { spacing, points: points(session.finish().unwrap().network(), spacing / 16.0) }
    }

    /// The share of these rivers that lies within half a spacing of those of another map.
    fn kept_in(&self, other: &Self) -> f64 {
        let far = self.spacing / 2.0;
        let cell = |at: Vec2| ((at.x / far).floor() as i32, (at.y / far).floor() as i32);
        let mut cells: BTreeMap<(i32, i32), Vec<Vec2>> = BTreeMap::new();
        other.points.iter().for_each(|&at| cells.entry(cell(at)).or_default().push(at));
        let is_kept = |&&at: &&Vec2| {
            let (column, row) = cell(at);
            let mut around =
                (row - 1..=row + 1).flat_map(|row| (column - 1..=column + 1).map(move |column| (column, row)));
            around
                .any(|place| cells.get(&place).is_some_and(|near| near.iter().any(|&point| point.distance(at) <= far)))
        };
        self.points.iter().filter(is_kept).count() as f64 / self.points.len() as f64
    }
}

/// A point at every step of this length along all that is great enough.
fn points(network: &Network, every: f32) -> Vec<Vec2> {
    let mut points = Vec::new();
    for (vertex, &below) in network.vertices.iter().zip(&network.downstream()) {
        if below == NONE || vertex.discharge < GREATER {
            continue;
        }
        let to = network.vertices[below as usize].at;
        let count = (vertex.at.distance(to) / every).ceil().max(1.0) as u32;
        points.extend((0..count).map(|i| vertex.at.lerp(to, i as f32 / count as f32)));
    }
    points
}

/// The kept share of the greater rivers of a link, as medians over eight seeds: after each small change, and for
/// another seed.
fn kept(link: &str, notches: &[(Key, &str)]) -> Vec<f64> {
    let recipe = |seed: usize| link::read(&format!("country=usual&seed=s{seed}&{DEFAULTS}&{link}")).unwrap();
    let notched = |seed: usize, (key, change): (Key, &str)| {
        let mut recipe = recipe(seed);
        let before: f64 = key.parameter().text_of(recipe.value(key)).parse().unwrap();
        let value = before + change.parse::<f64>().unwrap();
        recipe.set(key, format!("{value:.2}").trim_end_matches(".00")).unwrap();
        Courses::of(recipe)
    };
    let before: Vec<Courses> = (0..8).map(|seed| Courses::of(recipe(seed))).collect();
    let another = |seed: usize| before[seed].kept_in(&before[(seed + 1) % 8]);
    let after =
        notches.iter().map(|&notch| median((0..8).map(|seed| before[seed].kept_in(&notched(seed, notch))).collect()));
    after.chain([median((0..8).map(another).collect())]).collect()
}

/// The mean of the two in the middle of eight.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    (values[3] + values[4]) / 2.0
}

fn told(link: &str, notches: &[(Key, &str)], kept: &[f64]) -> String {
    let names = notches.iter().map(|(key, change)| format!("{} {change}", key.parameter().name));
    let shares =
        names.chain(["another seed".into()]).zip(kept).map(|(name, kept)| format!("{name} {:.0} %", kept * 100.0));
    format!("{link}: of the greater rivers is kept: {}", shares.collect::<Vec<_>>().join(", "))
}

fn notches_of_a_slider_keep_the_greater_rivers() {
    let growers = ["growth=drainage&valleys=0.2", "growth=drainage&valleys=0", "growth=colonize&valleys=0.2"];
    let mut of_colonization = BTreeMap::new();
    for (land, grower) in one_in(6, pairs(["land=island&sea=0.6", "land=continent&sea=0.3"], growers)) {
        // For comparison: there is no bar for space colonization without valleys, whose fronts meet elsewhere after any
        // change.
        let colonized =
            of_colonization.entry(land).or_insert_with(|| kept(&format!("{land}&growth=colonize&valleys=0"), &NOTCHES));
        let link = format!("{land}&{grower}");
        let kept = kept(&link, &NOTCHES);
        let told = format!(
            "{}\n{}",
            told(&link, &NOTCHES, &kept),
            told("with growth=colonize&valleys=0", &NOTCHES, colonized)
        );
        println!("{told}");
        let (another, notches) = kept.split_last().unwrap();
        assert!(notches.iter().all(|&share| share >= BAR), "{told}");
        assert!(notches.iter().zip(&*colonized).all(|(share, colonized)| share > colonized), "{told}");
        // Of rivers that have nothing to do with these, the measure says so.
        assert!(*another < 0.2, "{told}");
    }
}

tiers!(notches_of_a_slider_keep_the_greater_rivers);

fn notches_of_the_sea_keep_the_greater_rivers_of_drowned_coasts() {
    for land in one_in(3, ["land=island&sea=0.6", "land=continent&sea=0.3", "land=archipelago&sea=0.7"]) {
        let link = format!("{land}&growth=drainage&valleys=0.2&drowning=0.5");
        let kept = kept(&link, &NOTCHES_OF_THE_SEA);
        let told = told(&link, &NOTCHES_OF_THE_SEA, &kept);
        println!("{told}");
        let (another, notches) = kept.split_last().unwrap();
        assert!(notches.iter().all(|&share| share >= BAR), "{told}");
        assert!(*another < 0.2, "{told}");
    }
}

tiers!(notches_of_the_sea_keep_the_greater_rivers_of_drowned_coasts);
