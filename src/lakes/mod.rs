//! Lakes along rivers: local drownings of a finished relief.
//!
//! A lake is the ground above a dam, as a moraine leaves one: all that lies upstream of a river's cell and not above a level. So
//! it has one outlet, the river at the dam, and the rivers that enter it join there. The land, the courses and the flow of water
//! stay as they are: a lake has the heights of its ground as its bed.
//!
//! ```text
//! relief ─► ways of water ─► sites of dams ─► floods, the greatest first ─► shores
//! ```
//!
//! Areas follow a power law, as those of real lakes do (Cael and Seekell 2016).

mod areas;
mod cells;
mod flood;
mod list;
mod maker;
mod shoreline;
mod shores;
mod sites;
#[cfg(test)]
mod tests;
mod upstream;

pub use list::{Lake, Lakes, Outlet, Passage};
pub(crate) use maker::LakeMaker;
