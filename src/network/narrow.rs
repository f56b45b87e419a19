//! Narrowing: where a course turns too sharply for the width of its river, or comes back to itself, the river is drawn narrower.
//!
//! Both banks of a river form a ring. Where the ring crosses or touches itself, the river is made narrower little by
//! little until it does not, and widens again above and below.

use std::ops::Range;

use glam::Vec2;

use super::centerline::middle;
use super::{Banks, NONE, Network, Place, River, Vertex};
use crate::base::geometry::{distance, doubled_area, fast_max, fast_min, length, meet};
use crate::base::work;
use crate::recipe::CourseShape;

/// The greatest change of half the width per unit of length along a narrowed river.
const FLARE: f32 = 0.2;

/// The greatest distance of a bank from the line where it turns, in half-widths.
const MITRE: f32 = 1.16;

/// The cosine of the angle up to which a line counts as straight.
const STRAIGHT: f32 = 0.98;

/// The factor for the width of a river where its banks still meet, and how often that is tried.
const LESS: f32 = 0.85;
const TRIES: u32 = 96;

/// Returns the network, with smooth courses, with some of its rivers narrowed so that their banks do not meet; `None`
/// if none has to be.
pub(super) fn narrowed<'a>(network: &Network, rivers: impl Iterator<Item = &'a River>) -> Option<Network> {
    let mut drawn: Option<Network> = None;
    for river in rivers {
        let course: Vec<&Vertex> = network.course(river).collect();
        let own = river.vertex_range().len();
        let Some(shares) = shares(&course, own, river.junction != NONE) else { continue };
        let drawn = drawn.get_or_insert_with(|| network.clone());
        for (vertex, share) in drawn.vertices[river.vertex_range()].iter_mut().zip(shares) {
            (vertex.left, vertex.right) = (vertex.left * share, vertex.right * share);
        }
    }
    drawn
}

/// Returns the share of its width that each own vertex of a course keeps; `None` if all keep all of it.
fn shares(course: &[&Vertex], own: usize, is_tributary: bool) -> Option<Vec<f32>> {
    let line = middle(course, is_tributary);
    if own < 2 || !is_in_doubt(&line) {
        return None;
    }
    let mut shares: Vec<f32> = vec![1.0; own];
    // Places around which banks met in the last try; all places at first, and again once none meet.
    let mut suspects: Option<Vec<bool>> = None;
    for _ in 0..TRIES {
        let places =
            Banks::of_line(&scaled(course, &shares, is_tributary), CourseShape::Smooth).meetings(suspects.as_deref());
        if places.is_empty() {
            if suspects.take().is_none() {
                break;
            }
            continue;
        }
        let mut gives_way = vec![false; own];
        for place in places {
            // The neighbours give way too; the junction belongs to the other river.
            let place = (place as usize).min(own - 1);
            gives_way[place.saturating_sub(1)..(place + 2).min(own)].fill(true);
        }
        for (share, _) in shares.iter_mut().zip(&gives_way).filter(|(_, gives_way)| **gives_way) {
            *share *= LESS;
        }
        suspects = Some(gives_way);
        flare(&mut shares, &line);
    }
    shares.iter().any(|&share| share < 1.0).then_some(shares)
}

/// Returns the centerline of a course whose widths are scaled.
fn scaled(course: &[&Vertex], shares: &[f32], is_tributary: bool) -> Vec<Place> {
    let narrow = |(vertex, share): (&&Vertex, &f32)| Vertex {
        left: vertex.left * share,
        right: vertex.right * share,
        ..**vertex
    };
    let last = course.iter().skip(shares.len()).map(|vertex| **vertex);
    let course: Vec<Vertex> = course.iter().zip(shares).map(narrow).chain(last).collect();
    middle(&course.iter().collect::<Vec<_>>(), is_tributary)
}

/// Returns `true` if pieces of a line come so near to each other, or turn so sharply, that banks could meet.
fn is_in_doubt(line: &[Place]) -> bool {
    let turns = |three: &[Place]| {
        let (before, after) = (three[1].at - three[0].at, three[2].at - three[1].at);
        let shorter = fast_min(length(before), length(after));
        let turn = before.dot(after);
        turn < 0.0 || three[1].half * MITRE > shorter && turn < STRAIGHT * length(before) * length(after)
    };
    let pieces: Vec<Piece> = line.windows(2).map(Piece::of).collect();
    let runs = Runs::of_sides(&line.windows(2).map(|ends| (ends[0].at, ends[1].at)).collect::<Vec<_>>());
    let largest = |pieces: &[Piece]| pieces.iter().map(|piece| piece.radius).fold(0.0, fast_max);
    let widest = largest(&pieces);
    let comes_near = |a: usize| {
        let own = Runs::range(a, pieces.len());
        let reach = largest(&pieces[own.clone()]) + widest;
        let others = runs.near(a, reach).filter(|&b| b >= a).flat_map(|b| Runs::range(b, pieces.len()));
        others.into_iter().any(|j| own.clone().any(|i| j > i + 1 && pieces[i].may_meet(&pieces[j])))
    };
    line.windows(3).any(turns) || (0..runs.0.len()).any(comes_near)
}

