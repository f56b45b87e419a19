//! Land: the area where rivers may run.
//!
//! A [`CoastDistance`] gives the distance of every point of the domain from the coast. A [`Land`] is the grid of cells
//! made from it: each is land, water or a ridge that no river may cross, as in Demiurge, part 2.
//!
//! A drawn land comes from an [`Outline`](crate::recipe::Outline), which is made from hand-drawn lines
//! ([`from_polylines`](crate::recipe::Outline::from_polylines)) or from a picture ([`trace`]).
//!
//! Growth uses cells, painting uses smoothed coast distances ([`SmoothedDistance`]). Therefore the coast is smooth at
//! any size, and rivers end at it.

mod archipelago;
mod breakthrough;
mod cell;
mod coast_detail;
mod coast_distance;
mod contours;
mod curve;
mod drafts;
mod draws;
mod figures;
mod form;
mod grid;
mod gulf;
mod island;
mod kinds;
mod low_stand;
mod margin;
mod obstacles;
mod outline;
mod plains;
mod queries;
mod ragged;
mod regions;
mod risen;
mod rock;
mod room;
mod sides;
mod smoothed_distance;
mod spine;
mod straits;
mod strokes;
pub mod trace;
mod walk;

pub use cell::{CELL_SIZE, Cell};
pub(crate) use coast_detail::{CoastDetail, REACH};
pub use coast_distance::CoastDistance;
pub(crate) use low_stand::LowStand;
pub(crate) use margin::{MARGIN, margin_of, runs_off};
pub(crate) use outline::{divided, in_units};
pub use queries::Land;
pub use regions::{Cells, Region, Run, Shore};
pub(crate) use risen::RisenSea;
pub use smoothed_distance::SmoothedDistance;
pub(crate) use smoothed_distance::{Across, Parabola, beside, nearest};
pub use strokes::DrawError;
pub(crate) use walk::walk;
