//! Squares of the plane with a number each, so that a thing can be known by the place where it lies.

use glam::Vec2;

/// Squares with sides of this length, in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Squares(pub f32);

/// The number of squares of a row, and of rows: enough for sides of two units on maps of any aspect.
const STRIDE: u32 = 1000;

impl Squares {
    /// The number of all squares.
    pub const COUNT: u32 = STRIDE * STRIDE;

    /// Returns the column and the row of the square in which a point lies.
    pub fn cell(self, at: Vec2) -> [u32; 2] {
        at.to_array().map(|x| ((x / self.0).max(0.0) as u32).min(STRIDE - 1))
    }

    /// Returns the number of the square in which a point lies.
    pub fn number(self, at: Vec2) -> u32 {
        let [column, row] = self.cell(at);
        row * STRIDE + column
    }

    /// Returns the middle of a square, in units.
    pub fn middle(self, number: u32) -> Vec2 {
        Vec2::new((number % STRIDE) as f32 + 0.5, (number / STRIDE) as f32 + 0.5) * self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_s_middle_lies_in_it_and_no_point_panics() {
        let squares = Squares(8.0);
        for number in [0, 1, 50_050, 999_999] {
            assert_eq!(squares.number(squares.middle(number)), number);
        }
        assert_eq!([1e9, -1e9, f32::NAN].map(|x| squares.number(Vec2::splat(x))), [999_999, 0, 0]);
    }
}
