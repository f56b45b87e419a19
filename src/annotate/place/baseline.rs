//! Lines that type can stand on: beside copies of a course, more and less smooth.

use glam::Vec2;

use crate::base::geometry::{direction, distance, fast_max};
use crate::network::Place;

/// The number of samples of a course to the em.
pub const SAMPLES: usize = 4;
/// The smoothness of copies: the standard deviation of the weights of which each point is a mean, in samples.
const SMOOTHNESS: [usize; 3] = [SAMPLES, 2 * SAMPLES, 4 * SAMPLES];
/// The further smoothness of baselines, which are smoothed once more than their copies, in samples.
const SMOOTHED_AGAIN: usize = 3;
/// The stretch of the course around a place that may poke into letters there, to each side, in samples, and the share of its poking by
/// which a line keeps away.
const AROUND: usize = 2 * SAMPLES;
const KEPT: f32 = 0.7;
/// The smoothness of copies of reaches, which are named on and beside the belt of their bends.
const SMOOTHNESS_OF_REACHES: [usize; 3] = [3 * SAMPLES, 5 * SAMPLES, 8 * SAMPLES];
const AROUND_REACHES: usize = 4 * SAMPLES;
const SMOOTHED_AGAIN_OF_REACHES: usize = 2 * SAMPLES;
/// The distance of the baseline below its line where the middle of small letters stands on the line, in ems.
const ON: f32 = 0.2;

/// The distance of the baseline from the bank, in ems: above the river, and below it, where type hangs from it.
const ABOVE: f32 = 0.25 + 0.06;
const BELOW: f32 = 0.42 + 0.14;

/// A course at even distances.
#[derive(Clone, Debug)]
pub struct Course {
    at: Vec<Vec2>,
    half: Vec<f32>,
    /// The share of the river's area that lies upstream of each point.
    area: Vec<f32>,
    /// The greatest width of the river, in units.
    thick: f32,
}

/// A line for type, in the direction that it is read in.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its points, in units.
    pub at: Vec<Vec2>,
    /// The distance of each point from the first, along the line.
    pub along: Vec<f32>,
    /// `true` if it lies above the river, and not below it.
    pub is_above: bool,
    /// The share of the river's area that lies upstream of each point.
    pub area: Vec<f32>,
    /// The width of the river at each point, in units.
    pub width: Vec<f32>,
}

/// A walk along a line, which is asked for places at rising distances.
#[derive(Clone, Copy)]
pub struct Walk<'a> {
    line: &'a Line,
    next: usize,
}

impl Walk<'_> {
    /// Goes on to a distance along the line.
    #[inline]
    pub fn go(&mut self, along: f32) {
        let Line { at, along: lengths, .. } = self.line;
        while self.next + 1 < at.len() && lengths[self.next] < along {
            self.next += 1;
        }
    }

    /// Returns the point at a distance along the line.
    #[inline]
    pub fn at(&mut self, along: f32) -> Vec2 {
        self.go(along);
        let Line { at, along: lengths, .. } = self.line;
        let (from, to) = (lengths[self.next - 1], lengths[self.next]);
        let t = if to > from { (along - from) / (to - from) } else { 0.0 };
        at[self.next - 1] + (at[self.next] - at[self.next - 1]) * t
    }

    /// Returns the number of the line's point before the walk's place.
    pub fn place(&self) -> usize {
        self.next - 1
    }
}

/// Begins a walk at a distance found by halving.
pub fn walk_from(line: &Line, along: f32) -> Walk<'_> {
    let next = line.along.partition_point(|&length| length < along);
    Walk { line, next: next.clamp(1, line.at.len() - 1) }
}

impl Line {
    /// Makes a line through some points.
    pub fn through(at: Vec<Vec2>) -> Self {
        let (along, area, width) = (crate::base::geometry::lengths(&at), Vec::new(), Vec::new());
        Self { at, along, is_above: true, area, width }
    }

