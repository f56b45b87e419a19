//! Parallels: rivers that run side by side for a long way.

use glam::Vec2;

use super::index::Index;
use crate::base::geometry::{direction, distance};
use crate::network::{Network, River};

/// Rivers nearer than this, in spacings, are beside each other.
const BESIDE: f32 = 2.0;

/// The cosine of 20°, the greatest angle between courses in the same direction.
const SAME_DIRECTION: f32 = 0.939_692_6;

/// The greatest length that rivers may run beside each other without being counted, in spacings.
const LONG: f32 = 10.0;

/// Distance between the places of a course, in spacings.
const STEP: f32 = 0.5;

/// A course's direction at a place is measured from this number of places before it to the same number after.
const AROUND: usize = 4;

/// Number of places in a row that may be farther apart, or differ in direction, without ending a stretch.
const GAP: usize = 2;

/// A place of a course.
struct Place {
    at: Vec2,
    direction: Vec2,
    /// The number of the course.
    course: u32,
}

/// Measures the total length, in units, of pairs of rivers that run beside each other for more than ten spacings:
/// nearer than two spacings, and in directions within 20° of each other. Each pair counts with the mean of its two
/// lengths.
pub fn parallels(network: &Network, spacing: f32) -> f64 {
    // Shorter rivers cannot run beside anything that far.
    let long = network.rivers.iter().filter(|river| network.length(river) > LONG * spacing);
    let places: Vec<Place> =
        (0..).zip(long).flat_map(|(course, river)| places(network, river, course, spacing)).collect();
    let points: Vec<Vec2> = places.iter().map(|place| place.at).collect();
    let index = Index::new(&points, BESIDE * spacing);
    let mut stretches = Stretches::default();
    for (i, own) in places.iter().enumerate() {
        if i > 0 && places[i - 1].course != own.course {
            stretches.end_all();
        }
        stretches.end_those_before(i.saturating_sub(GAP + 1));
        for other in index.around(own.at, BESIDE * spacing).map(|j| &places[j]) {
            if own.is_beside(other, spacing) {
                stretches.go_on(other.course, i);
            }
        }
    }
    stretches.end_all();
    stretches.steps as f64 * f64::from(STEP * spacing) / 2.0
}

impl Place {
    fn is_beside(&self, other: &Self, spacing: f32) -> bool {
        self.course != other.course
            && distance(self.at, other.at) < BESIDE * spacing
            && self.direction.dot(other.direction) > SAME_DIRECTION
    }
}

/// The stretches along which one river runs beside others.
#[derive(Default)]
struct Stretches {
    /// For each open stretch, the other course and the first and last place so far.
    open: Vec<(u32, usize, usize)>,
    /// Total number of steps in all long stretches that have ended.
    steps: usize,
}

impl Stretches {
    fn go_on(&mut self, other: u32, place: usize) {
        match self.open.iter_mut().find(|stretch| stretch.0 == other) {
            Some(stretch) => stretch.2 = place,
            None => self.open.push((other, place, place)),
        }
    }

    fn end_those_before(&mut self, place: usize) {
        let steps = &mut self.steps;
        self.open.retain(|&(_, first, last)| {
            if last < place && (last - first) as f32 * STEP > LONG {
                *steps += last - first;
            }
            last >= place
        });
    }

    fn end_all(&mut self) {
        self.end_those_before(usize::MAX);
    }
}

/// Returns places along a course, half a spacing apart.
fn places(network: &Network, river: &River, course: u32, spacing: f32) -> Vec<Place> {
    let line = evenly(&network.places(river), STEP * spacing);
    let heading = |i: usize| direction(line[(i + AROUND).min(line.len() - 1)] - line[i.saturating_sub(AROUND)]);
    line.iter().enumerate().map(|(i, &at)| Place { at, direction: heading(i), course }).collect()
}

/// Returns points along a line, starting at its first point, `step` apart.
#[inline(never)] // each copy weighs two hundred bytes
pub(super) fn evenly(line: &[Vec2], step: f32) -> Vec<Vec2> {
    let mut points = Vec::new();
    points.extend(line.first());
    // Distance of the next point beyond the last vertex.
    let mut next = step;
    for pair in line.windows(2) {
        let length = distance(pair[0], pair[1]);
        while next <= length {
            points.push(pair[0].lerp(pair[1], next / length));
            next += step;
        }
        next -= length;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::super::samples::{network, to_sea};
    use super::*;

    /// Measures the common length of two rivers with spacings of 3 units. Also checks it for the rivers turned by a
    /// right angle and twice as large, with spacings of 6.
    fn common(a: &[(f32, f32)], b: &[(f32, f32)]) -> f64 {
        let scaled = |points: &[(f32, f32)]| points.iter().map(|(x, y)| (3.0 * x, 3.0 * y)).collect::<Vec<_>>();
        let turned = |points: &[(f32, f32)]| points.iter().map(|(x, y)| (-6.0 * y, 6.0 * x)).collect::<Vec<_>>();
        let length = parallels(&network(&[to_sea(&scaled(a)), to_sea(&scaled(b))]), 3.0);
        assert_eq!(parallels(&network(&[to_sea(&turned(a)), to_sea(&turned(b))]), 6.0), 2.0 * length);
        length / 3.0
    }

    #[test]
    fn rivers_side_by_side_for_long_count() {
        let straight = [(0.0, 0.0), (40.0, 0.0)];
        let beside = |y: f32, length: f32| [(10.0, y), (10.0 + length, y)];
        // The longer river is also beside the other one a little before and after it.
        let length = common(&straight, &beside(1.5, 20.0));
        assert!((length - 20.0).abs() < 1.5, "{length}");
        assert_eq!(common(&straight, &beside(2.5, 20.0)), 0.0, "farther than two spacings");
        assert_eq!(common(&straight, &beside(1.5, 8.0)), 0.0, "not for ten spacings");
        let backward = [(30.0, 1.5), (10.0, 1.5)];
        assert_eq!(common(&straight, &backward), 0.0, "the other way");
    }

    /// ```text
    /// ────────────────────────────────────────
    /// ───────────╮              ╭──────────────     Once for 8 spacings and once for 8: neither is long.
    ///            ╰──────────────╯
    /// ```
    #[test]
    fn stretches_count_one_by_one() {
        let away = |length: f32| {
            [(0.0, 1.5), (length, 1.5), (length, 6.0), (30.0 - length, 6.0), (30.0 - length, 1.5), (30.0, 1.5)]
        };
        let straight = [(0.0, 0.0), (30.0, 0.0)];
        assert_eq!(common(&straight, &away(8.0)), 0.0);
        let length = common(&straight, &away(13.0));
        assert!((length - 24.0).abs() < 2.5, "{length}");
    }

    #[test]
    fn rivers_that_cross_each_other_s_way_are_no_parallels() {
        // They approach by 0.4 per spacing, an angle of 21.8°.
        let (straight, oblique) = ([(0.0, 0.0), (40.0, 0.0)], [(0.0, 16.0), (40.0, 0.1)]);
        assert_eq!(common(&straight, &oblique), 0.0);
    }

    #[test]
    fn places_lie_evenly() {
        let line = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)].map(Vec2::from);
        let expected = [(0.0, 0.0), (2.0, 0.0), (3.0, 1.0)].map(Vec2::from);
        assert_eq!(evenly(&line, 2.0), expected);
    }
}
