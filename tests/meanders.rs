//! Rivers stay rivers however long they meander: no stretch becomes a knot, lakes keep apart and grow old, nothing runs
//! along the frame of the map, and the work of a round does not grow without end.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::tier::{one_in, pairs, tiers};
use geo::{LineString, Polygon, Validation};
use glam::Vec2;
use riverseed::base::work;
use riverseed::network::{Meander, NONE, Network, NetworkSettings, Place, Shaping, gap};
use riverseed::recipe::{CourseShape, link};
use riverseed::{Oxbow, River, Session};

/// Both models and all ways of growing, wide rivers and narrow ones, on lands with a frame and without; as old as can
/// be.
const OLD: [&str; 6] = [
    "country=usual&seed=skye&attractors=4000",
    "country=usual&seed=loire&land=rectangle&aspect=2&sides=e&mouths=1&growth=colonize&attractors=1200&curl=0.5&trim=14&trim-variation=0&tributary-spacing=0&width=22&great-rivers=2&flat-share=0.6",
    "country=usual&seed=needle&land=rectangle&aspect=1.5&sides=s&mouths=2&growth=colonize&attractors=800&trim=30&trim-variation=0&tributary-spacing=0&width=34&flat-share=0.6&meander=flow",
    "country=usual&seed=fisk&land=rectangle&aspect=2&sides=s&mouths=1&growth=colonize&attractors=700&trim=30&trim-variation=0&tributary-spacing=0&width=26&flat-share=0.7&meander-mix=0.8",
    "country=usual&seed=danube&land=continent&growth=brownian&sensitivity=30&trim=20&width=10&great-rivers=6&meander=flow&meander-strength=1",
    "country=usual&seed=anduin&land=continent&growth=drainage&attractors=3000&width=24&great-rivers=16&flat-share=1&meander-strength=1&meander-elsewhere=1&clearance=0",
];

/// Rivers that either model spoils most easily: wide ones and narrow ones, with many junctions that hold them.
const HELD: [&str; 4] = [
    "country=usual&seed=weka&land=rectangle",
    "country=usual&seed=rata&flat-share=0.5",
    "country=usual&seed=weka&land=rectangle&growth=colonize&attractors=2000&width=24",
    "country=usual&seed=skye&attractors=4000",
];

/// The rivers of a recipe before they meander.
fn young(recipe: &str) -> Meander {
    let mut session = Session::new(link::read(&format!("{recipe}&meander-rounds=0")).unwrap()).unwrap();
    session.finish().unwrap();
    let growth = session.growth();
    let settings = NetworkSettings::new(
        &link::read(&format!("{recipe}&meander-rounds=400")).unwrap(),
        growth.stream_spacing(),
        growth.total_discharge(),
    );
    let mut shaping =
        Shaping::new(&session.pruned().tree, growth.may_cross(), session.land().cloned(), settings).unwrap();
    while shaping.meander().is_none() {
        shaping.step();
    }
    shaping.meander().unwrap().clone()
}

/// Lets rivers of a recipe grow old, and looks at them before, in every twenty-fifth round and in the last.
fn grow_old(recipe: &str, mut look: impl FnMut(&Meander)) {
    let mut meander = young(recipe);
    look(&meander);
    while meander.round() {
        if meander.rounds().is_multiple_of(25) {
            look(&meander);
        }
    }
    assert_eq!(meander.rounds(), 400, "{recipe}");
    look(&meander);
}

/// The sinuosity of the most winding stretch of 48 widths of a river; 1 for shorter rivers.
fn sinuosity(network: &Network, river: &River, spacing: f32) -> f32 {
    let own = &network.vertices[river.vertex_range()];
    let stretch = |(start, first): (usize, &riverseed::Vertex)| {
        let (mut way, length) = (0.0, 48.0 * first.width().max(spacing));
        let last = own[start..].windows(2).find_map(|pair| {
            way += pair[0].at.distance(pair[1].at);
            (way >= length).then_some(pair[1].at)
        });
        last.map_or(1.0, |last| way / first.at.distance(last))
    };
    own.iter().enumerate().map(stretch).fold(1.0, f32::max)
}

