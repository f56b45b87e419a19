//! Cells that block lines, and the free room around points: far from all obstacles, a line need not be followed cell by
//! cell.

use std::ops::Range;

use glam::Vec2;

use super::walk::{floor, walk};
use crate::base::work;

/// The side of a tile, in cells. The cells of a tile are the bits of a number.
const TILE: usize = 8;

/// The obstacles of a grid, in tiles: compact enough to stay in the cache.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Obstacles {
    /// The cells of each tile, row by row from the lowest bit.
    cells: Vec<u64>,
    /// The distance of each tile from the nearest tile with an obstacle, in tiles.
    away: Vec<u8>,
    /// The size of the grid, in cells.
    columns: usize,
    rows: usize,
    tile_columns: usize,
    /// `true` if everything outside the grid is an obstacle.
    outside: bool,
}

impl Obstacles {
    /// Makes obstacles from ranges of cell indices, which count row by row.
    pub fn of(columns: usize, rows: usize, outside: bool, obstacles: impl Iterator<Item = Range<usize>>) -> Self {
        let (tile_columns, tile_rows) = (columns.div_ceil(TILE).max(1), rows.div_ceil(TILE));
        let cells = vec![0; tile_columns * tile_rows];
        let mut this = Self { cells, away: Vec::new(), columns, rows, tile_columns, outside };
        obstacles.for_each(|stretch| this.mark(stretch));
        this.spread();
        this
    }

    /// Marks a stretch of obstacles, which may continue over the ends of rows.
    #[inline(never)]
    fn mark(&mut self, Range { mut start, end }: Range<usize>) {
        while start < end {
            let (row, column) = (start / self.columns, start % self.columns);
            let stop = (column + end - start).min(self.columns);
            let tiles = row / TILE * self.tile_columns;
            for tile in column / TILE..=(stop - 1) / TILE {
                let across = bits(column.max(tile * TILE) % TILE, (stop - 1).min(tile * TILE + TILE - 1) % TILE);
                self.cells[tiles + tile] |= across << (row % TILE * TILE);
            }
            start += stop - column;
        }
    }

    /// Computes the distances of tiles from obstacles, forth and back from tile to neighbouring tile (Rosenfeld and
    /// Pfaltz 1968), in king's moves.
    fn spread(&mut self) {
        self.away = self.cells.iter().map(|&cells| if cells == 0 { u8::MAX } else { 0 }).collect();
        let columns = self.tile_columns;
        for row in 0..self.away.len() / columns {
            let (before, rest) = self.away.split_at_mut(row * columns);
            hear(&mut rest[..columns], before.rchunks(columns).next());
        }
        for row in (0..self.away.len() / columns).rev() {
            let (rest, after) = self.away.split_at_mut((row + 1) * columns);
            hear(&mut rest[row * columns..], after.chunks(columns).next());
        }
    }

    /// Returns a distance, in cells, within which there is certainly no obstacle around a point of the grid, along either axis.
    #[inline]
    pub fn room(&self, at: Vec2) -> f32 {
        let tile = at.y as u32 / TILE as u32 * self.tile_columns as u32 + at.x as u32 / TILE as u32;
        let between = self.away.get(tile as usize).map_or(0, |tiles| tiles.saturating_sub(1));
        f32::from(between) * TILE as f32
    }

    /// Returns `true` if there is certainly no obstacle within a distance of a point, in cells. For short distances it
    /// looks closer than tiles allow.
    #[inline]
    pub fn has_room(&self, at: Vec2, distance: f32) -> bool {
        self.room(at) >= distance || (distance <= TILE as f32 && self.is_box_clear(at - distance, at + distance))
    }

    /// Returns `true` if a straight line between two points, in cells, touches no obstacle.
    #[inline]
    pub fn let_pass(&self, from: Vec2, to: Vec2) -> bool {
        (is_worth_boxing(to - from) && self.is_box_clear(from, to)) || self.is_way_clear(from, to)
    }

    /// Returns `true` if a line touches no obstacle, by following it cell by cell up to the first one.
    fn is_way_clear(&self, from: Vec2, to: Vec2) -> bool {
        let mut cells = 0;
        let is_clear = walk(from, to).all(|(column, row)| {
            cells += 1;
            !self.holds(column, row)
        });
        work::count(cells);
        is_clear
    }

