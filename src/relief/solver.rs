//! The relief stage as a stepper: no step keeps a page waiting for long.

use super::cells::Cells;
use super::channels::Channels;
use super::creep::Creep;
use super::error::ReliefError;
use super::flow::ways_on;
use super::front::{Front, TILE};
use super::profile::elevations;
use super::rill_cells::RillCells;
use super::settings::ReliefSettings;
use super::steepness::Steepness;
use super::summits::{unworn, worn};
use super::{Grid, Relief};
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::parallel::for_each_row;
use crate::base::work;
use crate::network::Network;

/// A relief in the making.
#[derive(Clone, Debug)]
pub struct ReliefSolver {
    settings: ReliefSettings,
    /// The heights of rivers found by another relief, which may only be lowered here; `None` to find them.
    given: Option<GivenWater>,
    /// The memory that the relief needs, in bytes, approximately.
    bytes: usize,
    next: Part,
    cells: Cells,
    steepness: Steepness,
    rills: RillCells,
    channels: Channels,
    front: Front,
    creep: Creep,
    /// For each cell, `true` if a river passes it.
    is_river: Vec<bool>,
}

/// Heights of rivers taken from another relief.
#[derive(Clone, Debug)]
struct GivenWater {
    /// The height of the water at each vertex, in units.
    heights: Vec<f32>,
    /// [`ReliefSolver::lower_to_banks`], as a pointer so that programs that make no such relief do without its code.
    lower: fn(&mut ReliefSolver) -> Result<bool, Refused>,
}

/// The part that the next step does, or goes on with.
#[derive(Clone, Copy, Debug)]
enum Part {
    /// Finds the cells that are land.
    Cells,
    Hillsides,
    /// Finds the elevation of rivers by the slope of the hillsides around them.
    Profiles,
    /// Walks rills from cell to cell.
    Rills,
    /// Flattens valleys, from a vertex on.
    Valleys(usize),
    /// Raises ridges, from a segment on.
    Ridges(usize),
    /// Walks rivers from cell to cell.
    Channels,
    /// Divides the map into tiles, and adds the coast.
    Coast,
    /// Adds rivers to the tiles.
    Rivers,
    /// Moves the front on, then wears high ground; counts how often rivers have been lowered.
    Front(u32),
    /// Rounds hillsides.
    Creep,
    Finish,
}

/// The greatest number of queue entries by which the front moves on in a step.
const ENTRIES_A_STEP: usize = 20_000;

/// The greatest number of times that rivers are lowered to the ground beside them, and to their banks if their heights were given.
const MOST_BEDS: u32 = 4;
const MOST_BANKS: u32 = 5;

