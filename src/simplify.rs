//! Simplifying lines by the method of Visvalingam and Whyatt (1993): the point that makes the least difference goes
//! first, and the difference is the area of the triangle with its neighbours.
//!
//! Areas compare across lines, and keep their ratios when a drawing is stretched: so any number of lines can share one budget of
//! points, whatever the shape of their domain.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::Vec2;

/// No neighbour.
pub(crate) const NONE: u32 = u32::MAX;

/// The area that each point of a line stands for: at least those of the points that go before it. Dropping all points
/// below a threshold simplifies the line. Infinite for the ends of an open line, and for the last three points of a
/// closed one: these never go. O(n log n).
pub(crate) fn significance(points: &[Vec2], is_closed: bool) -> Vec<f32> {
    let count = points.len() as u32;
    let end = |i: u32| if is_closed { i } else { NONE };
    let before = (0..count).map(|i| if i == 0 { end(count - 1) } else { i - 1 }).collect();
    let after = (0..count).map(|i| if i + 1 == count { end(0) } else { i + 1 }).collect();
    let mut significance = vec![f32::INFINITY; points.len()];
    let fewest = if is_closed { 3 } else { 2 };
    Lines::new(points, before, after)
        .simplify(|lines, _| lines.left > fewest, |gone, area| significance[gone as usize] = area);
    significance
}

/// The points that are left of some lines, each knowing its neighbours. A point without two of them stays.
pub(crate) struct Lines<'a> {
    points: &'a [Vec2],
    before: Vec<u32>,
    after: Vec<u32>,
    is_gone: Vec<bool>,
    left: usize,
}

impl<'a> Lines<'a> {
    pub fn new(points: &'a [Vec2], before: Vec<u32>, after: Vec<u32>) -> Self {
        Self { points, before, after, is_gone: vec![false; points.len()], left: points.len() }
    }

    /// Takes out one point after the other, the least area first, as long as `may_go` lets the next one go. A point that
    /// may not is tried again when one of its neighbours has gone. The areas passed to `tell` never decrease.
    pub fn simplify(mut self, mut may_go: impl FnMut(&Self, u32) -> bool, mut tell: impl FnMut(u32, f32)) {
        let mut queue: BinaryHeap<Reverse<(u32, u32)>> =
            (0..self.points.len() as u32).filter_map(|i| self.entry(i)).collect();
        let mut highest = 0;
        while let Some(Reverse((bits, i))) = queue.pop() {
            // An entry is out of date when its point has gone or its neighbours have changed since.
            if self.is_gone(i) || self.entry(i) != Some(Reverse((bits, i))) || !may_go(&self, i) {
                continue;
            }
            highest = highest.max(bits);
            tell(i, f32::from_bits(highest));
            let neighbours = self.unlink(i);
            queue.extend(neighbours.into_iter().filter_map(|i| self.entry(i)));
        }
    }

    pub fn is_gone(&self, i: u32) -> bool {
        self.is_gone[i as usize]
    }

    /// A point and its neighbours; `None` if it has not two.
    pub fn triangle(&self, i: u32) -> Option<[u32; 3]> {
        let triangle = [self.before[i as usize], i, self.after[i as usize]];
        (!triangle.contains(&NONE)).then_some(triangle)
    }

    /// A point's place in the queue: its area as bits, which for numbers from 0 on have the numbers' order.
    fn entry(&self, i: u32) -> Option<Reverse<(u32, u32)>> {
        let [a, b, c] = self.triangle(i)?.map(|i| self.points[i as usize]);
        Some(Reverse((((a - b).perp_dot(c - b) * 0.5).abs().to_bits(), i)))
    }

    fn unlink(&mut self, i: u32) -> [u32; 2] {
        let (before, after) = (self.before[i as usize], self.after[i as usize]);
        self.after[before as usize] = after;
        // What follows a tributary's last point is a point of the river that it joins, with neighbours of its own.
        if self.before[after as usize] == i {
            self.before[after as usize] = before;
        }
        self.is_gone[i as usize] = true;
        self.left -= 1;
        [before, after]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
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
        #![proptest_config(cases(256))]

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
