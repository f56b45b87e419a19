//! Riverseed: a river network that grows from a word.
//!
//! A [recipe](recipe::Recipe) holds a seed text and parameters. Rivers [grow] from their mouths into the [land] by space
//! colonization or as a Brownian tree, are [trimmed](prune), read for their [hydrology](tree::Hydrology), made into a
//! [network] of rivers that meander, and [painted](paint). Data flows one way:
//!
//! ```text
//! recipe ─► land ─► grow ─► tree ─► prune ─► network ─► paint / export
//! ```
//!
//! Each stage is a function of its part of the recipe, the stage before it and its own random stream, and is the same
//! to the bit on every machine: `libm` instead of the platform's functions, sums in fixed point, no clock, no
//! hash-map order.
//!
//! ```
//! use riverseed::{grow::{Colonize, Parameters}, prune, recipe::link, tree::Hydrology};
//!
//! let recipe = link::read("seed=kauri&preset=trimmed-curl")?;
//! let mut growth = Colonize::new(Parameters::of(&recipe))?;
//! while growth.tick() {}
//! let hydrology = Hydrology::of(growth.tree());
//! let rivers = prune::trim(growth.tree(), &hydrology, prune::Trim::of(&recipe));
//! assert_eq!(rivers.hydrology.discharge[0], hydrology.discharge[0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`session::Session`] holds a recipe with all its stages, for whoever shows it and changes it.

pub mod dice;
#[cfg(feature = "tools")]
pub mod digest;
pub mod domain;
#[cfg(feature = "tools")]
pub mod export;
pub mod grow;
#[cfg(feature = "png")]
pub mod import;
pub mod land;
mod memory;
pub mod network;
mod order;
pub mod paint;
pub mod picture;
mod plane;
#[cfg(test)]
#[path = "../tests/common/property.rs"]
mod property;
pub mod prune;
pub mod random;
pub mod recipe;
pub mod session;
mod simplify;
mod thin;
pub mod tree;
#[cfg(target_arch = "wasm32")]
pub mod web;
pub mod work;

/// The README's example is compiled and run with the tests.
#[cfg(all(doctest, feature = "tools"))]
#[doc = include_str!("../README.md")]
pub struct Readme;
