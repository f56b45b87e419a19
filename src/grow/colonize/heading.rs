//! The direction in which a node grows: the pull, altered by momentum and curl (sections 4.2 and 4.3 of the paper).

use glam::Vec2;

use crate::base::random::{ItemHash, Purpose};
use crate::base::trigonometry::sine_and_cosine;
use crate::grow::GrowthSettings;

/// Returns the position of a node's child.
///
/// * `pull`: the paper's v₂, a unit vector.
/// * `came_from`: the node's parent, if it is not a mouth.
/// * `clockwise`: the sense of the curl.
/// * `identity`: the item that decides the random angle of the curl.
pub fn heading(
    settings: &GrowthSettings,
    node: Vec2,
    came_from: Option<Vec2>,
    pull: Vec2,
    clockwise: bool,
    identity: [u32; 3],
) -> Vec2 {
    let mut direction = pull;
    if settings.momentum > 0.0
        && let Some(parent) = came_from
    {
        direction = with_momentum(direction, (node - parent) / settings.step, settings.momentum);
    }
    if settings.curl > 0.0 {
        direction = with_curl(settings, direction, clockwise, identity);
    }
    node + direction * settings.step
}

/// Returns `true` if the curl at a node is clockwise, given its number of steps from the mouth. The first stretch is
/// clockwise, then the sense alternates, so that every branch bends in regular stretches, whatever grew elsewhere.
pub fn is_clockwise(settings: &GrowthSettings, nodes_from_mouth: u32) -> bool {
    (nodes_from_mouth / settings.stretch).is_multiple_of(2)
}

/// Returns the identity of an attractor, and whether the curl toward it is clockwise. The sense is random and the same
/// within squares of the plane as wide as a stretch is long. Neither changes when something downstream does.
pub fn curl_toward(settings: &GrowthSettings, attractor: Vec2) -> ([u32; 2], bool) {
    const FINE: f32 = 0.25;
    let cell =
        |size: f32| ((attractor - settings.domain.size / 2.0) / size).floor().to_array().map(|i| i as i32 as u32);
    let [column, row] = cell(settings.stretch as f32 * settings.step);
    let clockwise = curl_hash(settings).bits([column, row, u32::MAX]).is_multiple_of(2);
    (cell(FINE * settings.spacing), clockwise)
}

/// Returns `true` if a child would lie within an eighth of a step of another one: such twins would count as a
/// confluence and raise the stream order.
#[inline]
pub fn is_duplicate(child: Vec2, sibling: Vec2, step: f32) -> bool {
    const NEAR: f32 = 1.0 / 8.0;
    let gap = child - sibling;
    gap.x * gap.x + gap.y * gap.y < (NEAR * step) * (NEAR * step)
}

/// Returns u = v₂ − k·v₁, normalised; v₂ itself where that vanishes.
fn with_momentum(v2: Vec2, v1: Vec2, k: f32) -> Vec2 {
    /// The length below which the direction of the difference is rounding error.
    const VANISHING: f32 = 1e-6;
    let u = v2 - v1 * k;
    let squared = u.x * u.x + u.y * u.y;
    if squared > VANISHING { u / squared.sqrt() } else { v2 }
}

/// Turns a direction by a random angle in [0, θ_c).
fn with_curl(settings: &GrowthSettings, direction: Vec2, clockwise: bool, identity: [u32; 3]) -> Vec2 {
    let chance = curl_hash(settings).unit(identity);
    let (sine, cosine) = sine_and_cosine(settings.curl * chance);
    direction.rotate(Vec2::new(cosine, if clockwise { sine } else { -sine }))
}

fn curl_hash(settings: &GrowthSettings) -> ItemHash {
    settings.seed.item_hash(Purpose::Curl)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn settings(link: &str) -> GrowthSettings {
        GrowthSettings::of(&link::read(link).unwrap())
    }

    /// Returns the angle of the child of a node at the origin that came straight east and is pulled by `angle`.
    fn turn(settings: &GrowthSettings, angle: f32, nodes_from_mouth: u32) -> f32 {
        let pull = Vec2::new(libm::cosf(angle), libm::sinf(angle));
        let parent = Vec2::NEG_X * settings.step;
        let clockwise = is_clockwise(settings, nodes_from_mouth);
        let child = heading(settings, Vec2::ZERO, Some(parent), pull, clockwise, [0, 0, 5]);
        libm::atan2f(child.y, child.x)
    }

    #[test]
    fn plain_growth_follows_the_pull() {
        assert!((turn(&settings("curl=0"), 0.5, 3) - 0.5).abs() < 1e-5);
    }

    #[test]
    fn momentum_turns_by_its_formula() {
        // tan φ = sin θ / (cos θ − k), from u = v₂ − k·v₁.
        for (k, degrees) in [(0.2f32, 20.0f32), (0.4, 30.0), (0.5, 10.0)] {
            let theta = degrees.to_radians();
            let expected = libm::atan2f(libm::sinf(theta), libm::cosf(theta) - k);
            let found = turn(&settings(&format!("curl=0&momentum={k}")), theta, 3);
            assert!((found - expected).abs() < 1e-5, "k {k}, {degrees}°: {found} is not {expected}");
        }
    }

    #[test]
    fn curl_turns_at_most_its_angle_and_changes_sides_each_stretch() {
        let settings = settings("curl=0.8&stretch=3");
        for nodes in 0..12 {
            let turned = turn(&settings, 0.0, nodes);
            let side = if (nodes / 3) % 2 == 0 { 1.0 } else { -1.0 };
            assert!((0.0..0.8).contains(&(turned * side)), "{nodes}: {turned}");
        }
    }
}
