//! The nearest other line.

use glam::Vec2;

use super::super::index::Index;
use crate::base::geometry::{direction, distance};

/// Other lines farther away than this do not count, in pixels.
const NEAR: f32 = 10.0;

/// Nor do places nearer than this to another line, in pixels: they are part of a junction.
const JUNCTION: f32 = 2.5;

/// The direction at a place is taken from this number of pixels before it to the same number after.
const AROUND: usize = 3;

/// Measures the mean of cos 2θ over all places of lines with another line 2.5 to 10 pixels away, where θ is the angle
/// between the directions of the line there and of the other one at its nearest place: 1 for parallel lines, 0 for any
/// directions, −1 for right angles. `None` if no lines are near each other.
pub(super) fn nearest_line(rivers: &[Vec<Vec2>]) -> Option<f64> {
    let (mut points, mut places) = (Vec::new(), Vec::new());
    for (number, line) in rivers.iter().enumerate() {
        points.extend_from_slice(line);
        places.extend((0..line.len()).map(|at| (number, heading(line, at))));
    }
    let index = Index::new(&points, NEAR);
    let (mut sum, mut count) = (0.0, 0);
    for (&at, &(own, towards)) in points.iter().zip(&places) {
        let (mut far, mut other) = (NEAR, Vec2::ZERO);
        for i in index.around(at, NEAR) {
            if places[i].0 != own && distance(at, points[i]) < far {
                (far, other) = (distance(at, points[i]), places[i].1);
            }
        }
        if (JUNCTION..NEAR).contains(&far) {
            let cosine = f64::from(towards.dot(other));
            sum += 2.0 * cosine * cosine - 1.0;
            count += 1;
        }
    }
    (count > 0).then(|| sum / f64::from(count))
}

fn heading(line: &[Vec2], at: usize) -> Vec2 {
    direction(line[(at + AROUND).min(line.len() - 1)] - line[at.saturating_sub(AROUND)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn line(from: Vec2, step: Vec2, count: usize) -> Vec<Vec2> {
        (0..count).map(|i| from + step * i as f32).collect()
    }

    #[test]
    fn parallels_count_as_one_and_combs_as_minus_one() {
        let stem = line(Vec2::ZERO, Vec2::X, 50);
        let beside = line(Vec2::new(0.0, 5.0), Vec2::X, 50);
        assert!((nearest_line(&[stem.clone(), beside]).unwrap() - 1.0).abs() < 1e-6);
        let teeth = (1..4).map(|i| line(Vec2::new(12.0 * i as f32, 0.0), Vec2::Y, 15));
        let comb: Vec<Vec<Vec2>> = teeth.chain([stem.clone()]).collect();
        assert!((nearest_line(&comb).unwrap() + 1.0).abs() < 1e-6);
        // Too far apart, or the same line.
        assert_eq!(nearest_line(&[stem.clone(), line(Vec2::new(0.0, 11.0), Vec2::X, 50)]), None);
        assert_eq!(nearest_line(&[stem]), None);
    }

    /// Measures how lines run beside each other by comparing all places with all others.
    fn twin(rivers: &[Vec<Vec2>]) -> Option<f64> {
        let mut all = Vec::new();
        for (own, at) in rivers.iter().enumerate().flat_map(|(i, line)| (0..line.len()).map(move |at| (i, at))) {
            let here = rivers[own][at];
            let others = rivers.iter().enumerate().filter(|(i, _)| *i != own);
            let places = others.flat_map(|(_, line)| (0..line.len()).map(move |at| (line, at)));
            let (line, other) =
                places.min_by(|a, b| here.distance(a.0[a.1]).total_cmp(&here.distance(b.0[b.1]))).unwrap();
            if !(JUNCTION..NEAR).contains(&here.distance(line[other])) {
                continue;
            }
            let cosine = heading(&rivers[own], at).dot(heading(line, other));
            all.push(f64::from(2.0 * cosine * cosine - 1.0));
        }
        (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64)
    }

    proptest! {
        #![proptest_config(cases(64))]

        #[test]
        fn it_is_that_of_all_places(lines in proptest::collection::vec((0f32..9.0, 0f32..9.0, -1f32..1.0, -1f32..1.0), 2..5)) {
            let rivers: Vec<_> = lines.iter().map(|&(x, y, dx, dy)| line(Vec2::new(x, y), Vec2::new(dx, dy), 6)).collect();
            let (found, expected) = (nearest_line(&rivers), twin(&rivers));
            prop_assert_eq!(found.is_some(), expected.is_some());
            prop_assert!((found.unwrap_or(0.0) - expected.unwrap_or(0.0)).abs() < 1e-4);
        }
    }
}
