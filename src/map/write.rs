//! Writing of maps for another wasm module.

use super::{Map, MapId};
use crate::base::memory;
use crate::base::wire::Writer;
use crate::grow::{Ending, Grown};
use crate::land::{CoastDistance, Land};
use crate::network::{Network, Oxbow, PastCourse, PastCourses, River, Vertex};
use crate::prune::Trim;
use crate::recipe::link;
use crate::tree::Tree;

/// The ways in which growth ends, by their numbers on the wire.
pub(super) const ENDINGS: [Ending; 3] = [Ending::Complete, Ending::NodeLimit, Ending::OutOfMemory];

impl Map {
    /// Writes the whole map as numbers, for [`Map::from_wire`] in another module of the same build. Returns an empty
    /// list if there is not enough memory.
    pub fn to_wire(&self) -> Vec<u32> {
        /// Seven numbers each, in a list that grows by doubling; then a limit for land, relief and past courses.
        const BYTES: usize = 56;
        const BYTES_BESIDES: usize = 10_000_000;
        if !memory::can_allocate((self.tree.len() + self.network.vertices.len()) * BYTES + BYTES_BESIDES) {
            return Vec::new();
        }
        let mut data = Writer::default();
        data.id(self.id);
        data.text(&link::write(&self.recipe));
        data.grown(&self.grown);
        data.tree(&self.tree);
        data.trim(self.trim);
        data.network(&self.network);
        data.count(self.reaches.len());
        for reach in &*self.reaches {
            data.push(&[reach.river, reach.least_discharge, reach.most_discharge]);
        }
        data.push(&[self.rounds]);
        data.past(&self.past);
        data.count(self.land.is_some().into());
        if let Some(land) = &self.land {
            data.land(land);
        }
        data.count(self.low_stand.is_some().into());
        if let Some(low_stand) = &self.low_stand {
            data.coast(low_stand);
        }
        data.count(self.relief.is_some().into());
        if let Some(relief) = &self.relief {
            data.numbers(relief.heights());
        }
        data.0
    }
}

impl Writer {
    fn id(&mut self, MapId(id): MapId) {
        self.push(&[id as u32, (id >> 32) as u32]);
    }

    fn grown(&mut self, grown: &Grown) {
        let Grown { attractors, unreached, total_discharge, spacing, reach, kill, step, stream_spacing, ending } =
            *grown;
        let ending = ENDINGS.iter().position(|known| *known == ending).unwrap_or_default();
        self.push(&[attractors, unreached, total_discharge, ending as u32]);
        self.push(&[spacing, reach, kill, step, stream_spacing].map(f32::to_bits));
    }

    fn tree(&mut self, tree: &Tree) {
        let Tree { at, parent, drained, tick_starts, elevation, identity } = tree;
        self.points(at);
        [parent, drained, tick_starts, identity].into_iter().for_each(|list| self.list(list));
        self.numbers(elevation);
    }

    /// Leaves out the seed, which is the recipe's.
    fn trim(&mut self, Trim { nodes, treats_sea_as_fork, variation, heads, tributary_spacing, seed: _ }: Trim) {
        self.push(&[nodes, treats_sea_as_fork.into(), heads.channel_area, heads.largest_basin]);
        self.push(&[variation, tributary_spacing, heads.variation, heads.wavelength].map(f32::to_bits));
    }

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
        for &Vertex { at, discharge, left, right, mobility, elevation } in vertices {
            self.push(&[discharge]);
            self.push(&[at.x, at.y, left, right, mobility, elevation].map(f32::to_bits));
        }
    }

    fn past(&mut self, past: &PastCourses) {
        self.list(past.great_rivers());
        self.count(past.rounds().len());
        for round in past.rounds() {
            self.push(&[round.round]);
            round.beds().into_iter().for_each(|beds| self.beds(beds));
        }
    }

    fn beds(&mut self, beds: &[PastCourse]) {
        self.count(beds.len());
        for PastCourse { river, line } in beds {
            self.push(&[*river]);
            self.count(line.len());
            line.iter().for_each(|place| self.push(&[place.at.x, place.at.y, place.half].map(f32::to_bits)));
        }
    }

    fn coast(&mut self, coast: &CoastDistance) {
        self.push(&[coast.spacing().to_bits()]);
        self.numbers(coast.heights());
    }

    fn land(&mut self, land: &Land) {
        self.coast(land.coast_distance());
        self.list(&land.stretches());
        for lines in [land.ridges(), land.rivers()] {
            self.count(lines.len());
            lines.iter().for_each(|line| self.points(line));
        }
    }
}
