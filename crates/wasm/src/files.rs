//! What only the full engine has, and a widget fetches when it is asked for a file: files and the digest.

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

/// The digest of a recipe: what proves that two browsers draw and write the same. The link is read strictly. Throws an Error
/// if the map has labels, a cartouche, woods or hills: another module draws these.
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
    /// Another river that has come as far, without a picture: what becomes of one does not touch the other. Throws an
    /// Error if there is not enough memory.
    pub fn copy(&self) -> Result<Self, JsValue> {
        let session = self.session.try_clone().map_err(|error| session_error(&error))?;
        Ok(Self::of(session, self.notices.clone()))
    }

    /// Makes a step of the relief of finished rivers, in a style that shows none too, so that files find it made. Returns whether one
    /// was left to make. Throws an Error if there is not enough memory.
    #[wasm_bindgen(js_name = raiseRelief)]
    pub fn raise_relief(&mut self) -> Result<bool, JsValue> {
        self.session.raise_relief().map_err(|error| session_error(&error))
    }

    /// How much of the ground of its picture is painted, from 0 to 1, once its rivers are finished.
    #[wasm_bindgen(getter)]
    pub fn painted(&self) -> f32 {
        self.picture.as_ref().map_or(0.0, |picture| picture.progress(&self.session))
    }

    /// Takes the ground out of its picture, once that is painted: the sea, or in styles of lines the paper. Pixels are then RGBA with an opacity,
    /// by which colours are not multiplied, until the picture is painted again.
    #[wasm_bindgen(js_name = cutOut)]
    pub fn cut_out(&mut self) {
        if let Some(picture) = &mut self.picture {
            picture.cut_out(&self.session);
        }
    }

    /// Draws its map as the text of an SVG file, with what the `svg` of a `Chart` says, if anything. Throws an Error until it is finished.
    pub fn svg(&self, chart: Vec<String>) -> Result<String, JsValue> {
        let [halo, labels] = <[String; 2]>::try_from(chart).unwrap_or_default();
        svg::with_chart(&self.map()?, &ChartText { halo, labels }).map_err(|error| export_error(&error))
    }

    /// Writes its rivers as GeoJSON, with the `names` of a `Chart`. Throws an Error until it is finished.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self, names: &[u32]) -> Result<JsValue, JsValue> {
        geojson::named(&self.map()?, named(names)).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }

    /// Returns recipe, nodes and rivers, with the `names` of a `Chart`: what the command line writes as JSON. Throws an Error until it is
    /// finished.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self, names: &[u32]) -> Result<JsValue, JsValue> {
        json::compose(&self.map()?, None, Some(named(names)))
            .map_err(|error| export_error(&error))
            .and_then(|file| to_js(&file))
    }
}

impl River {
    /// Its finished map.
    fn map(&self) -> Result<Map, JsValue> {
        self.session.map().ok_or_else(|| coded("unfinished", "the rivers are still growing"))
    }
}

/// What is known of each cell of the relief, for the files of a game: numbers and texts, which JavaScript makes files of.
#[wasm_bindgen]
pub struct Cells(Rasters);

#[wasm_bindgen]
impl River {
    /// Makes the rasters of its map. Throws an Error until it is finished.
    pub fn cells(&self) -> Result<Cells, JsValue> {
        Rasters::new(&self.map()?).map(Cells).map_err(|error| export_error(&error))
    }
}

#[wasm_bindgen]
impl Cells {
    /// How many cells lie side by side.
    #[wasm_bindgen(getter)]
    pub fn columns(&self) -> usize {
        self.0.columns
    }

    /// How many rows of cells there are.
    #[wasm_bindgen(getter)]
    pub fn rows(&self) -> usize {
        self.0.rows
    }

    /// What the files hold, and by which scale.
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

    /// Keywords and texts that a raster's file carries, in turn.
    pub fn texts(&self, number: usize) -> Vec<String> {
        let texts = Layer::ALL.get(number).map(|&layer| self.0.texts(layer)).unwrap_or_default();
        texts.into_iter().flat_map(|(keyword, text)| [keyword.into(), text]).collect()
    }
}

/// The names of a chart; none if it has none.
fn named(data: &[u32]) -> Names {
    Names::from_wire(data).unwrap_or_default()
}

fn export_error(error: &ExportError) -> JsValue {
    coded("too-large", &error.to_string())
}

/// Data as plain objects and lists.
fn to_js(value: &Json) -> Result<JsValue, JsValue> {
    value.serialize(&Serializer::json_compatible()).map_err(JsValue::from)
}
