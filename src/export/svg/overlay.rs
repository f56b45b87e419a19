//! Lines and areas that a page lays over a picture, as path data in units.

use glam::Vec2;

use super::path::Path;
use crate::recipe::CourseShape;

/// Draws lines like rivers: smooth, or along the tree's straight steps.
pub fn lines(lines: &[Vec<Vec2>], courses: CourseShape) -> String {
    let mut path = Path::default();
    for points in lines {
        if courses == CourseShape::Grown {
            path.line(points);
        } else if let [first, ..] = points[..] {
            path.start(first);
            path.smooth(points);
        }
    }
    path.data().to_owned()
}

/// Draws the area within some rings, with smooth borders.
pub fn area(rings: &[Vec<Vec2>]) -> String {
    let mut path = Path::default();
    rings.iter().filter(|ring| ring.len() > 2).for_each(|ring| path.ring(ring));
    path.data().to_owned()
}
