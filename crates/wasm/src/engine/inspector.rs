//! Queries about the rivers of a finished map, for a page.

use std::sync::Arc;

use glam::Vec2;
use js_sys::{Object, Uint32Array};
use wasm_bindgen::prelude::*;

use super::named::Named;
use crate::make::river::River;
use crate::objects::{object, set};
use riverseed::analyse::query::{Inspector as Rivers, RiverFacts, Spot};
use riverseed::export::svg::overlay;
use riverseed::lakes::Lakes;
use riverseed::land::Land;
use riverseed::network::NONE;
use riverseed::recipe::{CourseShape, LandKind};
use riverseed::scale::MapScale;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A river that was pointed at. Marks are those by which names know rivers; places are in shares of the map. */
export interface RiverFacts {
  readonly mark: number;
  /** Strahler's order at its end, and where it is pointed at. */
  readonly order: number;
  readonly orderHere: number;
  /** In kilometres, as the scale bar has them. */
  readonly length: number;
  /** The share of all land that it drains, and how much land that is, in square kilometres. */
  readonly share: number;
  readonly area: number;
  /** The rivers that its water comes to, one after the other; none if it reaches the sea itself. */
  readonly into: Uint32Array;
  /** What the last of them runs into. */
  readonly endsIn: "sea" | "lake";
  /** The number of mouths by which the river itself reaches the sea, if it does. */
  readonly mouths: number;
  /** The place on it. */
  readonly x: number;
  readonly y: number;
  /** `true` if that land is so small that its shape shows its cells. */
  readonly isBasinSmall: boolean;
  /** From there to the sea, and the land that it drains: paths of SVG, in units. */
  readonly way: string;
  readonly basin: string;
  /** The lake that is pointed at, out of which the river runs. */
  readonly lake?: LakeFacts;
}
/** A lake along a river. */
export interface LakeFacts {
  /** The mark by which names know it; empty if it has none. */
  readonly mark: string;
  /** In square kilometres. */
  readonly area: number;
  /** The greatest depth, and the height of its water over the sea, in metres. */
  readonly depth: number;
  readonly level: number;
}
"#;

/// Basins of fewer square units are small: of so few cells, one sees the cells.
const LEAST_BASIN: f64 = 200.0;

/// The rivers of a finished map, ready for queries.
#[wasm_bindgen]
pub struct Inspector {
    rivers: Rivers,
    scale: MapScale,
    /// Width and height of the map, in units.
    pub(super) size: Vec2,
    courses: CourseShape,
    lakes: Arc<Lakes>,
    /// The kind of water that rivers run into.
    ends_in: &'static str,
    /// The things with names besides rivers.
    pub(super) named: Named,
    /// The last river that was queried, with its basin: a pointer stays on one river for a while.
    last: (u32, String),
}

#[wasm_bindgen]
impl River {
    /// Prepares the finished rivers for queries. Returns nothing before they are finished, or if there is not enough memory.
    pub fn inspector(&self) -> Option<Inspector> {
        let map = self.session.map()?;
        let rivers = Rivers::new(&map)?;
        let (size, recipe) = (map.domain().size, map.recipe());
        let ends_in = if Land::kind_of(recipe) == LandKind::Basin { "lake" } else { "sea" };
        let named = Named::of(&map);
        let scale = map.scale();
        let (courses, lakes, last) = (recipe.get(), map.lakes().clone(), (NONE, String::new()));
        Some(Inspector { rivers, scale, size, courses, lakes, ends_in, named, last })
    }
}

#[wasm_bindgen]
impl Inspector {
    /// Returns the streams of an order, each from its beginning to its end, as SVG paths in units.
    pub fn streams(&self, order: u8) -> Vec<String> {
        let streams = self.rivers.stretches(|vertex| self.rivers.orders()[vertex] == order);
        let paths = streams.chunks(1).map(|stream| overlay::lines(stream, self.courses));
        paths.filter(|path| !path.is_empty()).collect()
    }

