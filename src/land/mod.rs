//! Land: where rivers may run.
//!
//! A [`Relief`] says of every point of the domain how far inland it lies; a [`Land`] is the field of cells made of it,
//! each Available (land), Unavailable (water) or Illegal (a ridge that no river may cross), as in seed document 2.
//!
//! A drawn land comes from an [`Outline`](crate::recipe::Outline), which hand-drawn lines
//! ([`of_strokes`](crate::recipe::Outline::of_strokes)) or a picture (`trace`, of the feature `tools`) are turned into.
//!
//! Growth asks the field, painting what is shown of the relief ([`Shown`]): so the coast is smooth at any size, and rivers
//! end at it.

#[cfg(feature = "files")]
mod contours;
mod field;
mod grid;
mod kinds;
mod obstacles;
mod outline;
mod regions;
mod relief;
mod shown;
mod strokes;
#[cfg(feature = "files")]
pub mod trace;
mod walk;

pub use field::Land;
pub use grid::{Cell, SIDE};
#[doc(hidden)]
pub use regions::{Cells, Run};
pub use regions::{Region, Shore};
pub use relief::Relief;
#[doc(hidden)]
pub use shown::Shown;
pub(crate) use shown::{Across, Parabola};
pub use strokes::DrawError;