/// The circle around a segment of a line and its banks.
struct Piece {
    middle: Vec2,
    radius: f32,
}

impl Piece {
    fn of(ends: &[Place]) -> Self {
        let [a, b] = [ends[0], ends[ends.len() - 1]];
        Self { middle: (a.at + b.at) * 0.5, radius: distance(a.at, b.at) * 0.5 + MITRE * fast_max(a.half, b.half) }
    }

    fn may_meet(&self, other: &Self) -> bool {
        let far = self.radius + other.radius;
        self.middle.distance_squared(other.middle) < far * far
    }
}

/// Lowers shares so that widths change gradually along a line.
fn flare(shares: &mut [f32], line: &[Place]) {
    let ease = |narrow: f32, a: usize, b: usize| {
        let room = narrow * line[a].half + FLARE * distance(line[a].at, line[b].at);
        if narrow < 1.0 && line[b].half > room { room / line[b].half } else { 1.0 }
    };
    for i in 1..shares.len() {
        shares[i] = fast_min(shares[i], ease(shares[i - 1], i - 1, i));
    }
    for i in (1..shares.len()).rev() {
        shares[i - 1] = fast_min(shares[i - 1], ease(shares[i], i, i - 1));
    }
}

/// The bounding boxes of runs of points or sides.
struct Runs(Vec<[Vec2; 2]>);

impl Runs {
    const LENGTH: usize = 16;

    fn of(points: impl Iterator<Item = Vec2>) -> Self {
        let mut boxes: Vec<[Vec2; 2]> = Vec::new();
        for (i, at) in points.enumerate() {
            match boxes.last_mut().filter(|_| i % Self::LENGTH > 0) {
                Some([least, most]) => (*least, *most) = (least.min(at), most.max(at)),
                None => boxes.push([at; 2]),
            }
        }
        Self(boxes)
    }

    fn of_sides(sides: &[(Vec2, Vec2)]) -> Self {
        let (lows, highs) = (sides.iter().map(|side| side.0.min(side.1)), sides.iter().map(|side| side.0.max(side.1)));
        let (lows, highs) = (Self::of(lows), Self::of(highs));
        Self(lows.0.iter().zip(&highs.0).map(|(low, high)| [low[0], high[1]]).collect())
    }

    /// Returns the indices of a run's members; `count` is the number of members of all runs.
    fn range(run: usize, count: usize) -> Range<usize> {
        (run * Self::LENGTH).min(count)..((run + 1) * Self::LENGTH).min(count)
    }

    /// Iterates over the runs whose boxes come within a distance of the box of a run, which is one of them.
    fn near(&self, run: usize, reach: f32) -> impl Iterator<Item = usize> + '_ {
        let [least, most] = self.0[run];
        work::count(self.0.len());
        let is_near =
            move |other: &[Vec2; 2]| other[0].cmple(most + reach).all() && other[1].cmpge(least - reach).all();
        self.0.iter().enumerate().filter(move |(_, other)| is_near(other)).map(|(i, _)| i)
    }

    /// Returns the intersection of the boxes of two runs: only there can their members meet.
    fn shared(&self, a: usize, b: usize) -> [Vec2; 2] {
        [self.0[a][0].max(self.0[b][0]), self.0[a][1].min(self.0[b][1])]
    }
}

/// Returns `true` if the box around a side touches or overlaps another box.
fn touches((from, to): (Vec2, Vec2), [least, most]: [Vec2; 2]) -> bool {
    from.min(to).cmple(most).all() && from.max(to).cmpge(least).all()
}

