//! Banks: the two sides of a line whose width is given place by place.

use glam::Vec2;

use crate::base::geometry::{direction, length};
use crate::recipe::CourseShape;

/// A place on a centerline, midway between two banks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The position, in units.
    pub at: Vec2,
    /// The distance to either bank, in units.
    pub half: f32,
}

/// A river's or a lake's outline, in units. Both banks have the same number of points. In rivers as grown, the lines
/// between them are straight.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Banks {
    /// The left bank, looking downstream, from the source to the end.
    pub left: Vec<Vec2>,
    /// The right bank.
    pub right: Vec<Vec2>,
    /// The index of the place of the line that each pair of points, left and right, belongs to.
    pub(super) places: Vec<u32>,
}

impl Banks {
    /// Makes the banks along a line from the width at each of its places.
    pub(crate) fn along(line: &[Place], courses: CourseShape) -> Self {
        let mut banks = Self::default();
        for (i, &Place { at, half }) in line.iter().enumerate() {
            let place = i as u32;
            let [before, after] = ways(line, i);
            let middle = (before + after) * 0.5;
            if courses == CourseShape::Grown && middle.length_squared() < SHARP {
                banks.turn(place, at, before * half, after * half);
            } else {
                let aside = aside(middle) * half;
                banks.push(place, at - aside, at + aside);
            }
        }
        banks
    }

    /// Makes the banks along a line. They meet at its first place.
    pub(crate) fn of_line(line: &[Place], courses: CourseShape) -> Self {
        let mut kept: Vec<u32> = (0..line.len() as u32).collect();
        kept.dedup_by_key(|i| line[*i as usize].at);
        let mut apart: Vec<Place> = kept.iter().map(|&i| line[i as usize]).collect();
        if let Some(source) = apart.first_mut() {
            source.half = 0.0;
        }
        let mut banks = Self::along(&apart, courses);
        banks.places.iter_mut().for_each(|place| *place = kept[*place as usize]);
        banks
    }

    /// Returns the polygon that both banks enclose: down the left bank and up the right one, no point twice in a row.
    pub fn ring(&self) -> Vec<Vec2> {
        let mut ring: Vec<Vec2> = self.left.iter().chain(self.right.iter().rev()).copied().collect();
        ring.dedup();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }

    /// Adds a sharp corner; `before` and `after` are the directions there, as long as half the width. Up to it the
    /// banks keep their distance from the line, and around it the outer one does. The inner bank passes through the
    /// corner itself, so that there is no gap.
    fn turn(&mut self, place: u32, at: Vec2, before: Vec2, after: Vec2) {
        let tip = at + direction(before - after) * length(before);
        self.push(place, at - before.perp(), at + before.perp());
        if before.perp_dot(after) > 0.0 {
            self.push(place, tip, at);
        } else {
            self.push(place, at, tip);
        }
        self.push(place, at - after.perp(), at + after.perp());
    }

    fn push(&mut self, place: u32, left: Vec2, right: Vec2) {
        self.places.push(place);
        self.left.push(left);
        self.right.push(right);
    }
}

/// A line turns by more than 60° if the mean of the unit vectors before and after has a smaller square: cos² 30°.
const SHARP: f32 = 0.75;

/// Returns the unit vectors along a line before and after a place; at either end of the line the only one twice.
fn ways(line: &[Place], i: usize) -> [Vec2; 2] {
    let way = |from: usize, to: usize| direction(line[to].at - line[from].at);
    let (before, after) = (way(i.saturating_sub(1), i), way(i, (i + 1).min(line.len() - 1)));
    match (i == 0, i + 1 == line.len()) {
        (true, _) => [after, after],
        (_, true) => [before, before],
        _ => [before, after],
    }
}

/// Returns the offset to the right bank at a corner of a line, for a half-width of 1: a mitre, long enough that both sides
/// of the corner keep their distance. It is cut where the line turns sharply, and zero where it turns straight back.
fn aside(middle: Vec2) -> Vec2 {
    // `f32::max` is avoided: it handles NaN, and takes several jumps in wasm.
    let squared = middle.length_squared();
    middle.perp() / if squared > SHARP { squared } else { SHARP }
}
