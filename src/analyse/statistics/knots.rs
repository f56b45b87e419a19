//! Knots: lines that crowd where they do not join.

use glam::Vec2;

use super::index::Index;
use super::parallels::evenly;
use crate::base::geometry::distance;
use crate::network::Network;

/// The last spacings of a river before its end do not count: there it joins.
const ENDS: f32 = 2.0;

/// Places lie this far apart along rivers, in spacings.
const STEP: f32 = 0.5;

/// Counts places where three rivers or more are within one spacing and do not join there, per 1,000 spacings of river.
/// The last two spacings of each river are part of its junction. `None` without rivers.
pub fn knots(network: &Network, spacing: f32) -> Option<f64> {
    let mut places: Vec<(usize, Vec2)> = Vec::new();
    let mut all = 0;
    for (river, course) in network.rivers.iter().enumerate() {
        let line = evenly(&network.places(course), STEP * spacing);
        all += line.len();
        let kept = line.len().saturating_sub((ENDS / STEP) as usize);
        places.extend(line[..kept].iter().map(|&at| (river, at)));
    }
    let index = Index::new(&places.iter().map(|place| place.1).collect::<Vec<_>>(), spacing);
    let is_knot = |&&(own, at): &&(usize, Vec2)| {
        let near = index.around(at, spacing).map(|i| places[i]).filter(|place| distance(place.1, at) < spacing);
        let mut others = near.map(|place| place.0).filter(|&river| river != own);
        others.next().is_some_and(|first| others.any(|other| other != first))
    };
    let knots = places.iter().filter(is_knot).count();
    // Two places are a spacing of river.
    (all > 0).then(|| 1000.0 * knots as f64 / all as f64)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{into, network, to_sea};
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    /// Counts knots by comparing all places with all others.
    fn twin(network: &Network, spacing: f32) -> f64 {
        let lines = network.rivers.iter().map(|river| evenly(&network.places(river), STEP * spacing));
        let lines: Vec<Vec<Vec2>> = lines.collect();
        let kept = |line: &[Vec2]| line[..line.len().saturating_sub(4)].to_vec();
        let is_near = |at: Vec2, line: &Vec<Vec2>| kept(line).iter().any(|other| distance(at, *other) < spacing);
        let crowd = |at: Vec2| lines.iter().filter(|line| is_near(at, line)).count();
        let knots = lines.iter().flat_map(|line| kept(line)).filter(|at| crowd(*at) >= 3).count();
        1000.0 * knots as f64 / lines.iter().map(Vec::len).sum::<usize>() as f64
    }

    proptest! {
        #![proptest_config(cases(64))]

        #[test]
        fn it_is_that_of_all_places(ends in proptest::collection::vec([(0f32..9.0, 0f32..9.0), (0f32..9.0, 0f32..9.0)], 1..9)) {
            let network = network(&ends.iter().map(|line| to_sea(line)).collect::<Vec<_>>());
            prop_assert_eq!(knots(&network, 1.0), Some(twin(&network, 1.0)));
        }
    }

    /// Rivers side by side, this far apart.
    fn side_by_side(count: usize, apart: f32) -> f64 {
        let lines: Vec<[(f32, f32); 2]> =
            (0..count).map(|i| [(0.0, i as f32 * apart), (20.0, i as f32 * apart)]).collect();
        let rivers: Vec<_> = lines.iter().map(|line| to_sea(line)).collect();
        knots(&network(&rivers), 1.0).unwrap()
    }

    #[test]
    fn two_rivers_make_no_knot_and_three_do() {
        assert_eq!((side_by_side(2, 0.6), side_by_side(3, 1.2)), (0.0, 0.0));
        // All of the river in the middle but for its end, of three rivers: its neighbours are too far from each other.
        assert!((side_by_side(3, 0.6) - 1000.0 * 37.0 / 123.0).abs() < 1.0, "{}", side_by_side(3, 0.6));
    }

    #[test]
    fn tributaries_that_meet_at_a_river_make_no_knot() {
        let stem = [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)];
        let star = [to_sea(&stem), into(&[(10.0, 8.0)], 0, 1), into(&[(10.0, -8.0)], 0, 1)];
        assert_eq!(knots(&network(&star), 1.0), Some(0.0));
        assert_eq!(knots(&network(&[]), 1.0), None);
    }
}
