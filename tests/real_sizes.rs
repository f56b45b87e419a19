//! Real sizes: what a map and its names tell of kilometres, square kilometres and metres.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use riverseed::annotate::names::{Names, PlaceKind};
use riverseed::paint::contours;
use riverseed::recipe::link;
use riverseed::{Map, Session};

use crate::common::tier::{one_in, tiers};

fn finished(link: &str) -> Map {
    Session::new(link::read(link).unwrap()).unwrap().finish().unwrap()
}

/// The square kilometres of a square unit of a map of this span, by its area alone.
fn of_square_unit(map: &Map, span: f64) -> f64 {
    let aspect = f64::from(map.domain().size.x / map.domain().size.y);
    span * span / aspect / 1e6
}

/// Names islands by their real size, and counts those that are called stones and the like.
fn check_islands(word: &str, land: &str, span: f64) -> usize {
    let map = finished(&format!("country=usual&seed={word}&land={land}&span={span}&attractors=1500&drowning=0.6"));
    let mut small = 0;
    for place in Names::of(&map).places.iter().filter(|place| place.kind == PlaceKind::Island && place.number != 0) {
        let area = f64::from(place.size * place.size) * of_square_unit(&map, span);
        let is = |words: &[&str]| words.iter().any(|word| place.name.ends_with(word));
        assert!(!is(&[" Stone", " Eyot"]) || area < 3.0001, "{word}, {span} km: {} has {area} km²", place.name);
        assert!(!is(&[" Holm", " Skerry"]) || area < 10.001, "{word}, {span} km: {} has {area} km²", place.name);
        assert!(
            is(&[" Holm", " Skerry", " Stone", " Eyot"]) || area > 9.999,
            "{word}, {span} km: {} has {area} km²",
            place.name
        );
        small += usize::from(area < 10.0);
    }
    small
}

fn islands_are_named_by_their_real_size() {
    let words = ["kauri", "tualmar", "Thornwick", "elbe", "mara", "O'Brien", "2026", "skye"];
    let spans = [15.0, 40.0, 115.0, 200.0, 500.0];
    let lands = ["island", "archipelago", "continent"];
    let cases = words.iter().flat_map(|word| spans.map(|span| (word, span)));
    let cases = cases.zip(lands.iter().cycle()).map(|((word, span), land)| (*word, *land, span));
    let small: usize = one_in(8, cases).map(|(word, land, span)| check_islands(word, land, span)).sum();
    assert!(small > 5, "{small} are small, or this proves nothing");
}

tiers!(islands_are_named_by_their_real_size);

/// The least and the greatest kilometres of a river by the word for its kind.
fn lengths_of(kind: &str) -> [f64; 2] {
    match kind {
        "River" | "Water" => [20.0, f64::INFINITY],
        "Creek" | "Beck" | "Stream" => [6.0, 20.0],
        "Fork" => [0.0, f64::INFINITY],
        _ => [0.0, 6.0],
    }
}

#[test]
fn rivers_are_named_by_their_length() {
    /// What trimming takes off the head of a river, in units, and how much longer or shorter courses are than trees.
    const HEAD: f64 = 40.0;
    const ROUND: f64 = 1.4;
    let (mut counts, mut wrong) = ([0; 2], Vec::new());
    for span in [15.0, 60.0, 200.0, 500.0, 5000.0] {
        let map = finished(&format!("country=usual&seed=tay&attractors=3000&meander=none&span={span}"));
        let kilometres = span / f64::from(map.domain().size.x);
        let network = map.network();
        for (river, name) in network.rivers.iter().zip(&Names::of(&map).rivers) {
            // The name goes by the untrimmed tree, so that no trimming changes it.
            let length = f64::from(network.length(river)) * kilometres;
            let [least, most] = lengths_of(&name.kind);
            if (length + HEAD * kilometres) * ROUND < least || length > most * ROUND {
                wrong.push(format!("{span}: {} is {length} km long", name.name));
            }
            counts[usize::from(least == 20.0)] += 1;
        }
    }
    let [others, rivers] = counts;
    assert!(rivers > 20 && others > 20, "{rivers} rivers, {others} others");
    // Where trimming takes the greater of two arms, the river goes on along the other.
    assert!(wrong.len() * 50 <= rivers + others, "{} of {}: {wrong:?}", wrong.len(), rivers + others);
}

#[test]
fn contours_lie_a_round_number_of_told_metres_apart() {
    for span in ["10", "200", "5000"] {
        let map = finished(&format!("country=usual&seed=kauri&attractors=2000&style=survey&span={span}"));
        let (relief, metres_up) = (map.make_relief().unwrap(), map.scale().metres_up);
        let told: Vec<f32> = contours(&relief, metres_up).iter().map(|line| line.height * metres_up).collect();
        let round = [5.0f32, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
        let apart = round.into_iter().find(|apart| (told[0] / apart - 1.0).abs() < 1e-4).unwrap();
        let is_even = told.iter().zip(1u16..).all(|(metres, i)| (metres / f32::from(i) / apart - 1.0).abs() < 1e-4);
        assert!(is_even && (8..=40).contains(&told.len()), "{span}: {told:?}");
    }
}

#[test]
fn nothing_drawn_depends_on_the_span_but_what_tells_a_size() {
    let of = |span: &str| {
        let link = format!("country=usual&seed=kauri&attractors=900&labels=none&cartouche=none&span={span}");
        let mut session = Session::new(link::read(&link).unwrap()).unwrap();
        session.finish().unwrap();
        let mut picture = riverseed::Picture::new(240, 150).unwrap();
        picture.paint(&session);
        picture.pixmap().data().to_vec()
    };
    assert!(of("200") == of("10") && of("200") == of("5000"));
}
