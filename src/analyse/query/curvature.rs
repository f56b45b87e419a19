//! The curvature of great rivers, as lines across them.

use glam::Vec2;

use super::Inspector;
use crate::base::geometry::{distance, fast_max, fast_min, length};

/// Distance between lines along a river, in its widths.
const APART: f32 = 0.6;
/// Length of the line at a bend with a radius of one width, in widths. Lines are longer at sharper bends.
const LONG: f32 = 4.0;
/// The greatest length of a line, in widths.
const LONGEST: f32 = 4.0;
/// Number of the highest orders that count as great.
const ORDERS: u8 = 2;

impl Inspector {
    /// Draws short lines on the great rivers, from the middle towards the outside of the bend: the sharper, the longer.
    /// Lines that would not reach the bank are left out.
    pub fn curvature(&self) -> Vec<Vec<Vec2>> {
        let highest = self.orders.iter().fold(0, |highest, &order| highest.max(order));
        let mut lines = Vec::new();
        for (number, river) in (0..).zip(&self.network.rivers) {
            if river.order + ORDERS <= highest {
                continue;
            }
            let mut since = 0.0;
            for around in self.lines.line(number).windows(3) {
                let [a, b, c] = [0, 1, 2].map(|i| around[i].at);
                let width = 2.0 * around[1].half;
                let line = outward(a, b, c) * (LONG * width * width);
                let long = length(line);
                since += distance(a, b);
                if since >= APART * width && long > around[1].half {
                    since = 0.0;
                    lines.push(vec![b, b + line * (fast_min(long, LONGEST * width) / long)]);
                }
            }
        }
        lines
    }
}

/// Returns the direction away from the centre of the circle through three points, as long as the circle's curvature; zero
/// if they lie on a line.
fn outward(a: Vec2, b: Vec2, c: Vec2) -> Vec2 {
    let (before, after, across) = (b - a, c - b, c - a);
    let lengths = length(before) * length(after) * across.length_squared();
    // Menger's curvature, towards the side of the middle point.
    across.perp() * (-2.0 * before.perp_dot(after) / fast_max(lengths, f32::MIN_POSITIVE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    #[test]
    fn great_rivers_have_lines_that_begin_on_them_and_are_no_longer_than_allowed() {
        let mut session = Session::new(link::read("seed=kea&attractors=3000&meander-rounds=20").unwrap()).unwrap();
        session.finish().unwrap();
        let inspector = Inspector::new(&session.map().unwrap()).unwrap();
        let lines = inspector.curvature();
        assert!(lines.len() > 100);
        for line in lines {
            let spot = inspector.nearest(line[0], 0.01).unwrap();
            assert!(line[0].distance(line[1]) <= spot.place.half * 2.0 * LONGEST * 1.001);
        }
    }

    #[test]
    fn a_line_points_away_from_the_middle_of_its_circle_and_is_as_long_as_one_over_its_radius() {
        for turn in [1.0f32, -1.0] {
            let at = |angle: f32| Vec2::new(30.0, 40.0) + Vec2::from_angle(angle * turn) * 20.0;
            let found = outward(at(0.4), at(0.5), at(0.6));
            assert!(found.distance(Vec2::from_angle(0.5 * turn) / 20.0) < 1e-4, "{found}");
        }
        assert_eq!(outward(Vec2::ZERO, Vec2::X, Vec2::X * 2.0), Vec2::ZERO);
        assert_eq!(outward(Vec2::ZERO, Vec2::ZERO, Vec2::ZERO), Vec2::ZERO);
    }
}
