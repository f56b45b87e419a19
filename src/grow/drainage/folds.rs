//! Folds of the bent plane: triangles that are turned over, and the edges that lie on them.
//!
//! Folds are few, so they are sorted by squares of the plane, and an edge is compared only with those near it.

use std::ops::Range;

use glam::Vec2;

use crate::base::geometry::{doubled_area, is_in_triangle, meet};
use crate::base::work;

/// The corners of a triangle.
pub(super) type Triangle = [Vec2; 3];

/// Returns `true` if a triangle is turned over: its corners do not run clockwise, with y down.
pub(super) fn is_turned_over(&[a, b, c]: &Triangle) -> bool {
    doubled_area(a, b, c) <= 0.0
}

/// Triangles by the squares of the plane that their bounding boxes touch.
pub(super) struct Folds {
    /// The north-western corner of the first square.
    origin: Vec2,
    /// The side of a square.
    side: f32,
    columns: usize,
    /// The last entry of each square, row by row; [`NONE`] if it has none.
    last: Vec<u32>,
    /// Triangles, each with the previous entry of its square.
    entries: Vec<(Triangle, u32)>,
}

/// Marks a missing entry.
const NONE: u32 = u32::MAX;

impl Folds {
    /// Sorts triangles. Their corners, and those of all edges in later queries, must be among `places`.
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
        let (columns, rows) = self.squares(a.min(b).min(c), a.max(b).max(c));
        for row in rows {
            for column in columns.clone() {
                let last = &mut self.last[row * self.columns + column];
                self.entries.push((triangle, std::mem::replace(last, self.entries.len() as u32)));
            }
        }
    }

    /// The columns and rows of the squares that the box between two corners touches.
    fn squares(&self, least: Vec2, most: Vec2) -> (Range<usize>, Range<usize>) {
        let square = |at: Vec2| ((at - self.origin) / self.side).to_array().map(|along| along as usize);
        let ([west, north], [east, south]) = (square(least), square(most));
        work::count((east - west + 1) * (south - north + 1));
        (west..east + 1, north..south + 1)
    }

    /// Returns `true` if an edge lies on one of the triangles.
    pub fn lie_under(&self, a: Vec2, b: Vec2) -> bool {
        let (least, most) = (a.min(b), a.max(b));
        let is_upon = |triangle: Triangle| {
            work::count(1);
            let [c, d, e] = triangle;
            let is_beside = most.cmplt(c.min(d).min(e)).any() || least.cmpgt(c.max(d).max(e)).any();
            !is_beside && is_upon((a, b), triangle)
        };
        let (columns, rows) = self.squares(least, most);
        for row in rows {
            for column in columns.clone() {
                let mut entry = self.last[row * self.columns + column];
                while let Some(&(triangle, before)) = self.entries.get(entry as usize) {
                    if is_upon(triangle) {
                        return true;
                    }
                    entry = before;
                }
            }
        }
        false
    }
}

/// Returns `true` if an edge lies on a triangle; one that only ends at a corner of it does not.
#[inline(never)] // inlined it would weigh a kilobyte
pub(super) fn is_upon((a, b): (Vec2, Vec2), [c, d, e]: Triangle) -> bool {
    let is_corner = |end: Vec2| end == c || end == d || end == e;
    let reaches_in = |end: Vec2| !is_corner(end) && is_in_triangle(end, c, d, e);
    let is_side = is_corner(a) && is_corner(b);
    let mut others = [(c, d), (d, e), (e, c)].into_iter().filter(|&(c, d)| a != c && a != d && b != c && b != d);
    is_side || reaches_in(a) || reaches_in(b) || others.any(|side| meet((a, b), side))
}
