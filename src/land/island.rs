//! Layouts of an island and of a lake: a bent spine with branches.

use glam::Vec2;

use super::curve::{Curve, swelling, turned};
use super::draws::Draws;
use super::room::{placed, room, roomier};
use super::spine::Spine;
use crate::base::geometry::distance;
use crate::base::trigonometry::sine_and_cosine;

use std::f32::consts::PI;

/// Lays out the spines of an island and its islets: a bent main spine, branches of it, perhaps one beside it en
/// échelon, and islets in line with them. They cover about `area` square units within a rectangle of this size.
pub(super) fn island(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    let (mut spines, curves) = masses(draws, size, area);
    let widest = spines.first().map_or(0.0, Spine::widest);
    for (number, curve) in curves.iter().enumerate() {
        // The main spine may go on at both of its ends, a branch at its tip.
        let is_main = number == 0;
        if is_main && draws.is(0.55) {
            let width = widest * draws.between(0.25, 0.5);
            islets(draws, &curve.reversed(), width, &mut spines);
        }
        if draws.is(if is_main { 0.55 } else { 0.4 }) {
            let width = widest * if is_main { draws.between(0.25, 0.5) } else { draws.between(0.15, 0.3) };
            islets(draws, curve, width, &mut spines);
        }
    }
    placed(draws, spines, size)
}

/// Lays out the spines of a lake, which are like those of an island without islets.
pub(super) fn lake(draws: &mut Draws, size: Vec2, area: f32) -> Vec<Spine> {
    let (spines, _) = masses(draws, size, area);
    placed(draws, spines, size)
}

/// Lays out the spines of the main island, with their curves.
pub(super) fn masses(draws: &mut Draws, size: Vec2, area: f32) -> (Vec<Spine>, Vec<Curve>) {
    let way = roomier(draws, size);
    let room = room(size, way);
    let long = room * draws.between(0.5, 1.0);
    let bend = draws.either(0.02, 0.3);
    let bends = [bend, if draws.is(0.3) { -bend } else { bend * draws.between(0.3, 1.3) }];
    let curve = Curve::bent(way * (-0.5 * long), way * (0.5 * long), bends);
    let (mut spines, mut curves) = (vec![main_spine(draws, curve, long)], vec![curve]);
    for _ in 0..draws.count(1, if long < 0.75 * room { 4 } else { 3 }) {
        let (branch, curve) = branch(draws, curve, long);
        spines.push(branch);
        curves.push(curve);
    }
    if draws.is(0.45) {
        spines.push(beside(draws, curve, long));
    }
    widen(&mut spines, area * draws.between(0.86, 0.95));
    (spines, curves)
}

/// Makes the main spine, widest at one place, with waists and swellings.
fn main_spine(draws: &mut Draws, curve: Curve, long: f32) -> Spine {
    let (middle, end) = (draws.between(0.2, 0.8), draws.between(0.05, 0.45));
    let (waves, phase, depth) = (draws.between(1.0, 2.6), draws.between(-0.5, 0.5), draws.between(0.1, 0.5));
    curve.spine(10, &|t| {
        let (wave, _) = sine_and_cosine(wrapped(waves * t + phase));
        0.12 * long * swelling(t, middle, end) * (1.0 + depth * wave)
    })
}

/// Returns the angle of a number of turns, from −π to π.
fn wrapped(turns: f32) -> f32 {
    (turns - turns.round()) * (2.0 * PI)
}

/// Draws a tapering branch from the main spine outward, a peninsula, with its curve.
fn branch(draws: &mut Draws, curve: Curve, long: f32) -> (Spine, Curve) {
    let t = draws.between(0.05, 0.95);
    let way = curve.way(t);
    // Near an end a branch leans outward more often, as the arms of a fork do.
    let ahead = if draws.is(t) { way } else { -way };
    let out = turned(ahead, draws.either(0.5, 1.45));
    let reach = long * draws.between(0.2, 0.48);
    let bend = draws.either(0.0, 0.25);
    let width = long * draws.between(0.045, 0.085);
    let tip = draws.between(0.1, 0.6);
    let from = curve.at(t);
    let branch = Curve::bent(from, from + out * reach, [bend, bend]);
    (branch.spine(6, &|t| width * (1.0 + (tip - 1.0) * t)), branch)
}

/// Draws a lesser spine beside the main one, shifted along it: en échelon.
fn beside(draws: &mut Draws, curve: Curve, long: f32) -> Spine {
    let t = draws.between(0.1, 0.9);
    let way = curve.way(t);
    let middle = curve.at(t) + way.perp() * (long * draws.either(0.2, 0.34));
    let half = turned(way, draws.either(0.0, 0.5)) * (long * draws.between(0.12, 0.32));
    let bend = draws.either(0.0, 0.2);
    let width = long * draws.between(0.04, 0.09);
    let highest = draws.between(0.3, 0.7);
    Curve::bent(middle - half, middle + half, [bend, bend]).spine(6, &|t| width * swelling(t, highest, 0.2))
}

/// Adds islets that go on where a curve ends, from a half width on smaller and smaller.
fn islets(draws: &mut Draws, curve: &Curve, widest: f32, spines: &mut Vec<Spine>) {
    let mut way = curve.way(1.0);
    let (turn, mut width) = (draws.either(0.05, 0.35), widest);
    let mut at = curve.at(1.0) + way * (width * draws.between(1.2, 2.2));
    for _ in 0..draws.count(1, 5) {
        way = turned(way, turn);
        at += way * (width * draws.between(1.8, 3.2));
        let half = turned(way, draws.either(0.0, 0.8)) * (width * draws.between(0.3, 1.2));
        let off = way.perp() * (width * draws.either(0.0, 0.8));
        let islet = Curve::bent(at + off - half, at + off + half, [0.1, 0.1]);
        spines.push(islet.spine(3, &|t| width * swelling(t, 0.5, 0.5)));
        width *= draws.between(0.55, 0.9);
    }
}

/// Widens spines so that they cover an area, in square units.
pub(super) fn widen(spines: &mut [Spine], area: f32) {
    /// The share of the area of spines that lies on no other.
    const APART: f32 = 0.82;
    let piece = |pair: &[(Vec2, f32)]| distance(pair[0].0, pair[1].0) * (pair[0].1 + pair[1].1);
    let covered: f32 = spines.iter().map(|spine| spine.points().windows(2).map(piece).sum::<f32>()).sum();
    let widened = area / (APART * covered).max(1.0);
    for spine in spines {
        for (_, width) in spine.points_mut() {
            *width *= widened;
        }
    }
}