    /// Returns `true` if the box between two points certainly holds no obstacle. Most lines beside obstacles need not
    /// be followed then.
    #[inline]
    fn is_box_clear(&self, a: Vec2, b: Vec2) -> bool {
        let (west, east) = ordered(floor(a.x), floor(b.x));
        let (north, south) = ordered(floor(a.y), floor(b.y));
        if west < 0 || north < 0 || east as usize >= self.columns || south as usize >= self.rows {
            return false;
        }
        let (west, east, north, south) = (west as usize, east as usize, north as usize, south as usize);
        work::count((south / TILE - north / TILE + 1) * (east / TILE - west / TILE + 1));
        let mut met = 0;
        for row in north / TILE..=south / TILE {
            let first = if row == north / TILE { north % TILE * TILE } else { 0 };
            let last = if row == south / TILE { south % TILE * TILE + TILE - 1 } else { 63 };
            let tiles = &self.cells[row * self.tile_columns..][west / TILE..=east / TILE];
            let down = bits(first, last);
            for (i, tile) in tiles.iter().enumerate() {
                let first = if i == 0 { west % TILE } else { 0 };
                let last = if i + 1 == tiles.len() { east % TILE } else { TILE - 1 };
                met |= tile & down & (bits(first, last) * EVERY_ROW);
            }
        }
        met == 0
    }

    /// Returns `true` if a cell is an obstacle.
    fn holds(&self, column: i32, row: i32) -> bool {
        let (x, y) = (column as usize, row as usize);
        if column < 0 || row < 0 || x >= self.columns || y >= self.rows {
            return self.outside;
        }
        self.cells[y / TILE * self.tile_columns + x / TILE] >> (y % TILE * TILE + x % TILE) & 1 == 1
    }
}

/// Returns `true` if a line is so short, or so close to the direction of an axis, that the box around it has no more
/// tiles than the line has cells. A line across the map is followed instead, up to the first obstacle.
#[inline]
fn is_worth_boxing(along: Vec2) -> bool {
    let along = along.abs();
    let tiles = along * (1.0 / TILE as f32) + 2.0;
    tiles.x * tiles.y <= along.x + along.y + TILE as f32
}

/// A bit in every row of a tile.
const EVERY_ROW: u64 = 0x0101_0101_0101_0101;

/// Returns a number with the bits from `first` to `last` set.
#[inline]
fn bits(first: usize, last: usize) -> u64 {
    u64::MAX << first & u64::MAX >> (63 - last)
}

#[inline]
fn ordered(a: i32, b: i32) -> (i32, i32) {
    (a.min(b), a.max(b))
}

/// Lets each tile of a row take over a smaller distance from the neighbouring row and from its neighbours to the left
/// and right.
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
    use crate::property::cases;
    use proptest::prelude::*;

    const COLUMNS: usize = 90;
    const ROWS: usize = 70;

    fn obstacles(cells: &[(usize, usize)], outside: bool) -> Obstacles {
        let numbers = cells.iter().map(|&(column, row)| row * COLUMNS + column);
        Obstacles::of(COLUMNS, ROWS, outside, numbers.map(|number| number..number + 1))
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn there_is_no_obstacle_where_there_is_room(
            cells in proptest::collection::vec((0..COLUMNS, 0..ROWS), 0..4),
            x in 0f32..90.0, y in 0f32..70.0,
        ) {
            let gap = |at: f32, cell: usize| (cell as f32 - at).max(at - (cell + 1) as f32);
            let nearest = cells.iter().map(|&(c, r)| gap(x, c).max(gap(y, r)).max(0.0)).fold(f32::INFINITY, f32::min);
            let room = obstacles(&cells, false).room(Vec2::new(x, y));
            prop_assert!(nearest >= room);
            for distance in [2.0, 7.0, 20.0] {
                prop_assert!(nearest >= distance || !obstacles(&cells, false).has_room(Vec2::new(x, y), distance));
            }
            prop_assert!(nearest < room + 2.0 * TILE as f32 || cells.is_empty());
        }

        #[test]
        fn a_line_passes_if_no_cell_that_it_touches_is_an_obstacle(
            cells in proptest::collection::vec((0..COLUMNS, 0..ROWS), 0..60),
            from in (0f32..90.0, 0f32..70.0), along in (-30f32..30.0, -30f32..30.0), outside: bool,
        ) {
            let (from, to) = (Vec2::from(from), Vec2::from(from) + Vec2::from(along));
            let is_outside = |(c, r)| !(0..COLUMNS as i32).contains(&c) || !(0..ROWS as i32).contains(&r);
            let is_obstacle = |(c, r)| cells.contains(&(c as usize, r as usize)) || (outside && is_outside((c, r)));
            let touches = walk(from, to).any(is_obstacle);
            prop_assert_eq!(obstacles(&cells, outside).let_pass(from, to), !touches);
        }

        #[test]
        fn stretches_may_go_on_over_rows(start in 0..COLUMNS * ROWS, length in 0usize..300) {
            let end = (start + length).min(COLUMNS * ROWS);
            let obstacles = Obstacles::of(COLUMNS, ROWS, false, std::iter::once(start..end));
            for number in 0..COLUMNS * ROWS {
                let held = obstacles.holds((number % COLUMNS) as i32, (number / COLUMNS) as i32);
                prop_assert_eq!(held, (start..end).contains(&number), "{}", number);
            }
        }
    }
}
