//! A set of cells that finds the nearest of them: a bit pyramid, which knows for each block of side 2ʲ whether it is
//! empty.
//!
//! At the bottom, 8 × 8 cells are the bits of a word. A search begins in the block that contains the query and climbs,
//! looking into the rest of each larger block, until everything outside is farther than the nearest cell found.

use super::raster::{Place, Raster};
use crate::base::work;

/// The side of a tile, in cells.
const TILE: i32 = 8;
const TILE_BITS: i32 = 3;

/// A set of cells of a raster.
#[derive(Clone, Debug)]
pub(super) struct Pyramid {
    /// The cells of each tile: bit `8 · row + column`.
    tiles: Vec<u64>,
    tile_columns: i32,
    /// The levels from fine to coarse, up to a single block.
    levels: Vec<Level>,
    /// The number of columns of the raster.
    columns: i32,
}

/// Blocks of four blocks of the level below. Bit `2 · row + column` is set if that block is not empty.
#[derive(Clone, Debug)]
struct Level {
    children: Vec<u8>,
    columns: i32,
}

/// The nearest cell so far: its squared distance in the upper bits and the rank of its number in the lower ones, so
/// that among equals the lowest rank is the smallest.
type Found = u64;

impl Pyramid {
    /// Makes an empty set.
    pub fn new(raster: &Raster) -> Self {
        let tiles = |cells: i32| (cells + TILE - 1) >> TILE_BITS;
        let (tile_columns, tile_rows) = (tiles(raster.columns()), tiles(raster.rows()));
        let (mut columns, mut rows) = (tile_columns, tile_rows);
        let mut levels = Vec::new();
        while columns > 1 || rows > 1 {
            (columns, rows) = ((columns + 1) / 2, (rows + 1) / 2);
            levels.push(Level { children: vec![0; (columns * rows) as usize], columns });
        }
        Self { tiles: vec![0; (tile_columns * tile_rows) as usize], tile_columns, levels, columns: raster.columns() }
    }

    /// Adds a cell of the raster.
    pub fn insert(&mut self, at: Place) {
        let (mut column, mut row) = (at.column >> TILE_BITS, at.row >> TILE_BITS);
        let bit = (at.row & (TILE - 1)) << TILE_BITS | (at.column & (TILE - 1));
        self.tiles[(row * self.tile_columns + column) as usize] |= 1 << bit;
        for level in &mut self.levels {
            let child = 1 << ((row & 1) * 2 + (column & 1));
            (column, row) = (column >> 1, row >> 1);
            let children = &mut level.children[(row * level.columns + column) as usize];
            if *children & child != 0 {
                break;
            }
            *children |= child;
        }
    }

    /// Finds the nearest cell whose squared distance from a cell of the raster is below the limit. Returns its number
    /// and squared distance. Among equals, the one with the lowest rank.
    #[inline]
    pub fn nearest(&self, at: Place, limit: i32) -> Option<(u32, i32)> {
        let none = (limit as u64) << 32;
        let found = self.climb(at, none);
        (found < none).then_some((number(found as u32), (found >> 32) as i32))
    }

    fn climb(&self, at: Place, limit: Found) -> Found {
        let (mut column, mut row) = (at.column >> TILE_BITS, at.row >> TILE_BITS);
        let mut found = self.look_into_tile(at, column, row, limit);
        for (level, blocks) in self.levels.iter().enumerate() {
            let bits = TILE_BITS + level as i32;
            if squared_way_out(at, bits) >= found {
                break;
            }
            let seen = (row & 1) * 2 + (column & 1);
            (column, row) = (column >> 1, row >> 1);
            let children = blocks.children[(row * blocks.columns + column) as usize] & !(1 << seen);
            // Crosses the nearer border first.
            for child in [seen ^ 1, seen ^ 2, seen ^ 3] {
                if children >> child & 1 == 1 {
                    found = self.descend(at, level, column * 2 + (child & 1), row * 2 + (child >> 1), found);
                }
            }
        }
        found
    }

