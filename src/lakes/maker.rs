//! The lakes of a map in the making: no step keeps a page waiting for long.

use std::cell::Cell as Known;

use super::areas::areas;
use super::cells::around;
use super::flood::{Dam, Flooded, Ground, Unevenness};
use super::list::{Cell, Lake, Lakes, Outlet};
use super::sites::{Site, sites};
use super::upstream::Upstream;
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::random::{Purpose, Seed};
use crate::base::rings::area;
use crate::base::work;
use crate::network::Network;
use crate::relief::{Flow, Relief, ReliefError, ReliefSettings};

/// The lakes of a map, as far as they are made.
#[derive(Debug)]
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
#[derive(Debug)]
enum Part {
    Ways,
    Order(Vec<u32>),
    Flood(Box<Search>),
}

/// The search for places of lakes.
#[derive(Debug)]
struct Search {
    upstream: Upstream,
    /// What is known of the unevenness of each cell.
    unevenness: Vec<f32>,
    sites: Vec<Site>,
    /// For each site, the number of cells that it is known to be too small for.
    too_many: Vec<usize>,
    /// The areas that lakes are still to have, the least first, in square units.
    areas: Vec<f32>,
}

/// The number of elementary steps after which a step ends.
const WORK_A_STEP: u64 = 500_000;

/// The number of sites that are tried for a lake.
const TRIES: usize = 150;

/// The number of cells from which on a lake is great, and the number of sites for a great lake among which the best is chosen.
const GREAT: usize = 70;
const FEW: usize = 6;

/// The number of cells that lakes keep from each other.
const APART: usize = 2;

/// The least area that drains to a lake, as a multiple of its own.
const BASIN: usize = 4;

impl LakeMaker {
    /// Begins the lakes of a map: `share` of the most land under lakes that there may be.
    pub fn new(share: f32, seed: Seed) -> Self {
        Self { share, seed, next: Part::Ways, made: Lakes::default(), is_taken: Vec::new() }
    }

    /// Goes by known ways of water: the cell that that of each cell runs to, as [`Flow::ways`] finds them.
    #[must_use]
    pub fn along(self, ways: Vec<u32>) -> Self {
        Self { next: Part::Order(ways), ..self }
    }

    /// Does a step of the work on a finished relief, made of these rivers with these settings. Returns the lakes once they are made.
    ///
    /// # Errors
    /// If there is not enough memory. A further call tries the same step again.
    pub fn step(
        &mut self,
        relief: &Relief,
        network: &Network,
        settings: impl FnOnce() -> ReliefSettings,
    ) -> Result<Option<Lakes>, ReliefError> {
        self.next = match std::mem::replace(&mut self.next, Part::Ways) {
            Part::Ways => Part::Order(Flow::ways(relief, network, &settings())?),
            Part::Order(ways) => match self.begin(&ways, relief, network) {
                Ok(search) => Part::Flood(search.into()),
                Err(Refused) => {
                    let bytes = ways.len() * BYTES_A_CELL;
                    self.next = Part::Order(ways);
                    return Err(ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 });
                }
            },
            Part::Flood(mut search) => match self.advance(&mut search, relief, network) {
                true => Part::Flood(search),
                false => return Ok(Some(std::mem::take(&mut self.made))),
            },
        };
        Ok(None)
    }

    fn begin(&mut self, ways: &[u32], relief: &Relief, network: &Network) -> Result<Search, Refused> {
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
        let mut unevenness = Vec::new();
        lengthen(&mut unevenness, ways.len(), Unevenness::UNKNOWN)?;
        Ok(Search { upstream: Upstream::of(ways)?, unevenness, too_many: vec![usize::MAX; sites.len()], sites, areas })
    }

    /// Places some more lakes. Returns `true` if there are more.
    fn advance(&mut self, search: &mut Search, relief: &Relief, network: &Network) -> bool {
        let begun = work::steps();
        let Search { upstream, unevenness, sites, too_many, areas } = search;
        let unevenness = Unevenness::of(self.seed, Known::from_mut(&mut unevenness[..]).as_slice_of_cells());
        let cell = relief.cell_size() * relief.cell_size();
        while let Some(area) = areas.pop() {
            let ground =
                Ground { relief, upstream, is_taken: &self.is_taken, made: &self.made, unevenness: &unevenness };
            if let Some(found) = find(&ground, network, sites, too_many, (area / cell) as usize) {
                let lake = make(&ground, &sites[found.site], &found, network, self.seed);
                too_many[found.site] = 0;
                self.add(lake, &found, relief);
            }
            if work::steps() - begun >= WORK_A_STEP {
                return true;
            }
        }
        false
    }

    fn add(&mut self, lake: Lake, Found { flooded, shore, .. }: &Found, relief: &Relief) {
        let number = self.made.list.len() as u32;
        for &cell in &flooded.cells {
            self.made.cells[cell] = Cell(number);
            self.is_taken[cell] = true;
        }
        let mut edge = flooded.cells.clone();
        for _ in 0..APART {
            let mut beside: Vec<usize> = edge.iter().flat_map(|cell| around(&relief.grid(), *cell)).flatten().collect();
            beside.retain(|cell| !std::mem::replace(&mut self.is_taken[*cell], true));
            edge = beside;
        }
        for &(cell, _) in shore {
            // No other lake may lie there.
            self.made.cells[cell as usize] = Cell(number | Cell::SHORE);
            self.is_taken[cell as usize] = true;
        }
        self.made.raised.extend(shore);
        self.made.list.push(lake);
    }
}

