//! The rasters of a map, for the files of a game.

use js_sys::{Uint8Array, Uint16Array};
use wasm_bindgen::prelude::*;

use riverseed::export::pack;
use riverseed::export::rasters::{Layer, Rasters, Values};

/// Values of each cell of the relief, for the files of a game: numbers and texts, from which JavaScript makes files.
#[wasm_bindgen]
pub struct Cells(pub(super) Rasters);

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
