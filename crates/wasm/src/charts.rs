//! A chart: a wasm package of its own, which knows names and type, and of rivers only what `River.mapData` says.

use wasm_bindgen::prelude::*;

use crate::objects::coded;
use riverseed::Map;
use riverseed::annotate::builder::ChartBuilder;
use riverseed::annotate::names::Names;
use riverseed::export::svg::ChartText;
use riverseed::export::svg::labels::chart;
use riverseed::paint::{Framing, View};
use riverseed::recipe::{Mark, OwnNames};

/// What stands on a map besides its rivers, which another module has.
#[wasm_bindgen]
pub struct Chart(Map);

#[wasm_bindgen]
impl Chart {
    /// The chart of what a river's `mapData` says. Throws an Error if that is no map.
    #[wasm_bindgen(constructor)]
    pub fn new(data: &[u32]) -> Result<Self, JsValue> {
        Map::from_wire(data).map(Self).ok_or_else(|| coded("bad-params", "This data is of no map."))
    }

    /// Names: of so many of the greatest rivers, of what has one's own, and of all that is no river; of each in turn its mark, by which `names`
    /// in a link knows it, the name, and `own` or nothing. Names of one's own that are of nothing on this map come last.
    pub fn greatest(&self, rivers: usize) -> Vec<String> {
        let (names, own) = (Names::of(&self.0), self.0.recipe().own_names());
        let (marked, all) = (names.marked(self.0.network()), self.0.network().rivers.len());
        let is_great = |i: usize| i < rivers || i >= all;
        let shown = marked.iter().enumerate().filter(|(i, (mark, _))| is_great(*i) || own.get(*mark).is_some());
        let unused = own.marks().filter(|mark| marked.iter().all(|(known, _)| known != mark));
        let unused = unused.map(|mark| (mark, own.get(mark).unwrap_or_default()));
        let entry = |(mark, name): (Mark, &str)| {
            let is_own = if own.get(mark).is_some() { "own" } else { "" };
            [mark.to_string(), name.into(), is_own.into()]
        };
        shown.map(|(_, named)| *named).chain(unused).flat_map(entry).collect()
    }

    /// A text of `names` in a link with another name for what a mark stands for, or its usual one again. Throws an Error if there would be
    /// too many, or the name is too long.
    pub fn renamed(names: &str, mark: &str, name: Option<String>) -> Result<String, JsValue> {
        let own = OwnNames::readable(names).with(mark, name.as_deref());
        own.map(|own| own.to_string()).map_err(|error| coded("bad-params", &error.to_string()))
    }

    /// All names, for the files of `River`.
    pub fn names(&self) -> Vec<u32> {
        Names::of(&self.0).to_wire()
    }

    /// What it adds to an SVG file, for `River.svg`.
    pub fn svg(&self) -> Vec<String> {
        let ChartText { halo, labels } = chart(&self.0, false);
        vec![halo, labels]
    }

    /// What it lays over a picture of this size, for `River.takeChart`. So many of its pixels are one CSS pixel: letters have 11 of these at
    /// least. The framing is what the picture's `frame` was given, or nothing.
    pub fn masks(&self, width_px: u32, height_px: u32, ratio: f32, framing: &[f32]) -> Result<Vec<u8>, JsValue> {
        let domain = self.0.domain();
        let view = View::new(&domain, width_px, height_px);
        let view = view.map_err(|_| coded("bad-params", "A picture has no such size."))?;
        let view = view.framed(&domain, Framing::of(framing));
        Ok(ChartBuilder::whole(&self.0, &view, ratio).to_bytes())
    }
}
