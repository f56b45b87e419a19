//! Line simplification by the method of Visvalingam and Whyatt (1993): the least important point is removed first. A
//! point's importance is the area of the triangle that it forms with its neighbours.
//!
//! Areas can be compared across lines and keep their ratios when a drawing is stretched. Therefore any number of lines
//! can share one budget of points, whatever the shape of their domain.

mod areas;

use glam::Vec2;

use crate::base::geometry::fast_max;
use areas::Areas;

/// Marks a missing neighbour.
pub(crate) const NONE: u32 = u32::MAX;

/// Returns the importance of each point of a line: the area of its triangle, or that of a point removed before it if
/// greater. Dropping all points below a threshold simplifies the line. Infinite for points that are never removed: the
/// ends of an open line, and the last three points of a closed one. O(n log n).
pub(crate) fn significance(points: &[Vec2], is_closed: bool) -> Vec<f32> {
    let count = points.len() as u32;
    let end = |i: u32| if is_closed { i } else { NONE };
    let before = (0..count).map(|i| if i == 0 { end(count - 1) } else { i - 1 });
    let after = (0..count).map(|i| if i + 1 == count { end(0) } else { i + 1 });
    let places = points.iter().zip(before).zip(after).map(|((&at, before), after)| Place { at, before, after });
    let mut significance = vec![f32::INFINITY; points.len()];
    let fewest = if is_closed { 3 } else { 2 };
    Lines::new(places.collect(), area)
        .simplify(|lines, _| lines.left > fewest, |gone, area| significance[gone as usize] = area);
    significance
}

/// A point of a line and its remaining neighbours. A point without two of them stays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub at: Vec2,
    pub before: u32,
    pub after: u32,
}

/// Lines with the points that remain.
pub(crate) struct Lines {
    places: Vec<Place>,
    is_gone: Vec<bool>,
    left: usize,
    importance: Importance,
}

/// The importance of a point between its neighbours.
type Importance = fn([Vec2; 3]) -> f32;

/// Returns the area of a triangle.
fn area([a, b, c]: [Vec2; 3]) -> f32 {
    ((a - b).perp_dot(c - b) * 0.5).abs()
}

/// Returns the area of a triangle, less where the line turns back on itself: from half a right angle between the legs
/// down to nothing at 26°. So spikes go first, whatever their length (as in the weighted area of the program
/// Mapshaper).
pub(crate) fn area_unless_spike([a, b, c]: [Vec2; 3]) -> f32 {
    const BLUNT: f32 = 0.7;
    const SHARP: f32 = 0.9;
    let (back, on) = (a - b, c - b);
    let cosine = back.dot(on) / (back.length_squared() * on.length_squared()).sqrt();
    // Not a number where two points coincide: then the area is 0.
    let share = if cosine > BLUNT { fast_max((SHARP - cosine) / (SHARP - BLUNT), 0.0) } else { 1.0 };
    area([a, b, c]) * share
}

impl Lines {
    pub fn new(places: Vec<Place>, importance: Importance) -> Self {
        Self { is_gone: vec![false; places.len()], left: places.len(), places, importance }
    }

    /// Removes one point after the other, the least important first, as long as `may_go` allows. A refused point is tried
    /// again once one of its neighbours has been removed. What is passed to `tell`, with each point, never decreases.
    pub fn simplify(mut self, mut may_go: impl FnMut(&Self, [u32; 3]) -> bool, mut tell: impl FnMut(u32, f32)) {
        let mut queue = Areas::with_room_for(self.places.len());
        let mut highest = 0.0;
        (0..self.places.len() as u32).for_each(|i| self.enter(i, &mut queue));
        while let Some((importance, i)) = queue.pop() {
            // An entry is out of date if its point has been removed or its neighbours have changed.
            let Some(triangle) =
                self.triangle(i).filter(|triangle| self.importance_of(triangle).to_bits() == importance.to_bits())
            else {
                continue;
            };
            if may_go(&self, triangle) {
                highest = fast_max(highest, importance);
                tell(i, highest);
                let neighbours = self.unlink(triangle);
                neighbours.into_iter().for_each(|i| self.enter(i, &mut queue));
            }
        }
    }

