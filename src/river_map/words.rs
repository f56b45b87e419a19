//! A map as words: the wasm module that has it hands it to the one that makes charts.

use super::RiverMap;
use crate::memory;
use crate::network::{Network, Oxbow, River, Vertex};
use crate::words::Writer;

/// All of a map; nothing if there is not enough memory.
pub fn write(map: &RiverMap<'_>) -> Vec<u32> {
    /// Five words each, in a list that grows by doubling; and what a land and its heights take at most.
    const BYTES: usize = 40;
    const BYTES_OF_LAND: usize = 8_000_000;
    if !memory::can_allocate((map.tree.len() + map.network.vertices.len()) * BYTES + BYTES_OF_LAND) {
        return Vec::new();
    }
    let wishes = &map.wishes;
    let mut words = Writer::default();
    words.some(&[wishes.language, wishes.labels as u32, wishes.cartouche as u32, wishes.style as u32]);
    words.some(&[wishes.label_size, wishes.aspect, wishes.woods, wishes.hills].map(f32::to_bits));
    words.text(&wishes.seed);
    words.text(&wishes.names);
    words.some(&[map.total_discharge, map.is_finished.into()]);
    words.points(&map.tree.at);
    words.list(&map.tree.parent);
    words.list(&map.tree.drained);
    words.list(&map.tree.identity);
    words.network(map.network);
    words.count(map.reaches.len());
    for reach in map.reaches {
        words.some(&[reach.river, reach.least_discharge, reach.most_discharge]);
    }
    words.count(map.land.is_some().into());
    if let Some(land) = map.land {
        let coast = land.coast_distance();
        words.some(&[coast.spacing().to_bits()]);
        words.numbers(coast.heights());
        words.list(&land.stretches());
        words.count(land.ridges().len());
        land.ridges().iter().for_each(|ridge| words.points(ridge));
    }
    words.count(map.relief.is_some().into());
    if let Some(relief) = map.relief {
        words.numbers(relief.heights());
    }
    words.count(map.beds.len());
    for bed in &map.beds {
        words.count(bed.len());
        bed.iter().for_each(|place| words.some(&[place.at.x, place.at.y, place.half].map(f32::to_bits)));
    }
    words.0
}

impl Writer {
    fn network(&mut self, network: &Network) {
        self.vertices(&network.vertices);
        self.count(network.rivers.len());
        for &River { start, end, junction, parent, order, magnitude, identity } in &network.rivers {
            self.some(&[start, end, junction, parent, order.into(), magnitude, identity]);
        }
        self.count(network.oxbows.len());
        for Oxbow { river, born, silt, vertices } in &network.oxbows {
            self.some(&[*river, *born, silt.to_bits()]);
            self.vertices(vertices);
        }
    }

    #[inline(never)]
    fn vertices(&mut self, vertices: &[Vertex]) {
        self.count(vertices.len());
        for Vertex { at, discharge, left, right, .. } in vertices {
            self.some(&[at.x.to_bits(), at.y.to_bits(), *discharge, left.to_bits(), right.to_bits()]);
        }
    }
}
