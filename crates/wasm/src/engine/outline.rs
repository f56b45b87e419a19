//! Drawn land.

use js_sys::{Array, Float32Array, Object};
use wasm_bindgen::prelude::*;

use crate::objects::{coded, object};
use riverseed::recipe::{GridPoint, Outline};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Lines of a drawn land, each as x and y in turn, in fractions of the map's width and height. */
export interface Lines {
  /** Closed: the last point is joined to the first. */
  readonly coasts: readonly Float32Array[];
  readonly ridges: readonly Float32Array[];
  /** Each from its mouth; of one point if nothing more of it is drawn. */
  readonly rivers: readonly Float32Array[];
}
"#;

/// Returns the lines of an outline. Throws an Error if the text is not an outline.
#[wasm_bindgen(js_name = outlineLines, unchecked_return_type = "Lines")]
pub fn outline_lines(text: &str) -> Result<Object, JsValue> {
    let outline = Outline::parse(text).map_err(|error| coded("bad-params", &error.to_string()))?;
    let flat = |line: &Vec<GridPoint>| -> Vec<f32> { line.iter().flat_map(|at| at.fraction().to_array()).collect() };
    let lines =
        |lines: &[Vec<GridPoint>]| lines.iter().map(|line| Float32Array::from(&flat(line)[..])).collect::<Array>();
    let lines = [("coasts", outline.coasts()), ("ridges", outline.ridges()), ("rivers", outline.rivers())]
        .map(|(kind, of_kind)| (kind, lines(of_kind).into()));
    Ok(object(&lines))
}
