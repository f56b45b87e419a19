//! Small networks for tests.

use glam::Vec2;

use crate::network::{NONE, Network, River, Vertex};

/// A river through the given points, source first, with a constant width and discharge.
pub(crate) struct Sample<'a> {
    pub points: &'a [(f32, f32)],
    /// The river that it joins, and the vertex there.
    pub joins: Option<(usize, u32)>,
    pub discharge: u32,
    pub width: f32,
}

/// Makes a river to the sea with discharge 1, a unit wide.
pub(crate) fn to_sea(points: &[(f32, f32)]) -> Sample<'_> {
    Sample { points, joins: None, discharge: 1, width: 1.0 }
}

/// Makes a river like `to_sea` that joins a vertex of another river.
pub(crate) fn into(points: &[(f32, f32)], river: usize, vertex: u32) -> Sample<'_> {
    Sample { joins: Some((river, vertex)), ..to_sea(points) }
}

/// Makes a network of rivers, all of order 2.
pub(crate) fn network(samples: &[Sample<'_>]) -> Network {
    let mut network = Network::default();
    for sample in samples {
        let start = network.vertices.len() as u32;
        let half = sample.width / 2.0;
        let vertex = |&at: &(f32, f32)| Vertex {
            at: Vec2::from(at),
            discharge: sample.discharge,
            left: half,
            right: half,
            ..Vertex::default()
        };
        network.vertices.extend(sample.points.iter().map(vertex));
        let (parent, junction) =
            sample.joins.map_or((NONE, NONE), |(river, vertex)| (river as u32, network.rivers[river].start + vertex));
        let end = network.vertices.len() as u32;
        network.rivers.push(River { start, end, junction, parent, order: 2, magnitude: 1, identity: 0 });
    }
    network
}
