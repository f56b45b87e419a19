//! The state of a session in numbers.

use crate::grow::{Ending, Growth};
use crate::network::{Meander, NONE, Network};
use crate::recipe::GrowthMethod;

/// A picture in numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Summary {
    /// The growth method.
    pub growth: GrowthMethod,
    /// Ticks grown.
    pub ticks: u32,
    /// Nodes; once growth has ended, those of the trimmed tree.
    pub nodes: u32,
    /// River mouths; once there are rivers, those left after trimming.
    pub mouths: u32,
    /// Sources of the rivers; 0 until there are any.
    pub sources: u32,
    /// The highest stream order (Strahler) of the rivers; 0 until there are any.
    pub order: u8,
    /// Attractors scattered, or parcels in drainage; 0 for a Brownian tree.
    pub attractors: u32,
    /// Attractors that no river came near enough to, or parcels without a way to the sea.
    pub unreached: u32,
    /// The way in which growth ended; `None` while it goes on.
    pub ending: Option<Ending>,
    /// Rounds that rivers have meandered.
    pub rounds: u32,
    /// Oxbow lakes that the rivers have left.
    pub oxbows: u32,
}

impl Summary {
    /// Summarises a tree during its growth.
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

    /// Adds the numbers of rivers made from a trimmed tree with this number of nodes.
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

    /// Returns the reason why rivers leave much of the land dry, once growth has ended; `None` if they do not.
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

/// A reason why rivers leave much of the land dry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shortfall {
    /// No river grew, by any method: no land lies open to the sea.
    NoRiver,
    /// Space colonization left over a tenth of the attractors: the step is too long for the kill distance, the reach is
    /// too short, or mouths are too far apart.
    Unreached,
    /// In drainage, over a tenth of the parcels have no way to a mouth: ridges cut them off, or their land has none.
    CutOff,
}

impl Shortfall {
    /// Returns the reason's name, lower case, with hyphens between words.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoRiver => "no-river",
            Self::Unreached => "unreached",
            Self::CutOff => "cut-off",
        }
    }
}