impl ReliefSolver {
    /// Begins the relief of a finished network. Nothing is computed yet, but the memory is known to be there.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(network: &Network, settings: ReliefSettings) -> Result<Self, ReliefError> {
        /// Distance, front with queue, and height of a cell, or heights before and after creep; and paths where rivers have few vertices.
        const BYTES_A_CELL: usize = 20;
        const BYTES_A_VERTEX: usize = 40;
        let Grid { columns, rows, .. } = settings.grid;
        let this = Self {
            settings,
            given: None,
            bytes: (columns + 2) * (rows + 2) * BYTES_A_CELL + network.vertices.len() * BYTES_A_VERTEX,
            next: Part::Cells,
            cells: Cells::default(),
            steepness: Steepness::default(),
            rills: RillCells::default(),
            channels: Channels::default(),
            front: Front::default(),
            creep: Creep::default(),
            is_river: Vec::new(),
        };
        ask(this.bytes).map_err(|_| this.refused())?;
        Ok(this)
    }

    /// Begins a relief whose rivers have given heights, in units, one for each vertex: only the land between them is solved.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub(super) fn with_water(
        network: &Network,
        settings: ReliefSettings,
        water: Vec<f32>,
    ) -> Result<Self, ReliefError> {
        let given = GivenWater { heights: water, lower: Self::lower_to_banks };
        Ok(Self { given: Some(given), ..Self::new(network, settings)? })
    }

    /// Does a step of the work for `network`, with which it was begun. Returns the relief once it is finished.
    ///
    /// # Errors
    /// If there is not enough memory. A further call tries the same step again.
    pub fn step(&mut self, network: &Network) -> Result<Option<Relief>, ReliefError> {
        if matches!(self.next, Part::Finish) {
            return self.finished().map(Some).map_err(|_| self.refused());
        }
        // A step that fails is tried again by the next call.
        self.next = self.advance(network).map_err(|_| self.refused())?;
        Ok(None)
    }

    /// Returns the share of the work that is done, from 0 to 1.
    pub fn progress(&self) -> f32 {
        match self.next {
            Part::Cells => 0.0,
            Part::Hillsides | Part::Profiles => 0.05,
            Part::Rills | Part::Valleys(_) | Part::Ridges(_) | Part::Channels => 0.1,
            Part::Coast | Part::Rivers => 0.2,
            Part::Front(_) => 0.2 + 0.8 * self.front.progress(),
            Part::Creep | Part::Finish => 1.0,
        }
    }

    fn refused(&self) -> ReliefError {
        ReliefError::OutOfMemory { megabytes: (self.bytes / 1_000_000) as u32 + 1 }
    }

    /// Does the next part, or some of it. Returns the part to go on with.
    fn advance(&mut self, network: &Network) -> Result<Part, Refused> {
        Ok(match self.next {
            Part::Cells => {
                self.cells = Cells::new(&self.settings)?;
                Part::Hillsides
            }
            Part::Hillsides => {
                self.steepness = Steepness::of_hillsides(&self.settings, &self.cells)?;
                // Nothing else goes by the low stand.
                self.cells.from_low_stand = Vec::new();
                Part::Profiles
            }
            Part::Profiles => {
                self.channels = Channels::new(network, self.elevations(network)?)?;
                if self.settings.rill_lines.is_some() {
                    self.rills = RillCells::new(self.cells.inland.len())?;
                }
                Part::Rills
            }
            Part::Rills => self.carve(),
            Part::Valleys(from) => {
                let Self { settings, cells, steepness, .. } = self;
                steepness.flatten_valleys(settings, cells, network, from).map_or(Part::Ridges(0), Part::Valleys)
            }
            Part::Ridges(from) => {
                let land = self.settings.land.as_deref();
                let next = land.and_then(|land| self.steepness.raise_ridges(&self.cells, land, from));
                next.map_or(Part::Channels, Part::Ridges)
            }
            Part::Channels => match self.channels.walk(&self.cells, network)? {
                true => self.next,
                false => {
                    self.steepness.finish();
                    Part::Coast
                }
            },
            Part::Coast => {
                let Self { settings, cells, steepness, .. } = self;
                self.front = Front::new(cells, &steepness.rises, TILE, settings.threads)?;
                self.front.add_coast(cells, settings.threads);
                self.steepness = Steepness::default();
                Part::Rivers
            }
            Part::Rivers => {
                self.front.add_rivers(&self.cells, &self.channels);
                Part::Front(0)
            }
            Part::Front(times) => match self.front.advance(ENTRIES_A_STEP, self.settings.threads) {
                true => self.next,
                false if self.lower(times)? => Part::Front(times + 1),
                false => self.settle()?,
            },
            Part::Creep => match self.creep.advance(&self.cells, &self.is_river, self.settings.threads)? {
                true => self.next,
                false => {
                    self.is_river = Vec::new();
                    Part::Finish
                }
            },
            Part::Finish => self.next,
        })
    }

    /// Computes the height of the water at each vertex before wear and before any is lowered, in units.
    fn elevations(&mut self, network: &Network) -> Result<Vec<f32>, Refused> {
        /// Memory for the elevation of each vertex, and for the lists that it is computed from.
        const BYTES_A_VERTEX: usize = 20;
        ask(network.vertices.len() * BYTES_A_VERTEX)?;
        work::count(4 * network.vertices.len());
        if let Some(given) = &self.given {
            return Ok(given.heights.iter().map(|&height| unworn(height)).collect());
        }
        Ok(elevations(network, self.settings.total_discharge, &self.cells, &self.steepness.rises))
    }

    /// Walks some rills, and carves hillsides once all are walked. Returns the part to go on with.
    fn carve(&mut self) -> Part {
        let Some(rills) = self.settings.rill_lines.as_deref() else { return Part::Valleys(0) };
        if self.rills.walk(&self.cells, rills) {
            return Part::Rills;
        }
        self.steepness.carve(&self.settings, &self.cells, &std::mem::take(&mut self.rills));
        Part::Valleys(0)
    }

    /// Lowers rivers once more, where they stand above the ground around. Returns `true` if the front has to move again.
    fn lower(&mut self, times: u32) -> Result<bool, Refused> {
        match self.given.as_ref().map(|given| given.lower) {
            Some(lower) => Ok(times < MOST_BANKS && lower(self)?),
            None => Ok(times < MOST_BEDS && self.lower_beds()?),
        }
    }

    /// Lowers rivers to the ground at their sides. Returns `true` if any stood above it.
    fn lower_beds(&mut self) -> Result<bool, Refused> {
        let heights = self.heights()?;
        let Self { channels, cells, front, .. } = self;
        channels.find_perched(cells, &heights, |cell, height| front.lower(cell, height))
    }

    /// Reads the heights of all cells from the front, in units before wear; infinite where there is no land.
    fn heights(&self) -> Result<Vec<f32>, Refused> {
        let mut heights = Vec::new();
        lengthen(&mut heights, self.cells.inland.len(), f32::INFINITY)?;
        self.front.write(&mut heights, self.settings.threads);
        Ok(heights)
    }

    /// Lowers rivers to their banks: on a grid finer than the one their heights come from, hillsides come out a little
    /// lower, and rivers would stand on dams. Returns `true` if any were lowered noticeably.
    fn lower_to_banks(&mut self) -> Result<bool, Refused> {
        /// The mean lowering of a river's cells, in units, that may be ignored.
        const ENOUGH: f32 = 0.0005;
        let heights = self.heights()?;
        let Self { channels, cells, front, .. } = self;
        let lowered = channels.find_dams(cells, &heights, |cell, height| front.lower(cell, height))?;
        Ok(lowered > ENOUGH * self.channels.len() as f32)
    }

    /// Takes the heights from the front, wears them, lets rivers fall, and begins creep.
    fn settle(&mut self) -> Result<Part, Refused> {
        let mut heights = self.heights()?;
        let is_river = self.channels.marked(heights.len())?;
        work::count(heights.len());
        for_each_row(&mut heights, self.cells.columns, self.settings.threads, |_, heights| {
            heights.iter_mut().filter(|height| **height < f32::INFINITY).for_each(|height| *height = worn(*height));
        });
        self.channels.let_fall(&self.cells, &mut heights);
        self.creep = Creep::new(&self.cells, heights, &is_river)?;
        (self.is_river, self.front) = (is_river, Front::default());
        Ok(Part::Creep)
    }

    /// Finds the cell that the water of each cell of the finished relief runs to, as [`Flow::ways`](super::Flow::ways) does.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub(crate) fn ways(&self, network: &Network) -> Result<Vec<u32>, ReliefError> {
        const BYTES_A_CELL: usize = 13;
        ask(self.cells.inland.len() * BYTES_A_CELL).map_err(|_| self.refused())?;
        let height = |cell: usize| match (self.cells.is_land(cell), self.cells.is_sea(cell)) {
            (true, _) => self.creep.heights[cell],
            (_, true) => 0.0,
            _ => f32::INFINITY,
        };
        let heights = (0..self.cells.inland.len()).map(height).collect();
        Ok(ways_on(&self.cells, heights, &self.channels, network))
    }

    fn finished(&self) -> Result<Relief, Refused> {
        let Cells { columns, rows, .. } = self.cells;
        let mut heights = Vec::new();
        lengthen(&mut heights, (columns - 2) * (rows - 2), 0.0)?;
        for_each_row(&mut heights, columns - 2, self.settings.threads, |row, heights| {
            for (cell, height) in ((row + 1) * columns + 1..).zip(heights) {
                *height = match self.cells.is_land(cell) {
                    true => self.creep.heights[cell],
                    false => depth(self.cells.inland[cell]),
                };
            }
        });
        work::count(heights.len());
        Ok(Relief { grid: self.settings.grid, heights })
    }
}

/// Returns the height of the sea floor, negative, at a coast distance, negative too: it falls away to `DEEPEST`. Both are in units.
fn depth(inland: f32) -> f32 {
    const DEEPEST: f32 = 12.0;
    const FAR: f32 = 80.0;
    DEEPEST * (libm::expf(inland / FAR) - 1.0)
}
