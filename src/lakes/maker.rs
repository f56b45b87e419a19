//! The lakes of a map in the making: no step keeps a page waiting for long.

use super::areas::areas;
use super::flood::{Dam, Flooded, Ground, around};
use super::shores::area;
use super::sites::{Site, sites};
use super::upstream::Upstream;
use super::{Cell, Lake, Lakes, Outlet, SHORE};
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::random::{Purpose, Seed};
use crate::base::work;
use crate::network::Network;
use crate::relief::{Flow, Relief, ReliefError, ReliefSettings};

/// The lakes of a map, as far as they are made.
#[derive(Clone, Debug)]
pub(crate) struct LakeMaker {
    /// The share of the most land under lakes that is asked for.
    share: f32,
    seed: Seed,
    next: Part,
    made: Lakes,
    /// `true` for cells in a lake or close to one.
    is_taken: Vec<bool>,
}

/// The part that the next step does, or goes on with.
#[derive(Clone, Debug)]
enum Part {
    Ways,
    Order(Vec<u32>),
    Flood(Box<Search>),
}

/// The search for places of lakes.
#[derive(Clone, Debug)]
struct Search {
    upstream: Upstream,
    sites: Vec<Site>,
    /// For each site, the number of cells that it is known to be too small for.
    too_many: Vec<usize>,
    /// The areas that lakes are still to have, the least first, in square units.
    areas: Vec<f32>,
}

/// The number of elementary steps after which a step ends.
const WORK_A_STEP: u64 = 500_000;

/// The wavelength of the unevenness of shores, in units.
const ROUGH: f32 = 18.0;

/// The number of sites that are tried for a lake.
const TRIES: usize = 60;

/// The number of cells that lakes keep from each other.
const APART: usize = 2;

/// The least area that drains to a lake, as a multiple of its own.
const BASIN: usize = 4;

impl LakeMaker {
    /// Begins the lakes of a map: `share` of the most land under lakes that there may be.
    pub fn new(share: f32, seed: Seed) -> Self {
        Self { share, seed, next: Part::Ways, made: Lakes::default(), is_taken: Vec::new() }
    }

    /// Does a step of the work on a finished relief, made of these rivers with these settings. Returns the lakes once they are made.
    ///
    /// # Errors
    /// If there is not enough memory. A further call begins again.
    pub fn step(
        &mut self,
        relief: &Relief,
        network: &Network,
        settings: impl FnOnce() -> ReliefSettings,
    ) -> Result<Option<Lakes>, ReliefError> {
        self.next = match std::mem::replace(&mut self.next, Part::Ways) {
            Part::Ways => Part::Order(Flow::ways(relief, network, &settings())?),
            Part::Order(ways) => {
                let bytes = ways.len() * BYTES_A_CELL;
                let refused = |_| ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
                Part::Flood(self.begin(ways, relief, network).map_err(refused)?.into())
            }
            Part::Flood(mut search) => match self.advance(&mut search, relief, network) {
                true => Part::Flood(search),
                false => return Ok(Some(std::mem::take(&mut self.made))),
            },
        };
        Ok(None)
    }

    fn begin(&mut self, ways: Vec<u32>, relief: &Relief, network: &Network) -> Result<Search, Refused> {
        ask(ways.len() * BYTES_A_CELL)?;
        self.made = Lakes { grid: Some(relief.grid()), ..Lakes::default() };
        lengthen(&mut self.made.cells, ways.len(), Cell::DRY)?;
        self.is_taken.clear();
        lengthen(&mut self.is_taken, ways.len(), false)?;
        work::count(ways.len());
        let cell = relief.cell_size() * relief.cell_size();
        let land = relief.heights().iter().filter(|height| **height > 0.0).count() as f32 * cell;
        let sites = sites(network, relief, self.seed);
        let mut areas = areas(self.share, land);
        areas.reverse();
        Ok(Search { upstream: Upstream::of(ways)?, too_many: vec![usize::MAX; sites.len()], sites, areas })
    }

