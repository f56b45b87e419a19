//! The grain of a piece: how much the directions of its lines have in common.

use glam::Vec2;

use super::lines::smoothed;
use crate::base::geometry::length;

/// Directions are those of chords of this length, in pixels: wiggles are none.
const CHORD: usize = 10;

/// Measures |mean e^(2iθ)| over the directions θ of all chords between junctions: 0 for lines that run in all
/// directions alike, 1 for parallel ones. `None` without chords.
pub(super) fn anisotropy(chains: &[Vec<Vec2>]) -> Option<f64> {
    let (mut cosine, mut sine, mut total) = (0.0, 0.0, 0.0);
    for chain in chains {
        let line = smoothed(chain);
        for i in CHORD..line.len() {
            let chord = line[i] - line[i - CHORD];
            let long = length(chord).max(f32::MIN_POSITIVE);
            cosine += f64::from((chord.x * chord.x - chord.y * chord.y) / long);
            sine += f64::from(2.0 * chord.x * chord.y / long);
            total += f64::from(long);
        }
    }
    (total > 0.0).then(|| (cosine * cosine + sine * sine).sqrt() / total)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(x: f32, y: f32) -> Vec<Vec2> {
        vec![Vec2::ZERO, Vec2::new(x, y)]
    }

    #[test]
    fn parallel_lines_have_all_directions_in_common_and_those_at_right_angles_none() {
        let of = |lines: &[Vec<Vec2>]| anisotropy(lines).unwrap();
        assert!((of(&[line(40.0, 0.0), line(-50.0, 0.0)]) - 1.0).abs() < 1e-5);
        assert!(of(&[line(40.0, 0.0), line(0.0, 40.0)]) < 1e-5);
        // Of 31 + 11 chords, the 11 undo as many of the others.
        assert!((of(&[line(40.5, 0.0), line(0.0, 20.5)]) - 20.0 / 42.0).abs() < 1e-4);
        assert_eq!(anisotropy(&[line(9.0, 0.0)]), None);
    }
}
