//! Meandering by flow (Howard and Knutson 1984): a bank moves by the curvature of the river there and, fading with
//! distance, of all of it upstream. So bends skew, and travel downstream.
//!
//! With R₀ = κ W, the rate is R₁(s) = Ω R₀(s) + Γ ∫ R₀(s − ξ) G(ξ) dξ / ∫ G dξ, Ω = −1, Γ = 2.5, G = exp(−ξ / memory), the memory
//! about 1.4 widths (as meanderpy has it), times sinuosity^(−2/3), since a longer river is less steep. Short bends fade, those of
//! some eleven widths grow fastest. The integral is a recursive filter, one pass down the river.

use glam::Vec2;

use super::super::Network;
use super::super::parameters::Parameters;
use super::bend::Course;

const OMEGA: f32 = -1.0;
const GAMMA: f32 = 2.5;

/// In widths.
const MEMORY: f32 = 1.4;

/// How far a bank moves in a round at full strength where the rate is one, in widths.
const PACE: f32 = 0.66;

/// The way that each vertex goes in this round.
pub(super) fn moves(network: &Network, pace: &[f32], parameters: &Parameters) -> Vec<Vec2> {
    let mut moves = vec![Vec2::ZERO; network.vertices.len()];
    let mut course = Course::default();
    for river in &network.rivers {
        if pace[river.own()].iter().all(|&pace| pace == 0.0) {
            continue;
        }
        course.read(network, river, parameters);
        let slackening = libm::powf(network.sinuosity(river), -2.0 / 3.0);
        let mut upstream = 0.0f32;
        for (i, (&pace, way)) in pace[river.own()].iter().zip(&mut moves[river.own()]).enumerate() {
            let width = course.width[i];
            // The mean of what lies upstream, weighted by G, after another step.
            upstream += (course.bend[i] - upstream) * (1.0 - libm::expf(-course.step[i] / (MEMORY * width)));
            if pace == 0.0 || i == 0 || i + 1 == course.at.len() {
                continue;
            }
            let rate = (OMEGA * course.bend[i] + GAMMA * upstream) * slackening;
            let outward = course.tangent(i).perp() * (-rate * PACE * parameters.strength * width);
            *way = (outward + course.ease(i)) * pace;
        }
    }
    moves
}
