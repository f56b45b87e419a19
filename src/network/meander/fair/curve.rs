//! Bends: their sharpness at a vertex, and the place where it would be less.

use glam::Vec2;

use super::super::super::curvature::curvature;
use super::super::super::{Network, River};
use crate::base::geometry::{distance, fast_max, smooth_step};

/// The least radius of a wide river's bends, in widths: that of the circle through points a width apart.
pub(super) const LEAST_RADIUS: f32 = 1.5;

/// The radius from which down bends are eased, in widths, so that they rarely come to the least.
const EASED_RADIUS: f32 = 2.0;

/// The bend of a course at a vertex.
pub(super) struct Bend {
    /// The mean of the course within a width, weighted by nearness.
    pub mean: Vec2,
    /// The share of the way to the mean that the vertex moves, from 0 to 1.
    pub ease: f32,
}

impl Bend {
    /// Measures a bend. `None` at the river's ends.
    pub fn at(network: &Network, river: &River, i: u32, width: f32) -> Option<Self> {
        let course = |k: u32| {
            let k = if k < river.end { k } else { river.junction };
            network.vertices.get(k as usize).map(|vertex| vertex.at)
        };
        let at = course(i)?;
        let upper = Side::of(at, width, (river.start..i).rev().map_while(course))?;
        let lower = Side::of(at, width, (i + 1..=river.end).map_while(course))?;
        // A zigzag finer than a width shows only in the nearest vertices.
        let sharpest =
            fast_max(curvature(upper.end, at, lower.end).abs(), curvature(course(i - 1)?, at, course(i + 1)?).abs());
        let [from, to] = [EASED_RADIUS, LEAST_RADIUS].map(|radius| 1.0 / radius);
        let ease = smooth_step((sharpest * width - from) / (to - from));
        Some(Self { mean: (upper.mean + lower.mean) * 0.375 + at * 0.25, ease })
    }
}

/// The part of a course within a width of a vertex, on one side of it.
pub(super) struct Side {
    /// The point a width away along the course.
    pub end: Vec2,
    mean: Vec2,
}

impl Side {
    /// Measures a course from a vertex on, shorter than a width if it ends before. `None` if it ends at the vertex itself.
    pub fn of(at: Vec2, width: f32, others: impl Iterator<Item = Vec2>) -> Option<Self> {
        let (mut from, mut along, mut sum, mut weight) = (at, 0.0, Vec2::ZERO, 0.0);
        for next in others {
            let far = distance(from, next);
            if along + far >= width {
                let end = from.lerp(next, (width - along) / far);
                let mean = if weight > 0.0 { sum / weight } else { (at + end) * 0.5 };
                return Some(Self { end, mean });
            }
            along += far;
            let share = (width - along) * far;
            (sum, weight) = (sum + next * share, weight + share);
            from = next;
        }
        (weight > 0.0).then(|| Self { end: from, mean: sum / weight })
    }
}
