//! Pieces of rivers, lakes and ridges, or stretches of them, by the squares of the map that they come near.

use glam::Vec2;

use super::background::Piece;
use crate::base::geometry::fast_max;

/// A box that is larger than the ink in it by more than any rounding: its north-western and its south-eastern corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds(pub [Vec2; 2]);

impl Bounds {
    /// Returns a distance that the ink is no nearer to a point than; less than 0 in the box.
    #[inline]
    pub fn least_distance(&self, at: Vec2) -> f32 {
        let Self([least, most]) = *self;
        let (before, behind) = (least - at, at - most);
        fast_max(fast_max(before.x, behind.x), fast_max(before.y, behind.y))
    }
}

/// A piece and the bounds of its ink.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    pub piece: Piece,
    pub bounds: Bounds,
}

impl Bounded {
    pub fn new(piece: Piece) -> Self {
        Self { piece, bounds: Bounds(piece.corners()) }
    }
}

/// Things by the squares that their bounds come near.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    /// The side of a square, in units.
    side: f32,
    columns: usize,
    rows: usize,
    /// The place in the list where the things of each square begin, and the place where the last end.
    starts: Vec<u32>,
    /// The numbers of the things of each square, in ascending order.
    things: Vec<u32>,
}

impl Squares {
    /// Sorts bounds into the squares, of a side in units, of a rectangle of some size with its north-western corner at `corner`.
    pub fn new(side: f32, size: Vec2, corner: Vec2, bounds: &[Bounds]) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / side) as usize + 1);
        let mut this = Self { side, columns, rows, starts: vec![0; columns * rows + 1], things: Vec::new() };
        let squares_of = |Bounds(corners): &Bounds, this: &Self| {
            let [least, most] = corners.map(|at| at - corner);
            this.squares(least, most)
        };
        for bounds in bounds {
            squares_of(bounds, &this).for_each(|square| this.starts[square + 1] += 1);
        }
        for square in 0..columns * rows {
            this.starts[square + 1] += this.starts[square];
        }
        let (mut next, count) = (this.starts.clone(), this.starts.last().copied().unwrap_or(0));
        this.things = vec![0; count as usize];
        for (number, bounds) in (0..).zip(bounds) {
            for square in squares_of(bounds, &this) {
                this.things[next[square] as usize] = number;
                next[square] += 1;
            }
        }
        this
    }

    /// Returns the squares between two corners.
    fn squares(&self, least: Vec2, most: Vec2) -> impl Iterator<Item = usize> + use<> {
        let ([left, top], [right, bottom]) = (self.square(least), self.square(most));
        let columns = self.columns;
        (top..=bottom).flat_map(move |row| (left..=right).map(move |column| row * columns + column))
    }

    /// Returns the column and the row of a place's square. Squares at the border stand for what lies outside.
    fn square(&self, at: Vec2) -> [usize; 2] {
        // A conversion makes 0 of what is below.
        [((at.x / self.side) as usize).min(self.columns - 1), ((at.y / self.side) as usize).min(self.rows - 1)]
    }

    /// Hands out the things of all squares within a distance of a place, from its own square outward. Each time `look` returns the distance
    /// from then on, which never grows: what is near shortens the way to all that is far.
    pub fn around(&self, at: Vec2, distance: f32, mut look: impl FnMut(&[u32]) -> f32) {
        const ROUNDING: f32 = 0.01;
        let [column, row] = self.square(at);
        let ([left, top], [right, bottom]) = (self.square(at - distance), self.square(at + distance));
        // A distance below 0, of a place within a bank, may leave no square.
        if left > right || top > bottom {
            return;
        }
        let rings = (column - left).max(right - column).max(row - top).max(bottom - row);
        let mut distance = distance;
        for ring in 0..=rings {
            for y in row.saturating_sub(ring).max(top)..=(row + ring).min(bottom) {
                let is_whole = y.abs_diff(row) == ring;
                // Of a row between the first and the last, a ring has two squares.
                let every = if is_whole { 1 } else { 2 * ring };
                let first = if column >= left + ring {
                    column - ring
                } else if is_whole {
                    left
                } else {
                    column + ring
                };
                for x in (first..=(column + ring).min(right)).step_by(every) {
                    let corner = Vec2::new(x as f32, y as f32) * self.side;
                    let off = (corner - at).max(at - corner - self.side).max(Vec2::ZERO);
                    // Nothing in a square is nearer than the square.
                    if (x, y) == (column, row) || off.length_squared().sqrt() <= distance + ROUNDING {
                        let square = y * self.columns + x;
                        distance = look(&self.things[self.starts[square] as usize..self.starts[square + 1] as usize]);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn all_that_is_near_is_handed_out_and_within_a_bank_the_search_ends(
            boxes in prop::collection::vec((0.0f32..200.0, 0.0f32..120.0, 0.0f32..40.0), 1..30),
            (x, y) in (-20.0f32..220.0, -20.0f32..140.0),
            distance in -30.0f32..90.0,
        ) {
            let of_box = |&(x, y, side): &(f32, f32, f32)| Bounds([Vec2::new(x, y), Vec2::new(x, y) + side]);
            let bounds: Vec<Bounds> = boxes.iter().map(of_box).collect();
            let (at, mut seen) = (Vec2::new(x, y), BTreeSet::new());
            Squares::new(16.0, Vec2::new(200.0, 120.0), Vec2::ZERO, &bounds).around(at, distance, |things| {
                seen.extend(things.iter().copied());
                distance
            });
            for (number, bounds) in (0..).zip(&bounds) {
                let off = (bounds.0[0] - at).max(at - bounds.0[1]).max(Vec2::ZERO).length();
                prop_assert!(off > distance || seen.contains(&number), "{number} is {off} off");
            }
        }
    }
}
