//! Queries about the rivers of a finished map: the river at a place, its properties, its way to the sea and its basin.
//!
//! Queries are repeated while a pointer moves, so their data is prepared once per map: an index of all river segments
//! (`lines.rs`), the order at every vertex (`orders.rs`), and the river that the water of each land cell comes to
//! (`basins.rs`). Queries that also work on a growing map are in `growing.rs` and `captures.rs`.

mod basins;
mod captures;
mod curvature;
mod growing;
mod lines;
mod orders;

pub use captures::former_ways;
pub use growing::{cut, tips};
pub use lines::Spot;

use std::sync::Arc;

use glam::Vec2;

use self::basins::RiverBasins;
use self::lines::CourseLines;
use crate::analyse::statistics::Drained;
use crate::base::geometry::{fast_min, nearest};
use crate::base::memory;
use crate::deltas::{Deltas, Distributary};
use crate::map::Map;
use crate::network::{NONE, Network, Place};

/// The rivers of a finished map, ready for queries.
#[derive(Debug)]
pub struct Inspector {
    network: Arc<Network>,
    lines: CourseLines,
    orders: Vec<u8>,
    basins: RiverBasins,
    drained: Drained,
    deltas: Arc<Deltas>,
}

/// The properties of a river.
#[derive(Clone, Debug, PartialEq)]
pub struct RiverFacts {
    /// Strahler's order at its end.
    pub order: u8,
    /// Strahler's order at the place of the query.
    pub order_here: u8,
    /// Its length, in units.
    pub length: f32,
    /// The share of all land that it drains, from 0 to 1.
    pub share: f64,
    /// The area that it drains, in square units.
    pub area: f64,
    /// The numbers, in the network, of the rivers that its water comes to, in order; empty if it reaches the sea itself.
    pub into: Vec<u32>,
    /// The number of mouths by which it reaches the sea: the branches of its delta that end there, or 1.
    pub mouths: usize,
}

impl Inspector {
    /// Prepares the rivers of a map for queries; `None` if there is not enough memory.
    pub fn new(map: &Map) -> Option<Self> {
        /// For the lines and their index.
        const BYTES_A_VERTEX: usize = 120;
        let network = map.network();
        if !memory::can_allocate(network.vertices.len() * BYTES_A_VERTEX) {
            return None;
        }
        Some(Self {
            lines: CourseLines::new(network),
            orders: orders::along(network),
            basins: RiverBasins::new(map)?,
            drained: Drained::of(map),
            network: network.clone(),
            deltas: map.deltas().clone(),
        })
    }

    /// Returns the rivers that are asked about.
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Returns the Strahler order of the river at each vertex.
    pub fn orders(&self) -> &[u8] {
        &self.orders
    }

    /// Returns the parts of rivers whose vertices satisfy `is_so`, each extended to the next vertex below.
    pub fn stretches(&self, is_so: impl Fn(usize) -> bool) -> Vec<Vec<Vec2>> {
        let mut stretches: Vec<Vec<Vec2>> = Vec::new();
        for (number, river) in (0..).zip(&self.network.rivers) {
            let mut is_open = false;
            for (vertex, pair) in river.vertex_range().zip(self.lines.line(number).windows(2)) {
                match stretches.last_mut().filter(|_| is_open && is_so(vertex)) {
                    Some(last) => last.push(pair[1].at),
                    None if is_so(vertex) => stretches.push(pair.iter().map(|place| place.at).collect()),
                    None => {}
                }
                is_open = is_so(vertex);
            }
        }
        stretches
    }

    /// Finds the place on a river that is nearest to a point, measured from the banks, if it is within `reach` units. A point at a
    /// branch of a delta finds the place where its river divides.
    pub fn nearest(&self, at: Vec2, reach: f32) -> Option<Spot> {
        self.lines.nearest(at, reach).or_else(|| self.lines.mouth(self.branch(at, reach)?.river))
    }

    /// Finds the branch of a delta that is nearest to a point, measured from its banks, if it is within `reach` units.
    fn branch(&self, at: Vec2, reach: f32) -> Option<&Distributary> {
        let off = |branch: &Distributary| {
            let off = |pair: &[Place]| {
                let (away, _) = nearest(at, (pair[0].at, pair[1].at));
                away - pair[0].half
            };
            branch.line.windows(2).map(off).fold(f32::INFINITY, fast_min)
        };
        let branches = self.deltas.distributaries.iter().map(|branch| (off(branch), branch));
        let near = branches.filter(|(off, _)| *off <= reach);
        near.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, branch)| branch)
    }

    /// Finds the source of a river by its number in the network; `None` if there is none.
    pub fn source(&self, river: u32) -> Option<Spot> {
        self.lines.source(river)
    }

    /// Returns the properties of the river at a place.
    pub fn facts(&self, spot: &Spot) -> RiverFacts {
        let river = &self.network.rivers[spot.river as usize];
        let discharge = self.network.discharge(river);
        let vertex = (river.start + spot.segment).min(river.end - 1);
        let mut into = Vec::new();
        let mut below = river.parent;
        while below != NONE {
            into.push(below);
            below = self.network.rivers[below as usize].parent;
        }
        let mouths =
            self.deltas.distributaries.iter().filter(|branch| branch.river == spot.river && branch.reaches_sea);
        RiverFacts {
            mouths: mouths.count().max(1),
            order: river.order,
            order_here: self.orders[vertex as usize],
            length: self.network.length(river),
            share: self.drained.share(discharge),
            area: self.drained.area(discharge),
            into,
        }
    }

    /// Traces the way from a place to the sea, along its river and then along the rivers that it joins.
    pub fn way_to_the_sea(&self, spot: &Spot) -> Vec<Place> {
        let mut way = vec![spot.place];
        let (mut river, mut next) = (spot.river, spot.segment as usize + 1);
        loop {
            let (line, here) = (self.lines.line(river), &self.network.rivers[river as usize]);
            // A tributary's last place is left out: the line of the river that it joins goes on from there.
            let is_tributary = here.parent != NONE;
            way.extend_from_slice(line.get(next..line.len() - usize::from(is_tributary)).unwrap_or_default());
            if !is_tributary {
                return way;
            }
            next = here.junction.saturating_sub(self.network.rivers[here.parent as usize].start) as usize;
            river = here.parent;
        }
    }

    /// Returns the rings around the land that a river and its tributaries drain, in units.
    pub fn basin(&self, river: u32) -> Vec<Vec<Vec2>> {
        self.basins.rings(|other| self.is_above(other, river))
    }

    /// Returns `true` if a river is `other`, or if its water comes to that.
    fn is_above(&self, mut river: u32, other: u32) -> bool {
        while river != other && river != NONE {
            river = self.network.rivers[river as usize].parent;
        }
        river == other
    }
}
