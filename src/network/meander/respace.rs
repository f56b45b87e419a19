//! Even spacing, restored after a round: long segments are divided, and vertices too close to the one before are removed.
//!
//! Dividing does not move a line. Removing a vertex does, by its height over the line that is left: never farther than
//! a share of the clearance that moves have left over.

use super::super::evenly::{between, pieces};
use super::super::settings::NetworkSettings;
use super::super::smooth::room;
use super::super::{NONE, Network, Vertex};
use crate::base::geometry::{distance, fast_max, fast_min, height};

/// The share of the clearance that a removal may use up; with [`super::super::smooth::SHARE_OF_CLEARANCE`] less than a half.
pub(super) const SHARE_OF_CLEARANCE: f32 = 0.15;

/// Spaces vertices between half a step and one and a half, where that is possible.
pub(super) fn respace(network: &mut Network, clearance: &[f32], step_scale: &[f32], settings: &NetworkSettings) {
    let is_junction = network.junctions();
    let downstream = network.downstream();
    let old = &network.vertices;
    let mut place = vec![NONE; old.len()];
    let mut vertices = Vec::with_capacity(old.len() + old.len() / 8);
    for river in &mut network.rivers {
        let own = river.vertex_range();
        river.start = vertices.len() as u32;
        let mut last = NONE;
        for i in own.clone() {
            let below = downstream[i];
            let goes = i > own.start
                && last != NONE
                && last + 1 == i as u32
                && below != NONE
                && !is_junction[i]
                // A junction is known to be as wide as the last vertex of its tributary, which stays.
                && i + 1 < own.end
                && distance(old[i].at, old[i - 1].at) < 0.5 * settings.step(old[i].width())
                // The clearance of a vertex that does not move is unknown.
                && step_scale[i] > 0.0
                && height(old[i].at, old[i - 1].at, old[below as usize].at)
                    <= SHARE_OF_CLEARANCE * room(clearance[i].min(clearance[i - 1]));
            if goes {
                continue;
            }
            if last != NONE {
                divide(&mut vertices, &old[last as usize], &old[i], settings);
            }
            place[i] = vertices.len() as u32;
            vertices.push(old[i]);
            last = i as u32;
        }
        if let (Some(upper), Some(junction)) = (old.get(last as usize), old.get(river.junction as usize)) {
            // Under the water of the other river a tributary is not seen, and is not to hold that river.
            let far = distance(upper.at, junction.at);
            let share = fast_max(far - fast_min(junction.left, junction.right), 0.0) / fast_max(far, f32::MIN_POSITIVE);
            let at = upper.at.lerp(junction.at, share);
            // The tributary is no wider for being near a wider river.
            let end =
                Vertex { at, elevation: upper.elevation + (junction.elevation - upper.elevation) * share, ..*upper };
            divide(&mut vertices, upper, &end, settings);
        }
        river.end = vertices.len() as u32;
    }
    for river in &mut network.rivers {
        river.junction = place.get(river.junction as usize).copied().unwrap_or(NONE);
    }
    network.vertices = vertices;
}

/// Inserts vertices between two that are too far apart.
fn divide(vertices: &mut Vec<Vertex>, upper: &Vertex, lower: &Vertex, settings: &NetworkSettings) {
    let far = distance(upper.at, lower.at);
    let step = settings.step(upper.width());
    if far <= 1.5 * step {
        return;
    }
    let pieces = pieces(far, step);
    vertices.extend((1..pieces).map(|piece| between(upper, lower, piece as f32 / pieces as f32)));
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{places, river, settings, straight};
    use super::*;
    use glam::Vec2;

    fn respaced(mut network: Network, clearance: f32) -> Network {
        let (clearance, step_scale) = (vec![clearance; network.vertices.len()], vec![1.0; network.vertices.len()]);
        respace(&mut network, &clearance, &step_scale, &settings());
        network
    }

    #[test]
    fn what_has_drawn_apart_is_divided_and_what_crowds_goes() {
        let mut line = straight((0.0, 0.0), (12.0, 0.0), 4);
        line.extend(straight((12.2, 0.0), (16.0, 0.0), 19));
        let spaced = places(&respaced(river(&line, 1.0), 1.0));
        for pair in spaced[1..spaced.len() - 1].windows(2) {
            let apart = pair[0].distance(pair[1]);
            assert!((0.39..=1.5).contains(&apart), "{apart}");
        }
        assert_eq!((spaced[0], spaced[spaced.len() - 1]), (line[0], line[line.len() - 1]));
    }

    #[test]
    fn junctions_stay_and_are_followed() {
        let network =
            river(&straight((0.0, 0.0), (4.0, 0.0), 20), 1.0).with_arm(&straight((2.2, 9.0), (2.2, 3.0), 6), 11, 10);
        let spaced = respaced(network, 1.0);
        let arm = spaced.rivers[1];
        assert!(spaced.rivers[0].end < 15, "vertices have gone");
        assert_eq!(spaced.vertices[arm.junction as usize].at, Vec2::new(2.2, 0.0));
        assert!(arm.vertex_range().len() > 7, "the way to the junction is divided");
    }

    #[test]
    fn no_line_moves_into_what_is_near() {
        // A crowded corner, whose middle vertex stands a tenth of a unit out.
        let line = [(0.0, 0.0), (1.0, 0.0), (1.2, 0.1), (1.4, 0.0), (2.4, 0.0), (3.4, 0.0)].map(Vec2::from);
        let has_corner = |network: &Network| places(network).contains(&line[2]);
        assert!(has_corner(&respaced(river(&line, 1.0), 0.4)));
        assert!(!has_corner(&respaced(river(&line, 1.0), 2.0)));
    }
}
