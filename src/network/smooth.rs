//! Smoothing: simplified courses lose their corners.
//!
//! The smooth line is the chain of parabolas that the painter of a growing tree draws: from the middle of one side to the middle of
//! the next, bent round the corner between. Vertices approach their places on it under the guard, so that no line is pushed
//! across another; where there is no room, a corner stays.

use glam::Vec2;

use super::clearance::ClearanceGrid;
use super::heads::unhook;
use super::settings::NetworkSettings;
use super::{NONE, Network};
use crate::base::geometry::{distance, fast_max, fast_min};
use crate::land::Land;

/// The number of times that vertices are moved toward the smooth line: most reach it after two or three. Those of hooks have
/// farther to go, and are moved more often.
const ROUNDS: u32 = 6;
const ROUNDS_OF_HOOKS: u32 = 24;

/// The share of the distance to the nearest other line that a vertex may move. Below a half, with a margin for rounding
/// and for removed vertices, lines stay apart.
pub(super) const SHARE_OF_CLEARANCE: f32 = 0.3;

/// Smooths a network that [`super::evenly::divide`] has made from a coarser one.
pub(super) fn smooth(
    network: &mut Network,
    coarse: &Network,
    origin: &[(u32, f32)],
    land: Option<&Land>,
    settings: &NetworkSettings,
) {
    let spacing = settings.spacing;
    let mut targets = targets(coarse, origin);
    let is_hook = unhook(network, &mut targets, settings);
    let downstream = network.downstream();
    let mut guard = ClearanceGrid::new(&settings.domain, spacing);
    for (target, vertex) in targets.iter_mut().zip(&network.vertices) {
        let step = settings.step(2.0 * settings.half_width(vertex.discharge));
        if !has_room(land, vertex.at, distance(vertex.at, *target) + 2.0 * step) {
            *target = vertex.at;
        }
    }
    for round in 0..ROUNDS_OF_HOOKS {
        let is_off = |i: usize| targets[i] != network.vertices[i].at;
        let moves = |i: usize| is_off(i) || downstream[i] != NONE && is_off(downstream[i] as usize);
        let reach: Vec<f32> = (0..targets.len()).map(|i| if moves(i) { spacing } else { 0.0 }).collect();
        if reach.iter().all(|&reach| reach == 0.0) {
            break;
        }
        let caps = vec![spacing; reach.len()];
        let clearance = guard.measure(network, &downstream, &reach, caps, &mut |_| {});
        let limits = limits(&clearance, &downstream);
        for ((vertex, &target), limit) in network.vertices.iter_mut().zip(&targets).zip(limits) {
            vertex.at = toward(vertex.at, target, limit);
        }
        if round + 1 == ROUNDS {
            // Where there is no room, a corner stays.
            let rest = targets.iter_mut().zip(&network.vertices).zip(&is_hook).filter(|(_, is_hook)| !**is_hook);
            rest.for_each(|((target, vertex), _)| *target = vertex.at);
        }
    }
}

/// The least distance between lines, in units: far above rounding errors, far below what can be seen.
pub(super) const LEAST_CLEARANCE: f32 = 0.02;

/// Returns the part of a clearance that moves may use up, in units.
pub(super) fn room(clearance: f32) -> f32 {
    fast_max(clearance - LEAST_CLEARANCE, 0.0)
}

/// Returns the distance that each vertex may move, in units, by the least clearance of the segments that end in it.
pub(super) fn limits(clearance: &[f32], downstream: &[u32]) -> Vec<f32> {
    let mut limits: Vec<f32> = clearance.iter().map(|&clearance| room(clearance) * SHARE_OF_CLEARANCE).collect();
    for (&clearance, &below) in clearance.iter().zip(downstream) {
        if let Some(limit) = limits.get_mut(below as usize) {
            *limit = fast_min(*limit, room(clearance) * SHARE_OF_CLEARANCE);
        }
    }
    limits
}

