//! Maps from another module.

use wasm_bindgen::JsValue;

use crate::objects::coded;
use riverseed::Map;

/// Reads a map from the `mapData` of a river. Throws an Error if the data is not a map.
pub(super) fn map_of(data: &[u32]) -> Result<Map, JsValue> {
    Map::from_wire(data).ok_or_else(|| coded("bad-params", "This data is of no map."))
}
