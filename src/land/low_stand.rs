//! The low stand: the land as it was before the sea rose, with more of it above the water.
//!
//! It is the shape that a recipe names, at a lower level of the sea. Parts that are islands today stay apart, because a
//! river through a strait would join them for good.

use std::sync::Arc;

use super::cell::{CELL_SIZE, Cell};
use super::coast_distance::CoastDistance;
use super::grid::Grid;
use super::kinds::Shape;
use super::queries::Land;
use super::regions::{Region, regions_of};
use crate::base::work;
use crate::domain::Domain;
use crate::recipe::{GrowthMethod, LandKind, NumberKey, Recipe};

/// The land of a low stand, and the coast of the same shape at the share of sea that the recipe asks for.
#[derive(Clone, Debug)]
pub(crate) struct LowStand {
    pub land: Arc<Land>,
    pub today: CoastDistance,
    /// The share of the domain that the sea covers once it has risen.
    pub sea: f32,
}

/// The share of the domain that a risen sea has taken: at least, so that there is some of it although coasts are no more
/// exact than that, and what a sea risen in full has taken besides.
const LEAST_RISE: f32 = 0.03;
const RISE: f32 = 0.27;

/// The least share of sea at the lowest stand: an island would fill the frame before. A little sea falls to a share of it.
const LEAST_SEA: f32 = 0.1;
const LEAST_SEA_AROUND_AN_ISLAND: f32 = 0.3;
const LEAST_SHARE: f32 = 0.6;

/// The least depth of water at the corners of the lattice, in units: so every channel is some cells wide.
const SHALLOWEST: f32 = 1.0;

/// The least area of an island that stays apart, in square units.
const ISLAND: f32 = 500.0;

impl LowStand {
    /// The low stand of a recipe, on a lattice with this spacing; `None` if the recipe drowns nothing.
    pub fn of(recipe: &Recipe, spacing: f32) -> Option<Self> {
        if !Self::is_wanted(recipe) {
            return None;
        }
        let shape = Shape::of(recipe);
        let today = shape.coast_distance(spacing)?;
        let low = shape.coast_distance_at(spacing, low_sea(&shape, recipe.number(NumberKey::Drowning)))?;
        let kept = [straits(&today), lost_seas(&today, &low)].concat();
        let low = if kept.is_empty() { low } else { low.flooded(kept.into_iter()) };
        let land = Arc::new(Land::new(&shape.domain, low, shape.ridges()));
        Some(Self { land, today, sea: shape.sea })
    }

    /// Returns `true` if the sea rises in a recipe: over the valleys of drainage, on a shaped coast.
    pub fn is_wanted(recipe: &Recipe) -> bool {
        recipe.number(NumberKey::Drowning) > 0.0
            && recipe.get::<GrowthMethod>() == GrowthMethod::Drainage
            && !matches!(recipe.get(), LandKind::Rectangle | LandKind::Drawn)
    }
}

/// The land above a level, in units, of heights at the corners of the low stand's lattice. Specks of it sink.
pub(crate) fn above(low: &Land, heights: &[f32], level: f32) -> Land {
    /// The least area of an island, in cells.
    const SPECK: u32 = 40;
    /// How often specks are looked for: each time there are fewer corners of land.
    const ROUNDS: usize = 8;
    let domain = Domain { size: low.size() };
    let mut over: Vec<f32> = heights.iter().map(|height| height - level).collect();
    let mut round = 0;
    loop {
        let coast = CoastDistance::above(low.coast_distance(), &over, SHALLOWEST);
        let grid = Grid::above_water(&domain, &coast);
        let specks: Vec<Region> = regions_of(&grid.runs).into_iter().filter(|region| region.cells < SPECK).collect();
        round += 1;
        if specks.is_empty() || round == ROUNDS {
            return Land::on(grid, coast, low.ridges().to_vec());
        }
        sink(&specks, &coast, &mut over);
    }
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

/// The share of sea at the low stand, which falls evenly with drowning to that of the lowest stand.
fn low_sea(shape: &Shape, drowning: f32) -> f32 {
    let least = if shape.kind == LandKind::Island { LEAST_SEA_AROUND_AN_ISLAND } else { LEAST_SEA };
    let lowest = (shape.sea - LEAST_RISE - RISE).max(least.min(LEAST_SHARE * shape.sea));
    let highest = (shape.sea - LEAST_RISE).max(lowest);
    highest + (lowest - highest) * drowning
}

/// The corners of today's seas of which nothing is left at the low stand: land around them would have no outlet.
fn lost_seas(today: &CoastDistance, low: &CoastDistance) -> Vec<usize> {
    let columns = today.size().0;
    let corners = |sea: &Region| {
        let runs = sea.runs.iter().map(|run| (run.row as usize * columns, run.start as usize, run.end as usize));
        runs.flat_map(|(row, start, end)| row + start..row + end).collect::<Vec<_>>()
    };
    let seas = today.regions(Cell::Water).into_iter().map(|sea| corners(&sea));
    seas.filter(|sea| sea.iter().all(|&corner| low.heights()[corner] > 0.0)).flatten().collect()
}

/// The corners about midway between two islands of today: those beside a corner that is nearer to another island.
fn straits(today: &CoastDistance) -> Vec<usize> {
    let (columns, rows) = today.size();
    let nearest = nearest_island(today);
    let is_between = |corner: &usize| {
        let (column, row) = (corner % columns, corner / columns);
        let around = (row.saturating_sub(1)..(row + 2).min(rows))
            .flat_map(|row| (column.saturating_sub(1)..(column + 2).min(columns)).map(move |column| row * columns + column));
        around.into_iter().any(|beside| nearest[beside] != nearest[*corner])
    };
    let is_sea = |corner: &usize| today.heights()[*corner] <= 0.0;
    (0..nearest.len()).filter(is_sea).filter(is_between).collect()
}

/// The number of the island that each corner is nearest to by a way along the lattice; 0 everywhere if there are fewer
/// than two.
fn nearest_island(today: &CoastDistance) -> Vec<u16> {
    let (columns, rows) = today.size();
    let least = (ISLAND / (today.spacing() * today.spacing())) as u32;
    let mut nearest = vec![u16::MAX; columns * rows];
    let mut reached = Vec::new();
    for (number, island) in (0..).zip(today.regions(Cell::Land).iter().filter(|island| island.cells >= least)) {
        for run in &island.runs {
            let start = run.row as usize * columns;
            for corner in start + run.start as usize..start + run.end as usize {
                nearest[corner] = number;
                reached.push(corner as u32);
            }
        }
    }
    work::count(5 * nearest.len());
    // Rounds with and without diagonal neighbours take turns, so that what is equally far lies on an octagon.
    let mut is_diagonal = false;
    while !reached.is_empty() {
        let mut next = Vec::new();
        for &corner in &reached {
            let (column, row) = (corner as usize % columns, corner as usize / columns);
            for (east, south) in AROUND.into_iter().take(if is_diagonal { 8 } else { 4 }) {
                let (column, row) = (column.wrapping_add_signed(east), row.wrapping_add_signed(south));
                let beside = row.wrapping_mul(columns).wrapping_add(column);
                if column < columns && row < rows && nearest[beside] == u16::MAX {
                    nearest[beside] = nearest[corner as usize];
                    next.push(beside as u32);
                }
            }
        }
        reached = next;
        is_diagonal = !is_diagonal;
    }
    nearest
}

/// The ways to neighbouring corners: those that share a side, then the diagonal ones.
const AROUND: [(isize, isize); 8] = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];
