//! Vertices at even spacing along a course, without moving its line.

use super::parameters::Parameters;
use super::{NONE, Network, Vertex};
use crate::plane::distance;

/// Puts vertices between those of a network, so that neighbours lie at most one and a half steps apart, and at
/// least two thirds of one where the course has room. Returns for each vertex where it lies between two old ones: the upper one's
/// place among the old vertices, and the share of the way to the next.
pub(super) fn divide(network: &Network, parameters: &Parameters) -> (Network, Vec<(u32, f32)>) {
    let downstream = network.downstream();
    let mut place = vec![NONE; network.vertices.len()];
    let mut divided = Network { rivers: network.rivers.clone(), ..Network::default() };
    let mut origin = Vec::new();
    for river in &mut divided.rivers {
        let own = river.own();
        river.start = divided.vertices.len() as u32;
        for i in own {
            place[i] = divided.vertices.len() as u32;
            divided.vertices.push(network.vertices[i]);
            origin.push((i as u32, 0.0));
            let Some(next) = network.vertices.get(downstream[i] as usize) else { continue };
            let step = parameters.step(2.0 * parameters.half_width(network.vertices[i].discharge));
            let pieces = pieces(distance(network.vertices[i].at, next.at), step);
            for piece in 1..pieces {
                let share = piece as f32 / pieces as f32;
                divided.vertices.push(between(&network.vertices[i], next, share));
                origin.push((i as u32, share));
            }
        }
        river.end = divided.vertices.len() as u32;
    }
    for river in &mut divided.rivers {
        river.joins = place.get(river.joins as usize).copied().unwrap_or(NONE);
    }
    (divided, origin)
}

/// Into how many pieces a length is divided.
pub(super) fn pieces(length: f32, spacing: f32) -> u32 {
    ((length / spacing + 0.5) as u32).max(1)
}

/// A vertex on the way from one to the next downstream. It drains what the upper one does.
pub(super) fn between(upper: &Vertex, lower: &Vertex, share: f32) -> Vertex {
    let mix = |a: f32, b: f32| a + (b - a) * share;
    Vertex {
        at: upper.at.lerp(lower.at, share),
        discharge: upper.discharge,
        left: mix(upper.left, lower.left),
        right: mix(upper.right, lower.right),
        sway: mix(upper.sway, lower.sway),
    }
}
