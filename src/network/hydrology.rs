//! Slope and elevation of rivers.
//!
//! A tree grown by drainage brings its elevations. Other rivers flow through no terrain; but rivers flatten downstream: slope falls as
//! a power of discharge. So 'flat' has a meaning by discharge alone, and slopes summed from the mouth up are elevations that always
//! fall toward the sea.

use super::{NONE, Network};
use crate::base::geometry::{distance, fast_max, fast_min, lengths};
use crate::tree::LEAST_SLOPE;

/// Returns the slope of a river that drains a share of the whole map: S ∝ Q^−0.5, as Flint (1974) found for mountain
/// streams, so that slope is inversely proportional to width.
pub fn slope(share: f32) -> f32 {
    LEAST_SLOPE / share.max(1e-6).sqrt()
}

/// Computes the slope downstream at each vertex. Where the tree has elevations, it is averaged along the river, since
/// ground is hard here and soft there.
pub(super) fn slopes(network: &Network, total_discharge: u32) -> Vec<f32> {
    /// The number of vertices that a slope is averaged over: a few times the distance between streams.
    const VERTICES: usize = 24;
    if !has_elevations(network) {
        return network.vertices.iter().map(|vertex| slope(vertex.discharge as f32 / total_discharge as f32)).collect();
    }
    let mut slopes = vec![0.0; network.vertices.len()];
    for river in &network.rivers {
        let course: Vec<_> = network.course(river).collect();
        let along = lengths(&network.places(river));
        for (i, at) in river.vertex_range().enumerate() {
            let upper = i.saturating_sub(VERTICES / 2);
            let lower = (i + VERTICES / 2).min(course.len() - 1);
            let far = fast_max(along[lower] - along[upper], f32::MIN_POSITIVE);
            slopes[at] = (course[upper].elevation - course[lower].elevation) / far;
        }
    }
    slopes
}

fn has_elevations(network: &Network) -> bool {
    network.vertices.iter().any(|vertex| vertex.elevation > 0.0)
}

/// Returns the elevation of each vertex over the sea, in units; 0 at mouths. It falls along every river.
pub fn elevations(network: &Network, total_discharge: u32) -> Vec<f32> {
    let downstream = network.downstream();
    let is_given = has_elevations(network);
    let straightness = if is_given { Vec::new() } else { straightness(network) };
    upward(network, |i, below| {
        let (vertex, next) = (&network.vertices[i], &network.vertices[downstream[i] as usize]);
        let law = || {
            let share = vertex.discharge as f32 / total_discharge as f32;
            slope(share) * distance(vertex.at, next.at) * straightness[i]
        };
        // A river falls over any distance, however short.
        let own = if is_given { vertex.elevation } else { below + law() };
        own.max(below.next_up())
    })
}

/// Computes a value for each vertex from the sea up: 0 at mouths, else `of` its index and the value of the next vertex
/// downstream.
pub fn upward(network: &Network, of: impl Fn(usize, f32) -> f32) -> Vec<f32> {
    let downstream = network.downstream();
    let mut values = vec![f32::NAN; network.vertices.len()];
    let mut upward = Vec::new();
    for start in 0..network.vertices.len() as u32 {
        // Down to a vertex whose value is known, then up again.
        let mut i = start;
        while i != NONE && values[i as usize].is_nan() {
            upward.push(i);
            i = downstream[i as usize];
        }
        while let Some(i) = upward.pop() {
            let below = values.get(downstream[i as usize] as usize);
            values[i as usize] = below.map_or(0.0, |&below| of(i as usize, below));
        }
    }
    values
}

/// Returns the straight distance over that along the river, around each vertex: a river that winds through a plain does
/// not climb.
pub(crate) fn straightness(network: &Network) -> Vec<f32> {
    const VERTICES: usize = 12;
    let mut straightness = vec![1.0; network.vertices.len()];
    for river in &network.rivers {
        let course = network.places(river);
        let along = lengths(&course);
        for (i, at) in river.vertex_range().enumerate() {
            let (upper, lower) = (i.saturating_sub(VERTICES), (i + VERTICES).min(course.len() - 1));
            let way = along[lower] - along[upper];
            straightness[at] =
                if way > 0.0 { fast_min(distance(course[upper], course[lower]) / way, 1.0) } else { 1.0 };
        }
    }
    straightness
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, straight};
    use super::*;
    use glam::Vec2;

    #[test]
    fn four_times_the_slope_takes_a_sixteenth_of_the_discharge() {
        assert!((slope(0.01) / slope(0.16) - 4.0).abs() < 1e-4);
        assert_eq!(slope(1.0), 0.055 / 14.0);
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
