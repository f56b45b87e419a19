//! The contents of files.

use js_sys::{Uint8Array, Uint16Array};
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

use super::{FinishedMap, export_error};
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::export::{Json, geojson, json, pack, svg};

#[wasm_bindgen]
impl FinishedMap {
    /// Draws the map as the text of an SVG file. Throws an Error if there is not enough memory, like the others.
    pub fn svg(&self) -> Result<String, JsValue> {
        svg::svg(&self.map).map_err(|error| export_error(&error))
    }

    /// Writes the rivers as GeoJSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self) -> Result<JsValue, JsValue> {
        geojson::collection(&self.map).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }

    /// Returns recipe, nodes and rivers: the data that the command line writes as JSON.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self) -> Result<JsValue, JsValue> {
        json::network(&self.map, None).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }

    /// Makes the rasters of the map.
    pub fn cells(&self) -> Result<Cells, JsValue> {
        Rasters::new(&self.map).map(Cells).map_err(|error| export_error(&error))
    }
}

/// Values of each cell of the relief, for the files of a game: numbers and texts, from which JavaScript makes files.
#[wasm_bindgen]
pub struct Cells(Rasters);

#[wasm_bindgen]
impl Cells {
    /// Number of cells in a row.
    #[wasm_bindgen(getter)]
    pub fn columns(&self) -> usize {
        self.0.columns
    }

    /// Number of rows of cells.
    #[wasm_bindgen(getter)]
    pub fn rows(&self) -> usize {
        self.0.rows
    }

    /// The text that explains the contents and scale of the files.
    pub fn readme(&self) -> String {
        pack::readme(&self.0)
    }

    /// The names of the rasters, in the order of their numbers.
    pub fn names(&self) -> Vec<String> {
        Layer::ALL.iter().map(|layer| layer.name().into()).collect()
    }

    /// The values of a raster, row by row; `undefined` if there is none of that number.
    #[wasm_bindgen(unchecked_return_type = "Uint8Array | Uint16Array | undefined")]
    pub fn values(&self, number: usize) -> JsValue {
        match Layer::ALL.get(number).map(|&layer| self.0.values(layer)) {
            Some(Values::Bytes(bytes)) => Uint8Array::from(&bytes[..]).into(),
            Some(Values::Words(words)) => Uint16Array::from(&words[..]).into(),
            None => JsValue::UNDEFINED,
        }
    }

    /// The keywords and texts in a raster's file, in turn.
    pub fn texts(&self, number: usize) -> Vec<String> {
        let texts = Layer::ALL.get(number).map(|&layer| self.0.texts(layer)).unwrap_or_default();
        texts.into_iter().flat_map(|(keyword, text)| [keyword.into(), text]).collect()
    }
}

/// Converts data to plain objects and lists.
fn to_js(value: &Json) -> Result<JsValue, JsValue> {
    value.serialize(&Serializer::json_compatible()).map_err(JsValue::from)
}
