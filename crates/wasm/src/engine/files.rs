//! The files of a finished map, and its digest.

use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

use super::cells::Cells;
use crate::make::river::River;
use crate::objects::coded;
use riverseed::digest::{self, DigestError};
use riverseed::export::rasters::Rasters;
use riverseed::export::{ExportError, Json, geojson, json, svg};

#[wasm_bindgen]
impl River {
    /// Draws the finished map as the text of an SVG file. Throws an Error if there is not enough memory, like the others.
    pub fn svg(&self) -> Result<String, JsValue> {
        svg::svg(&self.map()?).map_err(|error| too_large(&error))
    }

    /// Writes the finished rivers as GeoJSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self) -> Result<JsValue, JsValue> {
        geojson::collection(&self.map()?).map_err(|error| too_large(&error)).and_then(|file| to_js(&file))
    }

    /// Returns recipe, nodes and rivers: the data that the command line writes as JSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self) -> Result<JsValue, JsValue> {
        json::network(&self.map()?, None).map_err(|error| too_large(&error)).and_then(|file| to_js(&file))
    }

    /// Makes the rasters of the finished map, with `longerSide` cells on the longer side, or else on the map's own grid;
    /// if `isSquare`, with sea around the map. Throws an Error if rasters of this map cannot have that size.
    pub fn cells(
        &self,
        #[wasm_bindgen(js_name = longerSide)] longer_side: Option<u32>,
        #[wasm_bindgen(js_name = isSquare)] is_square: Option<bool>,
    ) -> Result<Cells, JsValue> {
        let map = self.map()?;
        let rasters = longer_side.map_or_else(|| Rasters::new(&map), |side| Rasters::with_size(&map, side));
        let shaped = if is_square == Some(true) { rasters.and_then(Rasters::into_squares) } else { rasters };
        shaped.map(Cells).map_err(|error| match error {
            ExportError::RasterSize { .. } => coded("bad-params", &error.to_string()),
            _ => too_large(&error),
        })
    }

    /// Returns the digest of the finished map, which proves that two browsers draw and write the same. Its picture must
    /// be `digestWidth()` pixels square and painted.
    pub fn digest(&self) -> Result<String, JsValue> {
        let (map, attractors) = (self.map()?, self.session.growth().scattered());
        let picture = self.picture.as_ref().map_or(&[][..], |picture| picture.pixmap().data());
        let code =
            |error: &DigestError| if matches!(error, DigestError::Export(_)) { "too-large" } else { "bad-params" };
        digest::digest_of(&map, picture, &attractors).map_err(|error| coded(code(&error), &error.to_string()))
    }
}

/// Returns the width and height, in pixels, of the picture that goes into a digest.
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
