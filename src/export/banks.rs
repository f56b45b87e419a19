//! Rivers and lakes as shapes: two banks, from the source to the end.
//!
//! A river's own banks never run backward. Drawn wider than it is, as brooks are that would be hard to see, a bank may for a while,
//! like the offset of any curve. Both banks together still enclose, at least once, all that a disc as wide as the river sweeps. Filled
//! by the non-zero rule, they show no gap and nothing beyond.

use std::ops::Range;

use glam::Vec2;

use super::rings::{GridPoint, simple_ring};
use crate::network::{Banks, Network, Oxbow, Place, River};
use crate::recipe::CourseShape;

/// Distances of the banks from the middle, as shares, to be tried in turn while banks cross.
const SHARES: [f32; 4] = [1.0, 0.5, 0.25, 0.1];

/// The width of drawn rivers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Width {
    /// A share of their own width, plus a margin on each side that keeps brooks visible.
    Own { share: f32, more: f32 },
    /// One width for all rivers, with `half` on each side of the course, from its first vertex to its last.
    Even { half: f32 },
}

impl Banks {
    /// Makes a river's banks. They begin at its source, both at one point. A tributary's banks end in the middle of the
    /// river that it joins, those of other rivers past the shore. Empty if the river has no vertices.
    pub(super) fn of_river(network: &Network, river: &River, width: Width, courses: CourseShape) -> Self {
        let line = match width {
            Width::Own { share, more } => widened(network.middle(river), share, more),
            Width::Even { half } => network.course(river).map(|vertex| Place { at: vertex.at, half }).collect(),
        };
        Self::of_line(&line, courses)
    }

    /// Makes the banks along a line that is as wide at its beginning as its places say.
    pub(super) fn of_reach(mut line: Vec<Place>, courses: CourseShape) -> Self {
        line.dedup_by_key(|place| place.at);
        Self::along(&line, courses)
    }

    /// Makes a lake's banks, moved outward by a margin; they meet at both ends. Empty if silt has filled the whole
    /// lake.
    pub(super) fn of_lake(oxbow: &Oxbow, more: f32) -> Self {
        let mut line = widened(oxbow.middle(), 1.0, more);
        line.dedup_by_key(|place| place.at);
        if let [first, .., last] = &mut line[..] {
            (first.half, last.half) = (0.0, 0.0);
        }
        if line.len() > 2 { Self::along(&line, CourseShape::Smooth) } else { Self::default() }
    }

    /// Makes a valid polygon ring of the outline, on the grid that places are rounded to. It is counterclockwise on a
    /// map with north up, and its last point is its first. If it crosses itself, parts of a bank that run backward are
    /// left out; if that is not enough, the banks are moved nearer to each other; if they still cross, the first half,
    /// quarter and so on without a crossing stands for the whole. `None` only if the outline is narrower than the grid.
    pub(super) fn simple_ring(&self, rounded: impl Fn(Vec2) -> GridPoint) -> Option<Vec<GridPoint>> {
        let tries = self.stretches().flat_map(|stretch| {
            SHARES.into_iter().flat_map(move |share| [false, true].map(|forward| (stretch.clone(), share, forward)))
        });
        tries
            .map(|(stretch, share, forward)| self.ring_of(stretch, share, forward).into_iter().map(&rounded).collect())
            .find_map(simple_ring)
    }

    /// Returns the whole outline as a range of places, then shorter and shorter stretches of it. Each is half as long
    /// as those before, and the next starts at its middle.
    fn stretches(&self) -> impl Iterator<Item = Range<usize>> {
        let count = self.left.len();
        let lengths = std::iter::successors(Some(count), |&length| (length > 2).then_some(length.div_ceil(2)));
        lengths.flat_map(move |length| {
            let starts = (0..=count - length).step_by((length / 2).max(1));
            starts.map(move |start| start..start + length)
        })
    }

    /// Makes a ring down a stretch of the right bank and up the left one, at a share of their distance from the
    /// centerline. `forward` leaves out the parts of a bank that run backward.
    fn ring_of(&self, stretch: Range<usize>, share: f32, forward: bool) -> Vec<Vec2> {
        let (left, right) = (&self.left[stretch.clone()], &self.right[stretch]);
        let middle: Vec<Vec2> = left.iter().zip(right).map(|(left, right)| (*left + *right) * 0.5).collect();
        let nearer = |bank: &[Vec2]| {
            let mut kept: Vec<Vec2> = Vec::with_capacity(bank.len() * 2);
            for (i, (&at, &middle_at)) in bank.iter().zip(&middle).enumerate() {
                let at = middle_at.lerp(at, share);
                let is_end = i == 0 || i + 1 == bank.len();
                let runs_on = |last: Vec2| (at - last).dot(middle[i + 1] - middle[i - 1]) > 0.0;
                if !forward || is_end || kept.last().is_some_and(|&last| runs_on(last)) {
                    kept.push(at);
                }
            }
            kept
        };
        let mut ring = nearer(right);
        ring.extend(nearer(left).into_iter().rev());
        ring
    }
}

