//! Networks that are broken by hand: each check says what is wrong with them, and where.

use glam::Vec2;

use super::*;
use crate::analyse::statistics::samples::{into, network, to_sea};
use crate::deltas::Distributary;
use crate::digest::digest_of_session;
use crate::domain::Domain;
use crate::network::{NONE, Network, Place, River};
use crate::recipe::link;
use crate::relief::Relief;
use crate::scale::MapScale;

/// Makes a sound network of three rivers.
///
/// ```text
///        40
///         1        Rivers 0 to 2, whose vertices are 0 to 3, 4 to 5 and 6 to 7. Sources carry 1, and what rivers carry
///         │        grows only where they meet. The sea is at x = 100.
/// 0───────J────K───────~ 100, 50
///              │
///              2
///             60
/// ```
fn valley() -> Network {
    let stem = to_sea(&[(0.0, 50.0), (40.0, 50.0), (60.0, 50.0), (100.0, 50.0)]);
    let arms = [[(40.0, 10.0), (40.0, 30.0)], [(60.0, 90.0), (60.0, 70.0)]];
    let mut network = network(&[stem, into(&arms[0], 0, 1), into(&arms[1], 0, 2)]);
    for (vertex, discharge) in network.vertices.iter_mut().zip([1, 2, 3, 3, 1, 1, 1, 1]) {
        vertex.discharge = discharge;
    }
    for (river, (order, magnitude)) in network.rivers.iter_mut().zip([(2, 3), (1, 1), (1, 1)]) {
        *river = River { order, magnitude, ..*river };
    }
    network
}

/// Lists what is wrong, as the river, the place and the fault.
fn wrong(finding: &Finding) -> Vec<(u32, Vec2, Fault)> {
    finding.breaches.iter().map(|breach| (breach.river, breach.at, breach.fault)).collect()
}

/// Makes the relief of a plane that falls by a hundredth to the east, with one place that is higher by some units.
fn plane(raised: Vec2, up: f32) -> Relief {
    let domain = Domain::with_aspect(1.0);
    let flat = Relief::of_heights(&domain, vec![0.0; 500 * 500]).unwrap();
    let height = |cell: usize| 10.0 - (cell % 500) as f32 * 0.01 + if cell == flat.cell(raised) { up } else { 0.0 };
    Relief::of_heights(&domain, (0..500 * 500).map(height).collect()).unwrap()
}

#[test]
fn a_river_that_climbs_is_found_where_it_does() {
    let mut stem = valley();
    stem.rivers.truncate(1);
    stem.vertices.truncate(4);
    let found = falls(&stem, &plane(Vec2::new(81.0, 51.0), 0.0));
    assert_eq!((found.looked_at, found.breaches), (50, vec![]));
    let found = falls(&stem, &plane(Vec2::new(81.0, 51.0), 3.0));
    let [(0, at, Fault::Rises(up))] = wrong(&found)[..] else { panic!("{found:?}") };
    assert_eq!(at, Vec2::new(80.0, 50.0));
    assert!((up - 2.99).abs() < 1e-4, "{up}");
}

#[test]
fn level_ground_does_not_fall() {
    let mut arm = valley();
    arm.rivers = vec![River { start: 0, end: 2, junction: NONE, parent: NONE, ..arm.rivers[1] }];
    arm.vertices.drain(..4);
    arm.vertices.truncate(2);
    // It runs across the slope for ten cells.
    let found = falls(&arm, &plane(Vec2::ZERO, 0.0));
    assert_eq!((found.looked_at, found.breaches.len()), (10, 10));
    assert!(found.breaches.iter().all(|breach| breach.fault == Fault::Rises(0.0)));
}

#[test]
fn a_segment_that_is_moved_across_another_is_found_where_they_meet() {
    let mut network = valley();
    let found = crossings(&network);
    assert_eq!((found.looked_at, found.breaches), (7, vec![]));
    // The source of river 2 is carried over the stem.
    network.vertices[6].at = Vec2::new(60.0, 10.0);
    network.vertices[7].at = Vec2::new(80.0, 70.0);
    let found = wrong(&crossings(&network));
    let [(0, at, Fault::Crosses { other: 2 })] = found[..] else { panic!("{found:?}") };
    assert!(at.distance(Vec2::new(73.333, 50.0)) < 1e-2, "{at}");
}