    pub fn is_gone(&self, i: u32) -> bool {
        self.is_gone[i as usize]
    }

    /// Returns the position of point `i`.
    pub fn at(&self, i: u32) -> Vec2 {
        self.places[i as usize].at
    }

    /// Returns point `i` between its neighbours; `None` if one of them is missing.
    fn triangle(&self, i: u32) -> Option<[u32; 3]> {
        let Place { before, after, .. } = self.places[i as usize];
        (before != NONE && after != NONE).then_some([before, i, after])
    }

    fn importance_of(&self, triangle: &[u32; 3]) -> f32 {
        (self.importance)(triangle.map(|i| self.at(i)))
    }

    fn enter(&self, i: u32, queue: &mut Areas) {
        if let Some(triangle) = self.triangle(i) {
            queue.push(self.importance_of(&triangle), i);
        }
    }

    fn unlink(&mut self, [before, i, after]: [u32; 3]) -> [u32; 2] {
        self.places[before as usize].after = after;
        // The point after a tributary's last point belongs to the river that it joins, and has neighbours there.
        if self.places[after as usize].before == i {
            self.places[after as usize].before = before;
        }
        self.places[i as usize].before = NONE;
        self.is_gone[i as usize] = true;
        self.left -= 1;
        [before, after]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn kept(points: &[Vec2], is_closed: bool, least: f32) -> Vec<Vec2> {
        let areas = significance(points, is_closed);
        points.iter().zip(areas).filter(|(_, area)| *area >= least).map(|(point, _)| *point).collect()
    }

    #[test]
    fn corners_stay_and_what_lies_on_a_side_goes() {
        let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        let dense: Vec<Vec2> =
            (0..40).map(|i| corners[i / 10].lerp(corners[(i / 10 + 1) % 4], (i % 10) as f32 / 10.0)).collect();
        assert_eq!(kept(&dense, true, 1e-6), corners);
        assert_eq!(kept(&dense[..11], false, 1e-6), [Vec2::ZERO, Vec2::X]);
    }

    #[test]
    fn spikes_count_for_less_than_elbows_of_the_same_area() {
        let at = |angle: f32| area_unless_spike([Vec2::X, Vec2::ZERO, Vec2::new(libm::cosf(angle), libm::sinf(angle))]);
        let whole = |angle: f32| 0.5 * libm::sinf(angle);
        for blunt in [0.8, 1.2, 1.6, 2.4, 3.0] {
            assert_eq!(at(blunt), whole(blunt).abs(), "{blunt}");
        }
        assert!(at(0.6) < 0.7 * whole(0.6) && at(0.6) > 0.0 && at(0.4) == 0.0);
        assert_eq!(area_unless_spike([Vec2::ONE; 3]), 0.0);
    }

    #[test]
    fn short_lines_are_left_alone() {
        for count in 0..3 {
            let points = vec![Vec2::ONE; count];
            assert!(significance(&points, true).iter().all(|area| area.is_infinite()));
            assert!(significance(&points, false).iter().all(|area| area.is_infinite()));
        }
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn fewest_points_and_ends_never_go(xs in proptest::collection::vec((0f32..1.0, 0f32..1.0), 3..60)) {
            let points: Vec<Vec2> = xs.into_iter().map(Vec2::from).collect();
            let open = significance(&points, false);
            prop_assert!(open[0].is_infinite() && open[points.len() - 1].is_infinite());
            for (areas, fewest) in [(open, 2), (significance(&points, true), 3)] {
                prop_assert_eq!(areas.iter().filter(|area| area.is_infinite()).count(), fewest);
                prop_assert!(areas.iter().all(|&area| area >= 0.0));
            }
        }
    }
}
