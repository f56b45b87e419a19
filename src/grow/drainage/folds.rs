//! Folds of the bent plane: triangles that are turned over, and which edges lie upon one.
//!
//! There are few, so they are sorted by squares of the plane, and an edge is compared with those near it alone.

use glam::Vec2;

use crate::geometry::{doubled_area, is_in_triangle, meet};
use crate::work;

/// The corners of a triangle.
pub(super) type Triangle = [Vec2; 3];

/// Whether a triangle is turned over: its corners do not run clockwise, with y down.
pub(super) fn is_turned_over(&[a, b, c]: &Triangle) -> bool {
    doubled_area(a, b, c) <= 0.0
}

/// Triangles by the squares of the plane that the boxes around them touch.
pub(super) struct Folds {
    /// The north-western corner of the first square.
    origin: Vec2,
    /// The side of a square.
    side: f32,
    columns: usize,
    /// Of each square, row by row, its last entry; [`NONE`] if it has none.
    last: Vec<u32>,
    /// Triangles, each with the entry of its square before it.
    entries: Vec<(Triangle, u32)>,
}

/// No entry.
const NONE: u32 = u32::MAX;

impl Folds {
    /// Sorts triangles whose corners, and those of all edges that will be asked for, are among some places.
    pub fn new(triangles: &[Triangle], places: &[Vec2]) -> Self {
        let origin = places.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let far = places.iter().copied().fold(origin, Vec2::max) - origin;
        // About as many squares as places.
        let side = (far.x * far.y / places.len() as f32).sqrt();
        let [columns, rows] = (far / side).to_array().map(|length| length as usize + 1);
        let last = vec![NONE; columns * rows];
        let mut this = Self { origin, side, columns, last, entries: Vec::new() };
        triangles.iter().for_each(|&triangle| this.insert(triangle));
        this
    }

    fn insert(&mut self, triangle: Triangle) {
        let [a, b, c] = triangle;
        for square in self.squares(a.min(b).min(c), a.max(b).max(c)) {
            let before = std::mem::replace(&mut self.last[square], self.entries.len() as u32);
            self.entries.push((triangle, before));
        }
    }

    /// The squares that the box between two corners touches.
    fn squares(&self, least: Vec2, most: Vec2) -> impl Iterator<Item = usize> + use<> {
        let square = |at: Vec2| ((at - self.origin) / self.side).to_array().map(|along| along as usize);
        let ([west, north], [east, south], columns) = (square(least), square(most), self.columns);
        work::count((east - west + 1) * (south - north + 1));
        (north..=south).flat_map(move |row| (west..=east).map(move |column| row * columns + column))
    }

    /// Whether an edge lies upon one of the triangles.
    pub fn lie_under(&self, a: Vec2, b: Vec2) -> bool {
        let (least, most) = (a.min(b), a.max(b));
        let is_upon = |&triangle: &Triangle| {
            work::count(1);
            let [c, d, e] = triangle;
            let is_beside = most.cmplt(c.min(d).min(e)).any() || least.cmpgt(c.max(d).max(e)).any();
            !is_beside && is_upon((a, b), triangle)
        };
        self.squares(least, most).any(|square| self.triangles(square).any(is_upon))
    }

    /// The triangles of a square.
    fn triangles(&self, square: usize) -> impl Iterator<Item = &Triangle> {
        let entry = |i: u32| self.entries.get(i as usize);
        std::iter::successors(entry(self.last[square]), move |(_, before)| entry(*before)).map(|(triangle, _)| triangle)
    }
}

/// Whether an edge lies upon a triangle; one that only ends at a corner of it does not.
#[inline(never)] // inlined it would weigh a kilobyte
pub(super) fn is_upon((a, b): (Vec2, Vec2), [c, d, e]: Triangle) -> bool {
    let is_corner = |end: Vec2| end == c || end == d || end == e;
    let reaches_in = |end: Vec2| !is_corner(end) && is_in_triangle(end, c, d, e);
    let is_side = is_corner(a) && is_corner(b);
    let mut others = [(c, d), (d, e), (e, c)].into_iter().filter(|&(c, d)| a != c && a != d && b != c && b != d);
    is_side || reaches_in(a) || reaches_in(b) || others.any(|side| meet((a, b), side))
}
