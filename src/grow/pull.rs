//! The pull on a node: the sum of the unit vectors toward its attractors, in fixed point.
//!
//! Whole numbers can be added and taken away in any order with the same result, so an attractor that is stolen or
//! used up is subtracted exactly, no list of a node's attractors is kept, and the incremental index, the brute-force
//! twin and every processor agree to the bit.

use glam::Vec2;

/// A sum of unit vectors. One unit is 2¹⁸: fine enough for an error of a hundred-thousandth of a radian, and
/// 8,191 attractors can pull one way before the sum would wrap. At the longest reach a node has about 450.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pull {
    x: i32,
    y: i32,
}

const UNIT: f32 = 262_144.0;

/// No two places but equal ones are so near.
const TINY: f32 = 1e-20;

/// Rounds to the nearest whole number, below 2²² either way: added to 1.5 · 2²³ it is what the lowest bits say. A
/// conversion by `as` costs wasm many times as much.
#[inline]
fn whole(number: f32) -> i32 {
    const ALL_FRACTION: f32 = 12_582_912.0;
    (number + ALL_FRACTION).to_bits().wrapping_sub(ALL_FRACTION.to_bits()) as i32
}

/// A sum smaller than this is what rounding leaves of pulls that balance.
const NOISE: u32 = 64;

impl Pull {
    /// The pull of one attractor on a node; none if they coincide.
    #[inline]
    pub fn toward(node: Vec2, attractor: Vec2) -> Self {
        let gap = attractor - node;
        let squared = gap.x * gap.x + gap.y * gap.y;
        let scale = UNIT / (if squared > TINY { squared } else { TINY }).sqrt();
        Self { x: whole(gap.x * scale), y: whole(gap.y * scale) }
    }

    /// Adds an attractor's pull.
    #[inline]
    pub fn add(&mut self, other: Self) {
        self.x = self.x.wrapping_add(other.x);
        self.y = self.y.wrapping_add(other.y);
    }

    /// Takes an attractor's pull away.
    #[inline]
    pub fn subtract(&mut self, other: Self) {
        self.x = self.x.wrapping_sub(other.x);
        self.y = self.y.wrapping_sub(other.y);
    }

    /// The direction of the pull; `None` where the attractors balance, or there are none.
    #[inline]
    pub fn direction(self) -> Option<Vec2> {
        if self.x.unsigned_abs().max(self.y.unsigned_abs()) < NOISE {
            return None;
        }
        let sum = Vec2::new(self.x as f32, self.y as f32);
        Some(sum / (sum.x * sum.x + sum.y * sum.y).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_added_is_taken_away_exactly() {
        let node = Vec2::new(0.3, 0.7);
        let attractors = [Vec2::new(9.1, -3.0), Vec2::new(0.30001, 0.7), Vec2::new(-500.0, 800.0)];
        let mut pull = Pull::default();
        attractors.iter().for_each(|&a| pull.add(Pull::toward(node, a)));
        attractors.iter().rev().for_each(|&a| pull.subtract(Pull::toward(node, a)));
        assert_eq!(pull, Pull::default());
    }

    #[test]
    fn balanced_attractors_give_no_direction() {
        let mut pull = Pull::toward(Vec2::ZERO, Vec2::X);
        pull.add(Pull::toward(Vec2::ZERO, Vec2::NEG_X));
        assert_eq!(pull.direction(), None);
        assert_eq!(Pull::toward(Vec2::ONE, Vec2::ONE).direction(), None);
    }
}
