//! Measures of single rivers and of their junctions: sinuosity, density, angles.

use glam::Vec2;

use super::fit;
use crate::base::geometry::{direction, distance};
use crate::network::{NONE, Network, River};

/// Measures the median sinuosity of the rivers of order 2 and higher: length over the straight line from source to end.
/// `None` if there are none.
pub fn sinuosity(network: &Network) -> Option<f32> {
    let great = network.rivers.iter().filter(|river| river.order >= 2);
    fit::median(&great.map(|river| network.sinuosity(river)).collect::<Vec<_>>())
}

/// Sums up the length of all rivers, in units.
pub fn total_length(network: &Network) -> f64 {
    network.rivers.iter().map(|river| f64::from(network.length(river))).fold(0.0, |sum, length| sum + length)
}

/// The mean and standard deviation of angles, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub spread: f64,
}

/// Measures the angles between the two rivers above each junction. Each river's direction is that from the junction to
/// its point `upstream` units above it, because the first steps of a tributary exaggerate the angle. Junctions with a
/// shorter river are left out. `None` if no junction is left.
pub fn junction_angles(network: &Network, upstream: f32) -> Option<Angles> {
    let angles: Vec<f64> = network.rivers.iter().filter_map(|river| junction_angle(network, river, upstream)).collect();
    if angles.is_empty() {
        return None;
    }
    let count = angles.len() as f64;
    let mean = angles.iter().sum::<f64>() / count;
    let variance = angles.iter().map(|angle| (angle - mean) * (angle - mean)).sum::<f64>() / count;
    Some(Angles { mean, spread: variance.sqrt() })
}

/// Measures the median angle at which rivers of order 1 join others, in degrees, like [`junction_angles`]. `None` if no
/// such river is as long as `upstream`.
pub fn tributary_angle(network: &Network, upstream: f32) -> Option<f64> {
    let least = network.rivers.iter().filter(|river| river.order == 1);
    fit::median_of(&least.filter_map(|river| junction_angle(network, river, upstream)).collect::<Vec<_>>())
}

fn junction_angle(network: &Network, river: &River, upstream: f32) -> Option<f64> {
    let joined = network.rivers.get(river.parent as usize).filter(|_| river.junction != NONE)?;
    let places = |river: &River, end: u32| {
        let own = &network.vertices[river.start as usize..end as usize];
        own.iter().rev().map(|vertex| vertex.at).collect::<Vec<_>>()
    };
    let junction = network.vertices[river.junction as usize].at;
    let towards = |line: Vec<Vec2>| Some(direction(along(junction, &line, upstream)? - junction));
    let tributary = towards(places(river, river.end))?;
    let stem = towards(places(joined, river.junction))?;
    Some(libm::atan2f(tributary.perp_dot(stem).abs(), tributary.dot(stem)).to_degrees().into())
}

/// Returns the point at a distance from the start of a line, measured along it; `None` if the line is shorter.
fn along(start: Vec2, line: &[Vec2], mut far: f32) -> Option<Vec2> {
    let mut from = start;
    for &to in line {
        let length = distance(from, to);
        if length >= far && length > 0.0 {
            return Some(from.lerp(to, far / length));
        }
        far -= length;
        from = to;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::samples::{into, network, to_sea};
    use super::*;

    /// Measures three rivers, 7, 6 and 5 units long, whose ends are 5, 6 and 5 units apart.
    #[test]
    fn sinuosity_is_that_of_the_river_in_the_middle_of_order_2_at_least() {
        let bent = to_sea(&[(0.0, 0.0), (3.0, 0.0), (3.0, 4.0)]);
        let mut network = network(&[bent, to_sea(&[(9.0, 0.0), (9.0, 6.0)]), to_sea(&[(20.0, 0.0), (23.0, 4.0)])]);
        assert_eq!(sinuosity(&network), Some(1.0));
        network.rivers[1].order = 1;
        assert_eq!(sinuosity(&network), Some(1.2));
        assert_eq!(total_length(&network), 18.0);
        assert_eq!(sinuosity(&Network::default()), None);
    }

    /// ```text
    ///     B
    ///      \           The stem runs from A through J to the sea. B meets its upper part at 60°.
    /// A─────J────~     C meets it at 90°, but comes from a bend: 4 west and 3 south of J, its
    ///       │          direction is 36.87° off A's.
    ///  C────´
    /// ```
    #[test]
    fn angles_are_those_between_points_upstream() {
        let b = [(-5.0, -5.0 * 3f32.sqrt())];
        let stem = to_sea(&[(-10.0, 0.0), (0.0, 0.0), (10.0, 0.0)]);
        let rivers = [stem, into(&b, 0, 1), into(&[(-9.0, 3.0), (0.0, 3.0)], 0, 1)];
        let network = network(&rivers);
        let angles = |upstream| junction_angles(&network, upstream).unwrap();
        assert!((angles(3.0).mean - 75.0).abs() < 1e-4 && (angles(3.0).spread - 15.0).abs() < 1e-4);
        let turned = libm::atan2(3.0, 4.0).to_degrees();
        assert!((angles(7.0).mean - (60.0 + turned) / 2.0).abs() < 1e-4, "{:?}", angles(7.0));
        let mut least = network.clone();
        assert_eq!(tributary_angle(&least, 3.0), None);
        least.rivers[1].order = 1;
        assert!((tributary_angle(&least, 3.0).unwrap() - 60.0).abs() < 1e-4);
        // There are no angles farther upstream than the stem and B are long.
        assert_eq!(junction_angles(&network, 10.5), None);
    }
}
