//! The land that a risen sea leaves: what lies above a level of heights over a low stand.

use super::cell::{CELL_SIZE, Cell};
use super::coast_distance::CoastDistance;
use super::grid::{Grid, runs_above_water};
use super::queries::Land;
use super::regions::{Region, Run, is_in, regions_of};
use crate::domain::Domain;

/// The least depth of water at the corners of the lattice, in units, so that every channel is some cells wide.
const SHALLOWEST: f32 = 1.0;

/// A sea that has risen to a level, over a low stand.
#[derive(Clone, Debug)]
pub(crate) struct RisenSea<'a> {
    low: &'a Land,
    /// The heights above the level at the corners of the low stand's lattice, in units, with specks of land sunk.
    over: Vec<f32>,
    /// The share of the domain that is sea.
    share: f32,
}

impl<'a> RisenSea<'a> {
    /// Raises the sea to a level, in units, of heights at the corners. Specks of land sink.
    pub fn new(low: &'a Land, heights: &[f32], level: f32) -> Self {
        let mut this = Self { low, over: heights.iter().map(|height| height - level).collect(), share: 0.0 };
        let land: u32 = this.sink_specks(&|lattice| lattice).1.iter().map(|run| run.end - run.start).sum();
        this.share = 1.0 - land as f32 / Grid::cells_on(&this.domain()) as f32;
        this
    }

    /// Estimates the share of the domain that is sea, without the distances that decide where exactly the coast runs.
    pub fn share(&self) -> f32 {
        self.share
    }

    /// Makes the land that the sea has left.
    pub fn into_land(mut self) -> Land {
        // The exact coast may leave another speck.
        let low = self.low;
        let (coast, runs) = self.sink_specks(&|lattice| low.with_ragged_coasts(lattice.settled()));
        self.land(coast, runs)
    }

    /// Makes the land that the sea has left, but for specks and notches, in half the time: for a picture that is soon gone. The
    /// land of a higher level lies within it.
    pub fn into_passing_land(self) -> Land {
        let (coast, runs) = self.coast(CoastDistance::settled);
        self.land(coast, runs)
    }

    fn land(&self, coast: CoastDistance, runs: Vec<Run>) -> Land {
        Land::on(Grid::of_runs(&self.domain(), runs), coast, self.low.ridges().to_vec())
    }

    fn domain(&self) -> Domain {
        Domain { size: self.low.size() }
    }

    /// Sinks specks of land until there are none, as far as `settle` tells where the coast runs. Returns what is left: the coast, and
    /// the cells of land.
    fn sink_specks(&mut self, settle: &dyn Fn(CoastDistance) -> CoastDistance) -> (CoastDistance, Vec<Run>) {
        /// The least area of an island, in cells.
        const SPECK: u32 = 40;
        /// The number of times that specks are looked for: each time there are fewer corners of land.
        const ROUNDS: usize = 8;
        let mut round = 1;
        loop {
            let (coast, runs) = self.coast(settle);
            let specks: Vec<Region> = regions_of(&runs).into_iter().filter(|part| part.cells < SPECK).collect();
            let bare = corners_without_cells(&coast, &runs);
            if (specks.is_empty() && bare.is_empty()) || round == ROUNDS {
                return (coast, runs);
            }
            sink(&specks, &coast, &mut self.over);
            bare.into_iter().for_each(|corner| self.over[corner] = self.over[corner].min(-SHALLOWEST));
            round += 1;
        }
    }

    fn coast(&self, settle: impl Fn(CoastDistance) -> CoastDistance) -> (CoastDistance, Vec<Run>) {
        let coast = settle(self.low.coast_distance().with_heights_of(&self.over)).deepened(SHALLOWEST);
        let runs = runs_above_water(&self.domain(), &coast);
        (coast, runs)
    }
}

/// Sinks the corners of some regions: those that touch one of a region's cells or, if none of them is land, all around
/// it.
fn sink(regions: &[Region], coast: &CoastDistance, over: &mut [f32]) {
    for region in regions {
        let touching = corners_around(region, coast, true);
        let is_land = |corner: &usize| over[*corner] > 0.0;
        let sunk = if touching.iter().any(is_land) { touching } else { corners_around(region, coast, false) };
        for corner in sunk {
            over[corner] = over[corner].min(-SHALLOWEST);
        }
    }
}

/// Lists the corners of parts of the land without a single cell. There would still be a coast around them, and water lines.
fn corners_without_cells(coast: &CoastDistance, land: &[Run]) -> Vec<usize> {
    let (columns, _) = coast.size();
    let apart = (coast.spacing() / CELL_SIZE) as i32;
    let has_cell = |corner: usize| {
        let (column, row) = ((corner % columns) as i32 * apart, (corner / columns) as i32 * apart);
        let touching = [(column, row), (column - 1, row), (column, row - 1), (column - 1, row - 1)];
        touching.into_iter().any(|(column, row)| is_in(land, column as u32, row as u32))
    };
    let mut parts = coast.regions(Cell::Land);
    parts.retain(|part| !coast.corners_of(part).any(has_cell));
    parts.iter().flat_map(|part| coast.corners_of(part)).collect()
}

/// Lists the corners of all lattice squares that a region has cells in, or only those that touch a cell.
fn corners_around(region: &Region, coast: &CoastDistance, is_touching: bool) -> Vec<usize> {
    let (columns, rows) = coast.size();
    let apart = (coast.spacing() / CELL_SIZE) as u32;
    let first = |cell: u32| if is_touching { cell.div_ceil(apart) } else { cell / apart };
    let last = |cell: u32| if is_touching { (cell + 1) / apart } else { cell / apart + 1 };
    let mut corners = Vec::new();
    for run in &region.runs {
        for row in first(run.row)..=last(run.row).min(rows as u32 - 1) {
            for column in first(run.start)..=last(run.end - 1).min(columns as u32 - 1) {
                corners.push(row as usize * columns + column as usize);
            }
        }
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    #[test]
    fn no_coast_is_without_land() {
        for land in ["island", "archipelago", "continent"] {
            for seed in ["skye", "galicia", "orinoco"] {
                let text = format!("seed={seed}&land={land}&attractors=6000&drowning=0.4");
                let mut session = Session::new(link::read(&text).unwrap()).unwrap();
                session.finish().unwrap();
                let coast = session.land().unwrap().coast_distance();
                let land = runs_above_water(&session.domain(), coast);
                assert_eq!(corners_without_cells(coast, &land), Vec::<usize>::new(), "{text}");
            }
        }
    }
}
