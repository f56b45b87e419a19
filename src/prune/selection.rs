//! Selection of tributaries, the greatest discharge first, so that rivers do not look like fishbones. A tributary is
//! removed, with everything upstream of it, if it would
//!
//! - join its river nearer than a distance d to a greater tributary, along the river or across, or to an end of the
//!   river itself, or
//! - run beside other rivers: a fifth of its course, apart from its beginning at the junction, lies within a distance e
//!   of one that stays.
//!
//! Its water still flows down the river that it would have joined. d = spacing · e^(0.8 g), with g a normal deviate of
//! the tributary, because in nature the distances of junctions vary as much; e = 0.7 · spacing. The first rule spares
//! long tributaries, since the gap without one would be wider than all others along the river.

use glam::Vec2;

use super::Trim;
use crate::base::geometry::distance;
use crate::base::random::Purpose;
use crate::base::sort;
use crate::base::work;
use crate::tree::{NO_PARENT, Tree};

/// The deviation of the logarithm of the distance between junctions.
const DEVIATION: f32 = 0.8;

/// The distance between rivers, as a share of that between junctions.
const BESIDE: f32 = 0.7;

/// The part of a tributary that counts as its junction, in distances between rivers.
const JUNCTION: f32 = 2.2;

/// The length from which a tributary may join anywhere, in distances between junctions.
const LONG: f32 = 8.0;

/// The reciprocal of the share of a course's samples that may lie beside another river.
const SHARE: usize = 5;

/// Removes crowded tributaries from the nodes that stay.
pub(super) fn select(tree: &Tree, discharge: &[u32], stays: Vec<bool>, trim: Trim) -> Vec<bool> {
    if trim.tributary_spacing <= 0.0 {
        return stays;
    }
    let rivers = Rivers::of(tree, discharge, &stays);
    let mut selection = Selection::new(tree, &rivers, trim);
    let mut kept = vec![false; tree.len()];
    for &first in &rivers.greatest_first {
        let course = rivers.course(first);
        let parent = tree.parent_of(first as usize);
        if parent.is_some_and(|parent| !kept[parent] || !selection.has_room(&course, parent)) {
            continue;
        }
        course.iter().for_each(|&node| kept[node as usize] = true);
        selection.keep(&course, parent);
    }
    kept
}

/// The nodes that stay so far, as rivers. A river continues upstream along its arm of the greatest discharge.
struct Rivers {
    /// The next node upstream on the same river; [`NO_PARENT`] at a source.
    upstream: Vec<u32>,
    /// The lowest node of each river, the greatest discharge first.
    greatest_first: Vec<u32>,
}

impl Rivers {
    fn of(tree: &Tree, discharge: &[u32], stays: &[bool]) -> Self {
        let mut upstream = vec![NO_PARENT; tree.len()];
        let mut lowest = Vec::new();
        let staying = || (0..tree.len()).filter(|&node| stays[node]);
        for node in staying() {
            if let Some(parent) = tree.parent_of(node) {
                let arm = upstream[parent];
                if arm == NO_PARENT || discharge[node] > discharge[arm as usize] {
                    upstream[parent] = node as u32;
                }
            }
        }
        for node in staying() {
            if tree.parent_of(node).is_none_or(|parent| upstream[parent] != node as u32) {
                lowest.push(node as u32);
            }
        }
        let order = sort::argsort(lowest.iter().map(|&node| !discharge[node as usize]));
        Self { upstream, greatest_first: order.into_iter().map(|i| lowest[i]).collect() }
    }

    /// Returns the nodes of a river, from its lowest to its source.
    fn course(&self, first: u32) -> Vec<u32> {
        let next = |&node: &u32| Some(self.upstream[node as usize]).filter(|&node| node != NO_PARENT);
        std::iter::successors(Some(first), next).collect()
    }
}

/// The rivers that stay so far.
struct Selection<'a> {
    tree: &'a Tree,
    trim: Trim,
    /// The distance of each node from the lower end of its river, along the river.
    along: Vec<f32>,
    /// The last junction on the river of each lowest node, as an index of `junctions`; [`NO_PARENT`] if it has none.
    last_junction: Vec<u32>,
    /// The lowest node of the river of each node.
    river: Vec<u32>,
    /// Junctions and ends: the node on the river, and the index of the one before it.
    junctions: Vec<(u32, u32)>,
    courses: Samples,
}

impl<'a> Selection<'a> {
    fn new(tree: &'a Tree, rivers: &Rivers, trim: Trim) -> Self {
        let (mut along, mut river) = (vec![0.0; tree.len()], vec![NO_PARENT; tree.len()]);
        for &first in &rivers.greatest_first {
            let (mut far, mut before) = (0.0, tree.at[first as usize]);
            for node in rivers.course(first) {
                let at = tree.at[node as usize];
                far += distance(before, at);
                before = at;
                (along[node as usize], river[node as usize]) = (far, first);
            }
        }
        let apart = BESIDE * trim.tributary_spacing;
        let courses = Samples::new(&tree.at, apart);
        Self { tree, trim, along, last_junction: vec![NO_PARENT; tree.len()], river, junctions: Vec::new(), courses }
    }

