//! Points, segments and triangles in the plane.
//!
//! Lengths are computed here and not by glam. Without its `std` feature, glam computes square roots bit by bit, where
//! every processor has an instruction for them.

use glam::{DVec2, Vec2};

/// A straight piece of a line.
pub(crate) type Segment = (Vec2, Vec2);

/// Returns twice the signed area of a triangle. Only the last operation rounds, so the sign can be trusted.
pub(crate) fn doubled_area(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    let (a, b, c): (DVec2, DVec2, DVec2) = (a.into(), b.into(), c.into());
    (b - a).perp_dot(c - a)
}

/// Returns `true` if two segments have a point in common; touching counts.
pub fn meet((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2)) -> bool {
    let boxes_apart = a.max(b).cmplt(c.min(d)).any() || c.max(d).cmplt(a.min(b)).any();
    if boxes_apart {
        return false;
    }
    let apart = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    !apart(doubled_area(a, b, c), doubled_area(a, b, d)) && !apart(doubled_area(c, d, a), doubled_area(c, d, b))
}

/// Returns the position along the first segment, from 0 to 1, at which it meets the line of the second; 0 if parallel.
pub(crate) fn meeting((a, b): Segment, (c, d): Segment) -> f32 {
    let (from, to) = (doubled_area(c, d, a), doubled_area(c, d, b));
    if from == to { 0.0 } else { (from / (from - to)).clamp(0.0, 1.0) as f32 }
}

/// Returns the length of a vector.
#[inline]
pub(crate) fn length(vector: Vec2) -> f32 {
    vector.length_squared().sqrt()
}

/// Returns the distance between two points.
#[inline]
pub(crate) fn distance(a: Vec2, b: Vec2) -> f32 {
    a.distance_squared(b).sqrt()
}

/// Returns the direction of a vector as a unit vector; zero if the vector is too short to have one.
#[inline]
pub(crate) fn direction(vector: Vec2) -> Vec2 {
    let length = length(vector);
    if length > 1e-12 { vector / length } else { Vec2::ZERO }
}

/// Returns the distance between two segments that do not cross.
#[inline]
pub fn gap((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2)) -> f32 {
    let to_second = fast_min(squared_distance(a, c, d), squared_distance(b, c, d));
    let to_first = fast_min(squared_distance(c, a, b), squared_distance(d, a, b));
    fast_min(to_second, to_first).sqrt()
}

/// Returns the squared distance between a point and a segment.
#[inline]
fn squared_distance(point: Vec2, a: Vec2, b: Vec2) -> f32 {
    let (along, out) = (b - a, point - a);
    let squared_length = along.dot(along);
    let t = out.dot(along);
    if t <= 0.0 {
        out.dot(out)
    } else if t >= squared_length {
        let out = point - b;
        out.dot(out)
    } else {
        let off = out - along * (t / squared_length);
        off.dot(off)
    }
}

/// Returns the distance of a point from a segment, and the share of the segment's length at which it is nearest to the point.
#[inline]
pub(crate) fn nearest(point: Vec2, (a, b): Segment) -> (f32, f32) {
    let (along, out) = (b - a, point - a);
    let squared_length = along.length_squared();
    let t = if squared_length > 0.0 { (out.dot(along) / squared_length).clamp(0.0, 1.0) } else { 0.0 };
    (length(out - along * t), t)
}

/// Returns the smaller of two numbers. `f32::min` compiles to several jumps in wasm.
#[inline]
pub(crate) fn fast_min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Returns the greater of two numbers. `f32::max` compiles to several jumps in wasm.
#[inline]
pub(crate) fn fast_max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Returns the distance along a line from its first point to each of its points.
#[inline(never)] // each copy weighs two hundred bytes
pub(crate) fn lengths(line: &[Vec2]) -> Vec<f32> {
    let mut along = vec![0.0; line.len()];
    for i in 1..line.len() {
        along[i] = along[i - 1] + distance(line[i - 1], line[i]);
    }
    along
}

/// Returns `true` if a point lies in a triangle or on its border.
pub(crate) fn is_in_triangle(point: Vec2, a: Vec2, b: Vec2, c: Vec2) -> bool {
    // Every point on the line of a triangle without area is on the same side of all its edges.
    if point.cmplt(a.min(b).min(c)).any() || point.cmpgt(a.max(b).max(c)).any() {
        return false;
    }
    let (ab, bc, ca) = (doubled_area(a, b, point), doubled_area(b, c, point), doubled_area(c, a, point));
    (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)
}

/// Returns the distance of a point from the line through `a` and `b`, or from `a` if both are the same point.
pub(crate) fn height(point: Vec2, a: Vec2, b: Vec2) -> f32 {
    squared_distance(point, a, b).sqrt()
}

/// Rises smoothly from 0 to 1 as x goes from 0 to 1, level at both ends.
pub(crate) fn smooth_step(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Vec2> {
        (0i32..8, 0i32..8).prop_map(|(x, y)| Vec2::new(x as f32, y as f32))
    }

    #[test]
    fn segments_that_cross_or_touch_meet() {
        let s = |ax: f32, ay: f32, bx: f32, by: f32| (Vec2::new(ax, ay), Vec2::new(bx, by));
        assert!(meet(s(0., 0., 4., 4.), s(0., 4., 4., 0.)));
        assert!(meet(s(0., 0., 4., 0.), s(2., 0., 2., 3.)));
        assert!(meet(s(0., 0., 4., 0.), s(3., 0., 9., 0.)));
        assert!(!meet(s(0., 0., 4., 0.), s(5., 0., 9., 0.)));
        assert!(!meet(s(0., 0., 4., 4.), s(3., 0., 4., 1.)));
        assert_eq!(meeting(s(0., 0., 4., 4.), s(0., 2., 2., 0.)), 0.25);
    }

    #[test]
    fn a_triangle_without_an_area_holds_what_lies_between_its_corners() {
        let [a, b, c] = [1.0, 4.0, 2.0].map(Vec2::splat);
        for (at, is_inside) in [(0.5, false), (1.0, true), (3.0, true), (4.5, false)] {
            assert_eq!(is_in_triangle(Vec2::splat(at), a, b, c), is_inside, "{at}");
        }
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn gap_is_that_of_the_nearest_of_many_points(a in point(), b in point(), c in point(), d in point()) {
            let along = |a: Vec2, b: Vec2| (0..=200).map(move |i| a.lerp(b, i as f32 / 200.0));
            let sampled = along(a, b).map(|p| along(c, d).map(|q| p.distance(q)).fold(f32::MAX, f32::min)).fold(f32::MAX, f32::min);
            if meet((a, b), (c, d)) {
                prop_assert!(sampled < 0.06);
            } else {
                prop_assert!((gap((a, b), (c, d)) - sampled).abs() < 0.06);
            }
        }

        #[test]
        fn points_of_a_triangle_are_in_it(a in point(), b in point(), c in point(), t in 0f32..1.0, u in 0f32..1.0) {
            prop_assume!(doubled_area(a, b, c) != 0.0);
            let inside = a.lerp(b, t * 0.98 + 0.01).lerp(c, u * 0.98 + 0.01);
            prop_assert!(is_in_triangle(inside, a, b, c));
            prop_assert!(!is_in_triangle(a * 2.0 - inside, a, b, c));
        }
    }
}
