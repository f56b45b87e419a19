//! Points and lines over a map that may still be growing. Each is a list of coordinates, x and y in turn, in units.

use glam::Vec2;
use js_sys::{Float32Array, Object};
use wasm_bindgen::prelude::*;

use crate::make::river::River;
use crate::objects::object;
use riverseed::analyse::query::{cut, former_ways, tips};
use riverseed::land::SmoothedDistance;
use riverseed::scale::MapScale;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Lengths of a map, in units. */
export interface Lengths {
  readonly width: number;
  readonly height: number;
  /** The distance over which an attractor pulls a river, and that at which it is used up by one. */
  readonly reach: number;
  readonly kill: number;
  /** A kilometre of the scale bar. */
  readonly kilometre: number;
}
"#;

#[wasm_bindgen]
impl River {
    /// Returns the attractors that the tree grows to, or the parcels of drainage.
    pub fn scattered(&self) -> Vec<f32> {
        flat(&self.session.growth().scattered())
    }

    /// Returns the attractors that still pull, or the parcels that have found no way to the sea yet.
    pub fn left(&self) -> Vec<f32> {
        flat(&self.session.growth().left())
    }

    /// Returns the sources of the rivers, as far as they have grown.
    pub fn tips(&self) -> Vec<f32> {
        flat(&tips(&self.session))
    }

    /// Rings around all land, beyond which there is water; none if all is land. No river may cross them.
    pub fn coasts(&self) -> Vec<Float32Array> {
        let land = self.session.land();
        lines(&land.map_or_else(Vec::new, |land| SmoothedDistance::of(land.coast_distance()).rings_above(0.0)))
    }

    /// Returns the ridges, which no river may cross.
    pub fn ridges(&self) -> Vec<Float32Array> {
        self.session.land().map_or_else(Vec::new, |land| lines(land.ridges()))
    }

    /// Returns the branches that trimming has cut from the grown tree, once there are rivers.
    pub fn cut(&self) -> Vec<Float32Array> {
        lines(&cut(&self.session))
    }

    /// Returns, in drainage, the former ways of the greatest streams that were captured, each from the place of its capture.
    #[wasm_bindgen(js_name = formerWays)]
    pub fn former_ways(&self) -> Vec<Float32Array> {
        lines(&former_ways(&self.session))
    }

    /// Returns lengths of the map, and of how it grows.
    #[wasm_bindgen(unchecked_return_type = "Lengths")]
    pub fn lengths(&self) -> Object {
        let growth = self.session.growth().settings();
        let Vec2 { x, y } = self.session.domain().size;
        let kilometre = MapScale::of(self.session.recipe()).units(1.0);
        let lengths =
            [("width", x), ("height", y), ("reach", growth.reach), ("kill", growth.kill), ("kilometre", kilometre)];
        object(&lengths.map(|(name, length)| (name, length.into())))
    }
}

fn lines(lines: &[Vec<Vec2>]) -> Vec<Float32Array> {
    lines.iter().map(|line| Float32Array::from(&flat(line)[..])).collect()
}

fn flat(points: &[Vec2]) -> Vec<f32> {
    points.iter().flat_map(|at| at.to_array()).collect()
}
