//! The former courses of great rivers, recorded at even intervals while they meander: a map of past courses shows them,
//! and one can look through them from the first round to the last.
//!
//! Which rounds are recorded depends on their number alone: twelve, or all of fewer, as evenly as whole numbers allow;
//! of 40 those before the rounds 1, 5, 8, 11, 15 and so on. A loop that is cut off belongs to the last record before.
//! So the past does not depend on how often a session stops to be looked at, and takes 0.9 MB at most: long courses are
//! thinned out evenly, and loops beyond a number are left out.

use super::super::{Network, Place};

/// The greatest number of rounds that are recorded.
pub(super) const ROUNDS: u32 = 12;

/// The greatest number of places in the courses of a round, besides their ends, and in its loops.
const MOST_OF_COURSES: usize = 4000;
const MOST_OF_LOOPS: usize = 1500;

/// The former courses of a network's great rivers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PastCourses {
    great: Vec<u32>,
    rounds: Vec<PastRound>,
}

/// Courses before one round of meandering.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PastRound {
    /// The number of rounds that had been made.
    pub round: u32,
    /// The course of each great river.
    pub courses: Vec<PastCourse>,
    /// The loops that were cut off from then on, before the next round that is recorded.
    pub loops: Vec<PastCourse>,
}

/// A course, or a part of one, from where it begins to where it ends, with its width.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PastCourse {
    /// The index of the river.
    pub river: u32,
    /// The centerline, with half the width at each place.
    pub line: Vec<Place>,
}

impl PastCourses {
    /// The greatest memory that past courses take, in bytes.
    pub(in crate::network) const BYTES: usize = 900_000;

    /// Makes an empty past of the rivers that count as great.
    pub(super) fn of(great: Vec<u32>) -> Self {
        Self { great, rounds: Vec::new() }
    }

    /// Makes a past of recorded rounds and of the rivers that count as great.
    #[cfg(test)]
    pub(crate) fn of_rounds(great: Vec<u32>, rounds: Vec<PastRound>) -> Self {
        Self { great, rounds }
    }

    /// Returns the indices of the great rivers, which meander fully where they are flat, in descending order of flat
    /// length.
    pub fn great_rivers(&self) -> &[u32] {
        &self.great
    }

    /// Returns the recorded rounds, the oldest first. The courses that rivers have now are not among them.
    pub fn rounds(&self) -> &[PastRound] {
        &self.rounds
    }

    /// Returns `true` if the courses after `round` of `of` rounds are to be recorded and are not yet.
    pub(super) fn wants(&self, round: u32, of: u32) -> bool {
        let is_kept = self.rounds.last().is_some_and(|past| past.round == round);
        !self.great.is_empty() && !is_kept && round * ROUNDS >= self.rounds.len() as u32 * of
    }

    /// Records the courses of great rivers after a number of rounds.
    pub(super) fn keep(&mut self, network: &Network, round: u32) {
        let course = |&river: &u32| PastCourse { river, line: network.middle(&network.rivers[river as usize]) };
        let mut courses: Vec<PastCourse> = self.great.iter().map(course).collect();
        let every = courses.iter().map(|course| course.line.len()).sum::<usize>().div_ceil(MOST_OF_COURSES);
        courses.iter_mut().for_each(|course| course.thin_out(every));
        self.rounds.push(PastRound { round, courses, loops: Vec::new() });
    }

    /// Records the loops of great rivers that have been cut off in a round, with the full width of the river.
    pub(super) fn keep_loops(&mut self, network: &Network, round: u32) {
        let Some(PastRound { loops, .. }) = self.rounds.last_mut() else { return };
        for cut_off in network.oxbows.iter().filter(|oxbow| oxbow.born == round && self.great.contains(&oxbow.river)) {
            let (river, line) = (cut_off.river, cut_off.bed());
            if loops.iter().map(|other| other.line.len()).sum::<usize>() + line.len() <= MOST_OF_LOOPS {
                loops.push(PastCourse { river, line });
            }
        }
    }
}

impl PastRound {
    /// Returns all beds of the round: courses, and loops.
    pub fn beds(&self) -> [&[PastCourse]; 2] {
        [&self.courses, &self.loops]
    }
}

