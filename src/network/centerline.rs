//! The centerlines of rivers and lakes, for painting and files: the line midway between the banks, and how far those are from it.

use glam::Vec2;

use super::{Banks, NONE, Network, Oxbow, Place, River, Vertex};
use crate::base::geometry::direction;
use crate::recipe::CourseShape;

/// The distance by which a river runs beyond its last vertex into the sea, in widths. A round end adds another half.
const PAST_SHORE: f32 = 0.1;

impl Network {
    /// Returns the centerline of a river from its source to its end: in the middle of the river that it joins, no wider
    /// than above; or past the shore.
    pub fn middle(&self, river: &River) -> Vec<Place> {
        middle(&self.course(river).collect::<Vec<_>>(), river.junction != NONE)
    }

    /// Makes the banks of a river, from its source to its end. In a drawn network with smooth courses, both together
    /// are a valid polygon.
    pub fn banks(&self, river: &River, courses: CourseShape) -> Banks {
        Banks::of_line(&self.middle(river), courses)
    }
}

/// Returns the centerline of a course, which ends past the shore unless it is that of a tributary.
pub(super) fn middle(course: &[&Vertex], is_tributary: bool) -> Vec<Place> {
    let last = course.len().wrapping_sub(1);
    let place = |(i, vertex): (usize, &&Vertex)| {
        let banks = if is_tributary && i == last { course[i.saturating_sub(1)] } else { vertex };
        between(vertex.at, banks, tangent(course, i))
    };
    let mut line: Vec<Place> = course.iter().enumerate().map(place).collect();
    if let Some(&mouth) = line.last().filter(|_| !is_tributary) {
        line.push(Place { at: mouth.at + tangent(course, last) * (2.0 * mouth.half * PAST_SHORE), ..mouth });
    }
    line
}

impl Oxbow {
    /// Returns the centerline of the part of the lake that is still water; empty if silt has filled it all.
    pub fn middle(&self) -> Vec<Place> {
        let lake = self.lake();
        let course: Vec<&Vertex> = lake.iter().map(|(vertex, _)| vertex).collect();
        let open = lake.iter().map(|(_, share)| share);
        bed(&course).into_iter().zip(open).map(|(place, share)| Place { half: place.half * share, ..place }).collect()
    }

    /// Returns the centerline of the river that ran here, with its full width, which is 0 where other rivers have run over it.
    pub(super) fn bed(&self) -> Vec<Place> {
        bed(&self.vertices.iter().collect::<Vec<_>>())
    }
}

/// Returns the centerline of a part of a course.
fn bed(course: &[&Vertex]) -> Vec<Place> {
    course.iter().enumerate().map(|(i, vertex)| between(vertex.at, vertex, tangent(course, i))).collect()
}

fn between(at: Vec2, banks: &Vertex, tangent: Vec2) -> Place {
    // `perp` points to the right of someone who looks along the tangent, as y runs down.
    Place { at: at + tangent.perp() * ((banks.right - banks.left) * 0.5), half: banks.width() * 0.5 }
}

fn tangent(course: &[&Vertex], i: usize) -> Vec2 {
    direction(course[(i + 1).min(course.len() - 1)].at - course[i.saturating_sub(1)].at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn middle_lies_toward_the_farther_bank_and_runs_past_the_shore() {
        let vertex = |x: f32| Vertex { at: Vec2::new(x, 0.0), left: 1.0, right: 3.0, ..Vertex::default() };
        let river = River { start: 0, end: 3, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: 0 };
        let network = Network { vertices: [0.0, 10.0, 20.0].map(vertex).into(), rivers: vec![river], oxbows: vec![] };
        let line = network.middle(&river);
        assert_eq!(line[1], Place { at: Vec2::new(10.0, 1.0), half: 2.0 });
        assert_eq!(line[3].at, Vec2::new(20.4, 1.0));
    }
}