    /// Returns the stretches that stay in place while others meander, as an SVG path in units.
    pub fn held(&self) -> String {
        let vertices = &self.rivers.network().vertices;
        overlay::lines(&self.rivers.stretches(|vertex| vertices[vertex].mobility == 0.0), self.courses)
    }

    /// Returns short lines across the great rivers, towards the outside of each bend, longer where it is sharper, as an
    /// SVG path in units.
    pub fn curvature(&self) -> String {
        overlay::lines(&self.rivers.curvature(), CourseShape::Grown)
    }

    /// Returns the marks of the rivers that reach the sea.
    pub fn mouths(&self) -> Vec<u32> {
        self.rivers.network().mouths().iter().filter_map(|&river| self.mark_of(river)).collect()
    }

    /// Returns the river at a point, given in shares of the map's width and height, or the nearest within `reach`
    /// units; nothing if there is none. In a lake it is the river that runs out of that.
    #[wasm_bindgen(unchecked_return_type = "RiverFacts | undefined")]
    pub fn at(&mut self, x: f32, y: f32, reach: f32) -> Option<Object> {
        let point = Vec2::new(x, y) * self.size;
        if let Some(lake) = self.lakes.at(point) {
            return self.of_lake(lake, point);
        }
        let spot = self.rivers.nearest(point, reach)?;
        Some(self.facts(&spot))
    }

    /// Returns the river with a mark, at its source; nothing if there is none.
    #[wasm_bindgen(unchecked_return_type = "RiverFacts | undefined")]
    pub fn of(&mut self, mark: u32) -> Option<Object> {
        let river = self.named.of.rivers.iter().position(|river| river.identity == mark)?;
        let spot = self.rivers.source(river as u32)?;
        Some(self.facts(&spot))
    }

    /// Returns the mark of a river by its number in the network.
    fn mark_of(&self, river: u32) -> Option<u32> {
        Some(self.named.of.rivers.get(river as usize)?.identity)
    }

    /// Describes a lake at a point of it, and the river that runs out of it.
    fn of_lake(&mut self, lake: usize, point: Vec2) -> Option<Object> {
        /// The outlet is a vertex of a river.
        const HERE: f32 = 0.1;
        let lakes = self.lakes.clone();
        let lake = &lakes.list[lake];
        let spot = self.rivers.nearest(self.rivers.network().vertices[lake.outlet.vertex as usize].at, HERE)?;
        let named = self.named.of.places.iter().find(|place| place.at == lake.at);
        let lake = object(&[
            ("mark", named.map_or_else(String::new, |place| place.mark().to_string()).into()),
            ("area", self.scale.square_kilometres(lake.area.into()).into()),
            ("depth", (lake.depth * self.scale.metres_up).into()),
            ("level", (lake.level * self.scale.metres_up).into()),
        ]);
        let facts = self.facts(&spot);
        let Vec2 { x, y } = point / self.size;
        set(&facts, &[("lake", lake.into()), ("x", x.into()), ("y", y.into())]);
        Some(facts)
    }

    fn facts(&mut self, spot: &Spot) -> Object {
        let RiverFacts { order, order_here, length, share, area, into, mouths } = self.rivers.facts(spot);
        let into: Vec<u32> = into.into_iter().filter_map(|river| self.mark_of(river)).collect();
        let way: Vec<Vec2> = self.rivers.way_to_the_sea(spot).iter().map(|place| place.at).collect();
        let Vec2 { x, y } = spot.place.at / self.size;
        object(&[
            ("mark", self.mark_of(spot.river).into()),
            ("order", order.into()),
            ("orderHere", order_here.into()),
            ("length", self.scale.kilometres(length).into()),
            ("share", share.into()),
            ("area", self.scale.square_kilometres(area).into()),
            ("into", Uint32Array::from(&into[..]).into()),
            ("endsIn", self.ends_in.into()),
            ("mouths", (mouths as u32).into()),
            ("x", x.into()),
            ("y", y.into()),
            ("way", overlay::lines(&[way], self.courses).into()),
            ("isBasinSmall", (area < LEAST_BASIN).into()),
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