/// The former courses that are kept are those of each round, however a session gets there; nobody has to ask for them
/// in between.
#[test]
fn former_courses_are_those_of_their_rounds_and_the_same_stepped_or_at_once() {
    for recipe in OLD {
        let link = link::read(&format!("{recipe}&meander-rounds=50")).unwrap();
        let mut stepped = Session::new(link.clone()).unwrap();
        let mut courses: Vec<Vec<Vec<Place>>> = Vec::new();
        while stepped.advance(1).unwrap() {
            // A step may make no round.
            if stepped.rounds().is_none_or(|rounds| courses.len() as u32 > rounds) {
                continue;
            }
            if let Some((network, past)) = stepped.network().zip(stepped.past()) {
                assert!(past.rounds().iter().all(|past| past.round < courses.len() as u32));
                let great = past.great_rivers().iter().map(|&id| network.middle(&network.rivers[id as usize]));
                courses.push(great.collect());
            }
        }
        let mut at_once = Session::new(link).unwrap();
        at_once.finish().unwrap();
        let past = stepped.past().unwrap();
        assert!(Some(past) == at_once.past() && past.rounds().len() == 12, "{recipe}");
        for kept in past.rounds() {
            for (kept, whole) in kept.courses.iter().zip(&courses[kept.round as usize]) {
                let mut rest = whole.iter();
                assert!(kept.line.len() * 5 > whole.len() && kept.line.iter().all(|at| rest.any(|other| other == at)));
            }
        }
    }
}

/// A stretch rests from 2.6 on, and a loop that is nearly closed from 3.3 on; what moves beside it may add to that
/// until all of it rests.
fn no_stretch_becomes_a_knot() {
    const MOST: f32 = 4.0;
    for recipe in one_in(4, OLD) {
        grow_old(recipe, |meander| {
            let (network, spacing) = (meander.network(), meander.settings().spacing);
            for (id, river) in network.rivers.iter().enumerate() {
                let most = sinuosity(network, river, spacing);
                assert!(most < MOST, "{recipe}, round {}: river {id} winds {most}", meander.rounds());
            }
        });
    }
}

tiers!(no_stretch_becomes_a_knot);

/// Returns `true` if two lines of discs overlap.
fn overlap(a: &[Place], b: &[Place]) -> bool {
    let widest = |line: &[Place]| line.iter().map(|place| place.half).fold(0.0, f32::max);
    let most = widest(a) + widest(b);
    a.windows(2).any(|a| {
        let near =
            |b: &[Place]| a[0].at.distance(b[0].at) < most + a[0].at.distance(a[1].at) + b[0].at.distance(b[1].at);
        b.windows(2).filter(|b| near(b)).any(|b| {
            let halves = a[0].half.max(a[1].half) + b[0].half.max(b[1].half);
            gap((a[0].at, a[1].at), (b[0].at, b[1].at)) < halves
        })
    })
}

fn lakes_overlap_neither_rivers_nor_each_other() {
    let (mut seen, mut maps) = (0, 0);
    let held = HELD.map(|recipe| format!("{recipe}&meander=flow"));
    for recipe in one_in(4, OLD.into_iter().chain(held.iter().map(String::as_str))) {
        maps += 1;
        grow_old(&format!("{recipe}&oxbows=1&neck=3"), |meander| {
            let network = meander.drawn();
            let rivers: Vec<Vec<Place>> = network.rivers.iter().map(|river| network.middle(river)).collect();
            let lakes: Vec<Vec<Place>> = network.oxbows.iter().map(Oxbow::middle).collect();
            seen += lakes.len();
            for (number, lake) in lakes.iter().enumerate() {
                let others = lakes[..number].iter().chain(&rivers);
                let meets = others.into_iter().any(|other| overlap(lake, other));
                assert!(!meets, "{recipe}, round {}: lake {number}", meander.rounds());
            }
        });
    }
    assert!(seen >= 5 * maps, "{seen} lakes on {maps} maps");
}

