//! Promises of the network, tried on random networks of all growers: no two rivers cross, no tributary is ever
//! detached, every river reaches its mouth, and widths never shrink below a junction.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::property::{cases, large};
use crate::common::tier::{first, tiers};
use crate::common::{pairs, random_link};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::analyse::proof::{crossings, sums};
use riverseed::grow::{Growth, GrowthSettings};
use riverseed::land::Land;
use riverseed::network::{self, ClearanceGrid, Meander, NONE, Network, Shaping, hydrology, meet};
use riverseed::prune;
use riverseed::recipe::{NumberKey, Recipe, link};
use riverseed::tree::Hydrology;

fn shaped(recipe: &Recipe) -> Meander {
    let land = Land::of(recipe);
    let mut growth = Growth::new(GrowthSettings::new(recipe, land.clone())).unwrap();
    while growth.tick() {}
    let pruned = prune::trim(
        growth.tree(),
        &Hydrology::of(growth.tree()),
        prune::Trim::new(recipe.number(NumberKey::Trim), growth.node_length(), !growth.mouths_are_chosen()),
    );
    let settings = network::NetworkSettings::new(recipe, growth.stream_spacing(), growth.total_discharge());
    let mut shaping = Shaping::new(&pruned.tree, growth.may_cross(), land, settings).unwrap();
    while shaping.meander().is_none() {
        shaping.step();
    }
    let courses = shaping.courses().unwrap();
    check_rivers(&courses.network);
    check_no_crossing(&courses.network, "as grown");
    shaping.meander().unwrap().clone()
}

/// Checks that no two rivers cross, by a sweep that shares nothing with the guard.
fn check_no_crossing(network: &Network, when: &str) {
    assert_eq!(crossings(network).breaches, [], "{when}");
}

/// Every river has a course, joins its parent at one of its vertices, and comes to the sea.
fn check_rivers(network: &Network) {
    let mut end = 0;
    for (number, river) in network.rivers.iter().enumerate() {
        assert_eq!(river.start, end, "rivers stand one after the other");
        assert!(river.end > river.start, "river {number} has a vertex of its own");
        end = river.end;
        assert_eq!(river.junction == NONE, river.parent == NONE);
        if river.junction != NONE {
            let parent = network.rivers[river.parent as usize];
            assert!(parent.vertex_range().contains(&(river.junction as usize)), "river {number} ends on its parent");
        }
        let to_the_sea =
            std::iter::successors(Some(*river), |river| network.rivers.get(river.parent as usize).copied());
        assert!(
            to_the_sea.take(network.rivers.len() + 1).count() <= network.rivers.len(),
            "river {number} goes in circles"
        );
        assert!(river.order >= 1 && river.magnitude >= 1);
    }
    assert_eq!(end as usize, network.vertices.len());
}

fn check_vertices(network: &Network, size: Vec2) {
    for vertex in &network.vertices {
        assert!(
            vertex.at.is_finite() && vertex.at.cmpge(Vec2::ZERO).all() && vertex.at.cmple(size).all(),
            "{vertex:?}"
        );
        assert!(vertex.left.is_finite() && vertex.right.is_finite() && vertex.left >= 0.0 && vertex.right >= 0.0);
        assert!((0.0..=1.0).contains(&vertex.mobility), "{vertex:?}");
    }
    for river in &network.rivers {
        let discharges: Vec<u32> = network.course(river).map(|vertex| vertex.discharge).collect();
        assert!(discharges.is_sorted(), "{discharges:?}");
    }
}

/// Below a junction no river is narrower than its arms are there.
fn check_widths(network: &Network) {
    let junctions = network.junctions();
    for river in &network.rivers {
        let own = &network.vertices[river.vertex_range()];
        assert!(own[0].width() == 0.0, "a source has no width");
        let mut least = 0.0f32;
        for (vertex, is_junction) in own.iter().zip(&junctions[river.vertex_range()]) {
            assert!(
                vertex.width() >= least * 0.9999,
                "{} is less than {least}: {:?}",
                vertex.width(),
                own.iter()
                    .zip(&junctions[river.vertex_range()])
                    .map(|(v, j)| (v.width(), v.discharge, *j, v.mobility))
                    .collect::<Vec<_>>()
            );
            if *is_junction {
                least = vertex.width();
            }
        }
        if river.junction != NONE {
            let (last, junction) = (own.last().unwrap(), network.vertices[river.junction as usize]);
            assert!(junction.width() >= last.width() * 0.9999, "{river:?}: {:?} then {junction:?}", own.last());
        }
    }
}