/// Returns `true` if all within a distance of a point is land, so that a river may move there.
pub(super) fn has_room(land: Option<&Land>, at: Vec2, distance: f32) -> bool {
    land.is_none_or(|land| land.is_all_land(at, distance))
}

fn toward(at: Vec2, target: Vec2, limit: f32) -> Vec2 {
    let (way, far) = (target - at, distance(at, target));
    if far <= limit { target } else { at + way * (limit / far) }
}

/// Returns the place of each vertex on the smooth line.
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

#[cfg(test)]
mod tests {
    use super::super::curvature::curvature;
    use super::super::evenly::divide;
    use super::super::ranking::{rank, simplified};
    use super::super::samples::{places, river, settings, sine_generated, sinuosity};
    use super::*;
    use crate::base::geometry::meet;

    fn smoothed(coarse: &Network) -> Vec<Vec2> {
        let settings = settings();
        let (mut network, origin) = divide(coarse, &settings);
        smooth(&mut network, coarse, &origin, None, &settings);
        places(&network)
    }

    fn sharpest(line: &[Vec2]) -> f32 {
        line.windows(3).map(|at| curvature(at[0], at[1], at[2]).abs()).fold(0.0, f32::max)
    }

    const CORNER: [(f32, f32); 3] = [(100.0, 100.0), (106.0, 100.0), (106.0, 106.0)];

    #[test]
    fn corners_become_bends_and_ends_stay() {
        let corner = CORNER.map(Vec2::from);
        let network = river(&corner, 1.0);
        let line = smoothed(&network);
        assert_eq!((line[0], line[line.len() - 1]), (corner[0], corner[2]));
        let divided = places(&divide(&network, &settings()).0);
        assert!(sharpest(&line) < 0.85 * sharpest(&divided), "{} {}", sharpest(&divided), sharpest(&line));
        assert!(line.iter().all(|at| at.distance(corner[1]) > 0.9));
    }

    #[test]
    fn a_corner_is_not_pushed_across_what_lies_inside_it() {
        let brook = [(105.5, 100.5), (103.0, 103.0), (103.0, 108.0)].map(Vec2::from);
        let network = river(&CORNER.map(Vec2::from), 1.0).with_arm(&brook, 2, 10);
        let free = smoothed(&river(&CORNER.map(Vec2::from), 1.0));
        let meets = |line: &[Vec2]| line.windows(2).any(|pair| meet((pair[0], pair[1]), (brook[0], brook[1])));
        assert!(meets(&free), "it would");
        assert!(!meets(&smoothed(&network)[..free.len()]), "it is not");
    }

    #[test]
    fn sine_generated_curve_comes_back_after_simplification() {
        let omega = 1.3f32;
        let wave = 120.0;
        let fine = river(&sine_generated(omega, wave, 3, 240), 1.0);
        let line = smoothed(&simplified(&fine, &rank(&fine, None), 0.9));
        let analytic = 1.0 / libm::j0f(omega);
        assert!((sinuosity(&line) / analytic - 1.0).abs() < 0.02, "{} is not {analytic}", sinuosity(&line));
        let wide: Vec<f32> = line.windows(9).map(|at| curvature(at[0], at[4], at[8]).abs()).collect();
        let sharpest = wide.iter().copied().fold(0.0, f32::max);
        let analytic = omega * std::f32::consts::TAU / wave;
        assert!((sharpest / analytic - 1.0).abs() < 0.2, "{sharpest} is not {analytic}");
    }

    #[test]
    fn a_vertex_moves_as_far_as_both_its_segments_allow() {
        // Of the segments that end in a vertex, one goes out of it and is known by it, and one comes in.
        let limits = limits(&[2.02, 10.02, 0.01], &[1, 2, NONE]);
        assert!(
            limits.iter().zip([0.6, 0.6, 0.0]).all(|(limit, expected)| (limit - expected).abs() < 1e-6),
            "{limits:?}"
        );
    }
}
