//! The lakes of a map: the columns of the JSON form as arrays, with heights in metres as a relief has them.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riverseed::annotate::names::{Names, PlaceName};
use riverseed::lakes::Lake;

use crate::arrays::{put, put_rows};
use crate::map::Map;

/// The columns of `riverseed.Lakes`.
struct Lakes {
    identity: Vec<u32>,
    at: [Vec<f32>; 2],
    /// Metres above the sea, and metres.
    level: Vec<f32>,
    depth: Vec<f32>,
    area: Vec<f32>,
    river: Vec<u32>,
    point: Vec<u32>,
    name: Vec<Option<String>>,
    /// x and y of each point, where each ring begins among the points, and where the rings of each lake begin; the last two end with
    /// where the last one ends.
    points: Vec<f32>,
    offsets: Vec<i64>,
    rings: Vec<i64>,
}

impl Lakes {
    fn of(map: &riverseed::Map) -> Self {
        let (lakes, metres_up) = (&map.lakes().list, map.scale().metres_up);
        let named = if lakes.is_empty() { Vec::new() } else { Names::of(map).places };
        let column = |value: fn(&Lake) -> f32| lakes.iter().map(value).collect::<Vec<_>>();
        let metres = |value: fn(&Lake) -> f32| lakes.iter().map(|lake| value(lake) * metres_up).collect();
        let first_point = |river: u32| map.network().rivers[river as usize].start;
        let mut shores = (Vec::new(), vec![0], vec![0]);
        for lake in lakes {
            for ring in &lake.rings {
                shores.0.extend(ring.iter().flat_map(|at| at.to_array()));
                shores.1.push((shores.0.len() / 2) as i64);
            }
            shores.2.push(shores.1.len() as i64 - 1);
        }
        Self {
            identity: lakes.iter().map(|lake| lake.identity).collect(),
            at: [column(|lake| lake.at.x), column(|lake| lake.at.y)],
            level: metres(|lake| lake.level),
            depth: metres(|lake| lake.depth),
            area: column(|lake| lake.area),
            river: lakes.iter().map(|lake| lake.outlet.river).collect(),
            point: lakes.iter().map(|lake| lake.outlet.vertex - first_point(lake.outlet.river)).collect(),
            name: lakes.iter().map(|lake| name(lake, &named)).collect(),
            points: shores.0,
            offsets: shores.1,
            rings: shores.2,
        }
    }
}

/// Returns the name of a lake; `None` if it has none.
fn name(lake: &Lake, named: &[PlaceName]) -> Option<String> {
    named.iter().find(|place| place.at == lake.at).map(|place| place.name.clone()).filter(|name| !name.is_empty())
}

/// Makes the fields of `riverseed.Lakes`.
pub fn lakes<'py>(py: Python<'py>, map: &Map) -> PyResult<Bound<'py, PyDict>> {
    let lakes = map.read(py, |map| Ok(Lakes::of(map)))?;
    let fields = PyDict::new(py);
    let [x, y] = lakes.at;
    put(&fields, "identity", lakes.identity)?;
    put(&fields, "x", x)?;
    put(&fields, "y", y)?;
    put(&fields, "level", lakes.level)?;
    put(&fields, "depth", lakes.depth)?;
    put(&fields, "area", lakes.area)?;
    put(&fields, "river", lakes.river)?;
    put(&fields, "point", lakes.point)?;
    fields.set_item("name", lakes.name)?;
    put_rows(&fields, "points", lakes.points, 2)?;
    put(&fields, "offsets", lakes.offsets)?;
    put(&fields, "rings", lakes.rings)?;
    Ok(fields)
}
