//! The ground under labels without preparation: each sample goes through all rivers, and each cell does so once.

use std::cell::RefCell;
use std::collections::BTreeMap;

use riverseed::annotate::place::{Background, Box, Ink, Piece, cell_middle};
use riverseed::glam::Vec2;

/// The ground without preparation.
pub struct Literal {
    pieces: Vec<Piece>,
    /// The ink of cells that were asked for, by their middles' bits.
    seen: RefCell<BTreeMap<[u32; 2], Ink>>,
}

impl Literal {
    pub fn new(pieces: Vec<Piece>) -> Self {
        Self { pieces, seen: RefCell::default() }
    }
}

impl Background for Literal {
    const STOPS_EARLY: bool = false;

    fn ink(&self, at: Vec2) -> Ink {
        let middle = cell_middle(at);
        let look = || {
            let mut widest = Ink::NOTHING;
            for ink in self.pieces.iter().filter_map(|piece| piece.ink(middle)) {
                if ink.width > widest.width {
                    widest = ink;
                }
            }
            widest
        };
        *self.seen.borrow_mut().entry(middle.to_array().map(f32::to_bits)).or_insert_with(look)
    }

    fn distances(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> [f32; 2] {
        let rivers = || self.pieces.iter().filter(|piece| piece.is_river());
        let least =
            |pieces: &mut dyn Iterator<Item = &Piece>| pieces.map(|piece| piece.distance(at)).fold(reach, f32::min);
        let is_rival = |piece: &&Piece| piece.river != river && piece.is_as_wide_as(least_width);
        [least(&mut rivers().filter(|piece| piece.river == river)), least(&mut rivers().filter(is_rival))]
    }

    fn meets(&self, around: &Box, river: u32) -> bool {
        self.pieces.iter().any(|piece| piece.river == river && around.meets_river(&piece.ends))
    }
}
