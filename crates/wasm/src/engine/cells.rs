//! The rasters of a map, for the files of a game.

use js_sys::{Array, Object, Uint8Array, Uint16Array};
use wasm_bindgen::prelude::*;

use crate::objects::object;
use riverseed::export::pack;
use riverseed::export::rasters::{Layer, Rasters, Values};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A raster: values of all cells of a map, row by row. */
export interface Raster {
  readonly name: string;
  readonly values: Uint8Array | Uint16Array;
  /** The texts in its file, by their keywords. */
  readonly texts: Readonly<Record<string, string>>;
}
"#;

/// Values of each cell of the relief, for the files of a game, from which JavaScript makes files.
#[wasm_bindgen]
pub struct Cells(pub(super) Rasters);

#[wasm_bindgen]
impl Cells {
    /// Returns the number of cells in a row.
    #[wasm_bindgen(getter)]
    pub fn columns(&self) -> usize {
        self.0.columns
    }

    /// Returns the number of rows of cells.
    #[wasm_bindgen(getter)]
    pub fn rows(&self) -> usize {
        self.0.rows
    }

    /// Returns the text that explains the contents and scale of the files.
    pub fn readme(&self) -> String {
        pack::readme(&self.0)
    }

    /// Returns all rasters, copied.
    #[wasm_bindgen(unchecked_return_type = "Raster[]")]
    pub fn rasters(&self) -> Array {
        Layer::ALL.iter().map(|&layer| self.raster(layer)).collect()
    }

    fn raster(&self, layer: Layer) -> Object {
        let values: JsValue = match self.0.values(layer) {
            Values::Bytes(bytes) => Uint8Array::from(&bytes[..]).into(),
            Values::Words(words) => Uint16Array::from(&words[..]).into(),
        };
        let texts: Vec<_> = self.0.texts(layer).into_iter().map(|(keyword, text)| (keyword, text.into())).collect();
        object(&[("name", layer.name().into()), ("values", values), ("texts", object(&texts).into())])
    }
}
