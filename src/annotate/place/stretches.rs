//! The pieces of each river, stretch by stretch: what is far from all of a stretch is far from its pieces.

use std::ops::Range;

use glam::Vec2;

use super::squares::{Bounded, Bounds};

/// The most pieces of a stretch.
const MOST: usize = 8;

/// A few pieces of a river that follow each other.
#[derive(Clone, Debug)]
struct Stretch {
    pieces: Range<usize>,
    bounds: Bounds,
}

/// Pieces in stretches. Those of a river must follow each other.
#[derive(Clone, Debug)]
pub(super) struct Stretches {
    pieces: Vec<Bounded>,
    stretches: Vec<Stretch>,
    /// The numbers of each river's stretches.
    of_rivers: Vec<Range<usize>>,
}

impl Stretches {
    /// Divides the pieces of so many rivers, which are numbered from 0 on and come in that order, before all others.
    pub fn of(pieces: Vec<Bounded>, rivers: usize) -> Self {
        let mut this = Self { pieces, stretches: Vec::new(), of_rivers: Vec::new() };
        let mut end = 0;
        for river in 0..rivers as u32 {
            let first = this.stretches.len();
            let start = end;
            end = start + this.pieces[start..].iter().take_while(|bounded| bounded.piece.river == river).count();
            for from in (start..end).step_by(MOST) {
                let pieces = from..(from + MOST).min(end);
                let join = |Bounds(a): Bounds, Bounds(b): Bounds| Bounds([a[0].min(b[0]), a[1].max(b[1])]);
                let bounds = this.pieces[pieces.clone()].iter().map(|bounded| bounded.bounds).reduce(join);
                this.stretches.extend(bounds.map(|bounds| Stretch { pieces, bounds }));
            }
            this.of_rivers.push(first..this.stretches.len());
        }
        this
    }

    /// Returns all pieces.
    pub fn pieces(&self) -> &[Bounded] {
        &self.pieces
    }

    /// Hands out the pieces of a river whose bounds come nearer to a place than a distance. Each time `look` returns the distance from then
    /// on, which never grows.
    pub fn near(&self, river: u32, at: Vec2, mut distance: f32, mut look: impl FnMut(&Bounded) -> f32) {
        let of_river = self.of_rivers.get(river as usize).cloned().unwrap_or_default();
        for stretch in &self.stretches[of_river] {
            if stretch.bounds.least_distance(at) < distance {
                for bounded in &self.pieces[stretch.pieces.clone()] {
                    if bounded.bounds.least_distance(at) < distance {
                        distance = look(bounded);
                    }
                }
            }
        }
    }
}