proptest! {
    #![proptest_config(first(10, cases(40)))]

    fn guard_sees_what_all_pairs_say(link in random_link(300), rounds in 0u32..30) {
        let recipe = link::read(&link).unwrap();
        let mut meander = shaped(&recipe);
        (0..rounds).for_each(|_| {
            meander.round();
        });
        let (network, settings) = (meander.network(), meander.settings());
        // All pairs of more take a while.
        prop_assume!(network.vertices.len() < 4000);
        let downstream = network.downstream();
        let reach = meander.reach(&downstream, &meander.step_scale());
        let mut guard = ClearanceGrid::new(&settings.domain, settings.spacing);
        let mut near = Vec::new();
        let clearance = guard.measure(network, &downstream, &reach, meander.caps(), &mut |pair| near.push(pair));
        near.sort_by_key(|pair| (pair.first, pair.second));
        prop_assert_eq!((clearance, near), pairs::measure(network, &reach, meander.caps()));
    }
}

tiers!(guard_sees_what_all_pairs_say);

/// No segment crosses a ridge, or runs farther into the sea than its own line is wide: cells along the coast reach over
/// it.
fn check_land(network: &Network, land: &Land, when: &str) {
    const OVER_THE_COAST: f32 = 4.0;
    let ridges: Vec<&[Vec2]> = land.ridges().iter().flat_map(|ridge| ridge.windows(2)).collect();
    for (vertex, below) in network.vertices.iter().zip(network.downstream()).filter(|(_, below)| *below != NONE) {
        let (from, to) = (vertex.at, network.vertices[below as usize].at);
        let crosses = ridges.iter().any(|ridge| meet((from, to), (ridge[0], ridge[1])));
        assert!(!crosses, "{when}: {from} to {to} crosses a ridge");
        let inland = (0..=8).map(|part| land.coast_distance().height(from.lerp(to, part as f32 / 8.0)));
        let least = inland.fold(f32::INFINITY, f32::min);
        assert!(least > -OVER_THE_COAST, "{when}: {from} to {to} runs in the sea, {least} from the coast");
    }
}

proptest! {
    #![proptest_config(large(100))]

    #[test]
    fn rivers_keep_to_their_land(link in random_link(400), every in 3u32..40) {
        // Plain rectangles have neither.
        let link = link.replace("land=rectangle", "land=valley");
        let recipe = link::read(&link).unwrap();
        let Some(land) = Land::of(&recipe) else { return Ok(()) };
        let mut meander = shaped(&recipe);
        loop {
            let rounds = meander.rounds();
            if rounds.is_multiple_of(every) || meander.is_finished() {
                check_land(meander.network(), &land, &format!("{link}, round {rounds}"));
            }
            if !meander.round() && meander.is_finished() && meander.rounds() == rounds {
                break;
            }
        }
    }
}

/// Checks a network in its first rounds, in every `every`th round and in the last.
fn check_network(link: &str, every: u32) {
    let mut meander = shaped(&link::read(link).unwrap());
    let size = meander.settings().domain.size;
    loop {
        let network = meander.network();
        let rounds = meander.rounds();
        if rounds <= 2 || rounds.is_multiple_of(every) || meander.is_finished() {
            check_no_crossing(network, &format!("{link}, round {rounds}"));
            check_rivers(network);
            assert_eq!(sums(network).breaches, [], "{link}, round {rounds}");
            check_vertices(network, size);
            check_widths(network);
        }
        if !meander.round() && meander.is_finished() && meander.rounds() == rounds {
            break;
        }
    }
    check_elevations(meander.network(), meander.settings().total_discharge);
}

/// Every river falls, down to the sea.
fn check_elevations(network: &Network, total_discharge: u32) {
    let elevations = hydrology::elevations(network, total_discharge);
    for (i, &below) in network.downstream().iter().enumerate() {
        match elevations.get(below as usize) {
            Some(below) => assert!(elevations[i] > *below),
            None => assert_eq!(elevations[i], 0.0),
        }
    }
}