    /// Returns its length, in units.
    pub fn length(&self) -> f32 {
        self.along.last().copied().unwrap_or(0.0)
    }

    /// Returns the middle between its ends.
    pub fn middle(&self) -> Vec2 {
        let ends = [self.at.first(), self.at.last()].map(|at| at.copied().unwrap_or_default());
        (ends[0] + ends[1]) * 0.5
    }

    /// Returns the part that begins at a distance along it and has a length, both in units.
    pub fn part(&self, start: f32, length: f32) -> Self {
        let end = start + length;
        let [from, to] = [start, end].map(|along| walk_from(self, along).at(along));
        let within = self.at.iter().zip(&self.along).filter(|(_, along)| (start..end).contains(*along));
        Self::through(std::iter::once(from).chain(within.map(|(at, _)| *at)).chain([to]).collect())
    }
}

impl Course {
    /// Takes samples of a centerline, as many to the em as there are; `None` if it is shorter than an em.
    pub fn new(line: &[Place], em: f32) -> Option<Self> {
        let spacing = em / SAMPLES as f32;
        let (mut at, mut half) = (Vec::new(), Vec::new());
        let mut ahead = 0.0;
        for pair in line.windows(2) {
            let length = distance(pair[0].at, pair[1].at);
            while ahead < length {
                let t = ahead / length;
                at.push(pair[0].at + (pair[1].at - pair[0].at) * t);
                half.push(pair[0].half + (pair[1].half - pair[0].half) * t);
                ahead += spacing;
            }
            ahead -= length;
        }
        let total: f32 = half.iter().sum();
        let mut upstream = 0.0;
        let share = |half: &f32| {
            upstream += half;
            upstream / total
        };
        let area = half.iter().map(share).collect();
        let thick = 2.0 * half.iter().copied().fold(0.0, f32::max);
        (at.len() > SAMPLES && total > 0.0).then_some(Self { at, half, area, thick })
    }

    /// Returns its greatest width, in units.
    pub fn thick(&self) -> f32 {
        self.thick
    }

    /// Returns the lines beside it for letters of this size of which some part is read from left to right.
    pub fn lines(&self, em: f32) -> Vec<Line> {
        SMOOTHNESS.into_iter().flat_map(|radius| self.beside(&smoothed(&self.at, radius), em)).collect()
    }

    /// Returns the lines on and beside the belt of a reach.
    pub fn lines_of_reach(&self, em: f32) -> Vec<Line> {
        SMOOTHNESS_OF_REACHES.into_iter().flat_map(|radius| self.along_belt(&smoothed(&self.at, radius), em)).collect()
    }

    /// Returns the lines beside the belt of its bends.
    pub fn lines_beside_belt(&self, em: f32) -> Vec<Line> {
        // The first of each three is on it.
        self.lines_of_reach(em).into_iter().enumerate().filter(|(i, _)| i % 3 > 0).map(|(_, line)| line).collect()
    }

    /// Returns the lines on and beside one copy, in both directions if both can be read somewhere.
    fn along_belt(&self, copy: &[Vec2], em: f32) -> Vec<Line> {
        let along = directions(copy);
        let mut lines = Vec::new();
        for is_downstream in readable(&along) {
            // To the right of those who read is below.
            let right = if is_downstream { 1.0 } else { -1.0 };
            for (side, gap) in [(0.0, ON), (-1.0, ABOVE), (1.0, BELOW)] {
                let aside: Vec<Vec2> =
                    along.iter().map(|along| along.perp() * right * if side < 0.0 { -1.0 } else { 1.0 }).collect();
                let belt = if side == 0.0 { vec![0.0; copy.len()] } else { self.belt(copy, &aside) };
                let off = |i: usize| copy[i] + aside[i] * (gap * em + belt[i]);
                let at = smoothed(&(0..copy.len()).map(off).collect::<Vec<_>>(), SMOOTHED_AGAIN_OF_REACHES);
                lines.push(self.line(at, is_downstream, side < 0.0));
            }
        }
        lines
    }

