//! A map on the wire: the wasm module that has it hands it to the one that makes charts.

use super::RiverMap;
use crate::memory;
use crate::network::{Network, Oxbow, River, Vertex};
use crate::wire::Writer;

/// All of a map; nothing if there is not enough memory.
pub fn write(map: &RiverMap<'_>) -> Vec<u32> {
    /// Five numbers each, in a list that grows by doubling; and what a land and its heights take at most.
    const BYTES: usize = 40;
    const BYTES_OF_LAND: usize = 8_000_000;
    if !memory::can_allocate((map.tree.len() + map.network.vertices.len()) * BYTES + BYTES_OF_LAND) {
        return Vec::new();
    }
    let options = &map.options;
    let mut data = Writer::default();
    data.push(&[options.language, options.labels as u32, options.cartouche as u32, options.style as u32]);
    data.push(&[options.label_size, options.aspect, options.woods, options.hills].map(f32::to_bits));
    data.text(&options.seed);
    data.text(&options.names);
    data.push(&[map.total_discharge, map.is_finished.into()]);
    data.points(&map.tree.at);
    data.list(&map.tree.parent);
    data.list(&map.tree.drained);
    data.list(&map.tree.identity);
    data.network(map.network);
    data.count(map.reaches.len());
    for reach in map.reaches {
        data.push(&[reach.river, reach.least_discharge, reach.most_discharge]);
    }
    data.count(map.land.is_some().into());
    if let Some(land) = map.land {
        let coast = land.coast_distance();
        data.push(&[coast.spacing().to_bits()]);
        data.numbers(coast.heights());
        data.list(&land.stretches());
        data.count(land.ridges().len());
        land.ridges().iter().for_each(|ridge| data.points(ridge));
    }
    data.count(map.relief.is_some().into());
    if let Some(relief) = map.relief {
        data.numbers(relief.heights());
    }
    data.count(map.beds.len());
    for bed in &map.beds {
        data.count(bed.len());
        bed.iter().for_each(|place| data.push(&[place.at.x, place.at.y, place.half].map(f32::to_bits)));
    }
    data.0
}

impl Writer {
    fn network(&mut self, network: &Network) {
        self.vertices(&network.vertices);
        self.count(network.rivers.len());
        for &River { start, end, junction, parent, order, magnitude, identity } in &network.rivers {
            self.push(&[start, end, junction, parent, order.into(), magnitude, identity]);
        }
        self.count(network.oxbows.len());
        for Oxbow { river, born, silt, vertices } in &network.oxbows {
            self.push(&[*river, *born, silt.to_bits()]);
            self.vertices(vertices);
        }
    }

    #[inline(never)]
    fn vertices(&mut self, vertices: &[Vertex]) {
        self.count(vertices.len());
        for Vertex { at, discharge, left, right, .. } in vertices {
            self.push(&[at.x.to_bits(), at.y.to_bits(), *discharge, left.to_bits(), right.to_bits()]);
        }
    }
}
