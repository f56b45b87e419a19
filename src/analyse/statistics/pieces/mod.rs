//! Pieces of river networks as an eye sees them: lines of one pixel in a square of 100, real or drawn. The world's
//! rivers are only known like that, so a map's rivers are drawn as densely as those and measured by the same code.

mod drawing;
mod gaps;
mod grain;
mod lines;
mod nearest;
mod turns;

use glam::Vec2;

use super::fit;
use crate::network::Network;
use lines::Lines;

/// Side of a piece, in pixels.
pub const SIDE: usize = 100;

/// The mean distance of lines on the world's maps, in pixels: the area of a piece over the length of its lines.
const LINE_SPACING: f32 = 16.0;

/// The measures of pieces. A measure is `None` if there is too little of what it measures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Look {
    /// The length of line per junction, over the mean distance of lines.
    pub junction_spacing: Option<f64>,
    /// The mean cosine of twice the angle between a line and the nearest other one.
    pub nearest_line: Option<f64>,
    /// The kurtosis of turns over 4 pixels.
    pub turn_kurtosis: Option<f64>,
    /// The correlation of turns 8 pixels apart.
    pub turn_autocorrelation: Option<f64>,
    /// The variation of distances from the nearest line: standard deviation over mean.
    pub gap_variation: Option<f64>,
    /// The degree to which directions agree: |mean e^(2iθ)|.
    pub anisotropy: Option<f64>,
}

impl Look {
    /// Measures a piece, given by 100 rows of 100 pixels that are not 0 on lines. `None` if rivers do not cover it well:
    /// it has less than 220 or more than 1,400 pixels of them, less than 25 in a quarter, fewer than two junctions, or
    /// an empty disc of more than 27 pixels' radius. The world's pieces were chosen by the same rules.
    ///
    /// # Panics
    /// Panics if these are not 10,000 pixels.
    pub fn of_piece(pixels: &[u8]) -> Option<Self> {
        assert_eq!(pixels.len(), SIDE * SIDE, "a piece has 100 x 100 pixels");
        let gaps = gaps::Gaps::of(pixels);
        let lines = Lines::of(pixels, SIDE);
        if !has_enough(pixels) || lines.junctions.len() < 2 || gaps.largest_disc > 27.0 {
            return None;
        }
        let rivers = lines.rivers();
        let turns = turns::Turns::of(&rivers);
        Some(Self {
            junction_spacing: Some(junction_spacing(&lines)),
            nearest_line: nearest::nearest_line(&rivers),
            turn_kurtosis: turns.kurtosis(),
            turn_autocorrelation: turns.autocorrelation(),
            gap_variation: Some(gaps.variation),
            anisotropy: grain::anisotropy(&lines.chains),
        })
    }

    /// Sums up pieces by medians; what has to do with turns and neighbours, by means.
    pub fn typical(pieces: &[Self]) -> Self {
        let median = |of: fn(&Self) -> Option<f64>| fit::median_of(&known(pieces, of));
        let mean = |of: fn(&Self) -> Option<f64>| fit::mean(&known(pieces, of));
        Self {
            junction_spacing: median(|piece| piece.junction_spacing),
            nearest_line: mean(|piece| piece.nearest_line),
            turn_kurtosis: mean(|piece| piece.turn_kurtosis),
            turn_autocorrelation: mean(|piece| piece.turn_autocorrelation),
            gap_variation: median(|piece| piece.gap_variation),
            anisotropy: median(|piece| piece.anisotropy),
        }
    }

    /// Measures the pieces of a network in a rectangle of this size, drawn so that its lines are as dense as those of
    /// the world's maps. `density` is the length of river per area of land, in 1/unit.
    pub fn all(network: &Network, size: Vec2, density: f32) -> Vec<Self> {
        drawing::pieces(network, size, LINE_SPACING * density)
            .iter()
            .filter_map(|piece| Self::of_piece(piece))
            .collect()
    }
}

#[inline(never)] // it has six callers
fn known(pieces: &[Look], of: fn(&Look) -> Option<f64>) -> Vec<f64> {
    pieces.iter().filter_map(of).collect()
}

/// Returns `true` if there is enough river, everywhere.
fn has_enough(pixels: &[u8]) -> bool {
    const HALF: usize = SIDE / 2;
    let mut quarters = [0; 4];
    for i in (0..pixels.len()).filter(|&i| pixels[i] != 0) {
        quarters[2 * usize::from(i / SIDE >= HALF) + usize::from(i % SIDE >= HALF)] += 1;
    }
    (220..=1400).contains(&quarters.iter().sum::<i32>()) && quarters.iter().all(|&count| count >= 25)
}

fn junction_spacing(lines: &Lines) -> f64 {
    let length = lines.chains.iter().map(|chain| lines::length(chain)).sum::<f64>();
    length * length / (lines.junctions.len() * SIDE * SIDE) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five lines across and four down.
    fn grid() -> Vec<u8> {
        let is_line = |i: usize| i % SIDE % 25 == 12 || i / SIDE % 20 == 10;
        (0..SIDE * SIDE).map(|i| u8::from(is_line(i))).collect()
    }

    #[test]
    fn a_grid_has_its_junctions() {
        let look = Look::of_piece(&grid()).unwrap();
        // 20 junctions, and 880 pixels of line: lines are 11.4 apart.
        let length = 5.0 * 99.0 + 4.0 * 99.0;
        assert!((look.junction_spacing.unwrap() - length * length / 20.0 / 1e4).abs() < 0.01, "{look:?}");
        assert!(look.nearest_line.unwrap() < 0.0, "{look:?}");
    }

    #[test]
    fn pieces_with_too_little_river_or_too_much_are_not_measured() {
        assert_eq!(Look::of_piece(&[0; SIDE * SIDE]), None);
        assert_eq!(Look::of_piece(&[1; SIDE * SIDE]), None);
        let mut half = grid();
        half[..SIDE * SIDE / 2].fill(0);
        assert_eq!(Look::of_piece(&half), None);
        let no_junctions: Vec<u8> = (0..SIDE * SIDE).map(|i| u8::from(i / SIDE % 20 == 10)).collect();
        assert_eq!(Look::of_piece(&no_junctions), None);
    }

    #[test]
    fn medians_and_means_are_those_of_the_pieces_that_have_the_measure() {
        let piece = |value: f64| Look { junction_spacing: Some(value), turn_kurtosis: Some(value), ..Look::default() };
        let typical = Look::typical(&[piece(1.0), piece(2.0), piece(6.0), Look::default()]);
        assert_eq!((typical.junction_spacing, typical.turn_kurtosis), (Some(2.0), Some(3.0)));
        assert_eq!(Look::typical(&[]), Look::default());
    }
}