#[test]
fn a_river_that_runs_over_itself_crosses_too() {
    let loop_ = to_sea(&[(0.0, 0.0), (40.0, 0.0), (40.0, 20.0), (20.0, 20.0), (20.0, -20.0)]);
    let found = wrong(&crossings(&network(&[loop_])));
    assert_eq!(found, [(0, Vec2::new(20.0, 0.0), Fault::Crosses { other: 0 })]);
}

fn arrived(network: &Network) -> Vec<(u32, Vec2, Fault)> {
    wrong(&joins::arrivals(network, &[], |at| 100.0 - at.x))
}

#[test]
fn a_junction_on_another_river_is_found() {
    let mut network = valley();
    assert_eq!(arrived(&network), []);
    // River 2 ends at a vertex of river 1, but is said to join the stem, 20 units from there.
    network.rivers[2].junction = 5;
    assert_eq!(arrived(&network), [(2, Vec2::new(40.0, 30.0), Fault::Detached(20.0))]);
}

#[test]
fn a_tributary_without_its_junction_ends_inland() {
    let mut network = valley();
    (network.rivers[1].junction, network.rivers[1].parent) = (NONE, NONE);
    assert_eq!(arrived(&network), [(1, Vec2::new(40.0, 30.0), Fault::OffCoast(60.0))]);
    let mut network = valley();
    network.vertices[3].at.x = 104.0;
    assert_eq!(arrived(&network), [(0, Vec2::new(104.0, 50.0), Fault::OffCoast(-4.0))]);
}

/// Makes the branch of the stem that runs straight from one place to another.
fn branch(id: u32, parent: Option<u32>, from: (f32, f32), to: (f32, f32)) -> Distributary {
    let line = [from, to].map(|at| Place { at: at.into(), half: 1.0 }).into();
    Distributary { id, river: 0, parent, share: 0.5, line, reaches_sea: parent.is_some() }
}

#[test]
fn a_river_that_divides_arrives_by_all_its_branches() {
    let mut network = valley();
    // The stem ends inland, where it divides; one arm divides again.
    network.vertices[3].at.x = 80.0;
    let sound = [
        branch(0, None, (80.0, 50.0), (90.0, 45.0)),
        branch(1, None, (80.0, 50.0), (100.0, 60.0)),
        branch(2, Some(0), (90.0, 45.0), (100.0, 40.0)),
        branch(3, Some(0), (90.0, 45.0), (101.0, 48.0)),
    ];
    let arrived = |branches: &[Distributary]| wrong(&joins::arrivals(&network, branches, |at| 100.0 - at.x));
    assert_eq!(arrived(&sound), []);
    assert_eq!(arrived(&[]), [(0, Vec2::new(80.0, 50.0), Fault::OffCoast(20.0))]);
    let mut short = sound.clone();
    short[3].line[1].at.x = 95.0;
    assert_eq!(arrived(&short), [(0, Vec2::new(95.0, 48.0), Fault::OffCoast(5.0))]);
    let mut parted = sound.clone();
    parted[2].line[0].at.y = 43.0;
    assert_eq!(arrived(&parted), [(0, Vec2::new(90.0, 43.0), Fault::Parted(2.0))]);
    let mut aside = sound;
    aside[1].line[0].at.y = 54.0;
    assert_eq!(arrived(&aside), [(0, Vec2::new(80.0, 54.0), Fault::Parted(4.0))]);
}

#[test]
fn rivers_that_run_in_a_circle_are_lost() {
    let mut network = valley();
    (network.rivers[0].junction, network.rivers[0].parent) = (5, 1);
    let lost = |river: u32, x: f32, y: f32| (river, Vec2::new(x, y), Fault::Lost);
    assert_eq!(arrived(&network), [lost(0, 40.0, 30.0), lost(1, 40.0, 50.0), lost(2, 60.0, 50.0)]);
    // The other checks come to an end there as well.
    assert!(!sums(&network).breaches.is_empty());
    assert_eq!(crossings(&network).looked_at, 8);
}