    /// Looks into a block that is not empty.
    fn descend(&self, at: Place, level: usize, column: i32, row: i32, found: Found) -> Found {
        if squared_gap(at, TILE_BITS + level as i32, column, row) >= found {
            return found;
        }
        if level == 0 {
            return self.look_into_tile(at, column, row, found);
        }
        let blocks = &self.levels[level - 1];
        let children = blocks.children[(row * blocks.columns + column) as usize];
        // The border between west and east, and the one between north and south.
        let bits = TILE_BITS + level as i32 - 1;
        let is_east = i32::from(at.column >> bits > column * 2);
        let is_south = i32::from(at.row >> bits > row * 2);
        let nearest = is_south * 2 + is_east;
        let mut found = found;
        for child in [nearest, nearest ^ 1, nearest ^ 2, nearest ^ 3] {
            if children >> child & 1 == 1 {
                found = self.descend(at, level - 1, column * 2 + (child & 1), row * 2 + (child >> 1), found);
            }
        }
        found
    }

    #[inline]
    fn look_into_tile(&self, at: Place, column: i32, row: i32, found: Found) -> Found {
        work::count(1);
        let mut cells = self.tiles[(row * self.tile_columns + column) as usize];
        let corner = Place { column: column << TILE_BITS, row: row << TILE_BITS };
        let mut found = found;
        while cells != 0 {
            let bit = cells.trailing_zeros() as i32;
            let cell = Place { column: corner.column + (bit & (TILE - 1)), row: corner.row + (bit >> TILE_BITS) };
            let rank = rank((cell.row * self.columns + cell.column) as u32);
            found = found.min((cell.squared_distance(at) as u64) << 32 | u64::from(rank));
            cells &= cells - 1;
        }
        found
    }
}

/// Shuffles numbers, one to one: the choice among equals must not favour a direction. (If the first one row by row were
/// chosen, one river in eighty would turn from south to north.)
#[inline]
fn rank(number: u32) -> u32 {
    let half = number.wrapping_mul(0x9e37_79b1);
    (half ^ (half >> 16)).wrapping_mul(0x85eb_ca77)
}

/// Returns the number of a rank.
fn number(rank: u32) -> u32 {
    let half = rank.wrapping_mul(0xb6c9_2f47);
    (half ^ (half >> 16)).wrapping_mul(0x0e8b_2f51)
}

/// Returns the squared distance out of the block of side 2ᵇⁱᵗˢ that contains a cell, in the form of a found cell.
#[inline]
fn squared_way_out(at: Place, bits: i32) -> Found {
    let last = (1 << bits) - 1;
    let (x, y) = (at.column & last, at.row & last);
    let way = x.min(y).min(last - x).min(last - y) + 1;
    ((way * way) as u64) << 32
}

/// Returns the squared distance to a block of side 2ᵇⁱᵗˢ.
#[inline]
fn squared_gap(at: Place, bits: i32, column: i32, row: i32) -> Found {
    let gap = |at: i32, block: i32| {
        let first = block << bits;
        let last = first + (1 << bits) - 1;
        (first - at).max(at - last).max(0)
    };
    let (x, y) = (gap(at.column, column), gap(at.row, row));
    ((x * x + y * y) as u64) << 32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::land::Cell;
    use crate::property::cases;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn nearest_is_that_of_a_literal_search(
            columns in 1i32..150, rows in 1i32..150, few in 0usize..40, limit in 1i32..20_000,
            places in proptest::collection::vec((0i32..150, 0i32..150), 60),
        ) {
            let raster = Raster::new(columns, rows, 1.0, |_, _| Cell::Land);
            let mut pyramid = Pyramid::new(&raster);
            let places: Vec<Place> =
                places.into_iter().map(|(x, y)| Place { column: x % columns, row: y % rows }).collect();
            let (cells, questions) = places.split_at(few);
            cells.iter().for_each(|&cell| pyramid.insert(cell));
            for &at in questions {
                let distances = cells.iter().map(|&cell| (cell.squared_distance(at), rank(raster.index(cell) as u32)));
                let nearest = distances.filter(|&(squared, _)| squared < limit).min();
                prop_assert_eq!(pyramid.nearest(at, limit), nearest.map(|(squared, rank)| (number(rank), squared)));
            }
        }
    }
}
