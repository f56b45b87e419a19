//! The pull on a node: the sum of the unit vectors toward its attractors, in fixed point.
//!
//! Whole numbers can be added and subtracted in any order with the same result. Therefore an attractor that is stolen
//! or used up is subtracted exactly, no list of a node's attractors is needed, and the incremental index, its
//! brute-force twin and every processor agree to the bit.

use glam::Vec2;
use wide::{f32x4, i32x4};

/// A sum of unit vectors. One unit is 2¹⁸, which limits the error to a hundred-thousandth of a radian and allows 8,191
/// attractors to pull in one direction before the sum would wrap. At the longest reach a node has about 450.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pull {
    x: i32,
    y: i32,
}

const UNIT: f32 = 262_144.0;

/// The squared distance below which places are equal.
const TINY: f32 = 1e-20;

/// Adding this, 1.5 · 2²³, rounds a number below 2²² in either direction: its lowest bits are then the whole number. In
/// wasm, a conversion by `as` costs many times as much.
const ALL_FRACTION: f32 = 12_582_912.0;

/// The size of a sum below which it is only the rounding error of pulls that balance.
const NOISE: u32 = 64;

impl Pull {
    /// Returns the pull of an attractor on a node; zero if they coincide.
    #[inline]
    pub fn toward(node: Vec2, attractor: Vec2) -> Self {
        let gap = attractor - node;
        let squared = gap.x * gap.x + gap.y * gap.y;
        let scale = UNIT / (if squared > TINY { squared } else { TINY }).sqrt();
        let whole = |number: f32| (number + ALL_FRACTION).to_bits().wrapping_sub(ALL_FRACTION.to_bits()) as i32;
        Self { x: whole(gap.x * scale), y: whole(gap.y * scale) }
    }

    /// Adds an attractor's pull.
    #[inline]
    pub fn add(&mut self, other: Self) {
        self.x = self.x.wrapping_add(other.x);
        self.y = self.y.wrapping_add(other.y);
    }

    /// Subtracts an attractor's pull.
    #[inline]
    pub fn subtract(&mut self, other: Self) {
        self.x = self.x.wrapping_sub(other.x);
        self.y = self.y.wrapping_sub(other.y);
    }

    /// Returns the direction of the pull; `None` if attractors balance, or if there are none.
    #[inline]
    pub fn direction(self) -> Option<Vec2> {
        if self.x.unsigned_abs().max(self.y.unsigned_abs()) < NOISE {
            return None;
        }
        let sum = Vec2::new(self.x as f32, self.y as f32);
        Some(sum / (sum.x * sum.x + sum.y * sum.y).sqrt())
    }
}

/// The pulls of four attractors, computed side by side.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pulls {
    x: i32x4,
    y: i32x4,
}

impl Pulls {
    /// Computes the pulls of four attractors on a node, each as by [`Pull::toward`].
    #[inline]
    pub fn toward(node: Vec2, x: f32x4, y: f32x4) -> Self {
        let (x, y) = (x - f32x4::splat(node.x), y - f32x4::splat(node.y));
        let scale = f32x4::splat(UNIT) / (x * x + y * y).fast_max(f32x4::splat(TINY)).sqrt();
        let bits = |numbers: f32x4| i32x4::from_ne_bytes(numbers.to_ne_bytes());
        let whole = |numbers: f32x4| bits(numbers + f32x4::splat(ALL_FRACTION)) - bits(f32x4::splat(ALL_FRACTION));
        Self { x: whole(x * scale), y: whole(y * scale) }
    }

    /// Replaces some lanes by those of `others`. Returns these lanes, with zero in the remaining ones.
    #[inline]
    pub fn take_over(&mut self, lanes: u32, others: Self) -> Self {
        let each = i32x4::new([1, 2, 4, 8]);
        let taken = (i32x4::splat(lanes as i32) & each).simd_eq(each);
        let gained = Self { x: others.x & taken, y: others.y & taken };
        *self = Self { x: gained.x | (self.x & !taken), y: gained.y | (self.y & !taken) };
        gained
    }

    /// Adds pulls lane by lane.
    #[inline]
    pub fn add(&mut self, other: Self) {
        self.x += other.x;
        self.y += other.y;
    }

    /// Returns the pull of the attractor in a lane.
    #[inline]
    pub fn lane(&self, lane: usize) -> Pull {
        Pull { x: self.x.as_array()[lane], y: self.y.as_array()[lane] }
    }

    /// Returns the sum of all four pulls.
    #[inline]
    pub fn sum(self) -> Pull {
        let sum = |lanes: i32x4| lanes.to_array().into_iter().fold(0, i32::wrapping_add);
        Pull { x: sum(self.x), y: sum(self.y) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_at_once_pull_as_each_does() {
        let node = Vec2::new(0.3, 0.7);
        let x = [9.1, 0.3, -500.25, 0.300_01];
        let y = [-3.0, 0.7, 812.5, 0.7];
        let mut pulls = Pulls::toward(node, f32x4::new(x), f32x4::new(y));
        let mut sum = Pull::default();
        for lane in 0..4 {
            let alone = Pull::toward(node, Vec2::new(x[lane], y[lane]));
            assert_eq!(pulls.lane(lane), alone, "lane {lane}");
            sum.add(alone);
        }
        assert_eq!(pulls.sum(), sum);

        let (before, others) = (pulls, Pulls::toward(Vec2::ONE, f32x4::new(x), f32x4::new(y)));
        let gained = pulls.take_over(0b0101, others);
        for lane in 0..4 {
            let taken = lane % 2 == 0;
            assert_eq!(pulls.lane(lane), if taken { others.lane(lane) } else { before.lane(lane) });
            assert_eq!(gained.lane(lane), if taken { others.lane(lane) } else { Pull::default() });
        }
    }

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