/// The memory of a cell: the order of cells, and what is told of each.
const BYTES_A_CELL: usize = 40;

/// A place that has been found for a lake.
struct Found {
    /// The index of its site.
    site: usize,
    dam: Dam,
    flooded: Flooded,
    /// The cells of its shore that are raised, each with its height, in units.
    shore: Vec<(u32, f32)>,
}

/// Finds a site for a lake of so many cells: the first of some that are tried, and for a great lake, of the first few that can hold it the
/// one with the longest shore.
fn find(ground: &Ground<'_>, network: &Network, sites: &[Site], too_many: &mut [usize], cells: usize) -> Option<Found> {
    let (mut tries, mut left) = (TRIES, if cells >= GREAT { FEW } else { 1 });
    let mut best: Option<(usize, Found)> = None;
    for (i, site) in sites.iter().enumerate() {
        let is_unfit =
            too_many[i] <= cells || site.least > cells as f32 * ground.relief.cell_size() * ground.relief.cell_size();
        if is_unfit || (ground.upstream.count(site.cell) as usize) < BASIN * cells {
            continue;
        }
        match attempt(ground, network, (i, site), cells) {
            Some(found) => {
                let edge = ground.edge(&found.flooded);
                if best.as_ref().is_none_or(|(longest, _)| edge > *longest) {
                    best = Some((edge, found));
                }
                left -= 1;
            }
            None => too_many[i] = cells,
        }
        tries -= 1;
        if tries == 0 || left == 0 {
            break;
        }
    }
    best.map(|(_, found)| found)
}

/// Floods the ground above a site until so many cells are under water. `None` if it cannot hold them.
fn attempt(ground: &Ground<'_>, network: &Network, (number, site): (usize, &Site), cells: usize) -> Option<Found> {
    let above = (network.rivers[site.river as usize].start..site.vertex).rev();
    let dam = Dam::new(ground.relief, site.cell, cells, above.map(|vertex| network.vertices[vertex as usize].at));
    let mut flooded = ground.flood(&dam, cells)?;
    ground.widen(&mut flooded, &dam);
    let shore = ground.shore(&flooded)?;
    Some(Found { site: number, dam, flooded, shore })
}

/// Makes a lake in the place that has been found for it.
fn make(ground: &Ground<'_>, site: &Site, Found { dam, flooded, .. }: &Found, network: &Network, seed: Seed) -> Lake {
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