impl PastCourse {
    /// Keeps every `every`-th place, and the last.
    fn thin_out(&mut self, every: usize) {
        let (mut i, last) = (0, self.line.len());
        self.line.retain(|_| {
            i += 1;
            (i - 1) % every == 0 || i == last
        });
        self.line.shrink_to_fit();
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Oxbow;
    use super::super::super::samples::{river, straight};
    use super::*;

    /// Makes an empty past in which the first half of a network's rivers are great.
    fn half_great(network: &Network) -> PastCourses {
        PastCourses::of((0..network.rivers.len() as u32 / 2).collect())
    }

    /// Records the courses before a round if the past wants them.
    fn keep(past: &mut PastCourses, network: &Network, round: u32, of: u32) {
        if past.wants(round, of) {
            past.keep(network, round);
        }
    }

    #[test]
    fn rounds_that_are_kept_are_even_however_many_there_are() {
        let network =
            river(&straight((0.0, 0.0), (9.0, 0.0), 9), 2.0).with_arm(&straight((4.0, 4.0), (4.0, 1.0), 3), 4, 1);
        for of in 0..=400u32 {
            let mut past = half_great(&network);
            (0..of).for_each(|round| keep(&mut past, &network, round, of));
            let rounds: Vec<u32> = past.rounds().iter().map(|past| past.round).collect();
            assert_eq!(rounds.len() as u32, of.min(ROUNDS), "{of}");
            let ends: Vec<u32> = rounds.iter().copied().chain((of > 0).then_some(of)).collect();
            let apart: Vec<u32> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
            let [least, most] = [apart.iter().min(), apart.iter().max()].map(|apart| apart.copied().unwrap_or(0));
            assert!(rounds.first().is_none_or(|first| *first == 0) && most - least <= 1, "{of}: {rounds:?}");
        }
    }

    #[test]
    fn courses_of_great_rivers_are_kept_as_they_are_and_no_others() {
        let network =
            river(&straight((0.0, 0.0), (9.0, 0.0), 9), 2.0).with_arm(&straight((4.0, 4.0), (4.0, 1.0), 3), 4, 1);
        let mut past = half_great(&network);
        keep(&mut past, &network, 0, 40);
        let line = network.middle(&network.rivers[0]);
        assert_eq!(past.rounds()[0].courses, [PastCourse { river: 0, line }]);
        let mut none = PastCourses::of(Vec::new());
        keep(&mut none, &network, 0, 40);
        assert_eq!(none.rounds(), []);
    }

    #[test]
    fn a_loop_belongs_to_the_round_before_and_has_the_width_of_its_river() {
        let mut network = river(&straight((0.0, 0.0), (40.0, 0.0), 40), 2.0);
        let mut past = PastCourses::of(vec![0]);
        let cut_off = |river: u32, born: u32| Oxbow { river, born, silt: 0.5, vertices: network.vertices.clone() };
        network.oxbows = vec![cut_off(0, 2), cut_off(0, 3), cut_off(1, 3)];
        keep(&mut past, &network, 0, 24);
        keep(&mut past, &network, 2, 24);
        past.keep_loops(&network, 3);
        assert_eq!(past.rounds()[0].loops, []);
        let [PastCourse { river: 0, line }] = &past.rounds()[1].loops[..] else {
            panic!("{:?}", past.rounds()[1].loops)
        };
        assert!(line.len() == 41 && line.iter().all(|place| place.half == 1.0), "{line:?}");
    }

    #[test]
    fn what_is_kept_is_bounded_and_keeps_the_ends_of_courses() {
        let mut network = river(&straight((0.0, 0.0), (30_000.0, 0.0), 30_000), 2.0);
        let lake = river(&straight((0.0, 0.0), (99.0, 0.0), 99), 2.0).vertices;
        for arm in 0..31 {
            network = network.with_arm(&straight((0.0, 9000.0), (0.0, 1.0), 9000), arm, 1);
        }
        network.oxbows =
            (0..400).map(|i| Oxbow { river: i % 8, born: i / 16, silt: 0.0, vertices: lake.clone() }).collect();
        let mut past = half_great(&network);
        for round in 0..400 {
            keep(&mut past, &network, round, 400);
            past.keep_loops(&network, round);
        }
        let all = past.rounds().iter().flat_map(|past| past.courses.iter().chain(&past.loops));
        let bytes = all.map(|course| size_of_val(course) + size_of_val(&course.line[..])).sum::<usize>();
        assert!((500_000..PastCourses::BYTES).contains(&bytes), "{bytes}");
        for course in &past.rounds()[11].courses {
            let whole = network.middle(&network.rivers[course.river as usize]);
            assert_eq!((course.line.first(), course.line.last()), (whole.first(), whole.last()));
        }
    }
}
