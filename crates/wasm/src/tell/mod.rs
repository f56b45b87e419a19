//! The package `tell`: tells about a finished map. It gives names, labels and scenery, measures, and what lies at a place.
//! It knows the map only by the `mapData` of a `River`.

mod inspector;
mod measures;
mod places;

use std::cell::RefCell;

use glam::Vec2;
use wasm_bindgen::prelude::*;

use crate::objects::coded;
use crate::wire::map_of;
use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::annotate::place::{Label, Places};
use riverseed::paint::{Framing, View};
use riverseed::picture::builder::AnnotationBuilder;
use riverseed::recipe::{Mark, OwnNames};

/// A finished map whose rivers were made in another module.
#[wasm_bindgen]
pub struct FinishedMap {
    map: Map,
    /// The labels' places, as far as pictures have asked for them.
    places: RefCell<Places>,
    /// Those of the last masks.
    labels: RefCell<Vec<Label>>,
}

#[wasm_bindgen]
impl FinishedMap {
    /// Reads the map from the `mapData` of a river. Throws an Error if the data is not a map.
    #[wasm_bindgen(constructor)]
    pub fn new(data: &[u32]) -> Result<Self, JsValue> {
        Ok(Self { map: map_of(data)?, places: RefCell::default(), labels: RefCell::default() })
    }

    /// Returns names: the map's, those of the `rivers` greatest rivers, the user's own, and those of everything that is
    /// not a river. Each takes three texts: the mark by which `names` in a link knows it, the name, and `own` or an empty
    /// text. Own names for nothing on this map come last.
    pub fn greatest(&self, rivers: usize) -> Vec<String> {
        let (names, own) = (Names::of(&self.map), self.map.recipe().own_names());
        let marked = names.marked(self.map.network());
        let mut left = rivers;
        let mut is_shown = |(mark, _): &&(Mark, &str)| {
            let is_great = !matches!(mark, Mark::River(_)) || left > 0;
            left -= usize::from(is_great && matches!(mark, Mark::River(_)));
            is_great || own.get(*mark).is_some()
        };
        let shown: Vec<_> = marked.iter().filter(|named| is_shown(named)).copied().collect();
        let unused = own.marks().filter(|mark| marked.iter().all(|(known, _)| known != mark));
        let unused = unused.map(|mark| (mark, own.get(mark).unwrap_or_default()));
        let entry = |(mark, name): (Mark, &str)| {
            let is_own = if own.get(mark).is_some() { "own" } else { "" };
            [mark.to_string(), name.into(), is_own.into()]
        };
        shown.into_iter().chain(unused).flat_map(entry).collect()
    }

    /// Returns the text of `names` in a link with another name for a mark, or with its usual name again. Throws an
    /// Error if there would be too many names, or if the name is too long.
    pub fn renamed(names: &str, mark: &str, name: Option<String>) -> Result<String, JsValue> {
        let own = OwnNames::readable(names).with(mark, name.as_deref());
        own.map(|own| own.to_string()).map_err(|error| coded("bad-params", &error.to_string()))
    }

    /// Returns the masks of labels and scenery that are laid over a picture of this size, for `River.takeAnnotation`.
    /// `ratio` is picture pixels per CSS pixel; letters have at least 11 CSS pixels. `framing` is the argument of the
    /// picture's `frame`, or empty.
    pub fn masks(&self, width_px: u32, height_px: u32, ratio: f32, framing: &[f32]) -> Result<Vec<u8>, JsValue> {
        let view = self.view(width_px, height_px, framing)?;
        let mut places = self.places.borrow_mut();
        let (masks, labels) = AnnotationBuilder::whole_in(&mut places, &self.map, &view, ratio);
        self.labels.replace(labels);
        Ok(masks.to_bytes())
    }

    /// Returns the same with the map's title as a heading: as large as it fits into `within`, a box's left, top, right and
    /// bottom in pixels of the picture.
    #[wasm_bindgen(js_name = headedMasks)]
    pub fn headed_masks(
        &self,
        width_px: u32,
        height_px: u32,
        ratio: f32,
        framing: &[f32],
        within: &[f32],
    ) -> Result<Vec<u8>, JsValue> {
        let view = self.view(width_px, height_px, framing)?;
        let &[left, top, right, bottom] = within else {
            return Err(coded("bad-params", "A box has four numbers."));
        };
        let within = [Vec2::new(left, top), Vec2::new(right, bottom)];
        Ok(AnnotationBuilder::headed(&self.map, &view, ratio, within).to_bytes())
    }

    /// Returns the left, top, right and bottom of all land, in widths of the map from its north-western corner.
    #[wasm_bindgen(js_name = landBounds)]
    pub fn land_bounds(&self) -> Vec<f32> {
        let size = self.map.domain().size;
        let all = [Vec2::ZERO, size];
        let [least, most] = self.map.land().and_then(|land| land.bounds()).unwrap_or(all);
        [least, most.min(size)].iter().flat_map(|corner| (*corner / size.x).to_array()).collect()
    }
}

impl FinishedMap {
    /// The view of a picture of this size.
    fn view(&self, width_px: u32, height_px: u32, framing: &[f32]) -> Result<View, JsValue> {
        let domain = self.map.domain();
        let view = View::new(&domain, width_px, height_px);
        let view = view.map_err(|_| coded("bad-params", "A picture has no such size."))?;
        Ok(view.framed(&domain, Framing::of(framing)))
    }
}
