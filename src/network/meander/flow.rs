//! Meandering by flow (Howard and Knutson 1984): a bank moves by the curvature of the river there and, fading with
//! distance, everywhere upstream. So bends skew, and travel downstream.
//!
//! With R₀ = κ W, the rate is R₁(s) = Ω R₀(s) + Γ ∫ R₀(s − ξ) G(ξ) dξ / ∫ G dξ, Ω = −1, Γ = 2.5, G = exp(−ξ / memory), the memory
//! about 1.4 widths (as meanderpy has it), times sinuosity^(−2/3), since a longer river is less steep. Short bends fade, those of
//! some eleven widths grow fastest. The integral is a recursive filter, one pass down the river.
//!
//! From upstream alone, bends travel faster than they grow. Between junctions, which hold, they would all crowd at the lower end as
//! hooks and leave straight lines behind. So part of the integral looks downstream, as bends of wide rivers do act upstream
//! (Zolezzi and Seminara 2001): a second pass, up the river. Waves of each length grow as fast as before and travel more slowly.

use glam::Vec2;

use super::super::Network;
use super::super::settings::NetworkSettings;
use super::bend::Course;

const OMEGA: f32 = -1.0;
const GAMMA: f32 = 2.5;

/// The distance over which curvature upstream fades, in widths.
const MEMORY: f32 = 1.4;

/// The share of the integral that is taken downstream: at a half, bends would not travel at all.
const DOWNSTREAM: f32 = 0.4;

/// The distance that a bank moves in a round at full strength where the rate is 1, in widths.
const PACE: f32 = 0.66;

/// Returns the offset by which each vertex is to move in a round, in units.
pub(super) fn moves(network: &Network, step_scale: &[f32], settings: &NetworkSettings) -> Vec<Vec2> {
    let mut moves = vec![Vec2::ZERO; network.vertices.len()];
    let mut course = Course::default();
    for river in &network.rivers {
        if step_scale[river.vertex_range()].iter().all(|&step_scale| step_scale == 0.0) {
            continue;
        }
        course.read(network, river, settings);
        let around = around(&course);
        let slackening = libm::powf(network.sinuosity(river), -2.0 / 3.0);
        for (i, (&step_scale, way)) in
            step_scale[river.vertex_range()].iter().zip(&mut moves[river.vertex_range()]).enumerate()
        {
            if step_scale == 0.0 || i == 0 || i + 1 == course.at.len() {
                continue;
            }
            let rate = (OMEGA * course.uncapped(i) + GAMMA * around[i]) * slackening;
            let outward = course.tangent(i).perp() * (-rate * PACE * settings.strength * course.width[i]);
            *way = (outward + course.ease(i)) * step_scale;
        }
    }
    moves
}

/// Returns the mean curvature up and down the river from each vertex, weighted by G. Beyond its lower end the river is
/// taken to bend as above it.
fn around(course: &Course) -> Vec<f32> {
    let mut around = vec![0.0; course.bend.len()];
    let mut mean = 0.0f32;
    let mut take = |i: usize, step: f32, share: f32| {
        mean += (course.bend[i] - mean) * (1.0 - libm::expf(-step / (MEMORY * course.width[i])));
        around[i] += mean * share;
    };
    let count = course.bend.len();
    (0..count).for_each(|i| take(i, course.step[i], 1.0 - DOWNSTREAM));
    (0..count).rev().for_each(|i| take(i, course.step.get(i + 1).copied().unwrap_or(0.0), DOWNSTREAM));
    around
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{river, settings, sine_generated};
    use super::super::bend;
    use super::*;

    /// Returns how far each vertex but the ends moves to the left by a model, in units.
    fn sideways(line: &[Vec2], moves: impl Fn(&Network, &[f32], &NetworkSettings) -> Vec<Vec2>) -> Vec<f32> {
        let settings = NetworkSettings { mix: 1.0, strength: 1.0, ..settings() };
        let ways = moves(&river(line, 5.0), &vec![1.0; line.len()], &settings);
        (1..line.len() - 1).map(|i| ways[i].perp_dot((line[i + 1] - line[i - 1]).normalize())).collect()
    }

    /// Returns the phase, in samples, of a wave whose length is given in samples.
    fn phase(values: &[f32], wave: usize) -> f32 {
        let turn = |i: usize| std::f32::consts::TAU * i as f32 / wave as f32;
        let sum = |part: fn(f32) -> f32| values.iter().enumerate().map(|(i, value)| value * part(turn(i))).sum::<f32>();
        libm::atan2f(sum(libm::sinf), sum(libm::cosf)) / std::f32::consts::TAU * wave as f32
    }

    #[test]
    fn banks_move_most_downstream_of_the_apex() {
        const WAVE: usize = 60;
        let line = sine_generated(0.6, 60.0, 6, WAVE as u32);
        let middle = 2 * WAVE..4 * WAVE;
        let (by_flow, by_bend) = (&sideways(&line, moves)[middle.clone()], &sideways(&line, bend::moves)[middle]);
        let lag = (phase(by_flow, WAVE) - phase(by_bend, WAVE)).rem_euclid(WAVE as f32);
        // A fraction of a quarter wave downstream: bends skew and travel, and they grow.
        assert!(lag > 2.0 && lag < 15.0, "{lag} of {WAVE}");
    }

    #[test]
    fn a_bend_moves_what_is_near_and_more_of_it_downstream() {
        // Straight, then half a wave, then straight, with middles 60 units from each other.
        let bend = sine_generated(0.6, 60.0, 1, 60);
        let (first, last) = (bend[15], bend[45]);
        let before = (1..=60).rev().map(|i| first - (bend[16] - bend[15]) * i as f32);
        let after = (1..=60).map(|i| last + (bend[45] - bend[44]) * i as f32);
        let line: Vec<Vec2> = before.chain(bend[15..=45].iter().copied()).chain(after).collect();
        let far = sideways(&line, moves);
        let sum = |range: std::ops::Range<usize>| far[range].iter().map(|far| far.abs()).sum::<f32>();
        let (above, below) = (sum(40..52), sum(98..110));
        assert!(above > 0.1 && below > 1.2 * above, "{above} above, {below} below");
        assert!(far[..20].iter().chain(&far[130..]).all(|far| far.abs() < 0.01));
    }
}
