//! `riverseed.network`: the columns of the JSON form as arrays. What the library has as a list becomes an array as it is, without a copy.

use numpy::{Element, IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::grow::Ending;
use riverseed::measure::{self, Measures};
use riverseed::name::Names;
use riverseed::network::{NONE, Network, Vertex};
use riverseed::prune::Pruned;
use riverseed::recipe::link;
use riverseed::Map;
use riverseed::tree::NO_PARENT;

use crate::failure::Failure;
use crate::map;
use crate::order::{self, Parameters};

/// Makes the arrays of a map, by the names of the fields of `riverseed.Network`.
#[pyfunction]
pub fn network<'py>(py: Python<'py>, link: &str, parameters: Parameters) -> PyResult<Bound<'py, PyDict>> {
    let mut session = map::grow(py, order::recipe(link, parameters)?)?;
    let map = session.finish().map_err(Failure::from)?;
    let parts = py.detach(|| Parts::of(&map));
    let summary = session.summary();
    let size = map.domain().size;
    let fields = PyDict::new(py);
    fields.set_item("link", link::write(session.recipe()))?;
    fields.set_item("size", (size.x, size.y))?;
    fields.set_item("ticks", summary.ticks)?;
    fields.set_item("attractors", summary.attractors)?;
    fields.set_item("unreached", summary.unreached)?;
    fields.set_item("complete", summary.ending == Some(Ending::Complete))?;
    fields.set_item("title", parts.names.title.as_str())?;
    fields.set_item("measures", measures(py, &parts.measures)?)?;
    fields.set_item("nodes", nodes(py, parts.pruned, parts.ticks)?)?;
    fields.set_item("rivers", rivers(py, parts.network, &parts.names)?)?;
    fields.set_item("oxbows", oxbows(py, parts.network)?)?;
    Ok(fields)
}

/// What takes long to make of a finished session.
struct Parts<'a> {
    network: &'a Network,
    pruned: Pruned,
    ticks: Vec<u32>,
    names: Names,
    measures: Measures,
}

impl<'a> Parts<'a> {
    fn of(map: &'a Map) -> Self {
        let pruned = map.pruned();
        Self {
            network: map.network(),
            ticks: pruned.tree.ticks().collect(),
            pruned,
            names: Names::of(map),
            measures: Measures::of(map),
        }
    }
}

fn measures<'py>(py: Python<'py>, measured: &Measures) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for measure in &measure::TABLE {
        dict.set_item(measure.name, (measure.value)(measured))?;
    }
    Ok(dict)
}

fn nodes<'py>(py: Python<'py>, pruned: Pruned, ticks: Vec<u32>) -> PyResult<Bound<'py, PyDict>> {
    let Pruned { tree, hydrology, .. } = pruned;
    let dict = PyDict::new(py);
    put(&dict, "x", tree.at.iter().map(|at| at.x).collect())?;
    put(&dict, "y", tree.at.iter().map(|at| at.y).collect())?;
    put(&dict, "parent", or_minus_one(tree.parent, NO_PARENT))?;
    put(&dict, "tick", ticks)?;
    put(&dict, "depth", hydrology.depth)?;
    put(&dict, "order", hydrology.order)?;
    put(&dict, "magnitude", hydrology.magnitude)?;
    put(&dict, "discharge", hydrology.discharge)?;
    Ok(dict)
}

fn rivers<'py>(py: Python<'py>, network: &Network, names: &Names) -> PyResult<Bound<'py, PyDict>> {
    let rivers = &network.rivers;
    let dict = PyDict::new(py);
    put(&dict, "parent", or_minus_one(rivers.iter().map(|river| river.parent).collect(), NONE))?;
    put(&dict, "order", rivers.iter().map(|river| river.order).collect())?;
    put(&dict, "magnitude", rivers.iter().map(|river| river.magnitude).collect())?;
    put(&dict, "discharge", rivers.iter().map(|river| network.discharge(river)).collect())?;
    put(&dict, "identity", rivers.iter().map(|river| river.identity).collect())?;
    let named: Vec<_> = names.rivers.iter().map(|river| Some(&*river.name).filter(|name| !name.is_empty())).collect();
    dict.set_item("name", named)?;
    let courses = rivers.iter().map(|river| network.course(river).map(|vertex| point(vertex, 1.0)));
    put_lines(&dict, Lines::of(courses))?;
    Ok(dict)
}

fn oxbows<'py>(py: Python<'py>, network: &Network) -> PyResult<Bound<'py, PyDict>> {
    let oxbows = &network.oxbows;
    let dict = PyDict::new(py);
    put(&dict, "river", oxbows.iter().map(|oxbow| oxbow.river).collect())?;
    put(&dict, "born", oxbows.iter().map(|oxbow| oxbow.born).collect())?;
    let lakes = oxbows.iter().map(|oxbow| oxbow.lake().into_iter().map(|(vertex, share)| point(&vertex, share)));
    put_lines(&dict, Lines::of(lakes))?;
    Ok(dict)
}

/// The points of several lines, one line after the other.
struct Lines {
    /// x, y and width of each point.
    points: Vec<f32>,
    /// Where each line begins among the points, and last where the last one ends.
    offsets: Vec<i64>,
}

impl Lines {
    fn of(lines: impl Iterator<Item = impl Iterator<Item = [f32; 3]>>) -> Self {
        let mut this = Self { points: Vec::new(), offsets: vec![0] };
        for line in lines {
            this.points.extend(line.flatten());
            this.offsets.push((this.points.len() / 3) as i64);
        }
        this
    }
}

/// x, y and a share of the width.
fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}

fn put_lines(dict: &Bound<'_, PyDict>, Lines { points, offsets }: Lines) -> PyResult<()> {
    let rows = points.len() / 3;
    dict.set_item("points", array(dict.py(), points).reshape([rows, 3])?)?;
    put(dict, "offsets", offsets)
}

fn put<T: Element>(dict: &Bound<'_, PyDict>, name: &str, column: Vec<T>) -> PyResult<()> {
    dict.set_item(name, array(dict.py(), column))
}

/// A list as an array of the same memory.
pub fn array<T: Element>(py: Python<'_>, list: Vec<T>) -> Bound<'_, PyArray1<T>> {
    list.into_pyarray(py)
}

/// Numbers of which one means none, with -1 for that. Lists are made into such in place.
fn or_minus_one(numbers: Vec<u32>, none: u32) -> Vec<i32> {
    numbers.into_iter().map(|number| if number == none { -1 } else { number as i32 }).collect()
}