tiers!(lakes_overlap_neither_rivers_nor_each_other);

/// There are never many lakes, however many necks are cut, and none is older than the time in which silt fills it.
fn lakes_grow_old_and_are_gone() {
    const OLDEST: u32 = 160;
    for recipe in one_in(4, OLD) {
        grow_old(recipe, |meander| {
            let oxbows = &meander.network().oxbows;
            assert!(oxbows.len() <= 40, "{recipe}, round {}: {} lakes", meander.rounds(), oxbows.len());
            for oxbow in oxbows {
                let age = meander.rounds() - oxbow.born;
                assert!(age < OLDEST && oxbow.silt < 1.0 && !oxbow.lake().is_empty(), "{age}: {oxbow:?}");
                assert_eq!(oxbow.silt > 0.0, age > 24, "{age}: {}", oxbow.silt);
            }
        });
    }
}

tiers!(lakes_grow_old_and_are_gone);

/// The length of rivers within eight units of the frame of the map.
fn beside_frame(meander: &Meander) -> f32 {
    let (network, size) = (meander.network(), meander.settings().domain.size);
    let inner = [Vec2::splat(8.0), size - 8.0];
    let segments = network.vertices.iter().zip(network.downstream()).filter(|(_, below)| *below != NONE);
    let segments = segments.map(|(vertex, below)| (vertex.at, network.vertices[below as usize].at));
    segments.map(|(a, b)| a.distance(b) * (1.0 - share_within(a, b, inner))).sum()
}

/// The share of a line from one place to another that lies within a box.
fn share_within(from: Vec2, to: Vec2, [least, most]: [Vec2; 2]) -> f32 {
    let (mut enters, mut leaves) = (0.0f32, 1.0f32);
    for axis in 0..2 {
        let (way, off) = (to[axis] - from[axis], [least[axis] - from[axis], most[axis] - from[axis]]);
        if way == 0.0 {
            leaves = if off[0] <= 0.0 && off[1] >= 0.0 { leaves } else { 0.0 };
            continue;
        }
        let [first, last] = if way > 0.0 { off } else { [off[1], off[0]] }.map(|off| off / way);
        (enters, leaves) = (enters.max(first), leaves.min(last));
    }
    (leaves - enters).max(0.0)
}

/// Great rivers that nothing but the frame keeps from running along it.
const BESIDE_FRAME: &str = "country=usual&seed=z0&land=rectangle&aspect=1.5&growth=colonize&attractors=600&trim=20&width=20&great-rivers=8&flat-share=1&meander-strength=1";

/// Rivers grow near it, and reach the sea there, but no bend comes to it.
fn no_river_comes_to_run_along_the_frame() {
    for recipe in std::iter::once(BESIDE_FRAME).chain(one_in(4, OLD)) {
        let mut begun = None;
        grow_old(recipe, |meander| {
            let (length, size) = (beside_frame(meander), meander.settings().domain.size);
            let young = *begun.get_or_insert(length);
            assert!(length <= young + 1.0, "{recipe}, round {}: {length}, first {young}", meander.rounds());
            let leaves = |at: Vec2| at.min(size - at).min_element() < 0.0;
            assert!(!meander.network().vertices.iter().any(|vertex| leaves(vertex.at)), "{recipe}");
        });
    }
}

tiers!(no_river_comes_to_run_along_the_frame);

