//! Riverseed: a river network that grows from a word.
//!
//! A [recipe](recipe::Recipe) holds a seed text and parameters. Rivers [grow] from their mouths into the [land], as water
//! drains it, by space colonization or as a Brownian tree, are [trimmed](prune), read for their [hydrology](tree::Hydrology), made into
//! a [network] of rivers that meander, and [painted](paint). Data flows one way:
//!
//! ```text
//! recipe ─► land ─► grow ─► prune ─► network ─► paint / export
//! ```
//!
//! Each stage is a function of its part of the recipe, the stage before it and its own random stream, and is the same
//! to the bit on every machine: `libm` instead of the platform's functions, sums in fixed point, no clock, no
//! hash-map order.
//!
//! ```
//! use riverseed::{Recipe, Session, export};
//!
//! let recipe: Recipe = "seed=kauri&growth=drainage&land=island".parse()?;
//! let map = Session::new(recipe)?.finish()?;
//! let rivers = &map.network().rivers;
//! println!("{} rivers, the greatest of order {:?}", rivers.len(), rivers.iter().map(|river| river.order).max());
//! # #[cfg(feature = "files")]
//! std::fs::write(std::env::temp_dir().join("kauri.svg"), export::svg::svg(&map)?)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Session`] holds a recipe with what each stage has made of it, for programs that show growth step by step or
//! change the recipe; a [`Map`] is what it comes to in the end, and a [`Picture`] is its pixels. To make rivers of a tree of your own, use [`network::Shaping`].
//!
//! # Features
//!
//! - `files` (default): SVG as text, GeoJSON and JSON as plain data, tracing of images, digests.
//! - `names` (default): names of rivers, lakes and islands, in files and on the map.
//! - `json`: JSON and GeoJSON as text, and recipes in JSON.
//! - `png`: PNG, written and read.
//! - `pack`: the game pack, a ZIP of pictures and data, with `json` and `png`.
//! - `cli`: the program `riverseed`, with all of these.

pub use glam;
pub use tiny_skia;

pub use land::Land;
pub use map::{Map, MapId};
pub use network::{Network, Oxbow, River, Vertex};
pub use picture::Picture;
pub use recipe::{
    Cartouche, CourseShape, GrowthMethod, Key, Labels, LandKind, MeanderModel, Recipe, RecipeError, Scatter, Sides,
    Style, Value,
};
pub use session::{Phase, Session, SessionError, Shortfall, Summary};
pub use tree::Tree;

// What unit tests share with those in `tests/` names the crate as those do.
#[cfg(test)]
extern crate self as riverseed;

#[cfg(feature = "names")]
#[doc(hidden)]
pub mod chart;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod chart_builder;
#[doc(hidden)]
pub mod dice;
#[cfg(feature = "files")]
pub mod digest;
pub mod domain;
#[cfg(feature = "files")]
pub mod export;
mod geometry;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod glyph;
pub mod grow;
#[cfg(feature = "png")]
pub mod import;
#[cfg(all(feature = "files", feature = "controls"))]
#[doc(hidden)]
pub mod inspect;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod labels;
pub mod land;
#[cfg(test)]
#[path = "../tests/common/lands.rs"]
mod lands;
pub mod map;
pub mod measure;
mod memory;
pub mod name;
pub mod network;
pub mod paint;
pub mod picture;
#[cfg(test)]
#[path = "../tests/common/property.rs"]
mod property;
pub mod prune;
mod queue;
pub mod random;
pub mod recipe;
pub mod relief;
#[cfg(feature = "names")]
#[doc(hidden)]
pub mod scenery;
pub mod session;
mod simplify;
mod skeletonize;
mod sort;
pub mod tree;
#[cfg(target_arch = "wasm32")]
mod web;
mod wire;
#[doc(hidden)]
pub mod work;

/// The README's example is compiled and run with the tests.
#[cfg(all(doctest, feature = "files"))]
#[doc = include_str!("../README.md")]
pub struct Readme;
