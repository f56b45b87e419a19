//! Land: where rivers may run.
//!
//! A [`Relief`] says of every point of the domain how far inland it lies; a [`Land`] is the field of cells made of it,
//! each Available (land), Unavailable (water) or Illegal (a ridge that no river may cross), as in seed document 2.
//! Growth asks the field, painting asks the relief: so the coast is smooth at any size, and rivers end at it.

mod field;
mod kinds;
mod outline;
mod relief;

pub use field::{Cell, Land, Shore};
pub use kinds::LandKind;
pub use relief::Relief;