    /// Returns for each point the greatest distance of the banks to one side of the copy, around that point.
    fn belt(&self, copy: &[Vec2], aside: &[Vec2]) -> Vec<f32> {
        let off = (0..copy.len()).map(|i| (self.at[i] - copy[i]).dot(aside[i]) + self.half[i]).collect::<Vec<_>>();
        most_around(&off, AROUND_REACHES)
    }

    /// Returns the lines beside one copy.
    fn beside(&self, copy: &[Vec2], em: f32) -> Vec<Line> {
        let last = copy.len() - 1;
        let along = directions(copy);
        let sides = [-1.0, 1.0].map(|side| {
            let aside: Vec<Vec2> = along.iter().map(|along| along.perp() * side).collect();
            let poking = self.poking(copy, &aside);
            (aside, poking)
        });
        let mut lines = Vec::new();
        for is_downstream in readable(&along) {
            for is_above in [true, false] {
                // To the left of those who read is above.
                let (aside, poking) = &sides[usize::from(is_downstream != is_above)];
                let gap = if is_above { ABOVE } else { BELOW } * em;
                for kept in [0.0, KEPT] {
                    let off = |i: usize| copy[i] + aside[i] * (self.half[i] + gap + kept * poking[i]);
                    let at = smoothed(&(0..=last).map(off).collect::<Vec<_>>(), SMOOTHED_AGAIN);
                    lines.push(self.line(at, is_downstream, is_above));
                }
            }
        }
        lines
    }

    fn line(&self, mut at: Vec<Vec2>, is_downstream: bool, is_above: bool) -> Line {
        let (mut area, mut width) = (self.area.clone(), self.half.iter().map(|half| 2.0 * half).collect::<Vec<_>>());
        if !is_downstream {
            at.reverse();
            area.reverse();
            width.reverse();
        }
        let along = crate::base::geometry::lengths(&at);
        Line { at, along, is_above, area, width }
    }

    /// Returns for each point the greatest distance of the course to one side of its copy, around that point.
    fn poking(&self, copy: &[Vec2], aside: &[Vec2]) -> Vec<f32> {
        let off: Vec<f32> = (0..copy.len()).map(|i| (self.at[i] - copy[i]).dot(aside[i])).collect();
        most_around(&off, AROUND)
    }
}

/// Returns the directions in which a line can be read somewhere: downstream, or up.
fn readable(along: &[Vec2]) -> impl Iterator<Item = bool> {
    let is_read =
        |is_downstream: &bool| along.iter().any(|&along| is_upright(if *is_downstream { along } else { -along }));
    [true, false].into_iter().filter(is_read)
}

/// Returns the unit vectors along a line.
fn directions(line: &[Vec2]) -> Vec<Vec2> {
    let last = line.len() - 1;
    (0..=last).map(|i| direction(line[(i + 1).min(last)] - line[i.saturating_sub(1)])).collect()
}

/// Returns for each number the greatest of those around it, at least 0.
fn most_around(numbers: &[f32], around: usize) -> Vec<f32> {
    let width = 2 * around + 1;
    let mut most = vec![0.0; numbers.len() + 2 * around];
    for (most, &number) in most[around..].iter_mut().zip(numbers) {
        *most = fast_max(number, 0.0);
    }
    // Each pass doubles the stretch of numbers, from a place on, of which that place has the greatest.
    let mut span = 1;
    while 2 * span <= width {
        for i in 0..most.len() - span {
            most[i] = fast_max(most[i], most[i + span]);
        }
        span *= 2;
    }
    (0..numbers.len()).map(|i| fast_max(most[i], most[i + width - span])).collect()
}

