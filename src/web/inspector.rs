//! What a page asks a finished map about its rivers.

use glam::Vec2;
use js_sys::{Object, Uint32Array};
use wasm_bindgen::prelude::*;

use super::objects::object;
use super::rivers::River;
use crate::export::svg::overlay;
use crate::inspect::{Inspector as Rivers, RiverFacts, Spot, tips};
use crate::land::{Land, SmoothedDistance};
use crate::network::NONE;
use crate::recipe::{CourseShape, LandKind};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A river that was pointed at. Marks are those by which names know rivers; areas are in square units, places in shares of the map. */
export interface RiverFacts {
  readonly mark: number;
  /** Strahler's order at its end, and where it is pointed at. */
  readonly order: number;
  readonly orderHere: number;
  /** In units. */
  readonly length: number;
  /** The share of all land that it drains, and how much land that is. */
  readonly share: number;
  readonly area: number;
  /** The rivers that its water comes to, one after the other; none if it reaches the sea itself. */
  readonly into: Uint32Array;
  /** What the last of them runs into. */
  readonly endsIn: "sea" | "lake";
  /** The place on it. */
  readonly x: number;
  readonly y: number;
  /** From there to the sea, and the land that it drains: paths of SVG, in units. */
  readonly way: string;
  readonly basin: string;
}
"#;

/// The rivers of a finished map, to be asked about.
#[wasm_bindgen]
pub struct Inspector {
    rivers: Rivers,
    /// Width and height of the map, in units.
    size: Vec2,
    courses: CourseShape,
    /// What rivers run into.
    ends_in: &'static str,
    /// The last river that was asked about, and its basin: a pointer stays on one for a while.
    last: (u32, String),
}

#[wasm_bindgen]
impl River {
    /// Where its attractors lie, or the parcels of drainage: a path of SVG, in units.
    pub fn attractors(&self) -> String {
        overlay::dots(&self.session.growth().scattered())
    }

    /// Those of them that still pull, or have found no way to the sea yet, likewise.
    #[wasm_bindgen(js_name = attractorsLeft)]
    pub fn attractors_left(&self) -> String {
        overlay::dots(&self.session.growth().left())
    }

    /// Where its rivers begin, as far as they have grown, likewise.
    pub fn tips(&self) -> String {
        overlay::dots(&tips(&self.session))
    }

    /// How far an attractor pulls, and how near a river comes that uses it up, in units.
    pub fn reaches(&self) -> Vec<f32> {
        let settings = self.session.growth().settings();
        vec![settings.reach, settings.kill]
    }

    /// What no river may cross: around all land, beyond which there is water, and along its ridges, likewise; nothing where all is land.
    pub fn masks(&self) -> Vec<String> {
        self.session.land().map_or_else(Vec::new, |land| {
            let land_rings = SmoothedDistance::of(land.coast_distance()).rings_above(0.0);
            vec![overlay::area(&land_rings), overlay::lines(land.ridges(), CourseShape::Grown)]
        })
    }

    /// Width and height of its map, in units.
    pub fn size(&self) -> Vec<f32> {
        self.session.domain().size.to_array().into()
    }

    /// Its rivers to be asked about, as they are now; nothing until they are finished, and where there is not enough memory.
    pub fn inspector(&self) -> Option<Inspector> {
        let rivers = Rivers::new(&self.session)?;
        let (size, recipe) = (self.session.domain().size, self.session.recipe());
        let ends_in = if Land::kind_of(recipe) == LandKind::Basin { "lake" } else { "sea" };
        Some(Inspector { rivers, size, courses: recipe.get(), ends_in, last: (NONE, String::new()) })
    }
}

#[wasm_bindgen]
impl Inspector {
    /// The streams of an order, each from where it begins to where it ends, as a path of SVG.
    #[wasm_bindgen(js_name = ofOrder)]
    pub fn of_order(&self, order: u8) -> String {
        overlay::lines(&self.rivers.stretches(|vertex| self.rivers.orders()[vertex] == order), self.courses)
    }

    /// The stretches of rivers that stay where they are when others meander, likewise.
    pub fn held(&self) -> String {
        let vertices = &self.rivers.network().vertices;
        overlay::lines(&self.rivers.stretches(|vertex| vertices[vertex].mobility == 0.0), self.courses)
    }

    /// Lines across the great rivers, to the outside of each bend, the longer the sharper that is, likewise.
    pub fn curvature(&self) -> String {
        overlay::lines(&self.rivers.curvature(), CourseShape::Grown)
    }

    /// The marks of the rivers that reach the sea.
    pub fn mouths(&self) -> Vec<u32> {
        let network = self.rivers.network();
        network.mouths().iter().map(|&river| network.rivers[river as usize].identity).collect()
    }

    /// The river at a point, in shares of the map's width and height, or the nearest within reach, in units; nothing if there is none.
    #[wasm_bindgen(unchecked_return_type = "RiverFacts | undefined")]
    pub fn at(&mut self, x: f32, y: f32, reach: f32) -> Option<Object> {
        let spot = self.rivers.nearest(Vec2::new(x, y) * self.size, reach)?;
        Some(self.facts(&spot))
    }

    /// The river of a mark, from its source; nothing if there is none.
    #[wasm_bindgen(unchecked_return_type = "RiverFacts | undefined")]
    pub fn of(&mut self, mark: u32) -> Option<Object> {
        let spot = self.rivers.source(mark)?;
        Some(self.facts(&spot))
    }

    fn facts(&mut self, spot: &Spot) -> Object {
        let RiverFacts { identity, order, order_here, length, share, area, into } = self.rivers.facts(spot);
        let way: Vec<Vec2> = self.rivers.way_to_the_sea(spot).iter().map(|place| place.at).collect();
        let Vec2 { x, y } = spot.place.at / self.size;
        object(&[
            ("mark", identity.into()),
            ("order", order.into()),
            ("orderHere", order_here.into()),
            ("length", length.into()),
            ("share", share.into()),
            ("area", area.into()),
            ("into", Uint32Array::from(&into[..]).into()),
            ("endsIn", self.ends_in.into()),
            ("x", x.into()),
            ("y", y.into()),
            ("way", overlay::lines(&[way], self.courses).into()),
            ("basin", self.basin(spot.river).into()),
        ])
    }

    fn basin(&mut self, river: u32) -> &str {
        if self.last.0 != river {
            self.last = (river, overlay::area(&self.rivers.basin(river)));
        }
        &self.last.1
    }
}
