//! Turns: by how much a line changes its direction within a short way.

use glam::Vec2;

use crate::base::geometry::{fast_max, lengths};

/// Returns for each point of a line the greatest turn that it is part of, in radians: the angle between the directions of
/// the line before one of its corners and after another, which lie at most `within` units apart along it and have
/// the point between them or are it. A full circle counts as 2π.
pub(crate) fn greatest_turns(line: &[Vec2], within: f32) -> Vec<f32> {
    let (along, headings) = (lengths(line), headings(line));
    let mut turns = vec![0.0; line.len()];
    for first in 1..headings.len() {
        let last = (first..headings.len()).take_while(|&last| along[last] - along[first] <= within).last();
        let mut greatest = 0.0;
        for last in (first..=last.unwrap_or(first)).rev() {
            greatest = fast_max(greatest, (headings[last] - headings[first - 1]).abs());
            turns[last] = fast_max(turns[last], greatest);
        }
    }
    turns
}

/// Returns the direction of each piece of a line, in radians from that of the first: each is the one before and the turn
/// between, so that what winds around is over π.
fn headings(line: &[Vec2]) -> Vec<f32> {
    let mut heading = 0.0;
    let mut before: Option<Vec2> = None;
    let pieces = line.windows(2).map(|pair| pair[1] - pair[0]);
    pieces
        .map(|piece| {
            let from = before.replace(piece).unwrap_or(piece);
            heading += libm::atan2f(from.perp_dot(piece), from.dot(piece));
            heading
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::samples::sine_generated;
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;
    use std::f32::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_hairpin_is_a_turn_of_half_a_circle_for_all_between_its_corners() {
        let line = [(0.0, 0.0), (5.0, 0.0), (10.0, 0.0), (10.0, 4.0), (5.0, 4.0), (0.0, 4.0)].map(Vec2::from);
        let turns = greatest_turns(&line, 4.0);
        assert!(
            turns.iter().zip([0.0, 0.0, PI, PI, 0.0, 0.0]).all(|(turn, asked)| (turn - asked).abs() < 1e-5),
            "{turns:?}"
        );
        let turns = greatest_turns(&line, 3.9);
        assert!(turns[2..4].iter().all(|turn| (turn - FRAC_PI_2).abs() < 1e-5), "one corner alone: {turns:?}");
    }

    #[test]
    fn no_points_and_points_that_coincide_turn_nowhere() {
        assert!(greatest_turns(&[], 1.0).is_empty());
        assert_eq!(greatest_turns(&[Vec2::ONE; 3], 1.0), [0.0; 3]);
    }

    proptest! {
        #![proptest_config(cases(32))]

        #[test]
        fn they_are_those_of_all_pairs_of_corners(omega in 0.2f32..2.0, within in 0.5f32..30.0) {
            let line = sine_generated(omega, 20.0, 2, 20);
            let (along, headings) = (lengths(&line), headings(&line));
            for (point, turn) in greatest_turns(&line, within).into_iter().enumerate() {
                let pairs = (1..=point).flat_map(|first| (point..headings.len()).map(move |last| (first, last)));
                let near = pairs.filter(|&(first, last)| along[last] - along[first] <= within);
                let all = near.map(|(first, last)| (headings[last] - headings[first - 1]).abs());
                prop_assert_eq!(turn, all.fold(0.0, f32::max));
            }
        }
    }
}
