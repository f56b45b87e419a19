//! A map that has come from another wasm module (`wire.rs`).

use std::ops::RangeInclusive;

use glam::Vec2;

use super::{ChartOptions, RiverMap};
use crate::domain::Domain;
use crate::land::{CoastDistance, Land};
use crate::network::{NONE, Network, Oxbow, Place, Reach, River, Vertex};
use crate::recipe::{Cartouche, Choice, Labels, Style};
use crate::relief::Relief;
use crate::tree::Tree;
use crate::wire::{Reader, point};

/// What maps' widths over their heights may be.
const ASPECTS: RangeInclusive<f32> = 0.25..=4.0;

/// A map with all that it is made of. Of vertices it knows place, discharge and width; of its land not what rivers cannot cross.
#[derive(Clone, Debug)]
pub struct OwnMap {
    options: ChartOptions,
    tree: Tree,
    total_discharge: u32,
    network: Network,
    reaches: Vec<Reach>,
    land: Option<Land>,
    relief: Option<Relief>,
    beds: Vec<Vec<Place>>,
    is_finished: bool,
}

impl OwnMap {
    /// The map of a message that another module of the same build has written; `None` if it is of none.
    pub fn read(data: &[u32]) -> Option<Self> {
        let mut data = Reader(data);
        let options = data.options()?;
        let domain = Domain::with_aspect(options.aspect);
        let [total_discharge, is_finished] = data.take()?;
        let tree = data.tree()?;
        let network = data.network()?;
        let reach =
            |&[river, least_discharge, most_discharge]: &[u32; 3]| Reach { river, least_discharge, most_discharge };
        let reaches = data.items()?.iter().map(reach).collect();
        let land = if data.take()? == [0] { None } else { Some(data.land(domain.size)?) };
        let is_finished = is_finished != 0;
        let relief = if data.take()? == [0] { None } else { Some(Relief::of_heights(&domain, data.heights()?)?) };
        let beds = data.beds()?;
        Some(Self { options, tree, total_discharge, network, reaches, land, relief, beds, is_finished })
    }

    /// The map.
    pub fn map(&self) -> RiverMap<'_> {
        RiverMap {
            options: self.options.clone(),
            tree: &self.tree,
            total_discharge: self.total_discharge,
            network: &self.network,
            reaches: &self.reaches,
            land: self.land.as_ref(),
            relief: self.relief.as_ref(),
            beds: self.beds.clone(),
            is_finished: self.is_finished,
        }
    }
}

impl Reader<'_> {
    fn options(&mut self) -> Option<ChartOptions> {
        let ([language, labels, cartouche, style], sizes) = (self.take()?, self.take()?);
        let [label_size, aspect, woods, hills] = sizes.map(f32::from_bits);
        if !ASPECTS.contains(&aspect) {
            return None;
        }
        let (labels, style) = (*Labels::ALL.get(labels as usize)?, *Style::ALL.get(style as usize)?);
        let cartouche = *Cartouche::ALL.get(cartouche as usize)?;
        let (seed, names) = (self.text()?, self.text()?);
        Some(ChartOptions { seed, language, names, labels, cartouche, label_size, aspect, style, woods, hills })
    }

    fn tree(&mut self) -> Option<Tree> {
        let (at, parent, drained, identity) = (self.points()?, self.list()?, self.list()?, self.list()?);
        let is_tree = (0..).zip(&parent).all(|(node, &parent)| parent < node || parent == crate::tree::NO_PARENT);
        let is_whole = parent.len() == at.len() && drained.len() == at.len();
        (is_tree && is_whole).then_some(Tree { at, parent, drained, identity, ..Tree::default() })
    }

    fn network(&mut self) -> Option<Network> {
        let vertices = self.vertices()?;
        let river = |&[start, end, junction, parent, order, magnitude, identity]: &[u32; 7]| {
            let is_run = start <= end && end as usize <= vertices.len();
            let joins = (junction as usize) < vertices.len() || junction == NONE;
            (is_run && joins).then_some(River { start, end, junction, parent, order: order as u8, magnitude, identity })
        };
        let rivers: Vec<River> = self.items()?.iter().map(river).collect::<Option<_>>()?;
        if rivers.iter().any(|river| river.parent as usize >= rivers.len() && river.parent != NONE) {
            return None;
        }
        let [count] = self.take()?;
        let mut oxbow = |_| {
            let [river, born, silt] = self.take()?;
            Some(Oxbow { river, born, silt: f32::from_bits(silt), vertices: self.vertices()? })
        };
        let oxbows = (0..count).map(&mut oxbow).collect::<Option<_>>()?;
        Some(Network { vertices, rivers, oxbows })
    }

    fn vertices(&mut self) -> Option<Vec<Vertex>> {
        let vertex = |&[x, y, discharge, left, right]: &[u32; 5]| {
            let [left, right] = [left, right].map(f32::from_bits);
            Vertex { at: point([x, y]), discharge, left, right, ..Vertex::default() }
        };
        Some(self.items()?.iter().map(vertex).collect())
    }

    fn heights(&mut self) -> Option<Vec<f32>> {
        Some(self.items::<1>()?.iter().map(|[height]| f32::from_bits(*height)).collect())
    }

    fn beds(&mut self) -> Option<Vec<Vec<Place>>> {
        let place = |[x, y, half]: &[u32; 3]| Place { at: point([*x, *y]), half: f32::from_bits(*half) };
        let [count] = self.take()?;
        (0..count).map(|_| Some(self.items()?.iter().map(place).collect())).collect()
    }

    fn land(&mut self, size: Vec2) -> Option<Land> {
        let [spacing] = self.take()?.map(f32::from_bits);
        let coast_distance = CoastDistance::of_heights(size, spacing, self.heights()?)?;
        let stretches = self.list()?;
        let [ridges] = self.take()?;
        let ridges = (0..ridges).map(|_| self.points()).collect::<Option<_>>()?;
        Land::of_stretches(size, coast_distance, &stretches, ridges)
    }
}
