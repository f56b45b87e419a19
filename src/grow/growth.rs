//! Growth by the method that a recipe names.

use std::sync::Arc;

use glam::Vec2;

use super::{Brownian, Capture, Colonize, Drainage, Ending, GrowError, GrowthSettings, Raster, scatter};
use crate::land::Land;
use crate::recipe::GrowthMethod;
use crate::tree::Tree;

/// Growth in progress by any of the methods: a stepper.
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
    /// Fails if there is not enough memory.
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

    /// Grows by one tick. Returns `true` if there is more to grow. Otherwise growth is over, and [`Growth::failure`]
    /// returns an error if the tree is not complete.
    pub fn tick(&mut self) -> bool {
        match &mut self.grower {
            Grower::Colonize(growth) => growth.tick(),
            Grower::Brownian(growth) => growth.tick(),
            Grower::Drainage(growth) => growth.tick(),
        }
    }

    /// Cuts the finished tree of drainage where it meets the coast of a smaller land, after the sea has risen. Nodes in
    /// the sea are removed, and every edge that crosses the coast gets a mouth there.
    pub(crate) fn cut(&mut self, land: &Land) -> Result<(), GrowError> {
        match &mut self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => Ok(()),
            Grower::Drainage(growth) => growth.cut(land).map_err(|_| GrowError::out_of_memory(&self.settings)),
        }
    }

    /// Undoes the cut, for another rise of the sea.
    pub(crate) fn heal(&mut self) {
        if let Grower::Drainage(growth) = &mut self.grower {
            growth.heal();
        }
    }

    /// Returns the tree so far.
    pub fn tree(&self) -> &Arc<Tree> {
        match &self.grower {
            Grower::Colonize(growth) => growth.tree(),
            Grower::Brownian(growth) => growth.tree(),
            Grower::Drainage(growth) => growth.tree(),
        }
    }

    /// Makes sure that the tree is not shared: copies it if need be.
    pub(crate) fn unshare(&mut self) {
        match &mut self.grower {
            Grower::Colonize(growth) => growth.unshare(),
            Grower::Brownian(growth) => growth.unshare(),
            Grower::Drainage(growth) => growth.unshare(),
        }
    }

    /// Returns the number of trees before the current one. While it stays the same the tree only grows; when it
    /// changes, the tree is another one for the same recipe. Only drainage has several trees, one for each round.
    pub fn trees(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => 0,
            Grower::Drainage(growth) => growth.trees(),
        }
    }

    /// Returns the captures so far: in drainage, the parcels that drain differently after a round than before it.
    /// Undone from last to first, they lead back from the finished tree to the earlier ones ([`Growth::trees`]).
    pub fn captures(&self) -> &[Capture] {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => &[],
            Grower::Drainage(growth) => growth.captures(),
        }
    }

    /// Returns the node of each parcel of drainage, in the order of [`Growth::scattered`]; `u32::MAX` for parcels that
    /// have none yet.
    pub fn nodes_of_parcels(&self) -> &[u32] {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => &[],
            Grower::Drainage(growth) => growth.nodes(),
        }
    }

    /// Returns the settings of this growth.
    pub fn settings(&self) -> &GrowthSettings {
        &self.settings
    }

    /// Returns the way growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        match &self.grower {
            Grower::Colonize(growth) => growth.ending(),
            Grower::Brownian(growth) => growth.ending(),
            Grower::Drainage(growth) => growth.ending(),
        }
    }

    /// Returns the error that stopped growth before its end: not enough memory for more nodes.
    pub fn failure(&self) -> Option<GrowError> {
        (self.ending() == Some(Ending::OutOfMemory)).then(|| match &self.grower {
            Grower::Colonize(_) | Grower::Drainage(_) => GrowError::out_of_memory(&self.settings),
            Grower::Brownian(growth) => growth.out_of_memory(),
        })
    }

    /// Returns the number of river mouths; for a growing Brownian tree, so far.
    pub fn mouths(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.mouths(),
            Grower::Brownian(growth) => growth.mouths(),
            Grower::Drainage(growth) => growth.mouths(),
        }
    }

    /// Returns the number of scattered attractors, or of parcels; 0 for a Brownian tree.
    pub fn attractors(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors(),
            Grower::Drainage(growth) => growth.parcels(),
            Grower::Brownian(_) => 0,
        }
    }

    /// Returns the positions of scattered attractors, in the order in which they were drawn, or of parcels.
    pub fn scattered(&self) -> Vec<Vec2> {
        match &self.grower {
            Grower::Colonize(_) => scatter(&self.settings),
            Grower::Drainage(growth) => growth.places().to_vec(),
            Grower::Brownian(_) => Vec::new(),
        }
    }

    /// Returns the positions of attractors that still pull because no river has come near enough, in no particular
    /// order; in drainage, of parcels without a way to the sea so far.
    pub fn left(&self) -> Vec<Vec2> {
        match &self.grower {
            Grower::Colonize(growth) => growth.left(),
            Grower::Drainage(growth) => growth.left(),
            Grower::Brownian(_) => Vec::new(),
        }
    }

    /// Returns the number of attractors that no river has come near enough to, or of parcels without a way to the sea.
    pub fn unreached(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.unreached(),
            Grower::Drainage(growth) => growth.unreached(),
            Grower::Brownian(_) => 0,
        }
    }

    /// Returns the discharge of a river that would drain the whole map. It is known before growth begins; for a
    /// Brownian tree it is an estimate.
    pub fn total_discharge(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors(),
            Grower::Brownian(growth) => growth.total_discharge(),
            Grower::Drainage(growth) => growth.parcels(),
        }
    }

    /// Returns the approximate distance between streams, in units: that between attractors, or the sensitivity.
    pub fn stream_spacing(&self) -> f32 {
        match self.settings.method {
            GrowthMethod::Colonize => self.settings.spacing,
            GrowthMethod::Brownian => self.settings.sensitivity,
            GrowthMethod::Drainage => self.settings.drainage.spacing,
        }
    }

    /// Returns the mean distance between a node and its parent, in units.
    pub fn node_length(&self) -> f32 {
        match &self.grower {
            Grower::Colonize(_) => self.settings.step,
            Grower::Brownian(growth) => growth.node_length(),
            Grower::Drainage(_) => self.settings.drainage.spacing,
        }
    }

    /// Returns `true` if every mouth was asked for. Unless mouths are drawn, a Brownian tree has one wherever its
    /// particles met the coast, and drainage one wherever water leaves the land; most of them are those of brooks.
    pub fn mouths_are_chosen(&self) -> bool {
        match self.settings.method {
            _ if !self.settings.starts.is_empty() => true,
            GrowthMethod::Colonize => true,
            GrowthMethod::Brownian => false,
            GrowthMethod::Drainage => self.settings.mouths > 0 && !self.is_cut(),
        }
    }

    /// Returns `true` if the sea has risen over part of the tree: then its mouths are where valleys drowned.
    fn is_cut(&self) -> bool {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => false,
            Grower::Drainage(growth) => growth.is_cut(),
        }
    }

    /// Returns the discharge of the largest river, once growth has ended. Only drainage knows it.
    pub fn largest_basin(&self) -> Option<u32> {
        match &self.grower {
            Grower::Colonize(_) | Grower::Brownian(_) => None,
            Grower::Drainage(growth) => growth.largest_basin(),
        }
    }

    /// Returns `true` if the tree also covers hillsides, so that rivers begin only where enough of it drains.
    pub fn covers_hillsides(&self) -> bool {
        match self.settings.method {
            GrowthMethod::Colonize | GrowthMethod::Brownian => false,
            GrowthMethod::Drainage => true,
        }
    }

    /// Returns `true` if steps of the tree may cross each other. The strands of a Brownian tree never touch.
    pub fn may_cross(&self) -> bool {
        match self.settings.method {
            GrowthMethod::Colonize => true,
            GrowthMethod::Brownian | GrowthMethod::Drainage => false,
        }
    }

    /// Returns the amount that is drained so far, out of [`Growth::total_discharge`].
    pub fn drained(&self) -> u32 {
        match &self.grower {
            Grower::Colonize(growth) => growth.attractors() - growth.unreached(),
            Grower::Drainage(growth) => growth.parcels() - growth.unreached(),
            Grower::Brownian(growth) => growth.tree().len() as u32,
        }
    }

    /// Returns the share that is drained so far, from 0 to 1; for a Brownian tree, an estimate.
    pub fn progress(&self) -> f32 {
        (self.drained() as f32 / self.total_discharge().max(1) as f32).min(1.0)
    }
}
