//! Functions for files, and the digest. Only the full engine has them; a widget fetches it when it is asked for a file.

use js_sys::{Uint8Array, Uint16Array};
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

use super::rivers::{River, paint_error, session_error};
use crate::objects::coded;
use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::digest::{self, DigestError};
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::export::svg::ChartText;
use riverseed::export::{ExportError, Json, geojson, json, pack, svg};
use riverseed::recipe::link;

/// Returns the digest of a recipe, which proves that two browsers draw and write the same. The link is read strictly.
/// Throws an Error if the map has labels, a cartouche, woods or hills, which another module draws.
#[wasm_bindgen(js_name = digest)]
pub fn digest_of(link: &str) -> Result<String, JsValue> {
    let recipe = link::read(link).map_err(|error| coded("bad-params", &error.to_string()))?;
    digest::digest(&recipe).map_err(|error| match &error {
        DigestError::Session(error) => session_error(error),
        DigestError::Paint(error) => paint_error(error),
        DigestError::Export(error) => export_error(error),
        DigestError::NoChart => coded("bad-params", &error.to_string()),
        _ => coded("too-large", &error.to_string()),
    })
}

#[wasm_bindgen]
impl River {
    /// Copies the river without its picture; the copies are independent. Throws an Error if there is not enough memory.
    pub fn copy(&self) -> Result<Self, JsValue> {
        let session = self.session.try_clone().map_err(|error| session_error(&error))?;
        Ok(Self::of(session, self.notices.clone()))
    }

    /// Makes a step of the relief of finished rivers, even if the style shows none, so that files find it ready.
    /// Returns `true` if a step was left to make. Throws an Error if there is not enough memory.
    #[wasm_bindgen(js_name = raiseRelief)]
    pub fn raise_relief(&mut self) -> Result<bool, JsValue> {
        self.session.raise_relief().map_err(|error| session_error(&error))
    }

    /// The share of the picture's ground that is painted, from 0 to 1, once the rivers are finished.
    #[wasm_bindgen(getter)]
    pub fn painted(&self) -> f32 {
        self.picture.as_ref().map_or(0.0, |picture| picture.progress(&self.session))
    }

    /// Makes the background of the painted picture transparent: the sea, or in line styles the paper. Pixels are then
    /// RGBA, not premultiplied, until the picture is painted again.
    #[wasm_bindgen(js_name = cutOut)]
    pub fn cut_out(&mut self) {
        if let Some(picture) = &mut self.picture {
            picture.cut_out(&self.session);
        }
    }

    /// Draws the map as the text of an SVG file, with the result of a `Chart`'s `svg` if one is given. Throws an Error
    /// until the map is finished.
    pub fn svg(&self, chart: Vec<String>) -> Result<String, JsValue> {
        let [halo, labels] = <[String; 2]>::try_from(chart).unwrap_or_default();
        svg::with_chart(&self.map()?, &ChartText { halo, labels }).map_err(|error| export_error(&error))
    }

    /// Writes the rivers as GeoJSON, with the `names` of a `Chart`. Throws an Error until they are finished.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self, names: &[u32]) -> Result<JsValue, JsValue> {
        geojson::named(&self.map()?, named(names)).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }

    /// Returns recipe, nodes and rivers, with the `names` of a `Chart`: the data that the command line writes as JSON.
    /// Throws an Error until the map is finished.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self, names: &[u32]) -> Result<JsValue, JsValue> {
        json::compose(&self.map()?, None, Some(named(names)))
            .map_err(|error| export_error(&error))
            .and_then(|file| to_js(&file))
    }
}

impl River {
    /// The finished map, or an Error.
    fn map(&self) -> Result<Map, JsValue> {
        self.session.map().ok_or_else(|| coded("unfinished", "the rivers are still growing"))
    }
}

/// Values of each cell of the relief, for the files of a game: numbers and texts, from which JavaScript makes files.
#[wasm_bindgen]
pub struct Cells(Rasters);

#[wasm_bindgen]
impl River {
    /// Makes the rasters of the map. Throws an Error until it is finished.
    pub fn cells(&self) -> Result<Cells, JsValue> {
        Rasters::new(&self.map()?).map(Cells).map_err(|error| export_error(&error))
    }
}

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

/// Reads the names of a chart; no names if the data is anything else.
fn named(data: &[u32]) -> Names {
    Names::from_wire(data).unwrap_or_default()
}

fn export_error(error: &ExportError) -> JsValue {
    coded("too-large", &error.to_string())
}

/// Converts data to plain objects and lists.
fn to_js(value: &Json) -> Result<JsValue, JsValue> {
    value.serialize(&Serializer::json_compatible()).map_err(JsValue::from)
}
