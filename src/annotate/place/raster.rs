//! The background, prepared: ink cell by cell, and pieces of rivers by where they lie. It answers as going through all pieces would, to the bit.

use glam::Vec2;

use super::background::{Background, CELL, Ink, Piece, cell_middle};
use super::input::Input;

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
    pieces: Vec<Piece>,
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
        let pieces = Piece::all(input);
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
        pieces.iter().for_each(|piece| this.draw(piece));
        Self { pieces, ..this }
    }

    fn draw(&mut self, piece: &Piece) {
        let [least, most] = piece.corners().map(|at| (at - self.corner) / CELL);
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
        const ROUNDING: f32 = 0.01;
        let mut nearest = [reach; 2];
        self.squares.around(at - self.corner, reach, |pieces, away| {
            // Nothing in a square is nearer than that.
            if away > nearest[0].max(nearest[1]) + ROUNDING {
                return;
            }
            for piece in pieces.iter().map(|&piece| &self.pieces[piece as usize]) {
                let is_other = piece.river != river;
                if !piece.is_river() || (is_other && !piece.is_as_wide_as(least_width)) {
                    continue;
                }
                // The box is larger than the ink by more than any rounding.
                let [least, most] = piece.corners();
                let nearest = &mut nearest[usize::from(is_other)];
                if (least - at).max(at - most).max_element() < *nearest {
                    *nearest = nearest.min(piece.distance(at));
                }
            }
        });
        nearest
    }
}

impl Squares {
    pub fn new(size: Vec2, corner: Vec2, pieces: &[Piece]) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / SQUARE) as usize + 1);
        let mut this = Self { columns, rows, starts: vec![0; columns * rows + 1], pieces: Vec::new() };
        let squares_of = |piece: &Piece, this: &Self| {
            let [least, most] = piece.corners().map(|at| at - corner);
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

    /// Returns the squares between two corners. Squares at the border stand for what lies outside.
    fn squares(&self, least: Vec2, most: Vec2) -> impl Iterator<Item = usize> + use<> {
        let clamp = |x: f32, count: usize| ((x / SQUARE) as usize).min(count - 1);
        let (left, right) = (clamp(least.x, self.columns), clamp(most.x, self.columns));
        let columns = self.columns;
        let rows = clamp(least.y, self.rows)..=clamp(most.y, self.rows);
        rows.flat_map(move |row| (left..=right).map(move |column| row * columns + column))
    }

    /// Hands out the pieces of all squares within a distance of a place, and how far each square is from that; its own square's first.
    pub fn around(&self, at: Vec2, distance: f32, mut look: impl FnMut(&[u32], f32)) {
        let pieces = |square: usize| &self.pieces[self.starts[square] as usize..self.starts[square + 1] as usize];
        let own = self.squares(at, at).next();
        if let Some(own) = own {
            look(pieces(own), 0.0);
        }
        for square in self.squares(at - distance, at + distance).filter(|square| Some(*square) != own) {
            let corner = Vec2::new((square % self.columns) as f32, (square / self.columns) as f32) * SQUARE;
            let off = (corner - at).max(at - corner - SQUARE).max(Vec2::ZERO);
            look(pieces(square), off.length_squared().sqrt());
        }
    }
}