/// Returns `true` if type that runs this way is upright: from 100 degrees upward to 80 downward.
pub fn is_upright(along: Vec2) -> bool {
    /// The direction ten degrees upward.
    const MIDDLE: Vec2 = Vec2::new(0.984_807_7, -0.173_648_18);
    let rightward = along.dot(MIDDLE);
    rightward > 0.0 || (rightward == 0.0 && along.y > 0.0)
}

/// Smooths a line three times over: each point becomes a mean of those around it. Beyond its ends the line goes on as its mirror image
/// through them, so it keeps them.
pub fn smoothed(line: &[Vec2], radius: usize) -> Vec<Vec2> {
    let last = line.len() - 1;
    let (mut smooth, mut before) = (line.to_vec(), Vec::with_capacity(line.len() + 2 * radius + 1));
    let (share, width) = (1.0 / (2 * radius + 1) as f32, 2 * radius + 1);
    for _ in 0..3 {
        before.clear();
        before.extend((1..=radius).rev().map(|i| smooth[0] * 2.0 - smooth[i.min(last)]));
        before.extend_from_slice(&smooth);
        before.extend((1..=radius + 1).map(|i| smooth[last] * 2.0 - smooth[last.saturating_sub(i)]));
        let mut sum = before[..width].iter().fold(Vec2::ZERO, |sum, at| sum + at);
        for (point, (behind, ahead)) in smooth.iter_mut().zip(before.iter().zip(&before[width..])) {
            *point = sum * share;
            sum = sum + ahead - behind;
        }
    }
    smooth
}

#[cfg(test)]
mod tests {
    use super::*;

    fn course(degrees: f32) -> Course {
        let along = Vec2::new(libm::cosf(degrees.to_radians()), libm::sinf(degrees.to_radians()));
        let line: Vec<Place> = (0..40).map(|i| Place { at: along * (i as f32 * 10.0), half: 2.0 }).collect();
        Course::new(&line, 12.0).unwrap()
    }

    #[test]
    fn smoothing_keeps_straight_lines_and_ends() {
        let line: Vec<Vec2> = (0..30).map(|i| Vec2::new(i as f32, 2.0 * i as f32)).collect();
        for (at, smooth) in line.iter().zip(smoothed(&line, 8)) {
            assert!(distance(*at, smooth) < 1e-3, "{at} became {smooth}");
        }
        let bent: Vec<Vec2> = (0..30).map(|i| Vec2::new(i as f32, (i % 5) as f32)).collect();
        let smooth = smoothed(&bent, 4);
        assert!(distance(bent[0], smooth[0]) < 1e-3 && distance(bent[29], smooth[29]) < 1e-3);
    }

    #[test]
    fn lines_lie_beside_a_straight_river_by_half_its_width_and_a_gap_and_are_upright() {
        for degrees in [0.0f32, 60.0, 120.0, 200.0, 300.0] {
            for line in course(degrees).lines(12.0) {
                let away = distance(line.at[20], course(degrees).at[20])
                    .min(distance(line.at[20], course(degrees).at[line.at.len() - 21]));
                let gap = 2.0 + 12.0 * if line.is_above { ABOVE } else { BELOW };
                assert!((away - gap).abs() < 1e-2, "{away} and not {gap}");
                assert!(is_upright(line.at[10] - line.at[9]), "{degrees}");
                // Above is where letters rise from the river, up on the page as long as type is not upright.
                let up = (line.at[10] - line.at[9]).perp();
                let river = course(degrees).at[20] - line.at[20];
                assert_eq!(river.dot(up) > 0.0, line.is_above, "{degrees}");
            }
        }
    }

    #[test]
    fn type_runs_from_100_degrees_upward_to_80_downward() {
        let is_upright =
            |degrees: f32| is_upright(Vec2::new(libm::cosf(degrees.to_radians()), libm::sinf(degrees.to_radians())));
        assert!([-99.9, -90.0, 0.0, 79.9].into_iter().all(is_upright));
        assert!(![-100.1, 80.1, 180.0, 100.0].into_iter().any(is_upright));
    }
}
