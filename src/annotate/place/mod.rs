//! The placement of labels and scenery. Labels are words set along courses, letter by letter, and on the sea; marks, which some styles have
//! besides, are heights, a grid, a legend, a seal; and scenery is woods and hills on the land between.
//!
//! The input is a map with its names, the result plain arrays, and neither knows pixels or files. After Wolff, Knipping, van Kreveld,
//! Strijk and Agarwal, *A simple and efficient algorithm for high-quality line labeling*: lines of type that bend little, at a small and
//! even distance from the course; ours are found by trying many. Rules of taste are Imhof's (*Positioning names on maps*, 1975).
//!
//! ```text
//! courses ─► copies of them, smoothed ─► baselines beside those ─► candidates ─► the cheapest that nothing forbids
//! points, evenly scattered ─► those that are clear of rivers, coasts and letters ─► hills on divides, trees in woods
//! ```

mod anchor;
mod areas;
mod background;
mod banks;
mod baseline;
mod beside;
mod blocks;
mod cartouche;
mod chosen;
mod compass_rose;
mod corner;
mod costs;
mod crowd;
mod frames;
mod free;
mod grid_letters;
mod heading;
mod hill_shapes;
mod hills;
mod inlets;
mod input;
mod islands;
mod legend;
mod lengths;
mod letters;
mod levels;
mod neat_line;
mod own;
mod panel;
mod pen;
mod places;
mod placing;
mod plate;
mod profile;
mod raster;
mod regions;
mod scale_bar;
mod scatter;
mod scenery;
mod seal;
mod search;
mod shapes;
mod spot_heights;
mod squares;
mod standing;
mod stretches;
mod tarns;
mod tree_shapes;
mod wetlands;
mod woods;

pub use background::{Background, Ink, Piece, cell_middle};
pub use free::{FOOT_FROM_BANKS, FROM_BANKS, FROM_COAST, FROM_LETTERS};
pub use heading::heading;
pub(crate) use input::Known;
pub use input::{
    Cartouche, Elevations, Frame, Heights, Input, Legend, LongProfile, MapInput, Marks, NorthPoint, Own, Plate,
    RiverClass, SceneryInput, Seal, SheetGrid, StraightRiver, Tributary, Weather,
};
pub use letters::{Box, Kind, Label, LabelIn, Placed, PlacedIn, Stroke};
pub use levels::{STEPS, least_em_of, step_for};
pub use neat_line::MARGIN as SHEET_MARGIN;
pub use pen::{Feature, PenStroke, Shape};
pub use places::{Places, place};
pub use raster::Raster;
pub use scenery::Scenery;
pub use shapes::SHAPES;
pub use standing::Standing;
