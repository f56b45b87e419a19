//! Straits: the water about midway between two islands, which stays open at a low stand.

use super::cell::Cell;
use super::coast_distance::CoastDistance;
use crate::base::work;

/// The least area of an island that stays apart, in square units.
const ISLAND: f32 = 500.0;

/// Lists the corners about midway between two islands of today: those beside a corner that is nearer to another island.
pub(super) fn straits(today: &CoastDistance) -> Vec<usize> {
    let (columns, rows) = today.size();
    let nearest = nearest_island(today);
    let is_between = |corner: &usize| {
        let (column, row) = (corner % columns, corner / columns);
        let (west, east) = (column.saturating_sub(1), (column + 2).min(columns));
        let mut around = (row.saturating_sub(1)..(row + 2).min(rows)).map(|row| &nearest[row * columns..][west..east]);
        around.any(|row| row.iter().any(|beside| *beside != nearest[*corner]))
    };
    let is_sea = |corner: &usize| today.heights()[*corner] <= 0.0;
    (0..nearest.len()).filter(is_sea).filter(is_between).collect()
}

/// Returns the number of the island nearest to each corner along the lattice; the same everywhere if there are fewer
/// than two.
fn nearest_island(today: &CoastDistance) -> Vec<u16> {
    let (columns, rows) = today.size();
    let least = (ISLAND / (today.spacing() * today.spacing())) as u32;
    let mut nearest = vec![u16::MAX; columns * rows];
    let mut reached = Vec::new();
    for (number, island) in (0..).zip(today.regions(Cell::Land).iter().filter(|island| island.cells >= least)) {
        for corner in today.corners_of(island) {
            nearest[corner] = number;
            reached.push(corner as u32);
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

/// The steps to neighbouring corners: along the sides, then along the diagonals.
const AROUND: [(isize, isize); 8] = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];
