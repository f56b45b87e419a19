//! Lists of the library as arrays of NumPy: of the same memory, and read-only, as a map does not change.

use numpy::{Element, IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::network::Vertex;

/// Hands a list over as an array of the same memory.
pub fn array<T: Element>(py: Python<'_>, list: Vec<T>) -> PyResult<Bound<'_, PyArray1<T>>> {
    let array = list.into_pyarray(py);
    array.getattr("flags")?.setattr("writeable", false)?;
    Ok(array)
}

/// Puts a column into the fields of a class.
pub fn put<T: Element>(fields: &Bound<'_, PyDict>, name: &str, column: Vec<T>) -> PyResult<()> {
    fields.set_item(name, array(fields.py(), column)?)
}

/// Puts a table into the fields of a class, with rows of this many numbers.
pub fn put_rows<T: Element>(fields: &Bound<'_, PyDict>, name: &str, numbers: Vec<T>, columns: usize) -> PyResult<()> {
    let rows = numbers.len() / columns;
    fields.set_item(name, array(fields.py(), numbers)?.reshape([rows, columns])?)
}

/// The points of several lines, one line after the other.
pub struct Lines {
    /// x, y and width of each point.
    points: Vec<f32>,
    /// Where each line begins among the points, and last where the last one ends.
    offsets: Vec<i64>,
}

impl Lines {
    pub fn of(lines: impl Iterator<Item = impl Iterator<Item = [f32; 3]>>) -> Self {
        let mut this = Self { points: Vec::new(), offsets: vec![0] };
        for line in lines {
            this.points.extend(line.flatten());
            this.offsets.push((this.points.len() / 3) as i64);
        }
        this
    }

    pub fn put(self, fields: &Bound<'_, PyDict>) -> PyResult<()> {
        put_rows(fields, "points", self.points, 3)?;
        put(fields, "offsets", self.offsets)
    }
}

/// Returns x, y and a share of the width.
pub fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}

/// Returns numbers with -1 for the one of them that means none. Lists are made into such in place.
pub fn or_minus_one(numbers: Vec<u32>, none: u32) -> Vec<i32> {
    numbers.into_iter().map(|number| if number == none { -1 } else { number as i32 }).collect()
}
