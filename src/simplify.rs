//! Simplifying lines by the method of Visvalingam and Whyatt (1993): the point that makes the least difference goes
//! first, and the difference is the area of the triangle with its neighbours.
//!
//! Areas compare across lines, and keep their ratios when a drawing is stretched: so many lines can share one budget of
//! points, whatever the shape of their domain.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::Vec2;

/// The area that each point of a line stands for: at least those of the points that go before it. Dropping all points
/// below a threshold simplifies the line. Infinite for the ends of an open line, and for the last three points of a
/// closed one: these never go. O(n log n).
pub(crate) fn significance(points: &[Vec2], is_closed: bool) -> Vec<f32> {
    let mut ring = Ring::new(points, is_closed);
    let mut queue: BinaryHeap<Reverse<(u32, usize)>> = (0..points.len()).filter_map(|i| ring.entry(i)).collect();
    let mut significance = vec![f32::INFINITY; points.len()];
    let (mut left, fewest) = (points.len(), if is_closed { 3 } else { 2 });
    let mut highest = 0;
    while left > fewest
        && let Some(Reverse((bits, i))) = queue.pop()
    {
        // An entry is out of date when its point has gone or its neighbours have changed since.
        if significance[i].is_finite() || ring.entry(i) != Some(Reverse((bits, i))) {
            continue;
        }
        highest = highest.max(bits);
        significance[i] = f32::from_bits(highest);
        left -= 1;
        let neighbours = ring.unlink(i);
        queue.extend(neighbours.into_iter().filter_map(|i| ring.entry(i)));
    }
    significance
}

/// The points that are left, each knowing its neighbours.
struct Ring<'a> {
    points: &'a [Vec2],
    is_closed: bool,
    before: Vec<usize>,
    after: Vec<usize>,
}

impl<'a> Ring<'a> {
    fn new(points: &'a [Vec2], is_closed: bool) -> Self {
        let count = points.len();
        let before = (0..count).map(|i| if i == 0 { count - 1 } else { i - 1 }).collect();
        let after = (0..count).map(|i| if i + 1 == count { 0 } else { i + 1 }).collect();
        Self { points, is_closed, before, after }
    }

    /// A point's place in the queue: its area as bits, which for numbers from 0 on have the numbers' order.
    fn entry(&self, i: usize) -> Option<Reverse<(u32, usize)>> {
        if !self.is_closed && (i == 0 || i + 1 == self.points.len()) {
            return None;
        }
        let (a, b) = (self.points[self.before[i]] - self.points[i], self.points[self.after[i]] - self.points[i]);
        Some(Reverse(((a.perp_dot(b) * 0.5).abs().to_bits(), i)))
    }

    fn unlink(&mut self, i: usize) -> [usize; 2] {
        let (before, after) = (self.before[i], self.after[i]);
        self.after[before] = after;
        self.before[after] = before;
        [before, after]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn kept(points: &[Vec2], is_closed: bool, least: f32) -> Vec<Vec2> {
        let areas = significance(points, is_closed);
        points.iter().zip(areas).filter(|(_, area)| *area >= least).map(|(point, _)| *point).collect()
    }

    #[test]
    fn corners_stay_and_what_lies_on_a_side_goes() {
        let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        let dense: Vec<Vec2> =
            (0..40).map(|i| corners[i / 10].lerp(corners[(i / 10 + 1) % 4], (i % 10) as f32 / 10.0)).collect();
        assert_eq!(kept(&dense, true, 1e-6), corners);
        assert_eq!(kept(&dense[..11], false, 1e-6), [Vec2::ZERO, Vec2::X]);
    }

    #[test]
    fn short_lines_are_left_alone() {
        for count in 0..3 {
            let points = vec![Vec2::ONE; count];
            assert!(significance(&points, true).iter().all(|area| area.is_infinite()));
            assert!(significance(&points, false).iter().all(|area| area.is_infinite()));
        }
    }

    proptest! {
        #[test]
        fn fewest_points_and_ends_never_go(xs in proptest::collection::vec((0f32..1.0, 0f32..1.0), 3..60)) {
            let points: Vec<Vec2> = xs.into_iter().map(Vec2::from).collect();
            let open = significance(&points, false);
            prop_assert!(open[0].is_infinite() && open[points.len() - 1].is_infinite());
            for (areas, fewest) in [(open, 2), (significance(&points, true), 3)] {
                prop_assert_eq!(areas.iter().filter(|area| area.is_infinite()).count(), fewest);
                prop_assert!(areas.iter().all(|&area| area >= 0.0));
            }
        }
    }
}
