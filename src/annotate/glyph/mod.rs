//! Type: the letters that names on maps are written with, as outlines.
//!
//! Two faces, EB Garamond Italic and EB Garamond Roman (their licence is `OFL.txt`), in tables of 21 kB each. Names are in Latin letters,
//! each with its accents, so nothing is shaped: a line of type is its letters one after the other, with kerning between.
//!
//! Lengths are in ems; x runs along the line, y down from the baseline, as on a screen.

mod fill;
mod initials;
mod measure;
mod subset;
mod table;

pub use fill::{Fill, pieces_of};
pub use initials::{capital, capitals, initials, is_letter};
pub use measure::{Letter, lacking, line_of};
pub(crate) use subset::write_subset;
pub use table::{Curve, Face, Glyph, Typeface};