    /// Places some more lakes. Returns `true` if there are more.
    fn advance(&mut self, search: &mut Search, relief: &Relief, network: &Network) -> bool {
        let (begun, noise) = (work::steps(), self.seed.noise(Purpose::Lakes, 1, 1.0 / ROUGH, 3));
        let cell = relief.cell_size() * relief.cell_size();
        while let Some(area) = search.areas.pop() {
            let cells = (area / cell) as usize;
            let (upstream, is_taken, noise) = (&search.upstream, &self.is_taken, &noise);
            let ground = Ground { relief, upstream, is_taken, noise };
            let found = find(&ground, network, &search.sites, &mut search.too_many, cells);
            if let Some((site, dam, flooded)) = found {
                let lake = make(&ground, (&search.sites[site], &dam), &flooded, network, self.seed);
                search.too_many[site] = 0;
                self.add(lake, &flooded, &search.upstream, relief);
            }
            if work::steps() - begun >= WORK_A_STEP {
                return true;
            }
        }
        false
    }

    fn add(&mut self, lake: Lake, flooded: &Flooded, upstream: &Upstream, relief: &Relief) {
        let mut edge = flooded.cells.clone();
        for &cell in &edge {
            self.made.cells[cell] = Cell(self.made.list.len() as u32);
            self.is_taken[cell] = true;
        }
        self.add_shore(&lake, flooded, upstream, relief);
        for _ in 0..APART {
            let mut beside: Vec<usize> =
                edge.iter().flat_map(|cell| around(&relief.grid(), *cell)).flatten().collect();
            beside.retain(|cell| !std::mem::replace(&mut self.is_taken[*cell], true));
            edge = beside;
        }
        self.made.list.push(lake);
    }
}

impl LakeMaker {
    /// Marks the shore of a lake: the ground whose water runs into it and that lies under its level, or hardly over it.
    fn add_shore(&mut self, lake: &Lake, flooded: &Flooded, upstream: &Upstream, relief: &Relief) {
        let mut edge = flooded.cells.clone();
        while let Some(cell) = edge.pop() {
            work::count(8);
            for beside in around(&relief.grid(), cell).into_iter().flatten() {
                let is_low = relief.heights()[beside] < lake.level + SHORE;
                if is_low && upstream.to[beside] as usize == cell && !self.is_taken[beside] {
                    // No other lake may lie there.
                    self.is_taken[beside] = true;
                    self.made.cells[beside] = Cell(self.made.list.len() as u32 | Cell::SHORE);
                    edge.push(beside);
                }
            }
        }
    }
}

/// The memory of a cell: the order of cells, and what is told of each.
const BYTES_A_CELL: usize = 32;

/// Finds the first site that can hold a lake of so many cells, of some that are tried.
fn find(
    ground: &Ground<'_>,
    network: &Network,
    sites: &[Site],
    too_many: &mut [usize],
    cells: usize,
) -> Option<(usize, Dam, Flooded)> {
    let mut tries = 0;
    for (i, site) in sites.iter().enumerate() {
        let is_known = too_many[i] <= cells;
        if is_known || (ground.upstream.count(site.cell) as usize) < BASIN * cells {
            continue;
        }
        let above = (network.rivers[site.river as usize].start..site.vertex).rev();
        let dam = Dam::new(ground.relief, site.cell, cells, above.map(|vertex| network.vertices[vertex as usize].at));
        if let Some(mut flooded) = ground.flood(&dam, cells) {
            ground.widen(&mut flooded, &dam);
            return Some((i, dam, flooded));
        }
        too_many[i] = cells;
        tries += 1;
        if tries == TRIES {
            break;
        }
    }
    None
}

/// Makes a lake of what is flooded above a dam.
fn make(ground: &Ground<'_>, (site, dam): (&Site, &Dam), flooded: &Flooded, network: &Network, seed: Seed) -> Lake {
    let rings = ground.shores(flooded, dam);
    let river = network.rivers[site.river as usize].identity;
    let whole: f32 = rings.iter().map(|ring| area(ring)).sum();
    Lake {
        identity: seed.item_hash(Purpose::Lakes).bits([river, site.number, 1]),
        at: ground.midst(flooded),
        level: flooded.level,
        depth: flooded.level - flooded.bed,
        area: whole.abs(),
        outlet: Outlet { river: site.river, vertex: site.vertex },
        rings,
    }
}
