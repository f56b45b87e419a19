//! Promises about patterns of drainage: each has the directions that define it, at any strike.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use glam::Vec2;
use riverseed::analyse::statistics::{Measures, junction_angles};
use riverseed::recipe::{Choice, Pattern};
use riverseed::{Map, Session};

/// Measures of the directions of rivers, each from 0 to 1 unless it is an angle.
#[derive(Clone, Copy, Debug, Default)]
struct Directions {
    /// |mean e^(2iθ)|: how far rivers share one direction, either way.
    one_axis: f64,
    /// |mean e^(4iθ)|: how far they share two directions at right angles.
    two_axes: f64,
    /// |mean e^(iθ)|: how far they flow one way.
    one_way: f64,
    /// The entropy of twelve classes of direction, over its greatest.
    entropy: f64,
    /// The mean cos² of the angle to the centre of the map.
    radial: f64,
    /// The share of length that leads away from the centre.
    outward: f64,
    /// The mean angle of junctions, in degrees.
    angle: f64,
    /// The median angle at which rivers of order 1 join, in degrees.
    angle_of_least: f64,
}

const CLASSES: usize = 12;

impl Directions {
    fn of(link: &str) -> Self {
        let link = format!("attractors=8000&aspect=1&meander=none&tributary-spacing=1.6&{link}");
        let map = Session::new(link.parse().unwrap()).unwrap().finish().unwrap();
        let spacing = map.grown().stream_spacing;
        let middle = middle_of(&map);
        let (mut sums, mut classes, mut all) = ([(0.0, 0.0); 3], [0.0; CLASSES], 0.0);
        let (mut radial, mut outward) = (0.0, 0.0);
        for (from, to) in steps(&map, spacing) {
            let (way, out) = (to - from, (0.5 * (from + to) - middle).normalize_or_zero());
            let length = f64::from(way.length());
            let angle = libm::atan2(way.y.into(), way.x.into());
            for (times, (real, imaginary)) in [1.0, 2.0, 4.0].into_iter().zip(&mut sums) {
                *real += length * libm::cos(times * angle);
                *imaginary += length * libm::sin(times * angle);
            }
            let class = angle.rem_euclid(std::f64::consts::PI) / std::f64::consts::PI * CLASSES as f64;
            classes[class as usize % CLASSES] += length;
            let cosine = f64::from(way.normalize().dot(out));
            radial += length * cosine * cosine;
            outward += length * f64::from(cosine > 0.0);
            all += length;
        }
        let [one_way, one_axis, two_axes] = sums.map(|(real, imaginary)| libm::hypot(real, imaginary) / all);
        let shares = classes.iter().map(|length| length / all).filter(|share| *share > 0.0);
        let entropy = shares.map(|share| -share * libm::log(share)).sum::<f64>() / libm::log(CLASSES as f64);
        let angle = junction_angles(map.network(), 3.0 * spacing).unwrap().mean;
        let angle_of_least = angle_of_least(&map, 3.0 * spacing);
        let (radial, outward) = (radial / all, outward / all);
        Self { one_axis, two_axes, one_way, entropy, radial, outward, angle, angle_of_least }
    }

    /// The median of each measure over five seeds.
    fn usual(link: &str) -> Self {
        let of_seeds = [1, 2, 3, 4, 5].map(|seed| Self::of(&format!("{link}&country=usual&seed=p{seed}")));
        let median = |measure: fn(&Self) -> f64| {
            let mut values = of_seeds.each_ref().map(measure);
            values.sort_by(f64::total_cmp);
            values[2]
        };
        Self {
            one_axis: median(|m| m.one_axis),
            two_axes: median(|m| m.two_axes),
            one_way: median(|m| m.one_way),
            entropy: median(|m| m.entropy),
            radial: median(|m| m.radial),
            outward: median(|m| m.outward),
            angle: median(|m| m.angle),
            angle_of_least: median(|m| m.angle_of_least),
        }
    }
}

