//! The exact distance of places from the nearest bank.

use glam::Vec2;

use super::background::Piece;
use super::squares::{Bounded, Bounds, Squares};

/// Pieces of rivers, lakes or ridges, sorted by squares of the map.
#[derive(Clone, Debug)]
pub struct Banks {
    squares: Squares,
    pieces: Vec<Bounded>,
}

/// The side of squares, in units.
const SQUARE: f32 = 24.0;

impl Banks {
    /// Sorts pieces by the squares of a map of some size.
    pub fn new(size: Vec2, pieces: Vec<Piece>) -> Self {
        let pieces: Vec<Bounded> = pieces.into_iter().map(Bounded::new).collect();
        let bounds: Vec<Bounds> = pieces.iter().map(|bounded| bounded.bounds).collect();
        Self { squares: Squares::new(SQUARE, size, Vec2::ZERO, &bounds), pieces }
    }

    /// Returns the distance of the nearest bank, at most `most`; less than 0 in the water.
    pub fn distance(&self, at: Vec2, most: f32) -> f32 {
        let mut nearest = most;
        self.squares.around(at, most, |pieces| {
            for bounded in pieces.iter().map(|&piece| &self.pieces[piece as usize]) {
                if bounded.bounds.least_distance(at) < nearest {
                    nearest = nearest.min(bank(&bounded.piece, at));
                }
            }
            nearest
        });
        nearest
    }
}

/// Returns the distance of a piece's bank from a point, less than 0 inside: that of the nearest of all discs that the piece is made of.
/// Where its width changes, that is not the disc around the nearest point of its middle line.
pub fn bank(piece: &Piece, at: Vec2) -> f32 {
    let [from, to] = piece.ends;
    let (along, out) = (to.at - from.at, at - from.at);
    let squared = along.length_squared();
    let wider = to.half - from.half;
    if squared <= wider * wider {
        // One end is in the other.
        let end = if wider > 0.0 { to } else { from };
        return (at - end.at).length_squared().sqrt() - end.half;
    }
    let slope = wider / squared.sqrt();
    let aside = along.perp_dot(out).abs() / squared;
    let t = (out.dot(along) / squared + aside * slope / (1.0 - slope * slope).sqrt()).clamp(0.0, 1.0);
    (out - along * t).length_squared().sqrt() - (from.half + wider * t)
}

#[cfg(test)]
mod tests {
    use super::super::background::LAKE;
    use super::*;
    use crate::network::Place;
    use crate::property::cases;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = Place> {
        (0.0f32..90.0, 0.0f32..70.0, 0.0f32..12.0).prop_map(|(x, y, half)| Place { at: Vec2::new(x, y), half })
    }

    proptest! {
        #![proptest_config(cases(200))]

        #[test]
        fn distance_is_that_of_the_nearest_of_many_discs(line in prop::collection::vec(place(), 2..9), x in 0.0f32..90.0, y in 0.0f32..70.0) {
            let at = Vec2::new(x, y);
            let disc = |pair: &[Place], t: f32| at.distance(pair[0].at.lerp(pair[1].at, t)) - (pair[0].half + (pair[1].half - pair[0].half) * t);
            let of_pair = |pair: &[Place]| (0..=400).map(|i| disc(pair, i as f32 / 400.0)).fold(f32::MAX, f32::min);
            let sampled = line.windows(2).map(of_pair).fold(25.0, f32::min);
            let banks = Banks::new(Vec2::new(90.0, 70.0), Piece::along(LAKE, &line).collect());
            let distance = banks.distance(at, 25.0);
            prop_assert!(distance <= sampled + 1e-3 && distance > sampled - 0.2, "{} is not {}", distance, sampled);
        }
    }
}
