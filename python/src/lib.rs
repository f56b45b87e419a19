//! The compiled part of the Python package: takes a recipe and returns a map, its files and its arrays.
//! `riverseed/__init__.py` is the public face.
//!
//! Long work runs without the interpreter's lock, in steps between which signals are handled ([`steps`]).

mod arrays;
mod failure;
mod file;
mod lakes;
mod map;
mod members;
mod names;
mod network;
mod order;
mod relief;
mod steps;
mod values;

use pyo3::prelude::*;

/// The part of the package that is compiled.
#[pymodule(gil_used = false)]
mod _native {
    use pyo3::prelude::*;
    use riverseed::paint::LONGEST_SIDE;
    use riverseed::relief::Grid;

    #[pymodule_export]
    use crate::file::form_of_file;
    #[pymodule_export]
    use crate::map::Map;
    #[pymodule_export]
    use crate::members::grow;
    #[pymodule_export]
    use crate::order::read;
    #[pymodule_export]
    use crate::values::parameters;

    /// Facts of the library that its callers need.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("FORMS", crate::file::forms())?;
        module.add("LAYERS", crate::file::layers())?;
        module.add("LONGEST_SIDE", LONGEST_SIDE)?;
        module.add("LONGEST_RASTER", Grid::MOST)
    }
}
