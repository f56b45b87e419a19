//! The cells of land and water.

/// The kind of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// Land.
    Land,
    /// Water, where rivers end.
    Water,
    /// A ridge, which no river crosses.
    Ridge,
}

/// The side of a cell, in units: far less than a step of a river at the default number of attractors.
pub const CELL_SIZE: f32 = 1.0;
