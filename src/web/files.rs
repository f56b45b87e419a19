//! What is fetched when somebody asks for it: files and the digest.

use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

use super::objects::coded;
use super::rivers::{River, paint_error, session_error};
use crate::digest::{self, DigestError};
use crate::export::{ExportError, Json, geojson, json, svg};
use crate::recipe::link;

/// The digest of a recipe: what proves that two browsers draw and write the same. The link is read strictly.
#[wasm_bindgen(js_name = digest)]
pub fn digest_of(link: &str) -> Result<String, JsValue> {
    let recipe = link::read(link).map_err(|error| coded("bad-params", &error.to_string()))?;
    digest::digest(&recipe).map_err(|error| match &error {
        DigestError::Session(error) => session_error(error),
        DigestError::Paint(error) => paint_error(error),
        DigestError::Export(error) => export_error(error),
    })
}

#[wasm_bindgen]
impl River {
    /// The map as it is, as the text of an SVG file. Throws an Error, as long as the tree grows.
    pub fn svg(&self) -> Result<String, JsValue> {
        svg::svg(&self.session).map_err(|error| export_error(&error))
    }

    /// The rivers as they are, as GeoJSON. Throws an Error, as long as the tree grows.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn geojson(&self) -> Result<JsValue, JsValue> {
        geojson::collection(&self.session).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }

    /// Recipe, nodes and rivers as they are: what the command line writes as JSON. Throws an Error, as long as the tree
    /// grows.
    #[wasm_bindgen(unchecked_return_type = "object")]
    pub fn network(&self) -> Result<JsValue, JsValue> {
        json::network(&self.session, false).map_err(|error| export_error(&error)).and_then(|file| to_js(&file))
    }
}

fn export_error(error: &ExportError) -> JsValue {
    let code = if *error == ExportError::Unfinished { "unfinished" } else { "too-large" };
    coded(code, &error.to_string())
}

/// Data as plain objects and lists.
fn to_js(value: &Json) -> Result<JsValue, JsValue> {
    value.serialize(&Serializer::json_compatible()).map_err(JsValue::from)
}