impl Banks {
    /// Finds the indices of the places where the ring of both banks crosses or touches itself: all of them, or those at suspects.
    fn meetings(&self, suspects: Option<&[bool]>) -> Vec<u32> {
        let corners = self.left.iter().zip(&self.places).chain(self.right.iter().zip(&self.places).rev());
        let mut corners: Vec<(Vec2, u32)> = corners.map(|(&at, &place)| (at, place)).collect();
        corners.dedup_by_key(|corner| corner.0);
        let Some(&first) = corners.first() else { return Vec::new() };
        if corners.last().is_some_and(|last| last.0 != first.0) {
            corners.push(first);
        }
        let sides: Vec<(Vec2, Vec2)> = corners.windows(2).map(|pair| (pair[0].0, pair[1].0)).collect();
        let runs = Runs::of_sides(&sides);
        let is_suspect =
            |side: usize| suspects.is_none_or(|suspects| suspects.get(corners[side].1 as usize) == Some(&true));
        let holds_suspects: Vec<bool> =
            (0..runs.0.len()).map(|run| Runs::range(run, sides.len()).any(is_suspect)).collect();
        let mut meetings = Vec::new();
        for a in (0..runs.0.len()).filter(|&a| holds_suspects[a]) {
            for b in runs.near(a, 0.0).filter(|&b| b >= a || !holds_suspects[b]) {
                let (a, b) = (a.min(b), a.max(b));
                let shared = runs.shared(a, b);
                work::count(Runs::LENGTH);
                for i in Runs::range(a, sides.len()).filter(|&i| touches(sides[i], shared)) {
                    let others = Runs::range(b, sides.len());
                    let others = others.start.max(i + 1)..others.end;
                    work::count(others.len());
                    for j in others.filter(|&j| sides_meet(&sides, i, j)) {
                        meetings.extend([i, i + 1, j, j + 1].map(|corner| corners[corner].1));
                    }
                }
            }
        }
        meetings
    }
}

/// Returns `true` if two sides of a closed ring meet anywhere but in the common corner of neighbours.
fn sides_meet(sides: &[(Vec2, Vec2)], i: usize, j: usize) -> bool {
    let (a, b) = (sides[i], sides[j]);
    let turns_back =
        |a: (Vec2, Vec2), b: (Vec2, Vec2)| (a.1 - a.0).dot(b.1 - b.0) < 0.0 && doubled_area(a.0, a.1, b.1) == 0.0;
    if j == i + 1 {
        turns_back(a, b)
    } else if i == 0 && j + 1 == sides.len() {
        turns_back(b, a)
    } else {
        meet(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, straight};
    use super::*;

    /// Returns a river of a given width along a line as it is drawn; `None` if it keeps all its width.
    fn drawn(line: &[Vec2], width: f32) -> Option<Network> {
        let network = river(line, width);
        narrowed(&network, network.rivers.iter())
    }

    /// Returns the course of two parallel limbs at a distance, joined by a half circle.
    fn hairpin(apart: f32) -> Vec<Vec2> {
        let back = straight((140.0, 400.0 + apart), (100.0, 400.0 + apart), 40);
        let turn = (1..12).map(|i| {
            let angle = std::f32::consts::PI * (i as f32 / 12.0 - 0.5);
            Vec2::new(140.0, 400.0 + apart / 2.0) + Vec2::new(libm::cosf(angle), libm::sinf(angle)) * (apart / 2.0)
        });
        straight((100.0, 400.0), (140.0, 400.0), 40).into_iter().chain(turn).chain(back).collect()
    }

    fn meets(network: &Network) -> bool {
        !network.banks(&network.rivers[0], CourseShape::Smooth).meetings(None).is_empty()
    }

    #[test]
    fn rivers_with_room_keep_all_their_width() {
        assert_eq!(drawn(&straight((100.0, 400.0), (160.0, 420.0), 60), 6.0), None);
        assert_eq!(drawn(&hairpin(12.0), 6.0), None);
    }

    #[test]
    fn limbs_that_would_meet_give_way_and_little_by_little() {
        assert!(meets(&river(&hairpin(4.0), 6.0)));
        let network = drawn(&hairpin(4.0), 6.0).unwrap();
        assert!(!meets(&network));
        let widths: Vec<f32> = network.vertices.iter().map(Vertex::width).collect();
        assert!(widths[1..].iter().all(|&width| (1.0..=6.0).contains(&width)) && widths[20] < 4.5, "{widths:?}");
        let steepest = widths[1..].windows(2).map(|pair| (pair[0] - pair[1]).abs()).fold(0.0, f32::max);
        assert!(steepest <= 2.0 * FLARE + 1e-3, "{steepest}");
    }

    #[test]
    fn places_are_where_the_ring_crosses_itself() {
        let line = [(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (5.0, 4.0), (5.0, -6.0)];
        let bow = Banks::along(&line.map(|(x, y)| Place { at: Vec2::new(x, y), half: 0.5 }), CourseShape::Smooth);
        let mut places = bow.meetings(None);
        places.sort_unstable();
        places.dedup();
        assert_eq!(places, [0, 1, 3, 4]);
    }
}
