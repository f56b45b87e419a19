//! The background, prepared: ink cell by cell, and pieces of rivers by where they lie. It answers as going through all pieces would, to the bit.

use glam::Vec2;

use super::background::{Background, CELL, Ink, Piece, cell_middle};
use super::input::Input;
use super::letters::Box;
use super::squares::{Bounded, Bounds, Squares};
use super::stretches::Stretches;
use crate::base::sort;

/// The background of letters as a table that is looked up.
#[derive(Clone, Debug)]
pub struct Raster {
    /// The north-western corner of the table.
    corner: Vec2,
    columns: usize,
    ink: Vec<Ink>,
    /// The pieces of each river, for questions about that one.
    stretches: Stretches,
    /// The pieces of all rivers, the widest first, for questions about others.
    wide: Vec<Bounded>,
    squares: Squares,
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
        let rivers = pieces.partition_point(|bounded| bounded.piece.is_river());
        let wide = sort::sorted_by(&pieces[..rivers], |bounded| sort::key(-bounded.piece.widest()));
        let mut this = Self {
            corner,
            columns,
            ink: vec![Ink::NOTHING; columns * rows],
            squares: Squares::new(size, corner, &wide),
            wide,
            stretches: Stretches::of(Vec::new(), 0),
        };
        pieces.iter().for_each(|bounded| this.draw(bounded));
        Self { stretches: Stretches::of(pieces, input.map.courses.len()), ..this }
    }

    fn draw(&mut self, Bounded { piece, bounds: Bounds(corners) }: &Bounded) {
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

    /// Returns the distance of a place from the banks of a river, at most `reach`.
    fn distance(&self, at: Vec2, river: u32, reach: f32) -> f32 {
        let mut nearest = reach;
        self.stretches.near(river, at, reach, |bounded| {
            nearest = nearest.min(bounded.piece.distance(at));
            nearest
        });
        nearest
    }

    /// Returns the distance of a place from the banks of all rivers but one that are as wide as `least_width`, at most `reach`.
    fn distance_of_others(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> f32 {
        let mut nearest = reach;
        self.squares.around(at - self.corner, reach, |pieces| {
            let pieces = pieces.iter().map(|&piece| &self.wide[piece as usize]);
            for Bounded { piece, bounds } in pieces.take_while(|bounded| bounded.piece.widest() >= least_width) {
                if piece.river != river && bounds.least_distance(at) < nearest {
                    nearest = nearest.min(piece.distance(at));
                }
            }
            nearest
        });
        nearest
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
        [self.distance(at, river, reach), self.distance_of_others(at, river, least_width, reach)]
    }

    fn meets(&self, around: &Box, river: u32) -> bool {
        let (reach, mut is_met) = (around.radius(), false);
        self.stretches.near(river, around.middle, reach, |bounded| {
            is_met = is_met || around.meets_river(&bounded.piece.ends);
            if is_met { f32::NEG_INFINITY } else { reach }
        });
        is_met
    }
}
