//! Rivers beside their valleys: beds that lie above the ground at their side.

use glam::Vec2;

use super::index::Index;
use crate::base::geometry::{direction, distance};
use crate::network::Network;
use crate::relief::Relief;

/// The distance between the places that rivers are measured at, in units.
const STEP: f32 = 3.0;

/// The distances to both sides at which the ground is looked at, in units.
const ASIDE: [f32; 3] = [4.0, 6.0, 8.0];

/// The distance within which another river makes the valley its own, in units.
const OTHERS: f32 = 14.0;

/// The height by which a bed may lie above the ground, as a share of the summit's.
const TOLERANCE: f32 = 0.01;

/// Returns the share, from 0 to 1, of the length of rivers whose bed lies above the ground 4 to 8 units to one of its sides,
/// by more than a hundredth of the summit's height. Places with another river within 14 units do not count, nor do those by the sea.
/// `order` limits it to rivers of one order. `None` where no place counts.
pub fn beside(network: &Network, relief: &Relief, order: Option<u8>) -> Option<f64> {
    let places = places(network);
    let index = Index::new(&places.iter().map(|place| place.at).collect::<Vec<_>>(), OTHERS);
    let summit = relief.heights().iter().copied().fold(0.0, f32::max);
    let (mut all, mut beside) = (0u32, 0u32);
    for own in places.iter().filter(|place| order.is_none_or(|order| place.order == order)) {
        let is_other = |other: &Place| other.river != own.river && distance(other.at, own.at) < OTHERS;
        let Some(lowest) = lowest_aside(relief, own) else { continue };
        if index.around(own.at, OTHERS).any(|other| is_other(&places[other])) {
            continue;
        }
        all += 1;
        beside += u32::from(relief.at(own.at) - lowest > TOLERANCE * summit);
    }
    (all > 0).then(|| f64::from(beside) / f64::from(all))
}

/// A place of a river.
struct Place {
    at: Vec2,
    along: Vec2,
    river: usize,
    order: u8,
}

/// Returns places at even distances along all rivers.
fn places(network: &Network) -> Vec<Place> {
    let mut places = Vec::new();
    for (river, course) in network.rivers.iter().enumerate() {
        let line = super::parallels::evenly(&network.places(course), STEP);
        let along = |i: usize| direction(line[(i + 1).min(line.len() - 1)] - line[i.saturating_sub(1)]);
        places.extend(line.iter().enumerate().map(|(i, &at)| Place {
            at,
            along: along(i),
            river,
            order: course.order,
        }));
    }
    places
}

/// Returns the height of the lowest ground at both sides of a place, in units; `None` if any of that is sea.
fn lowest_aside(relief: &Relief, place: &Place) -> Option<f32> {
    let across = place.along.perp();
    let ground = ASIDE.into_iter().flat_map(|far| [far, -far]).map(|far| relief.at(place.at + across * far));
    ground.min_by(f32::total_cmp).filter(|&lowest| lowest > 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::samples::{network, to_sea};
    use super::*;
    use crate::domain::Domain;

    /// Measures rivers that run from west to east, each at its y, on a land with a height for each y.
    fn measured(rivers: &[f32], height: impl Fn(f32) -> f32, order: Option<u8>) -> Option<f64> {
        let heights = (0..250_000).map(|cell| height((cell / 500) as f32 * 2.0 + 1.0));
        let relief = Relief::of_heights(&Domain::with_aspect(1.0), heights.collect()).unwrap();
        let lines: Vec<[(f32, f32); 2]> = rivers.iter().map(|&y| [(100.0, y), (900.0, y)]).collect();
        beside(&network(&lines.iter().map(|line| to_sea(line)).collect::<Vec<_>>()), &relief, order)
    }

    fn valley(y: f32) -> f32 {
        20.0 + 0.1 * (y - 500.0).abs()
    }

    #[test]
    fn a_river_on_a_slope_lies_beside_its_valley_and_one_at_the_bottom_in_it() {
        assert_eq!(measured(&[500.0], valley, None), Some(0.0));
        assert_eq!(measured(&[560.0], valley, None), Some(1.0));
        assert_eq!(measured(&[500.0, 560.0], valley, None), Some(0.5));
        assert_eq!(measured(&[560.0], valley, Some(1)), None, "both are of order 2");
    }

    #[test]
    fn places_near_another_river_or_the_sea_do_not_count() {
        assert_eq!(measured(&[560.0, 572.0], valley, None), None);
        assert_eq!(measured(&[560.0, 576.0], valley, None), Some(1.0));
        assert_eq!(measured(&[505.0], |y| 0.1 * (y - 500.0), None), None);
    }
}
