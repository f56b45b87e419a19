//! The background, prepared: ink cell by cell, and pieces of rivers by where they lie. It answers as going through all pieces would, to the bit.

use glam::Vec2;

use super::background::{Background, CELL, Ink, Piece};
use super::input::Input;
use super::letters::Box;
use super::squares::{Bounded, Bounds};
use super::stretches::Stretches;

/// The background of letters as a table that is looked up.
#[derive(Clone, Debug)]
pub struct Raster {
    ink: Table,
    rivers: Stretches,
}

/// The ink of each cell, row by row.
#[derive(Clone, Debug)]
struct Table {
    /// The north-western corner of the first cell.
    corner: Vec2,
    columns: usize,
    cells: Vec<Ink>,
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
        let mut ink = Table { corner, columns, cells: vec![Ink::NOTHING; columns * rows] };
        pieces.iter().for_each(|bounded| ink.draw(bounded));
        Self { ink, rivers: Stretches::of(pieces, input.map.courses.len(), [corner, size]) }
    }
}

impl Table {
    fn draw(&mut self, Bounded { piece, bounds: Bounds(corners) }: &Bounded) {
        let [least, most] = corners.map(|at| (at - self.corner) / CELL);
        let rows = self.cells.len() / self.columns;
        // A conversion makes 0 of what is below.
        let columns = least.x as usize..((most.x + 1.0) as usize).min(self.columns);
        for row in least.y as usize..((most.y + 1.0) as usize).min(rows) {
            for column in columns.clone() {
                let cell = &mut self.cells[row * self.columns + column];
                // That of a place in the cell, since all of these are small whole numbers.
                let middle = self.corner + (Vec2::new(column as f32, row as f32) + 0.5) * CELL;
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
        let Table { corner, columns, cells } = &self.ink;
        let cell = (at - corner) / CELL;
        let (column, row) = (cell.x as usize, cell.y as usize);
        if column < *columns { cells.get(row * columns + column).copied() } else { None }.unwrap_or(Ink::NOTHING)
    }

    fn distances(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> [f32; 2] {
        let mut nearest = [reach; 2];
        let [own, rival] = &mut nearest;
        self.rivers.near(river, at, reach, |piece| {
            *own = own.min(piece.distance(at));
            *own
        });
        self.rivers.near_others((river, least_width), at, reach, |piece| {
            *rival = rival.min(piece.distance(at));
            *rival
        });
        nearest
    }

    fn meets(&self, around: &Box, river: u32) -> bool {
        let (reach, mut is_met) = (around.radius(), false);
        self.rivers.near(river, around.middle, reach, |piece| {
            is_met = is_met || around.meets_river(&piece.ends);
            if is_met { f32::NEG_INFINITY } else { reach }
        });
        is_met
    }
}
