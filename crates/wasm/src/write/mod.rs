//! The package `write`: writes a finished map as files, and its digest. It knows the map only by the `mapData` of a `River`.

mod cells;

use glam::Vec2;
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

use self::cells::Cells;
use crate::objects::coded;
use crate::wire::map_of;
use riverseed::Map;
use riverseed::digest::{self, DigestError};
use riverseed::export::rasters::Rasters;
use riverseed::export::{ExportError, Json, geojson, json, svg};

/// The contents of the files of a finished map whose rivers were made in another module.
#[wasm_bindgen]
pub struct MapFiles(Map);

#[wasm_bindgen]
impl MapFiles {
    /// Reads the map from the `mapData` of a river. Throws an Error if the data is not a map.
    #[wasm_bindgen(constructor)]
    pub fn new(data: &[u32]) -> Result<Self, JsValue> {
        map_of(data).map(Self)
    }

    /// Draws the map as the text of an SVG file. Throws an Error if there is not enough memory, like the others.
    pub fn svg(&self) -> Result<String, JsValue> {
        svg::svg(&self.0).map_err(|error| too_large(&error))
    }

    /// Writes the rivers as GeoJSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self) -> Result<JsValue, JsValue> {
        geojson::collection(&self.0).map_err(|error| too_large(&error)).and_then(|file| to_js(&file))
    }

    /// Returns recipe, nodes and rivers: the data that the command line writes as JSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self) -> Result<JsValue, JsValue> {
        json::network(&self.0, None).map_err(|error| too_large(&error)).and_then(|file| to_js(&file))
    }

    /// Makes the rasters of the map, with `longerSide` cells on the longer side, or else on the map's own grid; if
    /// `isSquare`, with sea around the map. Throws an Error if rasters of this map cannot have that size.
    pub fn cells(
        &self,
        #[wasm_bindgen(js_name = longerSide)] longer_side: Option<u32>,
        #[wasm_bindgen(js_name = isSquare)] is_square: Option<bool>,
    ) -> Result<Cells, JsValue> {
        let rasters = longer_side.map_or_else(|| Rasters::new(&self.0), |side| Rasters::with_size(&self.0, side));
        let shaped = if is_square == Some(true) { rasters.and_then(Rasters::into_squares) } else { rasters };
        shaped.map(Cells).map_err(|error| match error {
            ExportError::RasterSize { .. } => coded("bad-params", &error.to_string()),
            _ => too_large(&error),
        })
    }

    /// Returns the digest of the map, which proves that two browsers draw and write the same. It takes the map's picture,
    /// `digestWidth()` pixels square, as RGBA bytes, and the attractors of its `River` (`scattered`).
    pub fn digest(&self, picture: &[u8], attractors: &[f32]) -> Result<String, JsValue> {
        let attractors: Vec<Vec2> = attractors.chunks_exact(2).map(Vec2::from_slice).collect();
        let code =
            |error: &DigestError| if matches!(error, DigestError::Export(_)) { "too-large" } else { "bad-params" };
        digest::digest_of(&self.0, picture, &attractors).map_err(|error| coded(code(&error), &error.to_string()))
    }
}

/// The width and height, in pixels, of the picture that goes into a digest.
#[wasm_bindgen(js_name = digestWidth)]
pub fn digest_width() -> u32 {
    digest::WIDTH
}

fn too_large(error: &ExportError) -> JsValue {
    coded("too-large", &error.to_string())
}

/// Converts data to plain objects and lists.
fn to_js(value: &Json) -> Result<JsValue, JsValue> {
    value.serialize(&Serializer::json_compatible()).map_err(JsValue::from)
}