/// A wide river's neck lay across a bay, and the river broke through it.
#[test]
fn no_river_breaks_through_a_strait() {
    let link = "country=usual&seed=ofmcjd&growth=colonize&valleys=0&sensitivity=43&mouth-spacing=373&shores=s&land=basin&sea=0.115&roughness=0.757&aspect=2.850\
        &mouths=1&sides=w&attractors=178&scatter=random&reach=6.408&kill=1.237&step=0.932&momentum=0.000&curl=0.920&stretch=25\
        &trim=0&width=36.39&style=dark&simplify=41&bank-variation=0.210&meander=flow&meander-rounds=29&meander-strength=0.199\
        &meander-mix=0.891&meander-elsewhere=0.575&great-rivers=13&flat-share=0.091&neck=3.84&clearance=0.12&taper=2.67";
    let recipe = link::read(link).unwrap();
    let land = Land::of(&recipe).unwrap();
    let mut meander = shaped(&recipe);
    while meander.round() {
        check_land(meander.network(), &land, &format!("round {}", meander.rounds()));
    }
}

proptest! {
    #![proptest_config(first(8, large(1000)))]

    fn every_network_holds_its_promises(link in random_link(400), every in prop_oneof![1 => Just(1), 9 => 4u32..60]) {
        check_network(&link, every);
    }
}

tiers!(every_network_holds_its_promises);

/// Each of these once broke a promise; with the rounds to look at.
const FOUND_BY_CHANCE: [(&str, u32); 6] = [
    (
        "country=usual&seed=a&growth=brownian&sensitivity=40&mouth-spacing=0&land=rectangle&outline=&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=e&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=0&bank-variation=0.000&meander=bend&meander-rounds=1&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=1&flat-share=0.942&neck=3.12&clearance=0.00&taper=1.00",
        1,
    ),
    (
        "country=usual&seed=a&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&land=rectangle&outline=&sea=0.100&roughness=0.000&aspect=0.250&mouths=1&sides=n&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=16&bank-variation=0.000&meander=bend&meander-rounds=131&meander-strength=0.748&meander-mix=0.996&meander-elsewhere=0.000&great-rivers=1&flat-share=0.714&neck=1.00&clearance=1&taper=10.87",
        1,
    ),
    (
        "country=usual&seed=fgycr&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&land=island&outline=&sea=0.513&roughness=0.052&aspect=1.729&mouths=21&sides=n&attractors=200&scatter=grid&reach=11.217&kill=0.500&step=0.483&momentum=0.731&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=36&bank-variation=0.000&meander=flow&meander-rounds=39&meander-strength=0.736&meander-mix=0.000&meander-elsewhere=0.984&great-rivers=0&flat-share=0.000&neck=2.06&clearance=1&taper=8.48",
        1,
    ),
    (
        "country=usual&seed=ngmweo&growth=brownian&sensitivity=44&mouth-spacing=0&land=island&outline=&sea=0.226&roughness=0.878&aspect=2.909&mouths=1&sides=n&attractors=100&scatter=random&reach=2.100&kill=0.500&step=0.200&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=0&bank-variation=0.379&meander=bend&meander-rounds=3&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.861&great-rivers=0&flat-share=0.000&neck=3.26&clearance=0.00&taper=1.00",
        1,
    ),
    (
        "country=usual&seed=gslj&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=0&land=basin&outline=&sea=0.100&roughness=0.694&aspect=1.287&mouths=1&sides=n&attractors=340&scatter=random&reach=11.924&kill=0.522&step=1.179&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=0&bank-variation=0.000&meander=bend&meander-rounds=0&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=0&flat-share=0.000&neck=1.00&clearance=0.00&taper=1.00",
        4,
    ),
    (
        "country=usual&seed=xxvwf&growth=colonize&valleys=0&sensitivity=40&mouth-spacing=147&land=archipelago&outline=&sea=0.594&roughness=0.425&aspect=3.775&mouths=49&sides=n&attractors=243&scatter=random&reach=2.100&kill=0.500&step=0.852&momentum=0.000&curl=0.000&stretch=1&trim=0&width=1.00&style=ink&simplify=39&bank-variation=0.000&meander=bend&meander-rounds=0&meander-strength=0.000&meander-mix=0.000&meander-elsewhere=0.000&great-rivers=0&flat-share=0.000&neck=1.00&clearance=0.00&taper=1.00",
        1,
    ),
];

#[test]
fn networks_that_once_failed_hold_their_promises() {
    for (link, every) in FOUND_BY_CHANCE {
        check_network(link, every);
    }
}
