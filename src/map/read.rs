//! Reading of maps from another wasm module. Every map that is read, from whatever numbers, is safe to query.

use std::sync::Arc;

use super::write::ENDINGS;
use super::{Map, MapId};
use crate::base::random::Seed;
use crate::base::wire::{Reader, point};
use crate::domain::Domain;
use crate::grow::Grown;
use crate::land::{CoastDistance, Land};
use crate::network::{NONE, Network, Oxbow, PastCourse, PastCourses, PastRound, Place, Reach, River, Vertex};
use crate::prune::{Heads, Trim};
use crate::recipe::link;
use crate::relief::Relief;
use crate::tree::{NO_PARENT, Tree};

impl Map {
    /// Reads the data written by [`Map::to_wire`]; `None` if it is anything else.
    pub fn from_wire(data: &[u32]) -> Option<Self> {
        let mut data = Reader(data);
        let [low, high] = data.take()?;
        let recipe = link::read(&data.text()?).ok()?;
        let domain = Domain::of(&recipe);
        let grown = data.grown()?;
        let tree = data.tree()?;
        let trim = Trim { seed: Seed::from_text(recipe.seed()), ..data.trim()? };
        let network = data.network()?;
        let rivers = network.rivers.len();
        let reaches = data.reaches(rivers)?;
        let [rounds] = data.take()?;
        let past = data.past(rivers)?;
        let land = if data.take()? == [0] { None } else { Some(data.land(&domain)?.into()) };
        let low_stand = if data.take()? == [0] { None } else { Some(data.coast(&domain)?.into()) };
        let relief =
            if data.take()? == [0] { None } else { Some(Relief::of_heights(&domain, data.numbers()?)?.into()) };
        let id = MapId(u64::from(low) | u64::from(high) << 32);
        let (tree, network, past) = (tree.into(), network.into(), past.into());
        data.0.is_empty().then_some(Self {
            id,
            recipe,
            land,
            low_stand,
            grown,
            tree,
            trim,
            network,
            reaches,
            rounds,
            past,
            relief,
        })
    }
}

impl Reader<'_> {
    fn grown(&mut self) -> Option<Grown> {
        let [attractors, unreached, total_discharge, ending] = self.take()?;
        let [spacing, reach, kill, step, stream_spacing] = self.take()?.map(f32::from_bits);
        let ending = *ENDINGS.get(ending as usize)?;
        Some(Grown { attractors, unreached, total_discharge, spacing, reach, kill, step, stream_spacing, ending })
    }

    fn tree(&mut self) -> Option<Tree> {
        let (at, parent, drained) = (self.points()?, self.list()?, self.list()?);
        let (tick_starts, identity, elevation) = (self.list()?, self.list()?, self.numbers()?);
        let is_tree = (0..).zip(&parent).all(|(node, &parent)| parent < node || parent == NO_PARENT);
        let is_whole = [parent.len(), drained.len()].iter().all(|&len| len == at.len());
        let may_lack = [identity.len(), elevation.len()].iter().all(|&len| len == at.len() || len == 0);
        let tree = Tree { at, parent, drained, tick_starts, elevation, identity };
        (is_tree && is_whole && may_lack).then_some(tree)
    }

    fn trim(&mut self) -> Option<Trim> {
        let [nodes, is_fork, channel_area, largest_basin] = self.take()?;
        let [variation, tributary_spacing, head_variation, wavelength] = self.take()?.map(f32::from_bits);
        let heads = Heads { channel_area, variation: head_variation, largest_basin, wavelength };
        let treats_sea_as_fork = is_fork != 0;
        Some(Trim { nodes, treats_sea_as_fork, variation, heads, tributary_spacing, ..Trim::default() })
    }

    fn network(&mut self) -> Option<Network> {
        let vertices = self.vertices()?;
        let items = self.items()?;
        let river = |&[start, end, junction, parent, order, magnitude, identity]: &[u32; 7]| {
            let is_run = start <= end && end as usize <= vertices.len();
            let joins = (junction as usize) < vertices.len() || junction == NONE;
            let has_parent = (parent as usize) < items.len() || parent == NONE;
            let order = u8::try_from(order).ok()?;
            let river = River { start, end, junction, parent, order, magnitude, identity };
            (is_run && joins && has_parent).then_some(river)
        };
        let rivers: Vec<River> = items.iter().map(river).collect::<Option<_>>()?;
        let oxbows = self.several(|data| {
            let [river, born, silt] = data.take()?;
            let oxbow = Oxbow { river, born, silt: f32::from_bits(silt), vertices: data.vertices()? };
            ((river as usize) < rivers.len()).then_some(oxbow)
        })?;
        Some(Network { vertices, rivers, oxbows })
    }

    fn vertices(&mut self) -> Option<Vec<Vertex>> {
        let vertex = |&[discharge, x, y, left, right, mobility, elevation]: &[u32; 7]| {
            let [left, right, mobility, elevation] = [left, right, mobility, elevation].map(f32::from_bits);
            Vertex { at: point([x, y]), discharge, left, right, mobility, elevation }
        };
        Some(self.items()?.iter().map(vertex).collect())
    }

    fn reaches(&mut self, rivers: usize) -> Option<Arc<[Reach]>> {
        let reach = |&[river, least_discharge, most_discharge]: &[u32; 3]| {
            ((river as usize) < rivers).then_some(Reach { river, least_discharge, most_discharge })
        };
        self.items()?.iter().map(reach).collect()
    }

    fn past(&mut self, rivers: usize) -> Option<PastCourses> {
        let great = self.list()?;
        let rounds = self.several(|data| {
            let [round] = data.take()?;
            Some(PastRound { round, courses: data.beds(rivers)?, loops: data.beds(rivers)? })
        })?;
        great.iter().all(|&river| (river as usize) < rivers).then(|| PastCourses::of_rounds(great, rounds))
    }

    fn beds(&mut self, rivers: usize) -> Option<Vec<PastCourse>> {
        let place = |&[x, y, half]: &[u32; 3]| Place { at: point([x, y]), half: f32::from_bits(half) };
        self.several(|data| {
            let [river] = data.take()?;
            let line = data.items()?.iter().map(place).collect();
            ((river as usize) < rivers).then_some(PastCourse { river, line })
        })
    }

    fn coast(&mut self, domain: &Domain) -> Option<CoastDistance> {
        let [spacing] = self.take()?.map(f32::from_bits);
        CoastDistance::of_heights(domain.size, spacing, self.numbers()?)
    }

    fn land(&mut self, domain: &Domain) -> Option<Land> {
        let coast_distance = self.coast(domain)?;
        let stretches = self.list()?;
        let lines = [self.several(Self::points)?, self.several(Self::points)?];
        Land::of_stretches(domain, coast_distance, &stretches, lines)
    }
}
