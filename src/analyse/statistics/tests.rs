//! Tests that apply to all measures.

use glam::Vec2;

use super::*;
use crate::network::Network;
use crate::recipe::link;
use crate::session::Session;

fn finished(text: &str) -> Session {
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

const LINK: &str = "country=usual&seed=kauri&growth=colonize&valleys=0&land=island&sea=0.5&attractors=4000&trim=2&width=40&meander=none";

/// Turns a point by a right angle and doubles it; both are exact in floats.
fn turned(at: Vec2) -> Vec2 {
    at.perp() * 2.0
}

#[test]
fn lengths_double_with_the_map_and_all_else_stays_however_it_is_turned() {
    let session = finished(LINK);
    let network = session.network().unwrap();
    let mut other: Network = network.clone();
    for vertex in &mut other.vertices {
        vertex.at = turned(vertex.at);
        (vertex.left, vertex.right) = (vertex.left * 2.0, vertex.right * 2.0);
    }
    assert_eq!(sinuosity(&other), sinuosity(network));
    assert_eq!(total_length(&other), total_length(network) * 2.0);
    assert!(junction_angles(network, 40.0).is_some());
    assert_eq!(junction_angles(&other, 80.0), junction_angles(network, 40.0));
    assert_eq!(knots(&other, 50.0), knots(network, 25.0));
    let [own, others] =
        [(network, 25.0), (&other, 50.0)].map(|(network, spacing)| Directions::of(network, spacing).unwrap());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-5;
    assert!(near(own.grain, others.grain) && near(own.cross_grain, others.cross_grain) && near(own.flow, others.flow));
    assert!(near(own.radial, others.radial) && near(own.outward, others.outward) && own.outward.abs() > 0.01);
    // The counts are not all 0.
    assert!(umbrellas(network) > 0);
    assert_eq!(umbrellas(&other), umbrellas(network));
    let land = session.land().unwrap();
    let inland = |at: Vec2| land.coast_distance().height(at);
    assert!(along_coast(network, 25.0, inland) > 100.0);
    // Turned back, by three more right angles.
    let double = |at: Vec2| inland(at.perp().perp().perp() / 2.0) * 2.0;
    assert_eq!(along_coast(&other, 50.0, double), along_coast(network, 25.0, inland) * 2.0);
}

#[test]
fn trees_are_measured_alike_however_they_are_turned() {
    let pruned = finished(LINK).pruned();
    let (order, area) = (&pruned.hydrology.order, &pruned.hydrology.discharge);
    let mut other = pruned.tree.clone();
    other.at.iter_mut().for_each(|at| *at = turned(*at));
    let [streams, others] = [&pruned.tree, &other].map(|tree| Streams::of(tree, order));
    assert_eq!((&streams.counts, &streams.joins), (&others.counts, &others.joins));
    let (ratio, other_ratio) = (streams.length_ratio().unwrap(), others.length_ratio().unwrap());
    assert!((ratio - other_ratio).abs() < 1e-6);
    let [hack, others] = [&pruned.tree, &other].map(|tree| hack_exponent(tree, order, area).unwrap());
    assert!((hack - others).abs() < 1e-5, "{hack}, {others}");
}

#[test]
fn a_small_map_has_no_ratios_but_lengths() {
    let measures = Measures::of(
        &finished("country=usual&seed=kauri&growth=colonize&valleys=0&land=rectangle&attractors=100&trim=20")
            .map()
            .unwrap(),
    );
    assert_eq!((measures.bifurcation_ratio, measures.tokunaga_c, measures.hack_exponent), (None, None, None));
    assert!(measures.drainage_density > 0.0);
}

/// Measures a network without rivers: its land is shut off from the sea.
#[test]
fn a_map_without_rivers_has_lengths_of_nothing() {
    let measures = |network: &Network| (umbrellas(network), parallels(network, 10.0), total_length(network));
    assert_eq!(measures(&Network::default()), (0, 0.0, 0.0));
}

#[test]
fn colonization_and_drainage_are_measured_by_one_ruler_and_what_is_idle_is_none() {
    let of = |growth: &str| ruler(&finished(&format!("land=island&{growth}")).map().unwrap());
    let spacing = (0.28e6f32 / 400.0).sqrt();
    for growth in ["colonize&valleys=0", "drainage"] {
        assert!((of(&format!("growth={growth}&attractors=400")) - spacing).abs() < 1e-3, "{growth}");
    }
    assert_eq!(of("growth=brownian&attractors=400&sensitivity=40"), 40.0);
}

#[test]
fn density_is_length_by_area_of_land() {
    let session =
        finished("country=usual&seed=kauri&growth=colonize&valleys=0&land=rectangle&attractors=400&meander=none");
    let measures = Measures::of(&session.map().unwrap());
    let length = total_length(session.network().unwrap());
    assert!((measures.drainage_density - length / 1e6).abs() < 1e-9);
    assert!((measures.density_per_spacing - length / 1e6 * 50.0).abs() < 1e-6);
}

#[test]
fn a_rectangle_s_coasts_are_its_chosen_sides() {
    let map = finished("land=rectangle&growth=colonize&valleys=0&aspect=1&sides=nw&attractors=100").map().unwrap();
    let at = |x: f32, y: f32| inland(&map, map.recipe().sides(), Vec2::new(x, y));
    assert_eq!((at(300.0, 20.0), at(30.0, 500.0), at(990.0, 600.0)), (20.0, 30.0, 600.0));
}

#[test]
fn nature_s_ranges_hold_their_medians_and_names_are_no_two_alike() {
    for (i, measure) in TABLE.iter().enumerate() {
        let names = TABLE[..i].iter().map(|other| other.name);
        assert!(names.into_iter().all(|name| name != measure.name));
        if let Some(nature) = measure.nature {
            assert!(nature.median.is_none_or(|median| nature.least < median && median < nature.most));
        }
    }
}
