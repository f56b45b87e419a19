//! Growth by the method that a recipe names.

use std::sync::Arc;

use glam::Vec2;

use super::{Brownian, Capture, Colonize, Drainage, Ending, GrowError, GrowthSettings, Raster, scatter};
use crate::recipe::GrowthMethod;
use crate::tree::Tree;

/// Growth in progress: a stepper, whatever the procedure.
#[derive(Clone, Debug)]
pub struct Growth {
    settings: GrowthSettings,
    grower: Grower,
}

#[derive(Clone, Debug)]
enum Grower {
    Colonize(Box<Colonize>),
    Brownian(Box<Brownian>),
    Drainage(Box<Drainage>),
}

impl Growth {
    /// Begins growth: tick 0.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(settings: GrowthSettings) -> Result<Self, GrowError> {
        let grower = match settings.method {
            GrowthMethod::Colonize => Grower::Colonize(Colonize::new(settings.clone())?.into()),
            GrowthMethod::Brownian => {
                let raster = Raster::of(&settings);
                let sensitivity = settings.sensitivity / raster.side();
                Grower::Brownian(Brownian::new(raster, settings.seed, sensitivity)?.into())
            }
            GrowthMethod::Drainage => Grower::Drainage(Drainage::new(settings.clone())?.into()),
        };
        Ok(Self { settings, grower })
    }

    /// Grows by one tick. Returns whether there is more to grow: if not, [`Growth::failure`] tells of a tree that is not
    /// whole.
    pub fn tick(&mut self) -> bool {
        match &mut self.grower {
            Grower::Colonize(growth) => growth.tick(),
            Grower::Brownian(growth) => growth.tick(),
            Grower::Drainage(growth) => growth.tick(),
        }
    }

    /// The tree so far.
    pub fn tree(&self) -> &Arc<Tree> {
        match &self.grower {
            Grower::Colonize(growth) => growth.tree(),
            Grower::Brownian(growth) => growth.tree(),
            Grower::Drainage(growth) => growth.tree(),
        }
    }

    /// Makes sure that nobody else has this very tree, by a copy if need be.
    pub(crate) fn unshare(&mut self) {
        match &mut self.grower {
            Grower::Colonize(growth) => growth.unshare(),
            Grower::Brownian(growth) => growth.unshare(),
            Grower::Drainage(growth) => growth.unshare(),
        }
    }

    /// How many trees came before this one: while it stays the same the tree only grows, and another is another tree of the same
    /// recipe. Only drainage has more than one, one a round.
    pub fn trees(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => 0,
            Grower::Drainage(growth) => growth.trees(),
        }
    }

    /// How streams have captured one another so far: of drainage, the parcels that drained another way after a round than before it. Undone
    /// from the last to the first, they lead back from the finished tree to those before it ([`Growth::trees`]).
    pub fn captures(&self) -> &[Capture] {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => &[],
            Grower::Drainage(growth) => growth.captures(),
        }
    }

    /// The node of each parcel of drainage in the tree, as [`Growth::scattered`] lists them; `u32::MAX` of those that have none yet.
    pub fn nodes_of_parcels(&self) -> &[u32] {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => &[],
            Grower::Drainage(growth) => growth.nodes(),
        }
    }

    /// The settings it grows by.
    pub fn settings(&self) -> &GrowthSettings {
        &self.settings
    }

    /// How growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        match &self.grower {
            Grower::Colonize(growth) => growth.ending(),
            Grower::Brownian(growth) => growth.ending(),
            Grower::Drainage(growth) => growth.ending(),
        }
    }

    /// Why growth stopped before its end: there was not enough memory for more nodes.
    pub fn failure(&self) -> Option<GrowError> {
        (self.ending() == Some(Ending::OutOfMemory)).then(|| match &self.grower {
            Grower::Colonize(_) | Grower::Drainage(_) => GrowError::out_of_memory(&self.settings),
            Grower::Brownian(growth) => growth.out_of_memory(),
        })
    }

    /// How many river mouths there are; when a Brownian tree grows, so far.
    pub fn mouths(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.mouths(),
            Grower::Brownian(growth) => growth.mouths(),
            Grower::Drainage(growth) => growth.mouths(),
        }
    }

    /// How many attractors have been scattered: none for a Brownian tree.
    pub fn attractors(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors(),
            Grower::Drainage(growth) => growth.parcels(),
            Grower::Brownian(_) => 0,
        }
    }

    /// Where attractors have been scattered, in the order of their drawing.
    pub fn scattered(&self) -> Vec<Vec2> {
        match &self.grower {
            Grower::Colonize(_) => scatter(&self.settings),
            Grower::Drainage(growth) => growth.places().to_vec(),
            Grower::Brownian(_) => Vec::new(),
        }
    }

    /// Where attractors lie that still pull, no river having come near enough, in no order to rely on; of drainage, the parcels that have
    /// found no way to the sea yet.
    pub fn left(&self) -> Vec<Vec2> {
        match &self.grower {
            Grower::Colonize(growth) => growth.left(),
            Grower::Drainage(growth) => growth.left(),
            Grower::Brownian(_) => Vec::new(),
        }
    }

    /// How many attractors no river has come near enough to.
    pub fn unreached(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.unreached(),
            Grower::Drainage(growth) => growth.unreached(),
            Grower::Brownian(_) => 0,
        }
    }

    /// The discharge of a river that drains everything: known before growth begins, for a Brownian tree nearly.
    pub fn total_discharge(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors(),
            Grower::Brownian(growth) => growth.total_discharge(),
            Grower::Drainage(growth) => growth.parcels(),
        }
    }

    /// About how far apart streams lie, in units: the distance between attractors, or the sensitivity.
    pub fn stream_spacing(&self) -> f32 {
        match self.settings.method {
            GrowthMethod::Colonize => self.settings.spacing,
            GrowthMethod::Brownian => self.settings.sensitivity,
            GrowthMethod::Drainage => self.settings.drainage.spacing,
        }
    }

    /// How far a node lies from its parent, in units, on average.
    pub fn node_length(&self) -> f32 {
        match &self.grower {
            Grower::Colonize(_) => self.settings.step,
            Grower::Brownian(growth) => growth.node_length(),
            Grower::Drainage(_) => self.settings.drainage.spacing,
        }
    }

    /// Whether each mouth was asked for: unless they are drawn, a Brownian tree has one wherever its particles met the coast, and
    /// drainage wherever water leaves the land, most of them a brook's.
    pub fn mouths_are_chosen(&self) -> bool {
        match self.settings.method {
            _ if !self.settings.starts.is_empty() => true,
            GrowthMethod::Colonize => true,
            GrowthMethod::Brownian => false,
            GrowthMethod::Drainage => self.settings.mouths > 0,
        }
    }

    /// The discharge of the largest river, once growth has ended; of drainage only, which knows it.
    pub fn largest_basin(&self) -> Option<u32> {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => None,
            Grower::Drainage(growth) => growth.largest_basin(),
        }
    }

    /// Whether the tree covers hillsides, too, so that rivers begin only where enough of them drains.
    pub fn covers_hillsides(&self) -> bool {
        match self.settings.method {
            GrowthMethod::Colonize | GrowthMethod::Brownian => false,
            GrowthMethod::Drainage => true,
        }
    }

    /// Whether steps of the tree may cross each other: the strands of a Brownian tree never touch.
    pub fn may_cross(&self) -> bool {
        match self.settings.method {
            GrowthMethod::Colonize => true,
            GrowthMethod::Brownian | GrowthMethod::Drainage => false,
        }
    }

    /// How much of everything is drained so far.
    pub fn drained(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors() - growth.unreached(),
            Grower::Drainage(growth) => growth.parcels() - growth.unreached(),
            Grower::Brownian(growth) => growth.tree().len() as u32,
        }
    }

    /// How much of everything is drained so far, from 0 to 1; of a Brownian tree, about so.
    pub fn progress(&self) -> f32 {
        (self.drained() as f32 / self.total_discharge().max(1) as f32).min(1.0)
    }
}
