//! What a session has come to, in numbers.

use crate::grow::{Ending, Growth};
use crate::network::{Meander, NONE, Network};
use crate::recipe::GrowthMethod;

/// A picture in numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// How its rivers grow.
    pub growth: GrowthMethod,
    /// Ticks grown.
    pub ticks: u32,
    /// Nodes: of the trimmed tree once it is grown.
    pub nodes: u32,
    /// River mouths: those that trimming has left, once there are rivers.
    pub mouths: u32,
    /// Sources of the rivers; 0 until there are any.
    pub sources: u32,
    /// The highest stream order (Strahler) of the rivers; 0 until there are any.
    pub order: u8,
    /// Attractors scattered, or parcels of drainage: 0 for a Brownian tree.
    pub attractors: u32,
    /// Attractors that no river came near enough to, or parcels from which no way leads to the sea.
    pub unreached: u32,
    /// How growth ended; `None` while it goes on.
    pub ending: Option<Ending>,
    /// Rounds that rivers have meandered.
    pub rounds: u32,
    /// Oxbow lakes that they have left.
    pub oxbows: u32,
}

impl Summary {
    /// While a tree grows.
    pub(super) fn of_growth(growth: &Growth) -> Self {
        let tree = growth.tree();
        Self {
            growth: growth.settings().method,
            ticks: tree.tick_starts.len() as u32 - 1,
            nodes: tree.len() as u32,
            mouths: growth.mouths(),
            sources: 0,
            order: 0,
            attractors: growth.attractors(),
            unreached: growth.unreached(),
            ending: growth.ending(),
            rounds: 0,
            oxbows: 0,
        }
    }

    /// The same once there are rivers, of a trimmed tree with this number of nodes.
    pub(super) fn with_rivers(self, nodes: u32, meander: &Meander) -> Self {
        let Network { rivers, oxbows, .. } = &**meander.network();
        Self {
            nodes,
            mouths: rivers.iter().filter(|river| river.junction == NONE).count() as u32,
            sources: rivers.len() as u32,
            order: rivers.iter().map(|river| river.order).max().unwrap_or(0),
            rounds: meander.rounds(),
            oxbows: oxbows.len() as u32,
            ..self
        }
    }

    /// Why rivers leave much of the land dry, once growth has ended; `None` if they do not.
    pub fn shortfall(&self) -> Option<Shortfall> {
        match self.ending {
            Some(Ending::Complete) if self.nodes == 0 => Some(Shortfall::NoRiver),
            Some(Ending::Complete) if self.unreached > self.attractors / 10 => match self.growth {
                GrowthMethod::Drainage => Some(Shortfall::CutOff),
                GrowthMethod::Colonize | GrowthMethod::Brownian => Some(Shortfall::Unreached),
            },
            _ => None,
        }
    }
}

/// Why rivers leave much of the land dry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shortfall {
    /// No river grew, by whatever method: no land lies open to the sea.
    NoRiver,
    /// Space colonization left over a tenth of the attractors: the step is too long for the kill distance, the reach too
    /// short, or mouths lie too far apart.
    Unreached,
    /// In drainage over a tenth of the parcels have no way to a mouth: ridges cut them off, or their land has none.
    CutOff,
}
