//! Whether a glyph may stand somewhere: off the water, the coast, ridges, letters and what stands there already, whole and exactly.

use glam::Vec2;

use super::background::{LAKE, Piece, RIDGE};
use super::banks::Banks;
use super::input::SceneryInput;
use super::letters::Box;
use super::shapes::{Feature, discs};

/// How far all of a glyph keeps from banks, in units, and how far a tree's foot does.
pub const FROM_BANKS: f32 = 2.4;
pub const FOOT_FROM_BANKS: f32 = 4.2;
/// How far all of it keeps from the coast, and from letters.
pub const FROM_COAST: f32 = 4.0;
pub const FROM_LETTERS: f32 = 3.0;

/// A disc of the map: its middle and its radius.
pub type Disc = (Vec2, f32);

/// What scenery keeps off.
#[derive(Clone, Debug)]
pub struct FreeGround {
    size: Vec2,
    water: Banks,
    ridges: Banks,
    letters: Vec<Box>,
}

impl FreeGround {
    /// Of a map.
    pub fn new(input: &SceneryInput<'_>) -> Self {
        let streams = (0..).zip(&input.streams).flat_map(|(number, stream)| Piece::along(number, &stream.course));
        let lakes = input.lakes.iter().flat_map(|line| Piece::along(LAKE, line));
        let ridges = input.ridges.iter().flat_map(|line| Piece::along(RIDGE, line));
        Self {
            size: input.size,
            water: Banks::new(input.size, streams.chain(lakes).collect()),
            ridges: Banks::new(input.size, ridges.collect()),
            letters: input.letters.clone(),
        }
    }

    /// How far a place is from the nearest bank, at most `most`.
    pub fn distance_to_bank(&self, at: Vec2, most: f32) -> f32 {
        self.water.distance(at, most)
    }

    /// How far it is from the nearest ridge, at most `most`.
    pub fn distance_to_ridge(&self, at: Vec2, most: f32) -> f32 {
        self.ridges.distance(at, most)
    }

    /// Whether all of a glyph is clear of water, coast, ridges and letters.
    pub fn is_clear(&self, input: &SceneryInput<'_>, feature: Feature, foot: Vec2, size: f32) -> bool {
        let is_ashore = |(at, radius): Disc| input.coast.is_none_or(|coast| coast.height(at) >= radius + FROM_COAST);
        let is_dry = |(at, radius): Disc| {
            let clear = radius + FROM_BANKS;
            self.distance_to_bank(at, clear) >= clear && self.distance_to_ridge(at, clear) >= clear
        };
        let is_blank = |(at, radius): Disc| {
            let clear = radius + FROM_LETTERS;
            let is_far = |letter: &Box| at.distance_squared(letter.middle) > squared(clear + letter.radius());
            self.letters.iter().all(|letter| is_far(letter) || letter.gap([at, at]) > clear)
        };
        discs_at(feature, foot, size).all(|disc| is_ashore(disc) && is_dry(disc) && is_blank(disc))
    }

    /// Things by where they stand, none yet.
    pub fn spots(&self) -> Spots {
        Spots::new(self.size)
    }
}

/// The discs that a glyph lies within.
pub fn discs_at(feature: Feature, foot: Vec2, size: f32) -> impl Iterator<Item = Disc> {
    discs(feature).iter().map(move |(middle, radius)| (foot + Vec2::from(*middle) * size, radius * size))
}

fn squared(x: f32) -> f32 {
    x * x
}

/// Discs by where they lie.
#[derive(Clone, Debug)]
pub struct Spots {
    columns: usize,
    squares: Vec<Vec<Disc>>,
    /// The radius of the greatest.
    most: f32,
}

impl Spots {
    /// The side of a square, in units.
    const SQUARE: f32 = 24.0;

    fn new(size: Vec2) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / Self::SQUARE) as usize + 1);
        Self { columns, squares: vec![Vec::new(); columns * rows], most: 0.0 }
    }

    fn square(&self, at: Vec2) -> [usize; 2] {
        let rows = self.squares.len() / self.columns;
        // A conversion makes 0 of what is below.
        [((at.x / Self::SQUARE) as usize).min(self.columns - 1), ((at.y / Self::SQUARE) as usize).min(rows - 1)]
    }

    /// Adds a disc.
    pub fn add(&mut self, disc: Disc) {
        let [column, row] = self.square(disc.0);
        self.squares[row * self.columns + column].push(disc);
        self.most = self.most.max(disc.1);
    }

    /// Whether a disc overlaps none.
    pub fn is_free(&self, (at, radius): Disc) -> bool {
        let reach = radius + self.most;
        let ([left, top], [right, bottom]) = (self.square(at - reach), self.square(at + reach));
        let is_apart = |other: &Disc| at.distance_squared(other.0) >= squared(radius + other.1);
        (top..=bottom).all(|row| {
            self.squares[row * self.columns + left..=row * self.columns + right].iter().flatten().all(is_apart)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_is_free_if_it_overlaps_none_wherever_that_lies() {
        let mut spots = Spots::new(Vec2::new(200.0, 100.0));
        assert!(spots.is_free((Vec2::new(50.0, 50.0), 500.0)));
        spots.add((Vec2::new(23.0, 23.0), 4.0));
        spots.add((Vec2::new(150.0, 90.0), 60.0));
        assert!(spots.is_free((Vec2::new(30.0, 23.0), 3.0)) && !spots.is_free((Vec2::new(30.0, 23.0), 3.1)));
        assert!(!spots.is_free((Vec2::new(95.0, 90.0), 0.0)) && spots.is_free((Vec2::new(89.0, 90.0), 0.5)));
    }
}
