//! Rivers whose mouths have come to lie in new land run on over it to the sea.

use glam::Vec2;

use crate::network::{NONE, Network, River, Vertex};

/// Returns a network some of whose rivers run on from their mouths, as wide as there.
pub(super) fn extended(network: &Network, ends: &[(u32, Vec<Vec2>)]) -> Network {
    let mut longer = Network { oxbows: network.oxbows.clone(), ..Network::default() };
    // The new index of the first vertex of each river.
    let mut starts = Vec::with_capacity(network.rivers.len());
    for (id, river) in (0..).zip(&network.rivers) {
        starts.push(longer.vertices.len() as u32);
        longer.vertices.extend_from_slice(&network.vertices[river.vertex_range()]);
        if let Some(&mouth) = longer.vertices.last().filter(|_| river.end > river.start) {
            for (_, way) in ends.iter().filter(|(of, _)| *of == id) {
                longer.vertices.extend(way.iter().map(|&at| Vertex { at, ..mouth }));
            }
        }
        let (start, end) = (starts[id as usize], longer.vertices.len() as u32);
        longer.rivers.push(River { start, end, ..*river });
    }
    for river in longer.rivers.iter_mut().filter(|river| river.junction != NONE) {
        let parent = river.parent as usize;
        river.junction = river.junction - network.rivers[parent].start + starts[parent];
    }
    longer
}
