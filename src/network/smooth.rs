//! Smoothing: simplified courses lose their corners.
//!
//! The smooth line is the chain of parabolas that the painter of a growing tree draws: from the middle of one side to the middle of
//! the next, bent round the corner between. Vertices approach their places on it under the guard, so that no line is pushed
//! across another; where there is no room, a corner stays.

use glam::Vec2;

use super::guard::Guard;
use super::parameters::Parameters;
use super::{NONE, Network};
use crate::land::Land;
use crate::plane::{distance, least, most};

/// How often vertices are moved toward the smooth line: most are there after two or three.
const ROUNDS: u32 = 6;

/// No move goes farther than this share of the distance to the nearest other line: with all of them below a half, and a
/// margin for rounding and for vertices taken out, lines stay apart.
pub(super) const SHARE_OF_CLEARANCE: f32 = 0.3;

/// Smooths a network that [`super::evenly::divide`] has made of a coarser one.
pub(super) fn smooth(network: &mut Network, coarse: &Network, origin: &[(u32, f32)], parameters: &Parameters) {
    let (land, spacing) = (parameters.land.as_deref(), parameters.spacing);
    let mut targets = targets(coarse, origin);
    let downstream = network.downstream();
    let mut guard = Guard::new(&parameters.domain, spacing);
    for (target, vertex) in targets.iter_mut().zip(&network.vertices) {
        let step = parameters.step(2.0 * parameters.half_width(vertex.discharge));
        if !has_room(land, vertex.at, distance(vertex.at, *target) + 2.0 * step) {
            *target = vertex.at;
        }
    }
    for _ in 0..ROUNDS {
        let is_off = |i: usize| targets[i] != network.vertices[i].at;
        let moves = |i: usize| is_off(i) || downstream[i] != NONE && is_off(downstream[i] as usize);
        let reach: Vec<f32> = (0..targets.len()).map(|i| if moves(i) { spacing } else { 0.0 }).collect();
        if reach.iter().all(|&reach| reach == 0.0) {
            break;
        }
        let caps = vec![spacing; reach.len()];
        let clearance = guard.survey(network, &downstream, &reach, caps, &mut |_| {});
        let limits = limits(&clearance, &downstream);
        for ((vertex, &target), limit) in network.vertices.iter_mut().zip(&targets).zip(limits) {
            vertex.at = toward(vertex.at, target, limit);
        }
    }
}

/// Lines come no nearer than this, in units: far above what is lost to rounding, far below what can be seen.
const LEAST_CLEARANCE: f32 = 0.02;

/// The clearance that moving may use up.
pub(super) fn room(clearance: f32) -> f32 {
    most(clearance - LEAST_CLEARANCE, 0.0)
}

/// How far each vertex may move: by the least clearance of the segments that end in it.
pub(super) fn limits(clearance: &[f32], downstream: &[u32]) -> Vec<f32> {
    let mut limits: Vec<f32> = clearance.iter().map(|&clearance| room(clearance) * SHARE_OF_CLEARANCE).collect();
    for (&clearance, &below) in clearance.iter().zip(downstream) {
        if let Some(limit) = limits.get_mut(below as usize) {
            *limit = least(*limit, room(clearance) * SHARE_OF_CLEARANCE);
        }
    }
    limits
}

/// Whether a river may move at a place: all around lies land.
pub(super) fn has_room(land: Option<&Land>, at: Vec2, distance: f32) -> bool {
    land.is_none_or(|land| land.is_all_land(at, distance))
}

fn toward(at: Vec2, target: Vec2, limit: f32) -> Vec2 {
    let (way, far) = (target - at, distance(at, target));
    if far <= limit { target } else { at + way * (limit / far) }
}

/// Where each vertex lies on the smooth line.
fn targets(coarse: &Network, origin: &[(u32, f32)]) -> Vec<Vec2> {
    let downstream = coarse.downstream();
    let mut before = vec![NONE; coarse.vertices.len()];
    for river in &coarse.rivers {
        (river.start + 1..river.end).for_each(|i| before[i as usize] = i - 1);
    }
    let at = |i: u32| coarse.vertices.get(i as usize).map(|vertex| vertex.at);
    // The parabola round a corner, from the middle of the side above it, at 0, to that of the side below, at 1.
    let round = |corner: u32, t: f32| {
        let own = at(corner)?;
        let (above, below) = (at(before[corner as usize])?, at(downstream[corner as usize])?);
        let rest = 1.0 - t;
        Some((above + own) * (0.5 * rest * rest) + own * (2.0 * t * rest) + (own + below) * (0.5 * t * t))
    };
    let straight = |upper: u32, share: f32| {
        let (a, b) = (at(upper)?, at(downstream[upper as usize])?);
        Some(a.lerp(b, share))
    };
    origin
        .iter()
        .map(|&(upper, share)| {
            let place = if share < 0.5 {
                round(upper, 0.5 + share)
            } else {
                // The junction is a corner of the river that is joined, not of the tributary.
                let lower = downstream[upper as usize];
                (before.get(lower as usize) == Some(&upper)).then(|| round(lower, share - 0.5)).flatten()
            };
            place.or_else(|| straight(upper, share)).or_else(|| at(upper)).unwrap_or_default()
        })
        .collect()
}
