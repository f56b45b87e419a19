//! Answers of a finished map about its rivers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::property::cases;
use crate::common::random_link;
use crate::common::tier::{first, tiers};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::analyse::query::{Inspector, Spot};
use riverseed::network::NONE;
use riverseed::recipe::link;
use riverseed::session::Session;

fn finished(text: &str) -> Session {
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

fn inspected(session: &Session) -> Inspector {
    Inspector::new(&session.map().unwrap()).unwrap()
}

/// Twice the area within rings; negative for holes.
fn area(rings: &[Vec<Vec2>]) -> f64 {
    let of_ring = |ring: &Vec<Vec2>| -> f64 {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| f64::from(a.perp_dot(*b))).sum()
    };
    rings.iter().map(of_ring).sum::<f64>().abs() * 0.5
}

/// Checks the answers for a pointer on each river in turn.
fn check_river(inspector: &Inspector, number: u32) -> Result<(), TestCaseError> {
    let network = inspector.network();
    let Some(source) = inspector.source(number) else { return Ok(()) };
    let facts = inspector.facts(&source);
    prop_assert_eq!((source.river, facts.order_here), (number, 1));
    let way = inspector.way_to_the_sea(&source);
    let last = &network.rivers[facts.into.last().copied().unwrap_or(number) as usize];
    prop_assert_eq!(last.parent, NONE);
    prop_assert_eq!(way.last().copied(), network.middle(last).last().copied());
    // It is as long as the rivers that it follows, and has no jump.
    let longest = network.rivers.iter().flat_map(|river| {
        let line = network.middle(river);
        (1..line.len()).map(move |i| line[i - 1].at.distance(line[i].at) + 2.0 * line[i].half).collect::<Vec<_>>()
    });
    let longest = longest.fold(0.0, f32::max) + network.vertices.iter().map(|v| v.width()).fold(0.0, f32::max);
    prop_assert!(way.windows(2).all(|pair| pair[0].at.distance(pair[1].at) <= longest));
    check_orders(inspector, number as usize)
}

/// Orders never fall from the source to the sea, and end with that of each river.
fn check_orders(inspector: &Inspector, mut river: usize) -> Result<(), TestCaseError> {
    let network = inspector.network();
    let mut order = 1;
    loop {
        let here = network.rivers[river];
        prop_assert!(here.order >= order);
        order = here.order;
        let Some(parent) = network.rivers.get(here.parent as usize) else { return Ok(()) };
        prop_assert!(parent.order >= order);
        river = network.rivers.iter().position(|other| other == parent).unwrap();
    }
}

/// The order at a river's last vertex is the river's.
fn check_last_order(inspector: &Inspector, number: u32) -> Result<(), TestCaseError> {
    let river = &inspector.network().rivers[number as usize];
    let line = inspector.network().middle(river);
    let spot = inspector.source(number).map(|source| Spot { segment: line.len() as u32 - 1, ..source });
    prop_assert!(spot.is_none_or(|spot| inspector.facts(&spot).order_here == river.order));
    Ok(())
}

proptest! {
    #![proptest_config(first(5, cases(24)))]

    fn every_way_ends_at_a_mouth_and_all_basins_together_are_at_most_the_land(text in random_link(900)) {
        let session = finished(&text);
        let inspector = inspected(&session);
        let network = inspector.network();
        for river in (0..network.rivers.len()).step_by(1 + network.rivers.len() / 40) {
            check_river(&inspector, river as u32)?;
        }
        let mouths = network.mouths();
        let facts = |&river: &u32| inspector.facts(&inspector.source(river).unwrap());
        let (mut share, mut land) = (0.0, 0.0);
        for facts in mouths.iter().map(facts) {
            prop_assert!(facts.into.is_empty());
            share += facts.share;
            land += facts.area;
        }
        prop_assert!(share <= 1.000_001, "{share}");
        prop_assert!(land <= 1_000_100.0, "{land}");
    }
}

tiers!(every_way_ends_at_a_mouth_and_all_basins_together_are_at_most_the_land);

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn a_river_is_found_where_it_runs_and_its_order_never_falls(text in random_link(900)) {
        let session = finished(&text);
        let inspector = inspected(&session);
        let network = inspector.network();
        for number in (0..network.rivers.len()).step_by(1 + network.rivers.len() / 40) {
            let (river, mut order) = (&network.rivers[number], 1);
            for place in network.middle(river) {
                let spot = inspector.nearest(place.at, 0.0).unwrap();
                prop_assert!(spot.off <= 0.0);
                // Another one may be wider there, or the river itself a little farther on.
                if spot.river == number as u32 && spot.place.at.distance(place.at) < 0.01 {
                    let facts = inspector.facts(&spot);
                    prop_assert!(facts.order_here >= order && facts.order_here <= facts.order);
                    order = facts.order_here;
                }
            }
            check_last_order(&inspector, number as u32)?;
        }
    }
}

#[test]
fn a_basin_holds_those_of_its_tributaries_and_is_as_large_as_what_it_drains() {
    let session =
        finished("country=usual&seed=kea&land=island&growth=drainage&attractors=4000&mouths=0&meander-rounds=4");
    let inspector = inspected(&session);
    let network = inspector.network();
    let greatest = network.mouths().into_iter().max_by_key(|&river| network.discharge(&network.rivers[river as usize]));
    let greatest = greatest.unwrap();
    let facts = inspector.facts(&inspector.source(greatest).unwrap());
    let own = area(&inspector.basin(greatest));
    assert!((own / facts.area - 1.0).abs() < 0.2, "{own} of {}", facts.area);
    let arms = (0..network.rivers.len() as u32).filter(|&river| network.rivers[river as usize].parent == greatest);
    let of_arms: f64 = arms.map(|river| area(&inspector.basin(river))).sum();
    assert!(of_arms > 0.3 * own && of_arms < own, "{of_arms} of {own}");
}

#[test]
fn rivers_that_are_not_finished_are_not_asked_about() {
    let mut session = Session::new(link::read("attractors=300").unwrap()).unwrap();
    assert_eq!(session.map(), None);
    session.advance(3).unwrap();
    assert_eq!(session.map(), None);
    session.finish().unwrap();
    assert_eq!(inspected(&session).source(u32::MAX - 1), None);
}

#[test]
fn a_branch_of_a_delta_is_found_as_its_river() {
    let session = finished("seed=Oakhollow&deltas=0.5");
    let (map, inspector) = (session.map().unwrap(), inspected(&session));
    let deltas = map.deltas();
    assert!(!deltas.is_empty());
    for branch in &deltas.distributaries {
        let middle = branch.line[branch.line.len() / 2].at;
        let spot = inspector.nearest(middle, 0.0).unwrap();
        assert_eq!(spot.river, branch.river);
        let tips = deltas.distributaries.iter().filter(|other| other.river == branch.river && other.reaches_sea);
        assert_eq!(inspector.facts(&spot).mouths, tips.count());
    }
}
