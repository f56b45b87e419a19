//! The ground under labels without preparation: every sample goes through all rivers.

use riverseed::annotate::place::{Background, Ink, Piece, cell_middle};
use riverseed::glam::Vec2;

/// The ground without preparation.
pub struct Literal(pub Vec<Piece>);

impl Background for Literal {
    const STOPS_EARLY: bool = false;

    fn ink(&self, at: Vec2) -> Ink {
        let middle = cell_middle(at);
        let mut widest = Ink::NOTHING;
        for ink in self.0.iter().filter_map(|piece| piece.ink(middle)) {
            if ink.width > widest.width {
                widest = ink;
            }
        }
        widest
    }

    fn distances(&self, at: Vec2, river: u32, least_width: f32, reach: f32) -> [f32; 2] {
        let rivers = || self.0.iter().filter(|piece| piece.is_river());
        let least =
            |pieces: &mut dyn Iterator<Item = &Piece>| pieces.map(|piece| piece.distance(at)).fold(reach, f32::min);
        let is_rival = |piece: &&Piece| piece.river != river && piece.is_as_wide_as(least_width);
        [least(&mut rivers().filter(|piece| piece.river == river)), least(&mut rivers().filter(is_rival))]
    }
}
