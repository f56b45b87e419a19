//! Spines: the axes of highlands, along which land rises out of the sea. Islands, peninsulas and, turned over, gulfs and
//! lakes are made of them.

use glam::Vec2;

use crate::base::geometry::{fast_max, length};
use crate::base::work;

/// A bent line with a half width at each of its points, in units. Its ends taper.
#[derive(Clone, Debug)]
pub(super) struct Spine(Vec<(Vec2, f32)>);

impl Spine {
    /// Makes a spine of points with half widths.
    pub fn new(points: Vec<(Vec2, f32)>) -> Self {
        Self(points)
    }

    /// Returns the points and half widths.
    pub fn points(&self) -> &[(Vec2, f32)] {
        &self.0
    }

    /// Returns the greatest half width, in units.
    pub fn widest(&self) -> f32 {
        self.0.iter().map(|(_, width)| *width).fold(0.0, f32::max)
    }

    /// Returns the points and half widths, to be changed.
    pub fn points_mut(&mut self) -> &mut [(Vec2, f32)] {
        &mut self.0
    }

    /// Returns the spine moved by a vector.
    pub fn moved(mut self, by: Vec2) -> Self {
        self.0.iter_mut().for_each(|(at, _)| *at += by);
        self
    }

    /// Returns the spine with another point before its first, with its half width there.
    pub fn from(mut self, at: Vec2, width: f32) -> Self {
        self.0.insert(0, (at, width));
        self
    }

    /// Returns the height of the spine at a point, in units: the half width at the nearest place less the distance from
    /// it, positive within the spine.
    pub fn height(&self, at: Vec2) -> f32 {
        self.pieces(0).map(|piece| piece.height(at)).fold(LOWEST, f32::max)
    }

    fn pieces(&self, spine: u32) -> impl Iterator<Item = Piece> + '_ {
        self.0.windows(2).map(move |pair| Piece::between(spine, pair[0], pair[1]))
    }
}

/// A straight piece of a spine.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The number of the spine.
    spine: u32,
    from: Vec2,
    along: Vec2,
    /// One over the square of the length.
    shortness: f32,
    /// The half width at the beginning of the piece, and how much greater it is at its end.
    width: f32,
    swelling: f32,
    /// The greatest change of the height with distance.
    steepness: f32,
}

impl Piece {
    #[inline(never)] // each copy weighs a hundred bytes
    fn between(spine: u32, (from, width): (Vec2, f32), (to, last): (Vec2, f32)) -> Self {
        let along = to - from;
        let (shortness, swelling) = (1.0 / along.length_squared().max(1.0), last - width);
        let steepness = (1.0 + swelling * swelling * shortness).sqrt();
        Self { spine, from, along, shortness, width, swelling, steepness }
    }

    #[inline]
    fn height(&self, at: Vec2) -> f32 {
        let off = at - self.from;
        let t = (off.dot(self.along) * self.shortness).clamp(0.0, 1.0);
        self.width + self.swelling * t - length(off - self.along * t)
    }
}

/// The heights of several spines together over a domain, with the few pieces that are the highest anywhere in each
/// tile.
#[derive(Clone, Debug)]
pub(super) struct Spines {
    pieces: Vec<Piece>,
    /// The pieces of each tile, row by row, and where those of the next one begin.
    of_tiles: Vec<u32>,
    ends: Vec<u32>,
    columns: usize,
    rows: usize,
    /// The difference of heights from which on only the higher spine counts, in units.
    round: f32,
}

impl Spines {
    /// The side of a tile, in units.
    const TILE: f32 = 80.0;
    /// The width of the tiles around the domain, in units: points stray from it.
    const AROUND: f32 = 160.0;

