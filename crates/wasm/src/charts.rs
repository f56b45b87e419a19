//! A chart: names and letters, in a separate wasm package. It knows rivers only by their `River.mapData`.

use wasm_bindgen::prelude::*;

use crate::objects::coded;
use riverseed::Map;
use riverseed::annotate::builder::ChartBuilder;
use riverseed::annotate::names::Names;
use riverseed::export::svg::ChartText;
use riverseed::export::svg::labels::chart;
use riverseed::paint::{Framing, View};
use riverseed::recipe::{Mark, OwnNames};

/// The names, labels and scenery on a map whose rivers are in another module.
#[wasm_bindgen]
pub struct Chart(Map);

#[wasm_bindgen]
impl Chart {
    /// Makes the chart of a river from its `mapData`. Throws an Error if the data is not a map.
    #[wasm_bindgen(constructor)]
    pub fn new(data: &[u32]) -> Result<Self, JsValue> {
        Map::from_wire(data).map(Self).ok_or_else(|| coded("bad-params", "This data is of no map."))
    }

    /// Returns names: those of the `rivers` greatest rivers, the user's own, and those of everything that is not a
    /// river. Each takes three texts: the mark by which `names` in a link knows it, the name, and `own` or an empty
    /// text. Own names for nothing on this map come last.
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

    /// Returns the text of `names` in a link with another name for a mark, or with its usual name again. Throws an
    /// Error if there would be too many names, or if the name is too long.
    pub fn renamed(names: &str, mark: &str, name: Option<String>) -> Result<String, JsValue> {
        let own = OwnNames::readable(names).with(mark, name.as_deref());
        own.map(|own| own.to_string()).map_err(|error| coded("bad-params", &error.to_string()))
    }

    /// Returns all names, for the files of `River`.
    pub fn names(&self) -> Vec<u32> {
        Names::of(&self.0).to_wire()
    }

    /// Returns the parts that the chart adds to an SVG file, for `River.svg`.
    pub fn svg(&self) -> Vec<String> {
        let ChartText { halo, labels } = chart(&self.0, false);
        vec![halo, labels]
    }

    /// Returns the masks that the chart lays over a picture of this size, for `River.takeChart`. `ratio` is picture
    /// pixels per CSS pixel; letters have at least 11 CSS pixels. `framing` is the argument of the picture's `frame`,
    /// or empty.
    pub fn masks(&self, width_px: u32, height_px: u32, ratio: f32, framing: &[f32]) -> Result<Vec<u8>, JsValue> {
        let domain = self.0.domain();
        let view = View::new(&domain, width_px, height_px);
        let view = view.map_err(|_| coded("bad-params", "A picture has no such size."))?;
        let view = view.framed(&domain, Framing::of(framing));
        Ok(ChartBuilder::whole(&self.0, &view, ratio).to_bytes())
    }
}
