//! Rivers as lines in space: at each point a place, a width and a depth, in an engine's own axes and units.
//!
//! Depth goes with width as at bankfull stage in natural rivers. Moody and Troutman (2002, Earth Surface Processes and
//! Landforms 27, 1251-1266) have width = 7.2 Q^0.50 and depth = 0.27 Q^0.30 in metres for a discharge Q in m³/s, so
//! depth = 0.27 (width / 7.2)^0.6.

use std::io::{Result, Write};

use riverseed::Map;
use riverseed::analyse::statistics::Drained;
use riverseed::annotate::names::Names;
use riverseed::glam::{DVec2, DVec3};
use riverseed::network::{NONE, Network, River, Vertex, hydrology};
use riverseed::recipe::link;
use serde_json::{Map as Members, Value, json};

use super::terrain::Terrain;
use crate::form::Engine;
use crate::memory::ask;

/// The axes, the unit and the origin of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Metres: x east, y north, z up, from the map's centre.
    Plain,
    /// The axes of an engine, from a corner of its landscape.
    Of(Engine),
}

impl Axes {
    /// Says what the numbers of a point are.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Plain => ("metre", "x east, y north, z up", "the centre of the map, at the sea's surface"),
            Self::Of(Engine::Unreal) => (
                "centimetre",
                "x east, y south, z up",
                "the north-western corner of the landscape, at the sea's surface",
            ),
            Self::Of(Engine::Unity) => {
                ("metre", "x east, y up, z north", "the south-western corner of the Terrain, at the sea's surface")
            }
            Self::Of(Engine::Godot) => {
                ("metre", "x east, y up, z south", "the north-western corner of the landscape, at the sea's surface")
            }
        }
    }

    /// Returns the number of its units in a metre.
    fn units_a_metre(self) -> f64 {
        if self == Self::Of(Engine::Unreal) { 100.0 } else { 1.0 }
    }

    /// Converts a place in metres east and south of a landscape's first corner and over the sea.
    fn place(self, at: DVec2, height: f64, terrain: &Terrain) -> DVec3 {
        let place = match self {
            Self::Plain => {
                let from_centre = at - terrain.metres(terrain.map() * 0.5);
                DVec3::new(from_centre.x, -from_centre.y, height)
            }
            Self::Of(Engine::Unreal) => DVec3::new(at.x, at.y, height),
            Self::Of(Engine::Unity) => {
                let depth = (terrain.rows - 1) as f64 * terrain.metres_a_pixel;
                DVec3::new(at.x, height, depth - at.y)
            }
            Self::Of(Engine::Godot) => DVec3::new(at.x, height, at.y),
        };
        place * self.units_a_metre()
    }
}

/// Returns the depth of a river of this width, in metres, where water reaches to the top of its banks.
pub fn depth(width: f64) -> f64 {
    0.27 * libm::pow(width.max(0.0) / 7.2, 0.6)
}

/// Writes the rivers of a map on a landscape, as JSON.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(mut out: impl Write, map: &Map, terrain: &Terrain, axes: Axes) -> Result<()> {
    const BYTES_A_VERTEX: usize = 400;
    ask(map.network().vertices.len() * BYTES_A_VERTEX)?;
    let (unit, words, origin) = axes.words();
    let mut members = Members::new();
    // First, so that it can be found without reading on.
    members.insert("riverseed".into(), link::write_for_file(map.recipe()).into());
    members.insert("rasters".into(), json!([terrain.columns, terrain.rows]));
    members.insert("unit".into(), unit.into());
    members.insert("axes".into(), words.into());
    members.insert("origin".into(), origin.into());
    members.insert("point".into(), json!(["x", "y", "z", "width", "depth"]));
    members.insert("rivers".into(), rivers(map, terrain, axes));
    serde_json::to_writer(&mut out, &Value::Object(members))?;
    writeln!(out)
}

fn rivers(map: &Map, terrain: &Terrain, axes: Axes) -> Value {
    let (network, names) = (map.network(), Names::of(map));
    let (heights, drained) = (heights(network, terrain), Drained::of(map));
    let river = |(number, river): (usize, &River)| {
        let name = names.rivers.get(number).map(|river| river.name.clone()).filter(|name| !name.is_empty());
        let parent = (river.parent != NONE).then_some(river.parent);
        let junction = (river.junction != NONE).then_some(river.junction as usize);
        let vertices = river.vertex_range().chain(junction);
        let points: Vec<Value> =
            vertices.map(|i| point(&network.vertices[i], heights[i], &drained, terrain, axes)).collect();
        json!({ "number": number, "name": name, "parent": parent, "order": river.order, "points": points })
    };
    network.rivers.iter().enumerate().map(river).collect()
}

/// Computes the height of each vertex in metres: that of the ground, but never lower than downstream; 0 at mouths.
fn heights(network: &Network, terrain: &Terrain) -> Vec<f32> {
    let ground = |vertex: usize| terrain.height_between(terrain.corners(network.vertices[vertex].at)) as f32;
    hydrology::upward(network, |vertex, below| ground(vertex).max(below))
}

fn point(vertex: &Vertex, height: f32, drained: &Drained, terrain: &Terrain, axes: Axes) -> Value {
    /// The last digit that is written is a hundredth of a metre or of a centimetre.
    const PARTS: f64 = 100.0;
    let rounded = |number: f64| (number * PARTS).round() / PARTS + 0.0;
    let place = axes.place(terrain.metres(vertex.at), f64::from(height), terrain);
    let width = drained.river_width(vertex.discharge);
    let sizes = [width, depth(width)].map(|metres| metres * axes.units_a_metre());
    [place.x, place.y, place.z, sizes[0], sizes[1]].map(rounded).to_vec().into()
}

#[cfg(test)]
mod tests {
    use super::depth;

    #[test]
    fn depth_is_that_of_a_river_of_the_same_discharge() {
        for discharge in [1.0f64, 40.0, 900.0, 20_000.0] {
            let (width, expected) = (7.2 * discharge.sqrt(), 0.27 * libm::pow(discharge, 0.3));
            assert!((depth(width) - expected).abs() < 1e-9);
        }
        assert_eq!(depth(0.0), 0.0);
    }
}
