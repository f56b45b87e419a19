//! Polygons as readers of maps want them: rings on a grid that neither cross nor fold back, not even after rounding.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{ContourDirection, IntOverlayOptions};
use i_overlay::core::simplify::Simplify;
use i_overlay::i_float::int::point::IntPoint;

/// A place on a grid: east and north.
pub(super) type GridPoint = [i32; 2];

/// A closed line, whose last point is its first.
pub(super) type Ring = Vec<GridPoint>;

/// The polygons that a closed line fills by the non-zero rule: each its outer ring, counterclockwise, and its holes, clockwise.
/// Mostly one; several where the line pinches itself off, none if all of it is narrower than the grid.
pub(super) fn polygons(line: &[GridPoint]) -> Vec<Vec<Ring>> {
    let options = IntOverlayOptions {
        preserve_input_collinear: false,
        output_direction: ContourDirection::CounterClockwise,
        preserve_output_collinear: false,
        min_output_area: 0,
        ogc: true,
    };
    let contour: Vec<IntPoint> = line.iter().map(|&[x, y]| IntPoint::new(x, y)).collect();
    let closed = |ring: Vec<IntPoint>| ring.iter().chain(ring.first()).map(|at| [at.x, at.y]).collect();
    contour
        .simplify(FillRule::NonZero, options)
        .into_iter()
        .map(|rings| rings.into_iter().map(closed).collect())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The polygons, each ring begun at its least point.
    fn ordered(line: &[GridPoint]) -> Vec<Vec<Ring>> {
        let turned = |ring: &Ring| {
            let mut ring = ring[1..].to_vec();
            let least = (0..ring.len()).min_by_key(|&i| ring[i]).unwrap_or(0);
            ring.rotate_left(least);
            ring
        };
        polygons(line).iter().map(|rings| rings.iter().map(turned).collect()).collect()
    }

    const SQUARE: [GridPoint; 4] = [[0, 0], [9, 0], [9, 9], [0, 9]];

    #[test]
    fn clockwise_line_becomes_a_counterclockwise_ring() {
        assert_eq!(ordered(&[[0, 0], [0, 9], [9, 9], [9, 0]]), [[SQUARE]]);
        let closed = &polygons(&SQUARE)[0][0];
        assert!(closed.len() == 5 && closed.first() == closed.last());
    }

    #[test]
    fn side_that_folds_back_is_left_out() {
        assert_eq!(ordered(&[[0, 0], [9, 0], [20, 0], [9, 0], [9, 9], [0, 9]]), [[SQUARE]]);
        assert_eq!(polygons(&[[0, 0], [9, 0], [20, 0], [9, 0]]), Vec::<Vec<Ring>>::new());
        assert_eq!(polygons(&[]), Vec::<Vec<Ring>>::new());
    }

    #[test]
    fn line_that_crosses_itself_becomes_two_polygons() {
        let eight = ordered(&[[0, 0], [8, 8], [8, 0], [0, 8]]);
        assert_eq!(eight.iter().flatten().count(), 2, "{eight:?}");
        assert!(eight.contains(&vec![vec![[0, 0], [4, 4], [0, 8]]]), "{eight:?}");
        assert!(eight.contains(&vec![vec![[4, 4], [8, 0], [8, 8]]]), "{eight:?}");
    }

    #[test]
    fn line_that_comes_back_to_its_beginning_has_a_hole() {
        let round = [[0, 9], [0, 0], [9, 0], [9, 9], [0, 9], [3, 6], [6, 6], [6, 3], [3, 3], [3, 6]];
        assert_eq!(ordered(&round), [[SQUARE.to_vec(), vec![[3, 3], [3, 6], [6, 6], [6, 3]]]]);
    }
}
