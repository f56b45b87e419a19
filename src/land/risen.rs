//! The land that a risen sea leaves: what lies above a level of heights over a low stand.

use super::cell::{CELL_SIZE, Cell};
use super::coast_distance::CoastDistance;
use super::grid::Grid;
use super::queries::Land;
use super::regions::{Region, regions_of};
use crate::domain::Domain;

/// The least depth of water at the corners of the lattice, in units: so every channel is some cells wide.
const SHALLOWEST: f32 = 1.0;

/// The land above a level, in units, of heights at the corners of the low stand's lattice. Specks of it sink.
pub(crate) fn above(low: &Land, heights: &[f32], level: f32) -> Land {
    /// The least area of an island, in cells.
    const SPECK: u32 = 40;
    /// The number of times that specks are looked for: each time there are fewer corners of land.
    const ROUNDS: usize = 8;
    let domain = Domain { size: low.size() };
    let mut over = over_level(heights, level);
    let mut round = 0;
    loop {
        let coast = CoastDistance::above(low.coast_distance(), &over, SHALLOWEST);
        let grid = Grid::above_water(&domain, &coast);
        let specks: Vec<Region> = regions_of(&grid.runs).into_iter().filter(|region| region.cells < SPECK).collect();
        let bare = corners_without_cells(&coast, &grid);
        round += 1;
        if (specks.is_empty() && bare.is_empty()) || round == ROUNDS {
            return Land::on(grid, coast, low.ridges().to_vec());
        }
        sink(&specks, &coast, &mut over);
        bare.into_iter().for_each(|corner| over[corner] = over[corner].min(-SHALLOWEST));
    }
}

/// The same land with its specks, for a picture that is soon gone: in less than half the time, and all of it was land at
/// each lower level.
pub(crate) fn all_above(low: &Land, heights: &[f32], level: f32) -> Land {
    let coast = CoastDistance::above(low.coast_distance(), &over_level(heights, level), SHALLOWEST);
    let grid = Grid::above_water(&Domain { size: low.size() }, &coast);
    Land::on(grid, coast, low.ridges().to_vec())
}

/// Heights over a level.
fn over_level(heights: &[f32], level: f32) -> Vec<f32> {
    heights.iter().map(|height| height - level).collect()
}

/// Takes the corners of some regions under water: those that touch one of their cells or, where a region has none, all
/// around it.
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

/// The corners of parts of the land without a single cell. There would still be a coast around them, and water lines.
fn corners_without_cells(coast: &CoastDistance, grid: &Grid) -> Vec<usize> {
    let (columns, _) = coast.size();
    let apart = (coast.spacing() / CELL_SIZE) as i32;
    let has_cell = |corner: usize| {
        let (column, row) = ((corner % columns) as i32 * apart, (corner / columns) as i32 * apart);
        let touching = [(column, row), (column - 1, row), (column, row - 1), (column - 1, row - 1)];
        touching.into_iter().any(|(column, row)| grid.cell(column, row) == Cell::Land)
    };
    let mut bare = Vec::new();
    for region in coast.regions(Cell::Land) {
        let before = bare.len();
        for run in &region.runs {
            let row = run.row as usize * columns;
            bare.extend(row + run.start as usize..row + run.end as usize);
        }
        if bare[before..].iter().any(|&corner| has_cell(corner)) {
            bare.truncate(before);
        }
    }
    bare
}

/// The corners of all lattice squares that a region has cells in, or only those that touch a cell.
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
                let grid = Grid::above_water(&session.domain(), coast);
                assert_eq!(corners_without_cells(coast, &grid), Vec::<usize>::new(), "{text}");
            }
        }
    }
}
