//! Parallels: rivers that run side by side for long.

use glam::Vec2;

use super::index::Index;
use crate::base::geometry::{direction, distance};
use crate::network::{Network, River};

/// Rivers are beside each other if they are nearer than this, in spacings.
const BESIDE: f32 = 2.0;

/// The cosine of 20°: what runs in about the same direction.
const SAME_DIRECTION: f32 = 0.939_692_6;

/// How far rivers may run beside each other, in spacings.
const LONG: f32 = 10.0;

/// How far apart the places of a course are, in spacings.
const STEP: f32 = 0.5;

/// A course's direction is that from this number of places before to as many after.
const AROUND: usize = 4;

/// So many places in a row may be farther apart, or in other directions, without an end.
const GAP: usize = 2;

/// A place of a course.
struct Place {
    at: Vec2,
    direction: Vec2,
    /// The number of the course.
    course: u32,
}

/// The length of pairs of rivers that run beside each other, nearer than two spacings and within 20° of the same direction, for more
/// than ten spacings, in units. Each pair has the mean of its two lengths.
pub fn parallels(network: &Network, spacing: f32) -> f64 {
    // What is shorter runs beside nothing for so long.
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

/// Where one river runs beside others.
#[derive(Default)]
struct Stretches {
    /// The other course, and the first and the last place so far.
    open: Vec<(u32, usize, usize)>,
    /// How many steps all have had that have ended and were long.
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

/// A course's places, half a spacing from one to the next along it.
fn places(network: &Network, river: &River, course: u32, spacing: f32) -> Vec<Place> {
    let line = evenly(network.course(river).map(|vertex| vertex.at), STEP * spacing);
    let heading = |i: usize| direction(line[(i + AROUND).min(line.len() - 1)] - line[i.saturating_sub(AROUND)]);
    line.iter().enumerate().map(|(i, &at)| Place { at, direction: heading(i), course }).collect()
}

/// Points of a line, from its start on, a step from one to the next along it.
fn evenly(mut line: impl Iterator<Item = Vec2>, step: f32) -> Vec<Vec2> {
    let Some(mut from) = line.next() else { return Vec::new() };
    let mut points = vec![from];
    // How far beyond `from` the next one lies.
    let mut next = step;
    for to in line {
        let length = distance(from, to);
        while next <= length {
            points.push(from.lerp(to, next / length));
            next += step;
        }
        next -= length;
        from = to;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::super::samples::{network, to_sea};
    use super::*;

    /// What two rivers have in common, measured in spacings of 3 units; and of 6, turned by a right angle and twice as large.
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
        // The longer one is beside the other a little before and after it, too.
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
        // They come nearer by 0.4 a spacing: 21.8° off.
        let (straight, oblique) = ([(0.0, 0.0), (40.0, 0.0)], [(0.0, 16.0), (40.0, 0.1)]);
        assert_eq!(common(&straight, &oblique), 0.0);
    }

    #[test]
    fn places_lie_evenly() {
        let line = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)].map(Vec2::from);
        let expected = [(0.0, 0.0), (2.0, 0.0), (3.0, 1.0)].map(Vec2::from);
        assert_eq!(evenly(line.into_iter(), 2.0), expected);
    }
}
