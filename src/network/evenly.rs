//! Vertices at even spacing along a course, without moving its line.

use super::settings::NetworkSettings;
use super::{NONE, Network, Vertex};
use crate::base::geometry::distance;

/// Inserts vertices, so that neighbours lie at most one and a half steps apart, and at least two thirds of one where
/// the course has room. Returns the new network, and for each of its vertices the index of the old vertex at or above
/// it, with the share of the way to the next.
pub(super) fn divide(network: &Network, settings: &NetworkSettings) -> (Network, Vec<(u32, f32)>) {
    let downstream = network.downstream();
    let mut place = vec![NONE; network.vertices.len()];
    let mut divided = Network { rivers: network.rivers.clone(), ..Network::default() };
    let mut origin = Vec::new();
    for river in &mut divided.rivers {
        let own = river.vertex_range();
        river.start = divided.vertices.len() as u32;
        for i in own.clone() {
            place[i] = divided.vertices.len() as u32;
            divided.vertices.push(network.vertices[i]);
            origin.push((i as u32, 0.0));
            let Some(next) = network.vertices.get(downstream[i] as usize) else { continue };
            let step = settings.step(2.0 * settings.half_width(network.vertices[i].discharge));
            // A river with a single vertex, its source, would have no width anywhere.
            let least = if own.len() == 1 { 2 } else { 1 };
            let pieces = pieces(distance(network.vertices[i].at, next.at), step).max(least);
            for piece in 1..pieces {
                let share = piece as f32 / pieces as f32;
                divided.vertices.push(between(&network.vertices[i], next, share));
                origin.push((i as u32, share));
            }
        }
        river.end = divided.vertices.len() as u32;
    }
    for river in &mut divided.rivers {
        river.junction = place.get(river.junction as usize).copied().unwrap_or(NONE);
    }
    (divided, origin)
}

/// Returns the number of pieces, at least 1, about as long as `spacing`, into which a length is divided.
pub(super) fn pieces(length: f32, spacing: f32) -> u32 {
    ((length / spacing + 0.5) as u32).max(1)
}

/// Interpolates between a vertex and the next downstream. The result has the discharge of the upper one.
pub(super) fn between(upper: &Vertex, lower: &Vertex, share: f32) -> Vertex {
    let mix = |a: f32, b: f32| a + (b - a) * share;
    Vertex {
        at: upper.at.lerp(lower.at, share),
        discharge: upper.discharge,
        left: mix(upper.left, lower.left),
        right: mix(upper.right, lower.right),
        mobility: mix(upper.mobility, lower.mobility),
        elevation: mix(upper.elevation, lower.elevation),
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, settings, straight};
    use super::*;
    use crate::base::geometry::height;
    use glam::Vec2;

    #[test]
    fn vertices_come_to_lie_about_a_step_apart_on_the_same_line() {
        let points = [(0.0, 0.0), (0.6, 0.0), (30.0, 17.3), (31.9, 17.0), (90.0, 80.0)].map(Vec2::from);
        let settings = settings();
        let network = river(&points, 1.0);
        let (divided, origin) = divide(&network, &settings);
        assert_eq!(divided.vertices.len(), origin.len());
        let step = settings.step(2.0 * settings.half_width(100));
        for (i, pair) in divided.vertices.windows(2).enumerate() {
            let (upper, share) = origin[i];
            let (a, b) = (points[upper as usize], points[upper as usize + 1]);
            assert!(height(pair[0].at, a, b) < 1e-4, "on the line");
            assert!((pair[0].at.distance(a) - share * a.distance(b)).abs() < 1e-3, "where it is said to be");
            let apart = pair[0].at.distance(pair[1].at) / step;
            assert!(apart <= 1.5 && (apart > 0.66 || a.distance(b) < step), "{apart}");
        }
    }

    #[test]
    fn junctions_are_followed() {
        let network =
            river(&straight((0.0, 0.0), (40.0, 0.0), 4), 1.0).with_arm(&straight((20.0, 30.0), (20.0, 10.0), 2), 2, 10);
        let (divided, _) = divide(&network, &settings());
        let arm = divided.rivers[1];
        assert_eq!(divided.vertices[arm.junction as usize].at, Vec2::new(20.0, 0.0));
        let last = divided.vertices[arm.vertex_range()].last().unwrap();
        assert!(last.at.y > 0.0 && last.at.y < 2.0, "the way to the junction is divided, too");
    }
}
