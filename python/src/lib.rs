//! What Python asks of Riverseed: recipes in, bytes and arrays out. `riverseed/__init__.py` is its face there.
//!
//! Everything long runs without the interpreter's lock, in steps between which signals are heard ([`steps`]).

mod failure;
mod form;
mod map;
mod network;
mod order;
mod relief;
mod steps;

use pyo3::prelude::*;

/// The part of the package that is compiled.
#[pymodule(gil_used = false)]
mod _native {
    #[pymodule_export]
    use crate::form::render;
    #[pymodule_export]
    use crate::network::network;
    #[pymodule_export]
    use crate::order::parameters;
    #[pymodule_export]
    use crate::relief::relief;
}
