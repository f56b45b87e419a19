//! The rivers of a map: the columns of the JSON form as arrays. A list of the library becomes an array as it is,
//! without a copy.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::analyse::statistics::{self, Measures};
use riverseed::annotate::names::Names;
use riverseed::deltas::Distributary;
use riverseed::network::{NONE, Network, Place};
use riverseed::prune::Pruned;
use riverseed::tree::NO_PARENT;

use crate::arrays::{Lines, ask_for_memory, or_minus_one, point, put};
use crate::map::Map;

/// Points and offsets as their lists grow, and the columns of a river, which has several vertices.
const BYTES_A_VERTEX: usize = 48;

/// Measures the network; None for measures that it is too small for.
pub fn measures<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    let measured = map.read(py, |map| Ok(Measures::of(map)))?;
    let dict = PyDict::new(py);
    for measure in &statistics::TABLE {
        dict.set_item(measure.name, (measure.value)(&measured))?;
    }
    Ok(dict)
}

/// Makes the fields of `riverseed.Nodes`.
pub fn nodes<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    /// The columns, the trimmed tree, and the hydrology of both trees.
    const BYTES_A_NODE: usize = 128;
    let Pruned { tree, hydrology, .. } = map.read(py, |map| {
        ask_for_memory(map.tree().len(), BYTES_A_NODE)?;
        Ok(map.pruned())
    })?;
    let fields = PyDict::new(py);
    put(&fields, "x", tree.at.iter().map(|at| at.x).collect())?;
    put(&fields, "y", tree.at.iter().map(|at| at.y).collect())?;
    put(&fields, "tick", tree.ticks().collect())?;
    put(&fields, "parent", or_minus_one(tree.parent, NO_PARENT))?;
    put(&fields, "depth", hydrology.depth)?;
    put(&fields, "order", hydrology.order)?;
    put(&fields, "magnitude", hydrology.magnitude)?;
    put(&fields, "discharge", hydrology.discharge)?;
    Ok(fields)
}

/// The columns of `riverseed.Rivers`.
struct Rivers {
    parent: Vec<i32>,
    order: Vec<u8>,
    magnitude: Vec<u32>,
    discharge: Vec<u32>,
    identity: Vec<u32>,
    name: Vec<Option<String>>,
    courses: Lines,
}

impl Rivers {
    fn of(network: &Network, names: Names) -> Self {
        let rivers = &network.rivers;
        let courses = rivers.iter().map(|river| network.course(river).map(|vertex| point(vertex, 1.0)));
        let identity = names.rivers.iter().map(|river| river.identity).collect();
        let named = names.rivers.into_iter().map(|river| Some(river.name).filter(|name| !name.is_empty()));
        Self {
            parent: or_minus_one(rivers.iter().map(|river| river.parent).collect(), NONE),
            order: rivers.iter().map(|river| river.order).collect(),
            magnitude: rivers.iter().map(|river| river.magnitude).collect(),
            discharge: rivers.iter().map(|river| network.discharge(river)).collect(),
            identity,
            name: named.collect(),
            courses: Lines::of(courses),
        }
    }
}

/// Makes the fields of `riverseed.Rivers`.
pub fn rivers<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    let rivers = map.read(py, |map| {
        ask_for_memory(map.network().vertices.len(), BYTES_A_VERTEX)?;
        Ok(Rivers::of(map.network(), Names::of(map)))
    })?;
    let fields = PyDict::new(py);
    put(&fields, "parent", rivers.parent)?;
    put(&fields, "order", rivers.order)?;
    put(&fields, "magnitude", rivers.magnitude)?;
    put(&fields, "discharge", rivers.discharge)?;
    put(&fields, "identity", rivers.identity)?;
    fields.set_item("name", rivers.name)?;
    rivers.courses.put(&fields)?;
    Ok(fields)
}

/// The columns of `riverseed.Oxbows`.
struct Oxbows {
    river: Vec<u32>,
    born: Vec<u32>,
    lakes: Lines,
}

impl Oxbows {
    fn of(network: &Network) -> Self {
        let oxbows = &network.oxbows;
        let lakes = oxbows.iter().map(|oxbow| oxbow.lake().into_iter().map(|(vertex, share)| point(&vertex, share)));
        Self {
            river: oxbows.iter().map(|oxbow| oxbow.river).collect(),
            born: oxbows.iter().map(|oxbow| oxbow.born).collect(),
            lakes: Lines::of(lakes),
        }
    }
}

/// Makes the fields of `riverseed.Oxbows`.
pub fn oxbows<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    let oxbows = map.read(py, |map| Ok(Oxbows::of(map.network())))?;
    let fields = PyDict::new(py);
    put(&fields, "river", oxbows.river)?;
    put(&fields, "born", oxbows.born)?;
    oxbows.lakes.put(&fields)?;
    Ok(fields)
}

/// The columns of `riverseed.Distributaries`.
struct Distributaries {
    river: Vec<u32>,
    parent: Vec<i32>,
    share: Vec<f32>,
    sea: Vec<bool>,
    courses: Lines,
}

impl Distributaries {
    fn of(branches: &[Distributary]) -> Self {
        let place = |place: &Place| [place.at.x, place.at.y, 2.0 * place.half];
        Self {
            river: branches.iter().map(|branch| branch.river).collect(),
            parent: branches.iter().map(|branch| branch.parent.map_or(-1, |parent| parent as i32)).collect(),
            share: branches.iter().map(|branch| branch.share).collect(),
            sea: branches.iter().map(|branch| branch.reaches_sea).collect(),
            courses: Lines::of(branches.iter().map(|branch| branch.line.iter().map(place))),
        }
    }
}

/// Makes the fields of `riverseed.Distributaries`.
pub fn distributaries<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    let branches = map.read(py, |map| Ok(Distributaries::of(&map.deltas().distributaries)))?;
    let fields = PyDict::new(py);
    put(&fields, "river", branches.river)?;
    put(&fields, "parent", branches.parent)?;
    put(&fields, "share", branches.share)?;
    put(&fields, "sea", branches.sea)?;
    branches.courses.put(&fields)?;
    Ok(fields)
}