/// All kinds of country, both models, the three ways of growing, widths to 40.
const DRAWN: [&str; 12] = [
    "country=usual&seed=s0&land=island",
    "country=usual&seed=s1&land=archipelago&attractors=12000&meander=flow",
    "country=usual&seed=s2&land=continent&sea=0.4&roughness=0.9&sides=sw&width=18",
    "country=usual&seed=s3&aspect=1.3&land=valley&sea=0.15&roughness=0.7&attractors=18000&channel-area=8&width=20",
    "country=usual&seed=s4&aspect=1.3&land=basin&sea=0.25&meander=flow&width=40",
    "country=usual&seed=s7&aspect=2&land=valley&sea=0.15&attractors=5000&channel-area=20&width=26&great-rivers=5&flat-share=0.6&neck=2.5&oxbows=1",
    "country=usual&seed=s8&land=island&sea=0.45&growth=brownian&sensitivity=11&width=18",
    "country=usual&seed=s9&land=continent&growth=brownian&sensitivity=30&trim=20&width=40&meander=flow",
    "country=usual&seed=s10&land=continent&sea=0.3&sides=e&attractors=30000&channel-area=3&width=24",
    "country=usual&seed=s12&land=rectangle&growth=colonize&attractors=2000&width=24&curl=0.9&stretch=7",
    "country=usual&seed=s13&land=rectangle&growth=colonize&attractors=1500&momentum=0.45&trim=8&width=40&meander=flow&clearance=0",
    "country=usual&seed=fisk&land=rectangle&mouths=1&attractors=1500&channel-area=20&trim=30&width=26&meander-mix=0.8&great-rivers=2&flat-share=0.6",
];

/// The banks of a river from its source to its end, as the geo crate sees them; `None` if the river has no width anywhere.
fn polygon(network: &Network, river: &River) -> Option<Polygon> {
    let ring = network.banks(river, CourseShape::Smooth).ring();
    let has_width = network.vertices[river.vertex_range()].iter().any(|vertex| vertex.width() > 0.0);
    let corners = ring.iter().map(|at| (f64::from(at.x), f64::from(at.y)));
    has_width.then(|| Polygon::new(LineString::from(corners.collect::<Vec<_>>()), Vec::new()))
}

/// The drawn network is looked at from its first rounds to the last of the page's slider, and so are maps of the gallery.
fn no_river_covers_itself() {
    let gallery: Vec<serde_json::Value> = serde_json::from_str(GALLERY).unwrap();
    let gallery = gallery.iter().map(|map| map["link"].as_str().unwrap().to_owned());
    let aged = pairs(DRAWN, [0, 1, 18, 60, 150, 400]);
    let aged = aged.map(|(recipe, rounds)| format!("{recipe}&meander-rounds={rounds}"));
    for recipe in one_in(3, aged.chain(gallery).collect::<Vec<_>>()) {
        let mut session = Session::new(link::read(&recipe).unwrap()).unwrap();
        let map = session.finish().unwrap();
        for (id, river) in map.network().rivers.iter().enumerate() {
            let Some(polygon) = polygon(map.network(), river) else { continue };
            let fault = polygon.check_validation().err();
            assert!(fault.is_none(), "{recipe}: river {id} {fault:?}");
        }
    }
}

const GALLERY: &str = include_str!("../www/gallery/recipes.json");

tiers!(no_river_covers_itself);

/// *Old river* promises oxbow lakes, however long it meanders.
#[test]
fn old_rivers_have_oxbow_lakes() {
    for rounds in [120, 400] {
        let lakes = |seed: u32| {
            let link = format!("seed=o{seed}&country=old-river&meander-rounds={rounds}");
            let mut session = Session::new(link::read(&link).unwrap()).unwrap();
            session.finish().unwrap().network().oxbows.len()
        };
        let counts: Vec<usize> = (0..8).map(lakes).collect();
        assert!(counts.iter().filter(|&&lakes| lakes > 0).count() >= 5, "{rounds} rounds: {counts:?}");
    }
}

/// Whatever was cut off, in the very last round, too.
#[test]
fn without_oxbows_there_are_none_in_any_round() {
    let mut cut = 0;
    for oxbows in [0, 1] {
        grow_old(&format!("{}&oxbows={oxbows}", OLD[5]), |meander| {
            let lakes = meander.network().oxbows.len();
            assert!(oxbows == 1 || lakes == 0, "round {}: {lakes} lakes", meander.rounds());
            cut += lakes;
        });
    }
    assert!(cut > 5, "{cut}");
}