fn middle_of(map: &Map) -> Vec2 {
    let vertices = &map.network().vertices;
    vertices.iter().map(|vertex| vertex.at).sum::<Vec2>() / vertices.len() as f32
}

/// The chords of all rivers between places a spacing apart.
fn steps(map: &Map, spacing: f32) -> Vec<(Vec2, Vec2)> {
    let mut steps = Vec::new();
    for river in &map.network().rivers {
        let mut from = map.network().vertices[river.start as usize].at;
        for vertex in &map.network().vertices[river.start as usize..river.end as usize] {
            if from.distance(vertex.at) >= spacing {
                steps.push((from, vertex.at));
                from = vertex.at;
            }
        }
    }
    steps
}

/// The median angle between rivers of order 1 and those that they join, in degrees.
fn angle_of_least(map: &Map, upstream: f32) -> f64 {
    let network = map.network();
    let mut angles = Vec::new();
    for river in network.rivers.iter().filter(|river| river.order == 1) {
        let Some(joined) = network.rivers.get(river.parent as usize) else { continue };
        let junction = network.vertices[river.junction as usize].at;
        let above = |start: u32, end: u32| {
            let (mut far, mut below) = (0.0, junction);
            let vertices = network.vertices[start as usize..end as usize].iter().rev();
            let way = |at: Vec2| {
                far += at.distance(std::mem::replace(&mut below, at));
                (far >= upstream).then_some(at - junction)
            };
            vertices.map(|vertex| vertex.at).find_map(way)
        };
        if let (Some(own), Some(stem)) = (above(river.start, river.end), above(joined.start, river.junction)) {
            angles.push(f64::from(own.angle_to(stem).abs().to_degrees()));
        }
    }
    angles.sort_by(f64::total_cmp);
    angles[angles.len() / 2]
}

const FROM_ALL_SIDES: &str = "land=rectangle&sides=nesw";

#[test]
fn each_pattern_has_the_directions_that_define_it() {
    let dendritic = Directions::usual("land=rectangle&pattern=dendritic");
    assert!(dendritic.one_axis <= 0.25 && dendritic.entropy >= 0.97, "{dendritic:?}");
    assert!((55.0..=75.0).contains(&dendritic.angle), "{dendritic:?}");
    let parallel = Directions::usual("land=rectangle&pattern=parallel&fall=0.3");
    assert!(parallel.one_axis >= 0.65 && parallel.angle <= 45.0, "{parallel:?}");
    let trellis = Directions::usual("land=rectangle&pattern=trellis");
    assert!(trellis.one_axis >= 0.5 && trellis.angle_of_least >= 70.0, "{trellis:?}");
    let rectangular = Directions::usual(&format!("{FROM_ALL_SIDES}&pattern=rectangular"));
    assert!(rectangular.two_axes >= 0.3 && rectangular.one_axis <= 0.15, "{rectangular:?}");
    let radial = Directions::usual(&format!("{FROM_ALL_SIDES}&pattern=radial"));
    assert!(radial.radial >= 0.75 && radial.outward >= 0.9, "{radial:?}");
    let centripetal = Directions::usual("land=basin&sea=0.15&pattern=centripetal");
    assert!(centripetal.radial >= 0.75 && centripetal.outward <= 0.1, "{centripetal:?}");
    let annular = Directions::usual(&format!("{FROM_ALL_SIDES}&pattern=annular"));
    assert!(annular.radial <= 0.4, "{annular:?}");
    let deranged = Directions::usual(&format!("{FROM_ALL_SIDES}&pattern=deranged"));
    assert!(deranged.one_way <= 0.1 && deranged.entropy >= 0.97, "{deranged:?}");
}

