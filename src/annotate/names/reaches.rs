//! The reaches that have names of their own: those stretches of flat country on which great rivers wind enough.

use glam::Vec2;

use crate::base::geometry::{distance, lengths};
use crate::network::{Network, Reach, Vertex};

/// Returns the course of a reach; `None` if it hardly winds, or is short for its width.
pub(super) fn course(network: &Network, reach: &Reach) -> Option<Vec<Vec2>> {
    /// The least length of a reach, over that of its smoothed course, and over its width.
    const LEAST_LENGTH: f32 = 1.3;
    const LEAST_WIDTHS: f32 = 12.0;
    let river = network.rivers.get(reach.river as usize)?;
    let is_within = |vertex: &&Vertex| (reach.least_discharge..=reach.most_discharge).contains(&vertex.discharge);
    let own: Vec<&Vertex> = network.vertices[river.vertex_range()].iter().filter(is_within).collect();
    let width = own.iter().map(|vertex| vertex.width()).sum::<f32>() / own.len().max(1) as f32;
    let line: Vec<Vec2> = own.iter().map(|vertex| vertex.at).collect();
    let length = *lengths(&line).last()?;
    let straight = *lengths(&smoothed(&line, width)).last()?;
    (length >= LEAST_LENGTH * straight && length >= LEAST_WIDTHS * width).then_some(line)
}

/// Smooths a line so that its bends are gone: each vertex becomes the mean of those within some widths of it along the line, as many
/// upstream as downstream, so that the ends stay.
fn smoothed(line: &[Vec2], width: f32) -> Vec<Vec2> {
    const WIDTHS: f32 = 20.0;
    let mean = line.windows(2).map(|pair| distance(pair[0], pair[1])).sum::<f32>() / line.len().max(2) as f32;
    let around = if mean > 0.0 { (WIDTHS * width / mean) as usize } else { 0 };
    let smooth = |i: usize| {
        let around = around.min(i).min(line.len() - 1 - i);
        let near = &line[i - around..=i + around];
        near.iter().fold(Vec2::ZERO, |sum, &at| sum + at) / near.len() as f32
    };
    (0..line.len()).map(smooth).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::{NONE, River};

    /// Makes a river of 400 vertices, two units wide, with bends of some height from vertex 100 on.
    fn river(height: f32) -> Network {
        let vertex = |i: u32| Vertex {
            at: Vec2::new(i as f32, if i < 100 { 0.0 } else { height * libm::sinf(i as f32 * 0.3) }),
            discharge: i,
            left: 1.0,
            right: 1.0,
            ..Vertex::default()
        };
        let river = River { start: 0, end: 400, junction: NONE, parent: NONE, order: 1, magnitude: 1, identity: 0 };
        Network { vertices: (0..400).map(vertex).collect(), rivers: vec![river], oxbows: vec![] }
    }

    #[test]
    fn only_a_long_stretch_that_winds_is_a_reach() {
        let reach = |from: u32, to: u32| Reach { river: 0, least_discharge: from, most_discharge: to };
        assert_eq!(course(&river(10.0), &reach(100, 399)).map(|line| line.len()), Some(300));
        assert_eq!(course(&river(0.5), &reach(100, 399)), None);
        assert_eq!(course(&river(10.0), &reach(0, 99)), None);
        assert_eq!(course(&river(10.0), &reach(100, 104)), None);
        assert_eq!(course(&river(10.0), &reach(900, 999)), None);
    }
}
