//! Bends of great rivers are those of natural ones: as wide as their water needs, as long as their width lets expect, and of one shape or
//! another as `meander-mix` asks.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../benches/bends.rs"]
mod measured;

use crate::common::tier::{Tier, one_in, pairs, tiers};
use crate::common::words::WORDS;
use glam::Vec2;
use riverseed::analyse::statistics::Measures;
use riverseed::network::{Vertex, curvature};
use riverseed::recipe::link;
use riverseed::{Map, Session};

/// Lands on which great rivers have room, by both models, and how long they meander.
const ROOMY: [&str; 6] = [
    "country=usual&seed=s6&aspect=1.6&land=island&sea=0.55&attractors=5600&channel-area=6&width=16",
    "country=usual&seed=s2&land=continent&sea=0.4&sides=sw&attractors=20000&width=18",
    "country=usual&seed=s3&aspect=1.3&land=valley&sea=0.15&attractors=18000&channel-area=8&width=20",
    "country=usual&seed=s7&aspect=2&land=valley&sea=0.15&attractors=5000&channel-area=20&width=26&great-rivers=5&flat-share=0.6&neck=2.5",
    "country=usual&seed=s10&land=continent&sea=0.3&sides=e&attractors=30000&channel-area=3&width=24&meander=flow",
    "country=usual&seed=fisk&land=rectangle&mouths=1&attractors=1500&channel-area=20&trim=30&width=26&meander-mix=0.8&great-rivers=2&flat-share=0.6&meander=flow",
];
const ROUNDS: [u32; 3] = [18, 100, 400];

/// The map of a recipe, in country that is bent evenly and little: what winds there does so by meandering.
fn finished(recipe: &str) -> Map {
    Session::new(link::read(&format!("{recipe}&bending=1&bending-variation=0&drowning=0")).unwrap())
        .unwrap()
        .finish()
        .unwrap()
}

/// The courses of the great rivers.
fn great_rivers(map: &Map) -> impl Iterator<Item = Vec<&Vertex>> {
    let network = map.network();
    map.past().great_rivers().iter().map(|&river| network.course(&network.rivers[river as usize]).collect())
}

/// The place a width away from a vertex, up or down its course.
fn width_away(course: &[&Vertex], i: usize, is_up: bool) -> Option<Vec2> {
    let (mut left, mut k) = (course[i].width(), i);
    loop {
        let next = if is_up { k.checked_sub(1)? } else { k + 1 };
        let (from, to) = (course[k].at, course.get(next)?.at);
        let far = from.distance(to);
        if far >= left {
            return Some(from.lerp(to, left / far));
        }
        (left, k) = (left - far, next);
    }
}

/// The radius of a bend at a vertex, in widths: that of the circle through points a width apart.
fn radius(course: &[&Vertex], i: usize) -> Option<f32> {
    let [above, below] = [true, false].map(|is_up| width_away(course, i, is_up));
    let bend = curvature(above?, course[i].at, below?).abs();
    Some(1.0 / (bend * course[i].width()))
}

/// The median of some numbers.
fn median(numbers: impl Iterator<Item = f32>) -> f32 {
    let mut numbers: Vec<f32> = numbers.collect();
    numbers.sort_by(f32::total_cmp);
    numbers[numbers.len() / 2]
}

