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

/// The turns of all lines of a piece.
#[derive(Default)]
pub(super) struct Turns {
    /// The sums of the first four powers of all turns.
    powers: [f64; 4],
    count: usize,
    /// The sum of products of turns 8 pixels apart along the same line.
    products: f64,
    pairs: usize,
}

impl Turns {
    /// Reads lines whose points are a pixel apart.
    pub fn of(rivers: &[Vec<Vec2>]) -> Self {
        let mut this = Self::default();
        for river in rivers {
            let turns = turns(river);
            for (i, &turn) in turns.iter().enumerate() {
                let mut power = 1.0;
                for sum in &mut this.powers {
                    power *= turn;
                    *sum += power;
                }
                if i >= LAG {
                    this.products += turn * turns[i - LAG];
                    this.pairs += 1;
                }
            }
            this.count += turns.len();
        }
        this
    }

    /// Returns the kurtosis of turns: 3 for turns that deviate normally, higher where straight reaches change with
    /// elbows. `None` for fewer than 20 turns.
    pub fn kurtosis(&self) -> Option<f64> {
        let [mean, second, third, fourth] = self.powers.map(|sum| sum / self.count as f64);
        let squared = mean * mean;
        let variance = second - squared;
        let moment = fourth - 4.0 * mean * third + 6.0 * squared * second - 3.0 * squared * squared;
        (self.count >= LEAST && variance > 0.0).then(|| moment / (variance * variance))
    }

    /// Measures how turns go with those 8 pixels farther along the same line: −1 if each is undone, 0 if they have
    /// nothing to do with each other, 1 in a circle. `None` for fewer than 20 pairs.
    pub fn autocorrelation(&self) -> Option<f64> {
        let mean_square = self.powers[1] / self.count as f64;
        (self.pairs >= LEAST && mean_square > 0.0).then(|| self.products / self.pairs as f64 / mean_square)
    }
}

/// Returns the turns of a line whose points are a pixel apart, in radians.
fn turns(line: &[Vec2]) -> Vec<f64> {
    let chord = |i: usize| line[i + CHORD] - line[i];
    let turn = |i: usize| libm::atan2f(chord(i).perp_dot(chord(i + APART)), chord(i).dot(chord(i + APART))).into();
    (0..line.len().saturating_sub(CHORD + APART)).map(turn).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a gently winding line of 500 pixels with bends of this length.
    fn winding(length: f32) -> Vec<Vec<Vec2>> {
        let at = |i: i32| Vec2::new(i as f32, 0.2 * libm::sinf(std::f32::consts::TAU * i as f32 / length));
        vec![(0..500).map(at).collect()]
    }

    #[test]
    fn regular_bends_undo_each_other_or_repeat() {
        for (length, expected) in [(16.0, -1.0), (32.0, 0.0), (48.0, 0.5)] {
            let found = Turns::of(&winding(length)).autocorrelation().unwrap();
            assert!((found - expected).abs() < 0.05, "{length}: {found}");
            // Sines have this kurtosis.
            let found = Turns::of(&winding(length)).kurtosis().unwrap();
            assert!((found - 1.5).abs() < 0.05, "{length}: {found}");
        }
    }

    #[test]
    fn straight_reaches_between_elbows_have_a_high_kurtosis() {
        let east = (0..50).map(|i| Vec2::new(i as f32, 0.0));
        let line: Vec<Vec2> = east.chain((0..50).map(|i| Vec2::new(50.0, i as f32))).collect();
        assert!(Turns::of(&[line]).kurtosis().unwrap() > 6.0);
    }

    #[test]
    fn a_few_turns_say_nothing() {
        let short: Vec<Vec2> = (0..20).map(|i| Vec2::new(i as f32, (i % 2) as f32)).collect();
        let turns = Turns::of(&[short]);
        assert_eq!((turns.kurtosis(), turns.autocorrelation()), (None, None));
    }
}