    /// Returns `true` if a tributary, lowest node first, is far enough from the rivers that stay.
    fn has_room(&self, course: &[u32], parent: usize) -> bool {
        (self.is_long(course) || self.is_apart(course[0], parent)) && !self.runs_beside(course, parent)
    }

    fn is_long(&self, course: &[u32]) -> bool {
        self.along[course[course.len() - 1] as usize] > LONG * self.trim.tributary_spacing
    }

    /// Returns `true` if a tributary joins its river far enough from other junctions and from its ends.
    fn is_apart(&self, first: u32, parent: usize) -> bool {
        let identity = self.tree.identity_of(first as usize);
        let deviate = self.trim.seed.item_hash(Purpose::Trimming).normal([identity, 1, 0]);
        let apart = self.trim.tributary_spacing * libm::expf(DEVIATION * deviate);
        let mut next = self.last_junction[self.river[parent] as usize];
        while let Some(&(node, before)) = self.junctions.get(next as usize) {
            work::count(1);
            let node = node as usize;
            let is_near = (self.along[node] - self.along[parent]).abs() < apart
                || distance(self.tree.at[node], self.tree.at[parent]) < apart;
            if is_near {
                return false;
            }
            next = before;
        }
        true
    }

    /// Returns `true` if too much of a tributary lies beside rivers that stay.
    fn runs_beside(&self, course: &[u32], parent: usize) -> bool {
        let junction = self.tree.at[parent];
        let beyond = JUNCTION * self.courses.apart;
        let (mut all, mut beside) = (0, 0);
        for at in self.samples(course, Some(parent)) {
            if distance(at, junction) > beyond {
                all += 1;
                beside += usize::from(self.courses.has_near(at));
            }
        }
        SHARE * beside > all
    }

    /// Keeps a river, lowest node first.
    fn keep(&mut self, course: &[u32], parent: Option<usize>) {
        let (first, source) = (course[0], course[course.len() - 1]);
        if let Some(parent) = parent {
            self.add_junction(self.river[parent], parent as u32);
            self.add_junction(first, first);
        }
        self.add_junction(first, source);
        for at in self.samples(course, parent) {
            self.courses.insert(at);
        }
    }

    fn add_junction(&mut self, river: u32, node: u32) {
        let last = std::mem::replace(&mut self.last_junction[river as usize], self.junctions.len() as u32);
        self.junctions.push((node, last));
    }

    /// Samples points along a course, half a distance between rivers apart at most.
    fn samples(&self, course: &[u32], parent: Option<usize>) -> Vec<Vec2> {
        let step = 0.5 * self.courses.apart;
        let mut samples = Vec::new();
        let mut below = parent;
        for &node in course {
            let to = self.tree.at[node as usize];
            let from = below.map_or(to, |below| self.tree.at[below]);
            let pieces = (distance(from, to) / step) as u32 + 1;
            samples.extend((1..=pieces).map(|piece| from.lerp(to, piece as f32 / pieces as f32)));
            below = Some(node as usize);
        }
        samples
    }
}

/// Points, sorted into squares of the plane.
struct Samples {
    /// The distance within which points count as near, in units.
    apart: f32,
    corner: Vec2,
    side: f32,
    columns: usize,
    rows: usize,
    /// The last point in each square; [`NO_PARENT`] if there is none.
    last: Vec<u32>,
    /// Points, each with the one before it in its square.
    points: Vec<(Vec2, u32)>,
}

impl Samples {
    /// Prepares for points between some places.
    fn new(places: &[Vec2], apart: f32) -> Self {
        let corner = places.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let size = places.iter().copied().fold(corner, Vec2::max) - corner;
        // No more squares than places, about, however near rivers may come to each other.
        let side = apart.max((size.x * size.y / places.len() as f32).sqrt()).max(f32::MIN_POSITIVE);
        let [columns, rows] = (size / side).to_array().map(|length| length as usize + 1);
        Self { apart, corner, side, columns, rows, last: vec![NO_PARENT; columns * rows], points: Vec::new() }
    }

    fn insert(&mut self, at: Vec2) {
        let (column, row) = self.square(at);
        let last = std::mem::replace(&mut self.last[row * self.columns + column], self.points.len() as u32);
        self.points.push((at, last));
    }

    /// Returns `true` if any of the points is near a place.
    fn has_near(&self, at: Vec2) -> bool {
        let ((left, top), (right, bottom)) = (self.square(at - self.apart), self.square(at + self.apart));
        (top..=bottom).any(|row| (left..=right).any(|column| self.holds_near(row * self.columns + column, at)))
    }

    fn holds_near(&self, square: usize, at: Vec2) -> bool {
        let mut next = self.last[square];
        while let Some(&(point, before)) = self.points.get(next as usize) {
            work::count(1);
            if distance(point, at) < self.apart {
                return true;
            }
            next = before;
        }
        false
    }

    /// Returns the column and row of the square that contains a place, or of the nearest one.
    fn square(&self, at: Vec2) -> (usize, usize) {
        let square = (at - self.corner) / self.side;
        ((square.x as usize).min(self.columns - 1), (square.y as usize).min(self.rows - 1))
    }
}
