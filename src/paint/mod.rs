//! Painting: draws a tree of rivers on a tiny-skia pixmap.
//!
//! Rivers are drawn into an 8-bit coverage mask in which the larger coverage wins ([`Coverage`]). Therefore the order
//! of drawing does not matter, a river that has grown wider is simply drawn again, and a picture painted bit by bit
//! while the tree grows equals the picture painted at once, to the byte. A style then lays colour through the mask.
//!
//! Units here are pixels. Only a [`View`] knows the number of pixels per unit of the domain.

pub(crate) mod annotation;
pub(crate) mod beds;
pub(crate) mod belts;
mod beyond;
mod coverage;
mod cut_out;
mod flat;
mod flow;
pub(crate) mod grid;
pub(crate) mod ground;
mod ground_cache;
mod ink;
mod lakes;
pub(crate) mod mouths;
pub(crate) mod neatline;
mod painter;
pub(crate) mod palette;
mod paper;
mod raised;
pub(crate) mod relief;
pub(crate) mod ridges;
mod rivers;
mod settings;
mod skeleton;
mod strokes;
mod styles;
mod view;
pub(crate) mod waters;

pub use annotation::masks::{AnnotationMasks, SparseMask};
pub use coverage::Rect;
pub use painter::Painted;
pub use relief::{Contour, contours};
pub use styles::atlas;
pub use view::{Framing, LONGEST_SIDE, PaintError, View};
#[doc(hidden)] // Benchmarks draw with these alone.
pub use {
    coverage::Coverage,
    strokes::{Pen, Widths},
};

pub(crate) use annotation::letters;
pub(crate) use annotation::scenery::SceneryPainter;
pub(crate) use painter::{Painter, Progress};
pub(crate) use palette::Lines;
pub(crate) use rivers::{Inland, Rivers};
pub(crate) use settings::PaintSettings;
pub(crate) use styles::Scheme;
pub(crate) use styles::palette as palette_of;
pub(crate) use styles::{LabelLook, label_look};
pub(crate) use styles::{SceneryLook, scenery_look};