/// Returns a bank without the loops that it makes in bends tighter than the river is wide. Where such a loop begins and ends,
/// the bank has a corner instead, twice, so that a smooth line passes through it. A loop lies between both banks.
pub(super) fn without_loops(bank: &[Vec2]) -> Vec<Vec2> {
    /// The most sides of a loop, its first and last included.
    const MOST: usize = 16;
    let mut kept: Vec<Vec2> = Vec::with_capacity(bank.len());
    let mut next = 0;
    while let Some(&to) = bank.get(next) {
        let last = (next + MOST).min(bank.len()) - 1;
        let crossed = |&from: &Vec2| {
            (next + 1..last).rev().find_map(|j| Some((crossing([from, to], [bank[j], bank[j + 1]])?, j + 1)))
        };
        match kept.last().and_then(crossed) {
            Some((corner, after)) => {
                kept.extend([corner, corner]);
                next = after;
            }
            None => {
                kept.push(to);
                next += 1;
            }
        }
    }
    kept
}

/// Returns the place where two sides cross; `None` where they do not, or lie in one line.
fn crossing([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> Option<Vec2> {
    let (first, second) = (b - a, d - c);
    let across = first.perp_dot(second);
    let along = |way: Vec2| (c - a).perp_dot(way) / across;
    let share = along(second);
    let is_on = |share: f32| (0.0..=1.0).contains(&share);
    (is_on(share) && is_on(along(first))).then(|| a + first * share)
}

fn widened(line: Vec<Place>, share: f32, more: f32) -> Vec<Place> {
    line.into_iter().map(|place| Place { half: place.half * share + more, ..place }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::{NONE, Vertex};

    fn river(points: &[(f32, f32)], width: f32) -> (Network, River) {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: Vec2::new(x, y),
            left: width / 2.0,
            right: width / 2.0,
            ..Vertex::default()
        };
        let river = River {
            start: 0,
            end: points.len() as u32,
            junction: NONE,
            parent: NONE,
            order: 1,
            magnitude: 1,
            identity: 0,
        };
        (Network { vertices: points.iter().map(vertex).collect(), rivers: vec![river], oxbows: vec![] }, river)
    }

    #[test]
    fn left_bank_is_north_of_a_river_that_runs_east() {
        let (network, river) = river(&[(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)], 4.0);
        let banks = Banks::of_river(&network, &river, Width::Own { share: 1.0, more: 0.0 }, CourseShape::Smooth);
        assert_eq!(banks.left, [(0.0, 0.0), (10.0, -2.0), (20.0, -2.0), (20.4, -2.0)].map(Vec2::from));
        assert_eq!(banks.right, [(0.0, 0.0), (10.0, 2.0), (20.0, 2.0), (20.4, 2.0)].map(Vec2::from));
    }

    #[test]
    fn banks_keep_their_distance_round_a_corner() {
        let (network, river) = river(&[(0.0, 0.0), (20.0, 0.0), (20.0 + 10.0, 17.3), (40.0, 34.6)], 4.0);
        let banks = Banks::of_river(&network, &river, Width::Even { half: 2.0 }, CourseShape::Smooth);
        assert!((banks.left[1].y + 2.0).abs() < 1e-3 && (banks.right[1].y - 2.0).abs() < 1e-3);
    }

    #[test]
    fn doubling_back_makes_no_spike() {
        let (network, river) = river(&[(0.0, 0.0), (20.0, 0.0), (0.0, 0.0), (0.0, 0.0)], 4.0);
        let banks = Banks::of_river(&network, &river, Width::Even { half: 2.0 }, CourseShape::Smooth);
        assert!(banks.left.iter().chain(&banks.right).all(|at| at.is_finite() && at.abs().max_element() < 23.0));
    }

    #[test]
    fn sharp_corners_of_rivers_as_grown_keep_their_width_and_are_round_outside() {
        let (network, river) = river(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0)], 4.0);
        let banks = Banks::of_river(&network, &river, Width::Even { half: 2.0 }, CourseShape::Grown);
        let corner = Vec2::new(20.0, 0.0);
        let outside = 2.0 * std::f32::consts::FRAC_1_SQRT_2;
        let expected = [(20.0, -2.0), (20.0 + outside, -outside), (22.0, 0.0)].map(Vec2::from);
        assert!(banks.left[1..4].iter().zip(expected).all(|(at, expected)| at.distance(expected) < 1e-5), "{banks:?}");
        assert_eq!(banks.right[1..4], [Vec2::new(20.0, 2.0), corner, Vec2::new(18.0, 0.0)]);
        let mirrored = Banks::of_river(&mirror(&network), &river, Width::Even { half: 2.0 }, CourseShape::Grown);
        assert!(mirrored.right.iter().zip(&banks.left).all(|(a, b)| *a == Vec2::new(b.x, -b.y)), "{mirrored:?}");
    }

    fn mirror(network: &Network) -> Network {
        let mut mirrored = network.clone();
        mirrored.vertices.iter_mut().for_each(|vertex| vertex.at.y = -vertex.at.y);
        mirrored
    }
}
