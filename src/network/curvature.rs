//! Signed Menger curvature: one over the radius of the circle through three points.

use glam::Vec2;

use crate::base::geometry::{fast_max, fast_min, length};

/// Returns the curvature at the middle one of three points on a line: positive where the line turns to the right as
/// seen on a screen, whose y runs down; 0 where it is straight or where points coincide.
///
/// κ = 2 (b − a) × (c − b) / (|ab| |bc| |ca|). A line that turns straight back has no curvature by this formula; it counts
/// as the sharpest bend that its points can form, one over half their distance. Units: 1 / length.
pub fn curvature(a: Vec2, b: Vec2, c: Vec2) -> f32 {
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let lengths = length(ab) * length(bc) * length(ca);
    let shorter = fast_min(length(ab), length(bc));
    if shorter <= 0.0 {
        return 0.0;
    }
    let cross = ab.perp_dot(bc);
    let sharpest = 2.0 / shorter;
    if ab.dot(bc) < 0.0 && length(ca) <= shorter * 1e-3 {
        return if cross < 0.0 { -sharpest } else { sharpest };
    }
    // Not `clamp`, whose panic would print its limits: the tables for that are 7 kB of the page's download.
    fast_max(fast_min(2.0 * cross / lengths, sharpest), -sharpest)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{sine_generated, sinuosity};
    use super::*;
    use std::f32::consts::PI;

    #[test]
    fn circle_has_one_over_its_radius() {
        for radius in [0.5f32, 3.0, 200.0] {
            let at = |angle: f32| Vec2::new(libm::cosf(angle), libm::sinf(angle)) * radius;
            assert!((curvature(at(0.1), at(0.4), at(0.9)) * radius - 1.0).abs() < 1e-3);
            assert!((curvature(at(0.9), at(0.4), at(0.1)) * radius + 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn straight_lines_and_repeated_points_have_none() {
        let [a, b, c] = [Vec2::ZERO, Vec2::ONE, Vec2::splat(3.0)];
        for [a, b, c] in [[a, b, c], [a, a, c], [a, c, c], [b, b, b]] {
            assert_eq!(curvature(a, b, c), 0.0);
        }
    }

    #[test]
    fn turning_straight_back_is_the_sharpest_bend() {
        assert_eq!(curvature(Vec2::ZERO, Vec2::X * 2.0, Vec2::ZERO), 1.0);
    }

    #[test]
    fn sine_generated_curve_has_its_analytic_curvature_and_sinuosity() {
        const PIECES: u32 = 400;
        let length = 100.0f32;
        for degrees in [45.0f32, 70.0, 90.0, 110.0] {
            let omega = degrees.to_radians();
            let line = sine_generated(omega, length, 1, PIECES);
            for i in (1..PIECES as usize).step_by(7) {
                let analytic = omega * 2.0 * PI / length * libm::cosf(2.0 * PI * i as f32 / PIECES as f32);
                let measured = curvature(line[i - 1], line[i], line[i + 1]);
                assert!((measured - analytic).abs() < 2e-3, "{degrees}°, {i}: {measured} is not {analytic}");
            }
            let (measured, analytic) = (sinuosity(&line), 1.0 / libm::j0f(omega));
            assert!((measured / analytic - 1.0).abs() < 2e-3, "{degrees}°: {measured} is not {analytic}");
        }
    }
}