    /// Combines some spines. Where the heights of two differ by less than `round` units, they blend into a rounded
    /// slope, as at the foot of a spur.
    pub fn new(spines: &[Spine], size: Vec2, round: f32) -> Self {
        let mut pieces = Vec::new();
        for (number, spine) in (0..).zip(spines) {
            pieces.extend(spine.pieces(number));
        }
        let [columns, rows] = [size.x, size.y].map(|length| ((length + 2.0 * Self::AROUND) / Self::TILE) as usize + 1);
        let mut this = Self { pieces, of_tiles: Vec::new(), ends: Vec::new(), columns, rows, round };
        for tile in 0..columns * rows {
            let place = Vec2::new((tile % columns) as f32, (tile / columns) as f32) + 0.5;
            this.add_tile(place * Self::TILE - Self::AROUND);
        }
        work::count(this.pieces.len() * columns * rows);
        this
    }

    /// Adds the pieces that may matter in the tile around a point: those that may somewhere exceed the height that is
    /// certainly reached, or come close to it.
    fn add_tile(&mut self, middle: Vec2) {
        let corner = Self::TILE * std::f32::consts::FRAC_1_SQRT_2;
        let mut certain = LOWEST;
        for piece in &self.pieces {
            certain = fast_max(certain, piece.height(middle) - piece.steepness * corner);
        }
        let least = certain - 1.25 * self.round;
        for (number, piece) in (0..).zip(&self.pieces) {
            if piece.height(middle) + piece.steepness * corner >= least {
                self.of_tiles.push(number);
            }
        }
        self.ends.push(self.of_tiles.len() as u32);
    }

    /// Returns the height of all spines together at a point, in units.
    pub fn height(&self, at: Vec2) -> f32 {
        let (mut whole, mut spine, mut highest) = (LOWEST, 0, LOWEST);
        for &number in self.tile(at) {
            let piece = &self.pieces[number as usize];
            if piece.spine != spine {
                whole = smooth_max(whole, highest, self.round);
                (spine, highest) = (piece.spine, LOWEST);
            }
            highest = fast_max(highest, piece.height(at));
        }
        smooth_max(whole, highest, self.round)
    }

    /// Returns the pieces that matter at a point; those of the nearest tile if it lies in none.
    #[inline]
    fn tile(&self, at: Vec2) -> &[u32] {
        let place = (at + Self::AROUND) / Self::TILE;
        let [column, row] = [(place.x, self.columns), (place.y, self.rows)]
            .map(|(place, count)| (place.max(0.0) as usize).min(count.saturating_sub(1)));
        let tile = row * self.columns + column;
        let start = tile.checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or(0);
        let end = self.ends.get(tile).copied().unwrap_or(start);
        self.of_tiles.get(start as usize..end as usize).unwrap_or_default()
    }
}

/// A height below that of all spines of a domain at any of its points, in units.
const LOWEST: f32 = -1e4;

/// Returns the greater of two numbers, or more where they differ by less than `round` (a quadratic blend: Quilez 2013).
pub(super) fn smooth_max(a: f32, b: f32, round: f32) -> f32 {
    let near = (1.0 - (a - b).abs() / round).max(0.0);
    a.max(b) + near * near * round * 0.25
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::{Purpose, Seed};

    #[test]
    fn tiles_know_all_pieces_that_matter() {
        const ROUND: f32 = 50.0;
        let size = Vec2::new(1250.0, 800.0);
        let mut chance = Seed::from_text("spines").stream(Purpose::Land);
        for _ in 0..10 {
            let mut point = |from: Vec2, far: f32| from + (Vec2::new(chance.unit(), chance.unit()) - 0.5) * far;
            let mut spine = || {
                let start = point(size / 2.0, 1000.0);
                let at = [start, point(start, 300.0), point(start, 300.0), point(start, 300.0)];
                Spine::new(at.into_iter().map(|at| (at, point(Vec2::splat(40.0), 70.0).x)).collect())
            };
            let spines: Vec<Spine> = (0..12).map(|_| spine()).collect();
            let tiled = Spines::new(&spines, size, ROUND);
            for i in 0..2000 {
                let at = Vec2::new((i % 50) as f32, (i / 50) as f32) / Vec2::new(50.0, 40.0) * (size + 200.0) - 100.0;
                let all = spines.iter().fold(LOWEST, |highest, spine| smooth_max(highest, spine.height(at), ROUND));
                assert!((tiled.height(at) - all).abs() < 0.01, "{at}: {} is not {all}", tiled.height(at));
            }
        }
    }
}