#[test]
fn a_grain_is_as_strong_at_any_strike() {
    let strengths = |pattern: &str, measure: fn(&Directions) -> f64| {
        let at = |strike: u32| Directions::usual(&format!("{FROM_ALL_SIDES}&pattern={pattern}&strike={strike}"));
        [15, 30, 60, 90].map(|strike| measure(&at(strike)))
    };
    for strengths in [strengths("trellis", |m| m.one_axis), strengths("rectangular", |m| m.two_axes)] {
        let (least, most) = strengths.iter().fold((1.0f64, 0.0f64), |(a, b), &x| (a.min(x), b.max(x)));
        assert!(most - least < 0.1, "{strengths:?}");
    }
}

#[test]
fn beds_strike_and_slopes_dip_as_asked_for() {
    // Measured along the strike and across it, in degrees clockwise from north.
    for (pattern, strike, is_along) in [("trellis", 40.0f32, true), ("parallel", 120.0, false)] {
        let link = format!("attractors=8000&aspect=1&meander=none&{FROM_ALL_SIDES}&pattern={pattern}&strike={strike}");
        let map = Session::new(link.parse().unwrap()).unwrap().finish().unwrap();
        let bed = Vec2::new(libm::sinf(strike.to_radians()), -libm::cosf(strike.to_radians()));
        let (mut along, mut all) = (0.0, 0.0);
        for (from, to) in steps(&map, map.grown().stream_spacing) {
            let cosine = (to - from).normalize().dot(bed);
            along += (to - from).length() * cosine * cosine;
            all += (to - from).length();
        }
        assert_eq!(along / all > 0.5, is_along, "{pattern}");
        assert!((along / all - 0.5).abs() > 0.2, "{pattern}: {}", along / all);
    }
}

#[test]
fn rivers_run_from_a_given_centre_and_to_it() {
    for (pattern, is_outward) in [("radial", true), ("centripetal", false)] {
        for (x, y) in [(25, 30), (70, 60)] {
            let link =
                format!("attractors=8000&meander=none&{FROM_ALL_SIDES}&pattern={pattern}&center-x={x}&center-y={y}");
            let map = Session::new(link.parse().unwrap()).unwrap().finish().unwrap();
            let center = Vec2::new(x as f32, y as f32) / 100.0 * map.domain().size;
            // Within reach of the centre, where no side of the map is near.
            let near: Vec<_> = steps(&map, map.grown().stream_spacing)
                .into_iter()
                .filter(|(from, _)| (40.0..220.0).contains(&from.distance(center)))
                .collect();
            let outward = near.iter().filter(|(from, to)| to.distance(center) > from.distance(center)).count();
            let share = outward as f32 / near.len() as f32;
            assert!(near.len() > 50 && if is_outward { share > 0.9 } else { share < 0.5 }, "{link}: {share}");
        }
    }
}

/// The patterns are told apart by the means of other maps, so these are new to the measure.
#[test]
fn nine_of_ten_maps_are_named_after_the_pattern_that_was_asked_for() {
    let lands = |pattern: Pattern| match pattern {
        Pattern::Centripetal => ["land=basin&sea=0.12", "land=basin&sea=0.2&roughness=0.5"],
        Pattern::Radial | Pattern::Annular => ["land=island&sea=0.4", FROM_ALL_SIDES],
        _ => ["land=rectangle", "land=continent&sea=0.25"],
    };
    let mut others = Vec::new();
    for &pattern in Pattern::ALL {
        let name = pattern.word().name;
        for seed in 0..5 {
            let link = format!(
                "{}&attractors={}&pattern={name}&meander-rounds=4&tributary-spacing={}&country=usual&seed=unseen{seed}",
                lands(pattern)[seed % 2],
                [8000, 12_000][seed / 2 % 2],
                [1.6, 0.0][seed / 3],
            );
            let map = Session::new(link.parse().unwrap()).unwrap().finish().unwrap();
            let found = Measures::of(&map).pattern().unwrap().name();
            if found != name {
                others.push(format!("{found}: {link}"));
            }
        }
    }
    assert!(others.len() <= 4, "{others:#?}");
}
