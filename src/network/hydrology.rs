//! Slope and elevation of rivers that flow through no terrain.
//!
//! Rivers flatten downstream: slope falls as a power of discharge. So 'flat' has a meaning by discharge alone, and
//! slopes summed from the mouth up are elevations that always fall toward the sea.

use super::{NONE, Network};
use crate::geometry::distance;

/// The slope at the mouth of a river that drains everything: that of lower rivers, a few units in ten thousand.
const LEAST_SLOPE: f32 = 3e-4;

/// The slope of a river that drains a share of everything: S ∝ Q^−0.4, as width, depth and velocity ∝ Q^0.5, Q^0.4 and Q^0.1
/// of Leopold and Maddock (1953) leave it (Pelletier 2021).
pub fn slope(share: f32) -> f32 {
    LEAST_SLOPE * libm::powf(share.max(1e-6), -0.4)
}

/// The elevation of each vertex over the sea, in units; 0 at mouths. It falls along every river.
pub fn elevations(network: &Network, total_discharge: u32) -> Vec<f32> {
    let downstream = network.downstream();
    let mut elevations = vec![f32::NAN; network.vertices.len()];
    let mut upward = Vec::new();
    for start in 0..network.vertices.len() as u32 {
        // Down to what is known, then up again.
        let mut i = start;
        while i != NONE && elevations[i as usize].is_nan() {
            upward.push(i);
            i = downstream[i as usize];
        }
        while let Some(i) = upward.pop() {
            let vertex = &network.vertices[i as usize];
            elevations[i as usize] = match network.vertices.get(downstream[i as usize] as usize) {
                None => 0.0,
                Some(next) => {
                    let fall = slope(vertex.discharge as f32 / total_discharge as f32) * distance(vertex.at, next.at);
                    // However short the way, a river falls.
                    let below = elevations[downstream[i as usize] as usize];
                    (below + fall).max(below.next_up())
                }
            };
        }
    }
    elevations
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, straight};
    use super::*;
    use glam::Vec2;

    #[test]
    fn four_times_the_slope_takes_a_thirty_second_of_the_discharge() {
        assert!((slope(0.01) / slope(0.32) - 4.0).abs() < 1e-4);
        assert_eq!(slope(1.0), 3e-4);
        assert!(slope(0.0).is_finite());
    }

    #[test]
    fn elevations_are_slopes_summed_from_the_mouth() {
        let network = river(&straight((0.0, 0.0), (100.0, 0.0), 10), 1.0).with_arm(
            &straight((50.0, 40.0), (50.0, 10.0), 3),
            5,
            25,
        );
        let elevations = elevations(&network, 100);
        assert_eq!(elevations[10], 0.0);
        assert!((elevations[0] - 100.0 * slope(1.0)).abs() < 1e-6);
        assert!((elevations[11] - elevations[5] - 40.0 * slope(0.25)).abs() < 1e-6);
    }

    #[test]
    fn a_river_falls_however_short_its_way() {
        // A thousand units up, where a fall of a millionth is less than a float can hold; and two vertices at one place.
        let line = [1e6, 10.0, 9.999_999, 9.999_999, 0.0].map(|x| Vec2::new(x, 0.0));
        let network = river(&line, 1.0);
        let elevations = elevations(&network, 100);
        assert!(elevations.is_sorted_by(|upper, lower| upper > lower), "{elevations:?}");
    }
}
