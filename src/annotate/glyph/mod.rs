//! Type: the letters that names on maps are written with, as outlines.
//!
//! One face, EB Garamond Italic (its licence is `OFL.txt`), in a table of 21 kB. Names are in Latin letters, each with its
//! accents, so nothing is shaped: a line of type is its letters one after the other, with kerning between.
//!
//! Lengths are in ems; x runs along the line, y down from the baseline, as on a screen.

mod fill;
mod initials;
mod measure;
mod table;

pub use fill::{Fill, pieces_of};
pub use initials::{capital, initials, is_letter};
pub use measure::{Letter, lacking, line_of};
pub use table::{Curve, Glyph, Typeface};
