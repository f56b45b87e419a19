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
        let (columns, rows) = (self.columns, self.tiles.len() / self.columns);
        let mut hear = |i: usize, other: usize| self.tiles[i] = self.tiles[i].min(self.tiles[other].saturating_add(1));
        for i in 0..columns * rows {
            let (column, row) = (i % columns, i / columns);
            if column > 0 {
                hear(i, i - 1);
            }
            if row > 0 {
                (column.saturating_sub(1)..(column + 2).min(columns)).for_each(|c| hear(i, (row - 1) * columns + c));
            }
        }
        for i in (0..columns * rows).rev() {
            let (column, row) = (i % columns, i / columns);
            if column + 1 < columns {
                hear(i, i + 1);
            }
            if row + 1 < rows {
                (column.saturating_sub(1)..(column + 2).min(columns)).for_each(|c| hear(i, (row + 1) * columns + c));
            }
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
