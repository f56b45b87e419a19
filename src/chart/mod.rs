//! The chart: what stands on a map besides rivers. Labels, so far: words set along courses, letter by letter, and on the sea.
//!
//! Input is plain arrays, so is the result, and neither knows what pixels or files are. After Wolff, Knipping, van Kreveld, Strijk and
//! Agarwal, *A simple and efficient algorithm for high-quality line labeling*: lines of type that bend little, at a small and even distance
//! from the course; ours are found by trying many. Rules of taste are Imhof's (*Positioning names on maps*, 1975).
//!
//! ```text
//! courses ─► copies of them, smoothed ─► baselines beside those ─► candidates ─► the cheapest that nothing forbids
//! ```

mod areas;
mod background;
mod baseline;
mod cartouche;
mod costs;
mod input;
mod islands;
mod letters;
mod place;
mod raster;
mod search;

pub use background::{Background, Ink, Piece, cell_middle};
pub use input::{Area, AreaKind, Cartouche, Input, Reach, River, Strip};
pub use letters::{Box, Kind, Label, Placed, Stroke};
pub use place::place;
pub use raster::Raster;
