//! The background, prepared: ink cell by cell, and pieces of rivers by where they lie. It answers as going through all pieces would, to the bit.

use glam::Vec2;

use super::background::{Background, CELL, Ink, Piece, cell_middle};
use super::input::Input;
use super::letters::Box;
use crate::base::geometry::fast_max;

/// The side of the squares that pieces are sorted into, in units.
const SQUARE: f32 = 24.0;

/// The background of letters as a table that is looked up.
#[derive(Clone, Debug)]
pub struct Raster {
    /// The north-western corner of the table.
    corner: Vec2,
    columns: usize,
    ink: Vec<Ink>,
    squares: Squares,
    pieces: Vec<Bounded>,
}

/// A piece with the corners of a box that is larger than its ink by more than any rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    pub piece: Piece,
    corners: [Vec2; 2],
}

impl Bounded {
    pub fn new(piece: Piece) -> Self {
        Self { piece, corners: piece.corners() }
    }

    /// Returns a distance that its ink is no nearer to a point than; less than 0 in its box.
    #[inline]
    pub fn least_distance(&self, at: Vec2) -> f32 {
        let [least, most] = self.corners;
        let (west_or_north, east_or_south) = (least - at, at - most);
        let across = fast_max(west_or_north.x, east_or_south.x);
        fast_max(across, fast_max(west_or_north.y, east_or_south.y))
    }
}

/// The pieces that come near each square.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    columns: usize,
    rows: usize,
    /// The place in the list where the pieces of each square begin, and the place where the last end.
    starts: Vec<u32>,
    pieces: Vec<u32>,
}

impl Raster {
    /// The greatest number of bytes that it takes, besides the pieces.
    pub const BYTES: usize = 4_000_000;

    /// Draws the rivers, lakes and ridges of a map.
    pub fn new(input: &Input<'_>) -> Self {
        let pieces: Vec<Bounded> = Piece::all(input).into_iter().map(Bounded::new).collect();
        // All of the map, where places are chosen, and what the picture shows around it.
        let ([least, most], sheet) = (input.frame, input.sheet());
        let (least, most) = (least.min(sheet[0]), most.max(sheet[1]));
        let corner = (least / CELL).floor() * CELL;
        let size = most - corner;
        let [columns, rows] = [size.x, size.y].map(|length| (length / CELL) as usize + 2);
        let mut this = Self {
            corner,
            columns,
            ink: vec![Ink::NOTHING; columns * rows],
            squares: Squares::new(size, corner, &pieces),
            pieces: Vec::new(),
        };
        pieces.iter().for_each(|bounded| this.draw(bounded));
        Self { pieces, ..this }
    }

    fn draw(&mut self, Bounded { piece, corners }: &Bounded) {
        let [least, most] = corners.map(|at| (at - self.corner) / CELL);
        let rows = self.ink.len() / self.columns;
        // A conversion makes 0 of what is below.
        let columns = least.x as usize..((most.x + 1.0) as usize).min(self.columns);
        for row in least.y as usize..((most.y + 1.0) as usize).min(rows) {
            for column in columns.clone() {
                let cell = &mut self.ink[row * self.columns + column];
                let middle = cell_middle(self.corner + (Vec2::new(column as f32, row as f32) + 0.5) * CELL);
                if let Some(ink) = piece.ink(middle).filter(|ink| ink.width > cell.width) {
                    *cell = ink;
                }
            }
        }
    }
}

impl Background for Raster {
    const STOPS_EARLY: bool = true;

    #[inline]
    fn ink(&self, at: Vec2) -> Ink {
        let cell = (at - self.corner) / CELL;
        let (column, row) = (cell.x as usize, cell.y as usize);
        if column < self.columns { self.ink.get(row * self.columns + column).copied() } else { None }
            .unwrap_or(Ink::NOTHING)
    }

    fn distances(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> [f32; 2] {
        let mut nearest = [reach; 2];
        self.squares.around(at - self.corner, reach, |pieces| {
            for bounded in pieces.iter().map(|&piece| &self.pieces[piece as usize]) {
                let piece = &bounded.piece;
                let is_other = piece.river != river;
                let nearest = &mut nearest[usize::from(is_other)];
                if bounded.least_distance(at) < *nearest
                    && piece.is_river()
                    && (!is_other || piece.is_as_wide_as(least_width))
                {
                    *nearest = nearest.min(piece.distance(at));
                }
            }
            fast_max(nearest[0], nearest[1])
        });
        nearest
    }

    fn meets(&self, around: &Box, river: u32) -> bool {
        let (middle, reach) = (around.middle, around.radius());
        let may_meet = |bounded: &&Bounded| bounded.piece.river == river && bounded.least_distance(middle) <= reach;
        let mut is_met = false;
        self.squares.around(middle - self.corner, reach, |pieces| {
            let mut near = pieces.iter().map(|&piece| &self.pieces[piece as usize]).filter(may_meet);
            is_met = is_met || near.any(|bounded| around.meets_river(&bounded.piece.ends));
            if is_met { 0.0 } else { reach }
        });
        is_met
    }
}

impl Squares {
    pub fn new(size: Vec2, corner: Vec2, pieces: &[Bounded]) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / SQUARE) as usize + 1);
        let mut this = Self { columns, rows, starts: vec![0; columns * rows + 1], pieces: Vec::new() };
        let squares_of = |piece: &Bounded, this: &Self| {
            let [least, most] = piece.corners.map(|at| at - corner);
            this.squares(least, most)
        };
        for piece in pieces {
            squares_of(piece, &this).for_each(|square| this.starts[square + 1] += 1);
        }
        for square in 0..columns * rows {
            this.starts[square + 1] += this.starts[square];
        }
        let (mut next, count) = (this.starts.clone(), this.starts.last().copied().unwrap_or(0));
        this.pieces = vec![0; count as usize];
        for (number, piece) in (0..).zip(pieces) {
            for square in squares_of(piece, &this) {
                this.pieces[next[square] as usize] = number;
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
        [((at.x / SQUARE) as usize).min(self.columns - 1), ((at.y / SQUARE) as usize).min(self.rows - 1)]
    }

    /// Hands out the pieces of all squares within a distance of a place, from its own square outward. Each time `look` returns the distance
    /// from then on, which never grows: what is near shortens the way to all that is far.
    pub fn around(&self, at: Vec2, distance: f32, mut look: impl FnMut(&[u32]) -> f32) {
        const ROUNDING: f32 = 0.01;
        let [column, row] = self.square(at);
        let ([left, top], [right, bottom]) = (self.square(at - distance), self.square(at + distance));
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
                    let corner = Vec2::new(x as f32, y as f32) * SQUARE;
                    let off = (corner - at).max(at - corner - SQUARE).max(Vec2::ZERO);
                    // Nothing in a square is nearer than the square.
                    if (x, y) == (column, row) || off.length_squared().sqrt() <= distance + ROUNDING {
                        let square = y * self.columns + x;
                        distance = look(&self.pieces[self.starts[square] as usize..self.starts[square + 1] as usize]);
                    }
                }
            }
        }
    }
}
