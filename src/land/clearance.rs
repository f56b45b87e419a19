//! How much room there is: far from all obstacles a line need not be followed cell by cell.

use glam::Vec2;

/// The side of a tile, in cells.
const TILE: usize = 4;

/// Of every tile of a field, how many tiles away the nearest obstacle is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Clearance {
    tiles: Vec<u8>,
    columns: usize,
}

impl Clearance {
    /// Measures a field, row by row.
    pub fn of<T>(cells: &[T], columns: usize, is_obstacle: impl Fn(&T) -> bool) -> Self {
        let tile_columns = columns.div_ceil(TILE).max(1);
        let tile_rows = cells.len().div_ceil(columns.max(1)).div_ceil(TILE);
        let mut tiles = vec![u8::MAX; tile_columns * tile_rows];
        for (row, cells) in cells.chunks(columns.max(1)).enumerate() {
            let tiles = &mut tiles[row / TILE * tile_columns..][..tile_columns];
            for (tile, cells) in tiles.iter_mut().zip(cells.chunks(TILE)) {
                if *tile > 0 && cells.iter().any(&is_obstacle) {
                    *tile = 0;
                }
            }
        }
        let mut this = Self { tiles, columns: tile_columns };
        this.spread();
        this
    }

    /// From tile to neighbouring tile, there and back (Rosenfeld and Pfaltz 1968): king's moves.
    fn spread(&mut self) {
        let columns = self.columns;
        for row in 0..self.tiles.len() / columns {
            let (before, rest) = self.tiles.split_at_mut(row * columns);
            hear(&mut rest[..columns], before.rchunks(columns).next());
        }
        for row in (0..self.tiles.len() / columns).rev() {
            let (rest, after) = self.tiles.split_at_mut((row + 1) * columns);
            hear(&mut rest[row * columns..], after.chunks(columns).next());
        }
    }

    /// Whether there surely is no obstacle within a distance, in cells, along either axis. The point lies in the field.
    #[inline]
    pub fn is_clear(&self, at: Vec2, distance: f32) -> bool {
        let tile = at.y as usize / TILE * self.columns + at.x as usize / TILE;
        let between = self.tiles.get(tile).map_or(0, |tiles| tiles.saturating_sub(1));
        f32::from(between) * TILE as f32 >= distance
    }
}

/// Each tile of a row asks those of the row beside it, and its neighbours to the left and right.
fn hear(row: &mut [u8], other: Option<&[u8]>) {
    if let Some(other) = other {
        let nearest = |i: usize| other[i.saturating_sub(1)].min(other[i]).min(other[(i + 1).min(other.len() - 1)]);
        row.iter_mut().enumerate().for_each(|(i, tile)| *tile = (*tile).min(nearest(i).saturating_add(1)));
    }
    let mut tell = |nearest: u8, tile: &mut u8| {
        *tile = (*tile).min(nearest.saturating_add(1));
        *tile
    };
    row.iter_mut().fold(u8::MAX, &mut tell);
    row.iter_mut().rev().fold(u8::MAX, tell);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_clear_has_no_obstacle_near(
            obstacles in proptest::collection::vec((0usize..90, 0usize..70), 0..4), x in 0f32..90.0, y in 0f32..70.0, distance in 0f32..60.0,
        ) {
            let (columns, rows) = (90, 70);
            let mut cells = vec![false; columns * rows];
            obstacles.iter().for_each(|&(column, row)| cells[row * columns + column] = true);
            let clearance = Clearance::of(&cells, columns, |&is_obstacle| is_obstacle);
            let gap = |at: f32, cell: usize| (cell as f32 - at).max(at - (cell + 1) as f32);
            let nearest = obstacles.iter().map(|&(c, r)| gap(x, c).max(gap(y, r))).fold(f32::INFINITY, f32::min);
            let is_clear = clearance.is_clear(Vec2::new(x, y), distance);
            prop_assert!(!is_clear || nearest >= distance);
            prop_assert!(is_clear || nearest < distance + 2.0 * TILE as f32);
        }
    }
}
