//! The parts that only the whole engine has, the package `engine`. While a map grows: drafts of a slider that moves,
//! moments back and forth, layers, parts of the map, drawn and traced land. Of a finished map: names and where they
//! stand, measures, what lies at a place, files.

mod cells;
mod drafts;
mod files;
mod growing;
mod inspector;
mod measures;
mod named;
mod names;
mod outline;
mod picture;
mod places;
mod seed;
mod timeline;
mod trace;

use wasm_bindgen::JsValue;

use crate::make::river::River;
use crate::objects::coded;
use riverseed::Map;

impl River {
    /// Returns the finished map. Fails before it is finished.
    fn map(&self) -> Result<Map, JsValue> {
        self.session.map().ok_or_else(|| coded("bad-params", "This map is not finished."))
    }
}