/// Old rivers are hardly longer than grown ones, so a round of them takes hardly more.
fn no_round_of_old_rivers_takes_long() {
    for recipe in one_in(4, OLD) {
        let mut meander = young(recipe);
        let vertices = meander.network().vertices.len();
        loop {
            let begun = work::steps();
            let goes_on = meander.round();
            let (steps, now) = (work::steps() - begun, meander.network().vertices.len());
            assert!(now <= 2 * vertices, "{recipe}, round {}: {now} vertices of {vertices}", meander.rounds());
            assert!(steps <= 180 * vertices as u64, "{recipe}, round {}: {steps} of {vertices}", meander.rounds());
            if !goes_on {
                break;
            }
        }
    }
}

tiers!(no_round_of_old_rivers_takes_long);

/// The course of a river: the position of each vertex, its width, and its distance along the course in widths.
fn course(meander: &Meander, river: u32) -> Vec<(Vec2, f32, f32)> {
    let (network, spacing) = (meander.network(), meander.settings().spacing);
    let own = &network.vertices[network.rivers[river as usize].vertex_range()];
    let (mut along, mut last) = (0.0, own[0].at);
    let place = |vertex: &riverseed::Vertex| {
        let width = vertex.width().max(spacing);
        along += last.distance(vertex.at) / width;
        last = vertex.at;
        (vertex.at, width, along)
    };
    own.iter().map(place).collect()
}

/// The longest part of a course that stays within a quarter of its width of a straight line, in widths.
fn longest_chord(course: &[(Vec2, f32, f32)]) -> f32 {
    let is_straight = |from: usize, to: usize| {
        let ((a, width, _), b) = (course[from], course[to].0);
        let way = (b - a).normalize_or_zero();
        course[from..to].iter().all(|(at, ..)| (*at - a).perp_dot(way).abs() < 0.25 * width)
    };
    let chord = |from: usize| {
        let end = (from + 1..course.len()).take_while(|&to| is_straight(from, to)).last().unwrap_or(from);
        course[end].2 - course[from].2
    };
    (0..course.len()).map(chord).fold(0.0, f32::max)
}

/// The turn of a course from the width above each vertex to the width below it, in degrees.
fn turns(course: &[(Vec2, f32, f32)]) -> Vec<f32> {
    let place = |along: f32| course[course.partition_point(|at| at.2 < along).min(course.len() - 1)].0;
    let length = course[course.len() - 1].2;
    let inner = course.iter().filter(|(.., along)| (1.0..length - 1.0).contains(along));
    inner.map(|&(at, _, s)| (at - place(s - 1.0)).angle_to(place(s + 1.0) - at).abs().to_degrees()).collect()
}

/// No line is longer than those that grow, and hardly a corner is sharp: what turns by more than 75° in two widths is
/// at most a thirtieth of the great rivers of `flow`, and an eighth of those of `bend`, which wind more.
fn old_courses_are_neither_chords_nor_hooks() {
    for ((model, most), recipe) in one_in(5, pairs([("bend", 1.0 / 8.0), ("flow", 1.0 / 30.0)], HELD)) {
        grow_old(&format!("{recipe}&meander={model}"), |meander| {
            if ![100, 200, 400].contains(&meander.rounds()) {
                return;
            }
            let courses: Vec<_> = meander.past().great_rivers().iter().map(|&river| course(meander, river)).collect();
            let chord = courses.iter().map(|course| longest_chord(course)).fold(0.0, f32::max);
            let turns: Vec<f32> = courses.iter().flat_map(|course| turns(course)).collect();
            let hooks = turns.iter().filter(|turn| **turn > 75.0).count() as f32 / turns.len() as f32;
            let seen = format!("{recipe}, {model}, round {}: {chord} widths straight, {hooks}", meander.rounds());
            // Where the country is hardly bent, reaches are straight as they grow.
            assert!(chord < 16.0 && hooks < most, "{seen}");
        });
    }
}

tiers!(old_courses_are_neither_chords_nor_hooks);
