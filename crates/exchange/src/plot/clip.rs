//! Lines cut off at a frame: in geometry, since machines that follow lines know no clip paths.

use riverseed::glam::DVec2;

/// Returns the parts of a line within a frame, given by its least and its greatest corner. A ring, whose last point is its
/// first, is one part if all of it is within.
pub fn clipped(line: &[DVec2], frame: [DVec2; 2]) -> Vec<Vec<DVec2>> {
    let mut parts: Vec<Vec<DVec2>> = Vec::new();
    // The end of the line so far, if it is within.
    let mut end = None;
    for side in line.windows(2) {
        let within = within([side[0], side[1]], frame);
        if let Some([from, to]) = within {
            match parts.last_mut().filter(|_| end == Some(from)) {
                Some(part) => part.push(to),
                None => parts.push(vec![from, to]),
            }
        }
        end = within.map(|[_, to]| to).filter(|to| *to == side[1]);
    }
    join_ends(line, &mut parts);
    parts
}

/// Joins the last part of a ring with the first one, if the ring's beginning is within.
fn join_ends(line: &[DVec2], parts: &mut Vec<Vec<DVec2>>) {
    let is_ring = line.first() == line.last();
    let meet = |parts: &[Vec<DVec2>]| parts.len() > 1 && parts[0].first() == parts[parts.len() - 1].last();
    if is_ring && meet(parts) {
        let first = parts.remove(0);
        if let Some(last) = parts.last_mut() {
            last.extend(&first[1..]);
        }
    }
}

/// Returns the part of a side within a frame (Liang and Barsky 1984, ACM Transactions on Graphics 3, 1-22); `None` if there
/// is none. An end that is within stays as it is.
fn within([from, to]: [DVec2; 2], [least, most]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    let (way, mut start, mut end) = (to - from, 0.0f64, 1.0f64);
    for axis in 0..2 {
        for (toward, room) in [(-way[axis], from[axis] - least[axis]), (way[axis], most[axis] - from[axis])] {
            if toward < 0.0 {
                start = start.max(room / toward);
            } else if toward > 0.0 {
                end = end.min(room / toward);
            } else if room < 0.0 {
                return None;
            }
        }
    }
    let at = |share: f64| (from + way * share).clamp(least, most);
    (start <= end).then(|| [if start > 0.0 { at(start) } else { from }, if end < 1.0 { at(end) } else { to }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FRAME: [DVec2; 2] = [DVec2::new(0.0, 0.0), DVec2::new(10.0, 6.0)];

    fn line(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().copied().map(DVec2::from).collect()
    }

    fn is_within(at: DVec2) -> bool {
        at.cmpge(FRAME[0]).all() && at.cmple(FRAME[1]).all()
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_is_two() {
        let parts = clipped(&line(&[(2.0, 3.0), (8.0, 3.0), (14.0, 3.0), (14.0, 5.0), (6.0, 5.0)]), FRAME);
        assert_eq!(parts, [line(&[(2.0, 3.0), (8.0, 3.0), (10.0, 3.0)]), line(&[(10.0, 5.0), (6.0, 5.0)])]);
        assert!(clipped(&line(&[(-4.0, 1.0), (-1.0, 9.0)]), FRAME).is_empty());
    }

    #[test]
    fn a_ring_within_stays_a_ring_and_one_that_leaves_begins_where_it_comes_back() {
        let ring = line(&[(2.0, 2.0), (8.0, 2.0), (8.0, 4.0), (2.0, 2.0)]);
        assert_eq!(clipped(&ring, FRAME), [ring]);
        let leaves = line(&[(8.0, 2.0), (12.0, 2.0), (12.0, 4.0), (8.0, 4.0), (8.0, 2.0)]);
        assert_eq!(clipped(&leaves, FRAME), [line(&[(10.0, 4.0), (8.0, 4.0), (8.0, 2.0), (10.0, 2.0)])]);
    }

    proptest! {
        #[test]
        fn parts_are_all_of_a_line_that_is_within(points in prop::collection::vec((-5.0..15.0f64, -5.0..11.0f64), 2..9)) {
            let line = line(&points);
            let parts = clipped(&line, FRAME);
            prop_assert!(parts.iter().flatten().all(|at| is_within(*at)));
            let length = |line: &[DVec2]| line.windows(2).map(|side| side[0].distance(side[1])).sum::<f64>();
            // A thousand pieces of each side, counted where they are within.
            const PIECES: i32 = 1000;
            let expected: f64 = line.windows(2).map(|side| {
                let middle = |i| side[0].lerp(side[1], (f64::from(i) + 0.5) / f64::from(PIECES));
                let count = (0..PIECES).filter(|i| is_within(middle(*i))).count();
                side[0].distance(side[1]) * count as f64 / f64::from(PIECES)
            }).sum();
            let found: f64 = parts.iter().map(|part| length(part)).sum();
            prop_assert!((found - expected).abs() < 0.05 * line.len() as f64, "{found} {expected}");
        }
    }
}
