//! Riverseed: a river network that grows from a word.
//!
//! A [recipe](recipe::Recipe) holds a seed text and parameters. From it, rivers [grow] from their mouths into the
//! [land], by drainage, by space colonization or as a Brownian tree. The tree is [trimmed](prune), its
//! [hydrology](tree::Hydrology) is computed, and it is turned into a [network] of meandering rivers, which is
//! [painted](paint). Data flows one way:
//!
//! ```text
//! recipe ─► land ─► grow ─► prune ─► network ─► relief ─► map ─► annotate / paint / export / analyse
//! ```
//!
//! Each stage is a function of its part of the recipe, the previous stage and its own random stream. Results are the
//! same to the bit on every machine: `libm` replaces the platform's functions, sums are in fixed point, and neither
//! clocks nor the order of hash maps play a part.
//!
//! ```
//! use riverseed::{Recipe, Session, export};
//!
//! let recipe: Recipe = "seed=kauri&growth=drainage&land=island".parse()?;
//! let map = Session::new(recipe)?.finish()?;
//! let rivers = &map.network().rivers;
//! println!("{} rivers, the greatest of order {:?}", rivers.len(), rivers.iter().map(|river| river.order).max());
//! std::fs::write(std::env::temp_dir().join("kauri.svg"), export::svg::svg(&map)?)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Session`] keeps a recipe together with the results of its stages, for programs that show growth step by step or
//! change the recipe. A [`Map`] is the finished result, and a [`Picture`] is its pixels. To turn your own tree into
//! rivers, use [`network::Shaping`].
//!
//! # Features
//!
//! - `names` (default): pictures have labels, woods and hills; without it they have rivers and ground alone.
//! - `texts` (default): labels and explanations of the parameters.
//! - `json`: JSON and GeoJSON as text, and recipes in JSON.
//! - `png`: PNG, written and read.
//! - `pack`: the game pack, a ZIP of pictures and data, with `json` and `png`.
//!
//! The command line is the crate `riverseed-cli`.

pub use glam;
pub use tiny_skia;

pub use land::Land;
pub use map::{Map, MapId};
pub use network::{Network, Oxbow, River, Vertex};
pub use picture::Picture;
pub use recipe::{
    Cartouche, CourseShape, GrowthMethod, IntegerKey, Key, Labels, LandKind, MeanderModel, NumberKey, Recipe,
    RecipeError, Scatter, Sides, Style, Value,
};
pub use session::{Phase, Session, SessionError, Shortfall, Summary};
pub use tree::Tree;

// Code that unit tests share with the tests in `tests/` calls the crate by its name.
#[cfg(test)]
extern crate self as riverseed;

pub mod analyse;
pub mod annotate;
pub mod base;
pub mod deltas;
pub mod digest;
pub mod domain;
mod drown;
pub mod export;
pub mod grow;
#[cfg(feature = "png")]
pub mod import;
pub mod lakes;
pub mod land;
#[cfg(test)]
#[path = "../tests/common/lands.rs"]
mod lands;
pub mod map;
pub mod network;
pub mod paint;
pub mod picture;
#[cfg(test)]
#[path = "../tests/common/property.rs"]
mod property;
pub mod prune;
pub mod recipe;
pub mod relief;
pub mod scale;
pub mod session;
pub mod tree;

/// The README's example is compiled and run with the tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
