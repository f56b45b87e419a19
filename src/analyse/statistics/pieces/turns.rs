//! Turns along lines.

use glam::Vec2;

/// The direction at a place is that of a chord of this length around it, in pixels.
const CHORD: usize = 8;

/// A turn is the angle between the directions at two places this far apart, in pixels.
const APART: usize = 4;

/// Turns this far apart are compared, in pixels.
const LAG: usize = 8;

/// The fewest turns that say something.
const LEAST: usize = 20;

/// Measures the kurtosis of turns: 3 for turns that deviate normally, higher where straight reaches change with
/// elbows. `None` for fewer than 20 turns.
pub(super) fn kurtosis(rivers: &[Vec<Vec2>]) -> Option<f64> {
    let turns: Vec<f64> = rivers.iter().flat_map(|river| turns(river)).collect();
    let count = turns.len() as f64;
    let mean = turns.iter().sum::<f64>() / count;
    let squares = || turns.iter().map(|turn| (turn - mean) * (turn - mean));
    let variance = squares().sum::<f64>() / count;
    let fourth = squares().map(|square| square * square).sum::<f64>() / count;
    (turns.len() >= LEAST && variance > 0.0).then(|| fourth / (variance * variance))
}

/// Measures how turns go with those 8 pixels farther along the same line: −1 if each is undone, 0 if they have nothing
/// to do with each other, 1 in a circle. `None` for fewer than 20 pairs.
pub(super) fn autocorrelation(rivers: &[Vec<Vec2>]) -> Option<f64> {
    let (mut products, mut pairs, mut squares, mut count) = (0.0, 0, 0.0, 0);
    for turns in rivers.iter().map(|river| turns(river)) {
        products += turns.iter().zip(turns.iter().skip(LAG)).map(|(turn, other)| turn * other).sum::<f64>();
        pairs += turns.len().saturating_sub(LAG);
        squares += turns.iter().map(|turn| turn * turn).sum::<f64>();
        count += turns.len();
    }
    (pairs >= LEAST && squares > 0.0).then(|| products / pairs as f64 / (squares / count as f64))
}

/// The turns of a line whose points are a pixel apart, in radians.
fn turns(line: &[Vec2]) -> Vec<f64> {
    let chords: Vec<Vec2> = line.iter().zip(line.iter().skip(CHORD)).map(|(from, to)| *to - *from).collect();
    let turn = |(a, b): (&Vec2, &Vec2)| libm::atan2f(a.perp_dot(*b), a.dot(*b)).into();
    chords.iter().zip(chords.iter().skip(APART)).map(turn).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gently winding line of 500 pixels with bends of this length.
    fn winding(length: f32) -> Vec<Vec<Vec2>> {
        let at = |i: i32| Vec2::new(i as f32, 0.2 * libm::sinf(std::f32::consts::TAU * i as f32 / length));
        vec![(0..500).map(at).collect()]
    }

    #[test]
    fn regular_bends_undo_each_other_or_repeat() {
        for (length, expected) in [(16.0, -1.0), (32.0, 0.0), (48.0, 0.5)] {
            let found = autocorrelation(&winding(length)).unwrap();
            assert!((found - expected).abs() < 0.05, "{length}: {found}");
            // Sines have this kurtosis.
            let found = kurtosis(&winding(length)).unwrap();
            assert!((found - 1.5).abs() < 0.05, "{length}: {found}");
        }
    }

    #[test]
    fn straight_reaches_between_elbows_have_a_high_kurtosis() {
        let east = (0..50).map(|i| Vec2::new(i as f32, 0.0));
        let line: Vec<Vec2> = east.chain((0..50).map(|i| Vec2::new(50.0, i as f32))).collect();
        assert!(kurtosis(&[line]).unwrap() > 6.0);
    }

    #[test]
    fn a_few_turns_say_nothing() {
        let short: Vec<Vec2> = (0..20).map(|i| Vec2::new(i as f32, (i % 2) as f32)).collect();
        assert_eq!((kurtosis(std::slice::from_ref(&short)), autocorrelation(&[short])), (None, None));
    }
}