/// Radii and wavelengths are those of Leopold and Wolman (1960). Where another river, the coast or the frame is in the way, a bend may
/// stay sharper.
fn great_rivers_bend_as_natural_ones_do() {
    let (mut bends, mut radii) = (Vec::new(), Vec::new());
    // With a stride of three, each tier would see bends of some ages alone.
    for (recipe, rounds) in one_in(4, pairs(ROOMY, ROUNDS)) {
        let map = finished(&format!("{recipe}&meander-rounds={rounds}"));
        bends.extend(measured::bends(map.network()));
        for course in great_rivers(&map) {
            let free = (0..course.len()).filter(|&i| course[i].mobility >= 0.7);
            radii.extend(free.filter_map(|i| radius(&course, i)));
        }
    }
    let sharp = radii.iter().filter(|radius| **radius < 1.5).count();
    assert!(radii.len() > 3000 && sharp * 500 <= radii.len(), "{sharp} of {}", radii.len());
    let as_long = bends.iter().filter(|bend| (8.0..=14.0).contains(&bend.wavelength)).count();
    assert!(bends.len() > 80 && as_long * 10 >= bends.len() * 7, "{as_long} of {}", bends.len());
    let radius = median(bends.iter().map(|bend| bend.radius));
    let sinuosity = median(bends.iter().map(|bend| bend.sinuosity));
    assert!((2.0..=3.0).contains(&radius) && (1.2..=1.8).contains(&sinuosity), "{radius}, {sinuosity}");
}

tiers!(great_rivers_bend_as_natural_ones_do);

/// The great rivers of a recipe, and how much they wind: their length over that of straight lines.
fn wind(recipe: &str) -> (Vec<Vec<Vec2>>, f32) {
    let map = finished(recipe);
    let courses = great_rivers(&map).map(|course| course.iter().map(|vertex| vertex.at).collect());
    let courses: Vec<Vec<Vec2>> = courses.collect();
    let way: f32 = courses.iter().flat_map(|course| course.windows(2)).map(|pair| pair[0].distance(pair[1])).sum();
    let straight: f32 = courses.iter().map(|course| course[0].distance(course[course.len() - 1])).sum();
    (courses, way / straight)
}

/// The share of some courses that lies farther than that from others.
fn share_beyond(far: f32, courses: &[Vec<Vec2>], others: &[Vec<Vec2>]) -> f32 {
    let all: Vec<Vec2> = courses.concat();
    let is_beyond = |at: &&Vec2| others.iter().flatten().all(|other| other.distance(**at) > far);
    all.iter().filter(is_beyond).count() as f32 / all.len() as f32
}

/// Rivers wind the more the farther outward bends move, and each quarter of the range leads them elsewhere: the last one least, since
/// rivers that wind so much rest.
fn meander_mix_can_be_seen_over_its_whole_range() {
    for recipe in one_in(4, ROOMY.into_iter().filter(|recipe| !recipe.contains("flow"))) {
        let mixed =
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|mix| wind(&format!("{recipe}&meander-rounds=60&meander-mix={mix}")));
        for (pair, rise) in mixed.windows(2).zip([0.07, 0.07, 0.07, -0.02]) {
            let [(before, winding), (after, more)] = pair else { unreachable!() };
            let moved = share_beyond(5.0, after, before);
            assert!(more - winding > rise && moved > 0.015, "{recipe}: {winding}, then {more}; {moved} elsewhere");
        }
    }
}

tiers!(meander_mix_can_be_seen_over_its_whole_range);

/// Natural bends lean upstream: the water that bent above bends on. Bends by flow do so once they have grown.
fn old_bends_lean_upstream() {
    let words = if Tier::here() == Tier::First { &WORDS[..3] } else { &WORDS[..] };
    for land in ["land=rectangle&sides=s", "land=island"] {
        let lean = |word: &&str| {
            let old = "meander=flow&meander-rounds=200&meander-strength=1";
            let link = format!("country=usual&seed={word}&{land}&{old}");
            let map = Session::new(link::read(&link).unwrap()).unwrap().finish().unwrap();
            Measures::of(&map).bends.upstream.map(|share| share as f32)
        };
        // A map of small rivers has too few such bends to tell.
        let shares: Vec<f32> = words.iter().filter_map(lean).collect();
        assert!(shares.len() * 4 >= words.len() * 3, "{land}: {} of {} maps", shares.len(), words.len());
        let share = median(shares.into_iter());
        println!("{land}: {share:.2} of strongly bent bends lean upstream");
        assert!(share >= 0.55, "{land}: {share}");
    }
}

tiers!(old_bends_lean_upstream);