#[test]
fn a_discharge_that_is_lowered_below_a_junction_is_found() {
    let mut network = valley();
    let found = sums(&network);
    assert_eq!((found.looked_at, found.breaches), (8, vec![]));
    network.vertices[2].discharge = 2;
    assert_eq!(wrong(&sums(&network)), [(0, Vec2::new(60.0, 50.0), Fault::Carries { discharge: 2, inflow: 3 })]);
}

#[test]
fn orders_and_magnitudes_that_are_no_sums_are_found() {
    let mut network = valley();
    (network.rivers[0].order, network.rivers[1].magnitude) = (3, 2);
    let expected = [
        (0, Vec2::new(100.0, 50.0), Fault::Order { has: 3, counted: 2 }),
        (1, Vec2::new(40.0, 30.0), Fault::Magnitude { has: 2, counted: 1 }),
    ];
    assert_eq!(wrong(&sums(&network)), expected);
}

#[test]
fn order_rises_once_where_three_of_one_order_meet() {
    let mut network = valley();
    network.rivers[2].junction = 1;
    network.vertices[1].discharge = 3;
    assert_eq!(wrong(&sums(&network)), []);
}

fn session(text: &str) -> Session {
    Session::new(link::read(text).unwrap()).unwrap()
}

const SMALL: &str = "country=usual&seed=kea&land=island&attractors=300&style=ink&labels=none";

fn proof(link: &str, again: &str) -> Proof {
    Proof::of(&mut session(link), digest_of_session(&mut session(again)).unwrap()).unwrap()
}

#[test]
fn another_map_has_other_bits() {
    let same = proof(SMALL, SMALL);
    assert!(same.broken() == 0 && same.bits.are_the_same() && same.bits.committed.is_none());
    let bits = proof(SMALL, &SMALL.replace("kea", "rimu")).bits;
    assert!(bits.digest != bits.again && bits.relief_is_the_same && !bits.are_the_same(), "{bits:?}");
    let alike = Bits { again: bits.digest.clone(), ..bits };
    assert!(alike.are_the_same());
    assert!(!Bits { committed: Some("0123456789abcdef"), ..alike.clone() }.are_the_same());
    assert!(!Bits { relief_is_the_same: false, ..alike }.are_the_same());
}

#[test]
fn a_committed_map_has_its_committed_digest() {
    let (digest, link) = crate::digest::COMMITTED.lines().next().unwrap().split_once(' ').unwrap();
    let bits = proof(link, link).bits;
    assert!(bits.are_the_same());
    assert_eq!((bits.committed, &*bits.digest), (Some(digest), digest));
}

#[test]
fn a_proof_counts_the_promises_that_are_broken() {
    let mut proof = proof(SMALL, SMALL);
    proof.findings[2].breaches.push(Breach { river: 0, at: Vec2::ZERO, fault: Fault::Lost });
    assert_eq!(proof.broken(), 1);
    proof.bits.relief_is_the_same = false;
    assert_eq!(proof.broken(), 2);
}

#[test]
fn faults_are_told_in_words_and_metres() {
    let scale = MapScale { metres_a_unit: 200.0, metres_up: 25.0 };
    let told = |fault: Fault| fault.told(&scale);
    assert_eq!(told(Fault::Rises(0.5)), "rises by 12.50 m");
    assert_eq!(told(Fault::Crosses { other: 3 }), "crosses river 3");
    assert_eq!(told(Fault::Detached(2.0)), "ends 400 m from the river that it joins");
    assert_eq!(told(Fault::Parted(5.0)), "has a branch that begins 1000 m away");
    assert_eq!(told(Fault::OffCoast(5.0)), "ends 1000 m inland");
    assert_eq!(told(Fault::OffCoast(-5.0)), "ends 1000 m out in the sea");
    assert_eq!(told(Fault::Carries { discharge: 2, inflow: 3 }), "carries 2, and 3 flow into it");
}
