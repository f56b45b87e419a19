//! Tools that any stage may use: geometry, exact random numbers, sorting, memory. They know no rivers.

pub(crate) mod case;
pub mod dice;
pub(crate) mod geometry;
pub(crate) mod gradient_noise;
pub(crate) mod hash;
pub(crate) mod memory;
pub(crate) mod numbers;
pub(crate) mod parallel;
pub(crate) mod parts;
pub(crate) mod queue;
pub mod random;
pub(crate) mod rings;
pub(crate) mod simplify;
pub(crate) mod skeletonize;
pub(crate) mod sort;
pub(crate) mod trigonometry;
#[doc(hidden)] // Tests count with it.
pub mod work;
