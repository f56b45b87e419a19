//! The pieces of rivers, stretch by stretch: what is far from all of a stretch is far from its pieces.

use std::ops::Range;

use glam::Vec2;

use super::background::Piece;
use super::squares::{Bounded, Bounds, Squares};
use crate::base::geometry::{fast_max, fast_min};
use crate::base::sort;

/// The most pieces of a stretch.
const MOST: usize = 8;

/// The side of the squares that stretches are sorted into, in units.
const SQUARE: f32 = 48.0;

/// A few pieces of a river that follow each other.
#[derive(Clone, Debug)]
struct Stretch {
    river: u32,
    pieces: Range<usize>,
    bounds: Bounds,
    /// The greatest width of a piece.
    widest: f32,
}

/// Rivers in stretches: those of each river, and all of them by where they lie.
#[derive(Clone, Debug)]
pub(super) struct Stretches {
    /// The north-western corner of the squares.
    corner: Vec2,
    /// Pieces, river by river.
    pieces: Vec<Bounded>,
    /// Stretches, river by river.
    stretches: Vec<Stretch>,
    /// The numbers of each river's stretches.
    of_rivers: Vec<Range<usize>>,
    /// The numbers of stretches, the widest first, and the squares of stretches in that order.
    by_width: Vec<usize>,
    squares: Squares,
}

impl Stretches {
    /// Divides the pieces of so many rivers, which are numbered from 0 on and come in that order, before anything else.
    pub fn of(pieces: Vec<Bounded>, rivers: usize, [corner, size]: [Vec2; 2]) -> Self {
        let (mut stretches, mut of_rivers, mut end) = (Vec::new(), Vec::new(), 0);
        for river in 0..rivers as u32 {
            let (first, start) = (stretches.len(), end);
            end = start + pieces[start..].iter().take_while(|bounded| bounded.piece.river == river).count();
            let some = (start..end).step_by(MOST).map(|from| from..(from + MOST).min(end));
            stretches.extend(some.filter_map(|some| Stretch::of(&pieces, some)));
            of_rivers.push(first..stretches.len());
        }
        let by_width = sort::argsort(stretches.iter().map(|stretch| sort::key(-stretch.widest)));
        let bounds: Vec<Bounds> = by_width.iter().map(|&stretch| stretches[stretch].bounds).collect();
        let squares = Squares::new(SQUARE, size, corner, &bounds);
        Self { corner, pieces, stretches, of_rivers, by_width, squares }
    }

    /// Hands out the pieces of a river whose bounds come nearer to a place than a distance. Each time `look` returns the distance from then
    /// on, which never grows.
    pub fn near(&self, river: u32, at: Vec2, mut distance: f32, mut look: impl FnMut(&Piece) -> f32) {
        let of_river = self.of_rivers.get(river as usize).cloned().unwrap_or_default();
        for stretch in &self.stretches[of_river] {
            self.look_at(stretch, at, &mut distance, &mut look);
        }
    }

    /// Does the same with the pieces of all other rivers that are at least so wide.
    pub fn near_others(
        &self,
        (river, least_width): (u32, f32),
        at: Vec2,
        mut distance: f32,
        mut look: impl FnMut(&Piece) -> f32,
    ) {
        self.squares.around(at - self.corner, distance, |things| {
            let stretches = things.iter().map(|&thing| &self.stretches[self.by_width[thing as usize]]);
            for stretch in stretches.take_while(|stretch| stretch.widest >= least_width) {
                if stretch.river != river {
                    self.look_at(stretch, at, &mut distance, &mut |piece: &Piece| {
                        if piece.is_as_wide_as(least_width) { look(piece) } else { f32::MAX }
                    });
                }
            }
            distance
        });
    }

    #[inline]
    fn look_at(&self, stretch: &Stretch, at: Vec2, distance: &mut f32, look: &mut impl FnMut(&Piece) -> f32) {
        if stretch.bounds.least_distance(at) < *distance {
            for Bounded { piece, bounds } in &self.pieces[stretch.pieces.clone()] {
                if bounds.least_distance(at) < *distance {
                    *distance = fast_min(*distance, look(piece));
                }
            }
        }
    }
}

impl Stretch {
    /// Gathers some pieces of one river; `None` if there are none.
    fn of(pieces: &[Bounded], some: Range<usize>) -> Option<Self> {
        let join = |Bounds(a): Bounds, Bounds(b): Bounds| Bounds([a[0].min(b[0]), a[1].max(b[1])]);
        let of_some = &pieces[some.clone()];
        let bounds = of_some.iter().map(|bounded| bounded.bounds).reduce(join)?;
        let widest = of_some.iter().map(|bounded| bounded.piece.widest()).fold(0.0, fast_max);
        Some(Self { river: of_some.first()?.piece.river, pieces: some, bounds, widest })
    }
}
