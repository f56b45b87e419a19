//! Layouts of islands with a figure of their own: a crescent, twins, a long island, one with arms.

use std::f32::consts::PI;

use glam::Vec2;

use super::curve::{Curve, swelling, turned};
use super::draws::Draws;
use super::island::{masses, widen};
use super::room::{placed, room, stretched};
use super::spine::Spine;
use crate::base::geometry::direction;

/// Lays out an island that bends around a bay: an arc, thickest somewhere about its middle, with tapering horns.
pub(super) fn crescent(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    let (way, gap) = (draws.direction(), draws.between(0.45, 0.85));
    let (middle, horn) = (draws.between(0.35, 0.65), draws.between(0.1, 0.24));
    let point = |draws: &mut Draws, t: f32| {
        let thick = swelling(t, middle, horn);
        // The outer coast is round, so the thicker the land, the farther in lies its middle.
        let off = (1.0 - 0.3 * thick) * draws.between(0.93, 1.07);
        (turned(way, (2.0 * t - 1.0) * (PI - gap)) * off, thick * draws.between(0.75, 1.25))
    };
    let mut spines = vec![Spine::new(steps(12).map(|t| point(draws, t)).collect())];
    stretched(&mut spines, size);
    widen(&mut spines, area);
    islets(draws, size, 5, &mut spines);
    placed(draws, spines, size)
}

/// Lays out two islands, each in its part of the map, of which the smaller is asked to have at least half the area of the other, and the
/// strait that keeps them apart wherever they come near one another.
pub(super) fn twins(draws: &mut Draws, size: Vec2, area: f32) -> (Vec<Spine>, Spine) {
    /// The distance from the domain at which the strait ends, as a share of the domain.
    const BEYOND: f32 = 0.2;
    let share = 0.5 + draws.either(0.0, 0.12);
    let is_wide = size.x * draws.between(0.8, 1.25) > size.y;
    let (axis, across) = if is_wide { (Vec2::X, Vec2::Y) } else { (Vec2::Y, Vec2::X) };
    let mut spines = Vec::new();
    for (share, corner) in [(share, 0.0), (1.0 - share, share)] {
        let part = size * (1.0 - axis * (1.0 - share));
        let (island, _) = masses(draws, part, area * share);
        spines.extend(placed(draws, island, part).into_iter().map(|spine| spine.moved(size * axis * corner)));
    }
    islets(draws, size, 5, &mut spines);
    let [from, to] = [-BEYOND, 1.0 + BEYOND].map(|end| size * (axis * share + across * end));
    let width = size.min_element() * draws.between(0.026, 0.038);
    let bends = [draws.either(0.01, 0.05), draws.either(0.01, 0.05)];
    (spines, Curve::bent(from, to, bends).spine(10, &|_| width))
}

/// Lays out one long island: a bent line, along which it swells and narrows.
pub(super) fn long(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    let along = if size.x > size.y { Vec2::X } else { Vec2::Y };
    let slant = draws.either(0.05, 0.36);
    let way = direction(turned(along, slant) * size);
    let half = way * (0.5 * room(size, way));
    let bend = draws.either(0.03, 0.16);
    let curve = Curve::bent(-half, half, [bend, bend * draws.between(-1.0, 1.2)]);
    let (middle, end) = (draws.between(0.25, 0.75), draws.between(0.25, 0.4));
    let thick = steps(10).map(|t| (curve.at(t), swelling(t, middle, end) * draws.between(0.6, 1.4)));
    let mut spines = vec![Spine::new(thick.collect())];
    widen(&mut spines, area);
    islets(draws, size, 5, &mut spines);
    placed(draws, spines, size)
}

/// Lays out an island whose arms reach out from its middle, unlike in length, and bend.
pub(super) fn arms(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    let count = if draws.is(0.35) { 4 } else { 3 };
    let first = draws.direction();
    let mut spines = Vec::new();
    for number in 0..count {
        let turn = (number as f32 + draws.between(-0.2, 0.2)) / count as f32;
        let way = turned(first, (turn - turn.round()) * (2.0 * PI));
        let (bend, thick) = (draws.either(0.05, 0.22), draws.between(0.8, 1.3));
        let arm = Curve::bent(Vec2::ZERO, way * draws.between(0.6, 1.25), [bend, bend * 0.7]);
        let thick = steps(7).map(|t| (arm.at(t), thick * (1.1 - 0.55 * t) * draws.between(0.75, 1.25)));
        spines.push(Spine::new(thick.collect()));
    }
    stretched(&mut spines, size);
    widen(&mut spines, area);
    islets(draws, size, 6, &mut spines);
    placed(draws, spines, size)
}

/// Iterates over shares from 0 to 1.
fn steps(count: u32) -> impl Iterator<Item = f32> {
    (0..=count).map(move |i| i as f32 / count as f32)
}

/// Adds some islets near the coast, none on land.
fn islets(draws: &mut Draws, size: Vec2, count: u32, spines: &mut Vec<Spine>) {
    /// The distances from the coast between which an islet lies, as shares of the domain's shorter side.
    const NEAREST: f32 = 0.045;
    const FARTHEST: f32 = 0.13;
    let masses = spines.len() as u32;
    let span = size.min_element();
    for _ in 0..count {
        let mass = &spines[draws.count(0, masses - 1) as usize];
        let points = mass.points();
        let (from, width) = points[draws.count(0, points.len() as u32 - 1) as usize];
        let at = from + draws.direction() * (width + span * draws.between(NEAREST, FARTHEST));
        let width = span * draws.between(0.014, 0.032);
        let highest = spines.iter().map(|spine| spine.height(at)).fold(f32::NEG_INFINITY, f32::max);
        if (-FARTHEST * span..-NEAREST * span).contains(&highest) {
            let half = draws.direction() * (width * draws.between(0.3, 1.2));
            spines.push(Curve::bent(at - half, at + half, [0.1, 0.1]).spine(3, &|t| width * swelling(t, 0.5, 0.5)));
        }
    }
}
