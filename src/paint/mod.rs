//! Painting: a tree of rivers on a tiny-skia pixmap.
//!
//! Rivers are drawn into an 8-bit coverage mask in which the larger coverage wins ([`Coverage`]). So drawing does not
//! depend on order, a river that has grown wider is simply drawn again, and a picture painted bit by bit while the
//! tree grows is the picture painted at once, to the byte. A style then lays colour through that mask.
//!
//! Units here are pixels; a [`View`] is the only thing that knows how many there are to a unit of the domain.

mod coverage;
mod flow;
pub(crate) mod ground;
mod ink;
mod painter;
pub(crate) mod palette;
pub(crate) mod ridges;
mod rivers;
mod skeleton;
mod strokes;
mod view;

#[doc(hidden)]
pub use coverage::Coverage;
pub use coverage::Rect;
#[doc(hidden)]
pub use painter::{Painter, Progress, Rivers};
#[doc(hidden)]
pub use strokes::{Pen, Widths};
pub use view::{LONGEST_SIDE, PaintError, View};

#[cfg(feature = "files")]
pub(crate) use painter::palette as palette_of;

/// How a network is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Ink on paper, rivers as wide as their discharge asks.
    Ink,
    /// The same for pages with a dark scheme: light rivers on paper like the night.
    Dark,
    /// A coloured map: green lowland, blue rivers and sea.
    Map,
    /// White lines one pixel wide on black, as in the study of the paper (figure 6.1).
    Skeleton,
}
