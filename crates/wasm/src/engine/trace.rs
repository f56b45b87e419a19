//! Outlines of land from pictures and from drawn lines.

use glam::Vec2;
use js_sys::{Float32Array, Object};
use wasm_bindgen::prelude::*;

use crate::objects::{coded, object};
use riverseed::land::trace;
use riverseed::recipe::Outline;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What tracing made of a picture. */
export interface Traced {
  readonly outline: string;
  /** How many coasts the picture shows; the outline may have room for fewer. */
  readonly coasts: number;
  readonly ridges: number;
  /** Width over height of the map that the outline is for. */
  readonly aspect: number;
  /** Whether the picture is longer than that: what is at its long sides goes on beyond them. */
  readonly isLonger: boolean;
  /** Whether the picture looks like a heightmap, which is not what is traced. */
  readonly looksLikeHeights: boolean;
}
"#;

/// Traces a picture: white land, black water, a third colour for ridges. Throws an Error if it shows no coast.
#[wasm_bindgen(js_name = traceImage, unchecked_return_type = "Traced")]
pub fn trace_image(rgba: &[u8], width_px: u32, height_px: u32) -> Result<Object, JsValue> {
    let traced = trace::trace(width_px, height_px, rgba).map_err(|error| coded("no-land", &error.to_string()))?;
    Ok(object(&[
        ("outline", traced.outline.to_string().into()),
        ("coasts", traced.coasts.into()),
        ("ridges", traced.ridges.into()),
        ("aspect", traced.aspect.into()),
        ("isLonger", traced.is_longer.into()),
        ("looksLikeHeights", traced.looks_like_heights.into()),
    ]))
}

/// Returns the longest side of a picture that can be traced, in pixels.
#[wasm_bindgen(js_name = longestTracedSide)]
pub fn longest_traced_side() -> u32 {
    trace::LONGEST_SIDE
}

/// Makes an outline from lines with any number of points, simplified until it fits a link. Throws an Error if they
/// enclose no land.
#[wasm_bindgen(js_name = outlineOf)]
pub fn outline_of(
    coasts: Vec<Float32Array>,
    ridges: Vec<Float32Array>,
    rivers: Vec<Float32Array>,
) -> Result<String, JsValue> {
    let [coasts, ridges, rivers] = [coasts, ridges, rivers].map(|lines| lines.iter().map(points).collect());
    let outline = Outline::from_polylines(coasts, ridges, rivers);
    outline.map(|outline| outline.to_string()).map_err(|error| coded("no-land", &error.to_string()))
}

/// Returns the points of a line given as x and y in turn; an odd number at the end is ignored.
fn points(line: &Float32Array) -> Vec<Vec2> {
    line.to_vec().chunks_exact(2).map(Vec2::from_slice).collect()
}
