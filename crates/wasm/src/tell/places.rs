//! The names on a finished map and where they lie, for a page on which they are changed there.

use std::slice;

use glam::Vec2;
use js_sys::{Array, Float32Array, Object};
use wasm_bindgen::prelude::*;

use super::FinishedMap;
use super::inspector::Inspector;
use crate::objects::object;
use riverseed::Map;
use riverseed::annotate::names::{Names, PlaceName};
use riverseed::annotate::place::{Kind, Label};
use riverseed::land::{CELL_SIZE, Region};
use riverseed::recipe::Mark;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A place on a map that has a name or could have one, and is no river. Lengths are shares of the map's width and height. */
export interface PlaceFacts {
  /** The mark by which `names` in a link knows it. */
  readonly mark: string;
  /** Its width, as a share of the map's. */
  readonly size: number;
  /** The line along which it lies, x and y in turn; one point if it has none. */
  readonly line: Float32Array;
}

/** A name in its place on a picture. Lengths are shares of the map's width and height. */
export interface LabelFacts {
  /** The mark of a river, of its meanders or of the map; empty for others, which are known by what the label says. */
  readonly mark: string;
  readonly text: string;
  /** The size of its letters, as a share of the map's width. */
  readonly em: number;
  /** The middles of its letters, x and y in turn. */
  readonly line: Float32Array;
}
"#;

/// The names of a map, with the regions of its places.
pub(super) struct Named {
    /// Marks and names in turn.
    names: Vec<String>,
    of: Names,
    regions: Vec<Region>,
}

impl Named {
    pub fn of(map: &Map) -> Self {
        let (of, regions) = Names::with_regions(map);
        let marked = of.marked(map.network()).into_iter();
        let names = marked.flat_map(|(mark, name)| [mark.to_string(), name.into()]).collect();
        Self { names, of, regions }
    }

    /// The marks of the last so many things: meanders and places come last, in their order.
    fn last_marks(&self, count: usize) -> impl Iterator<Item = &str> {
        self.names[self.names.len() - 2 * count..].iter().step_by(2).map(String::as_str)
    }
}

#[wasm_bindgen]
impl Inspector {
    /// Returns all names on the map, marks and names in turn.
    pub fn names(&self) -> Vec<String> {
        self.named.names.clone()
    }

    /// Returns the meanders with names of their own, and all places.
    #[wasm_bindgen(unchecked_return_type = "PlaceFacts[]")]
    pub fn places(&self) -> Array {
        let Names { reaches, places, .. } = &self.named.of;
        let reaches = reaches.iter().map(|reach| (0.0, &reach.course[..]));
        let all: Vec<_> = reaches.chain(places.iter().map(|place| (place.size, line_of(place)))).collect();
        let place = |(mark, (size, line)): (&str, &(f32, &[Vec2]))| {
            object(&[
                ("mark", mark.into()),
                ("size", (size / self.size.x).into()),
                ("line", shares(line.iter().copied(), self.size).into()),
            ])
        };
        self.named.last_marks(all.len()).zip(&all).map(place).collect()
    }

    /// Returns the mark of the sea, lake or land at a point, given in shares of the map's width and height.
    #[wasm_bindgen(js_name = areaAt)]
    pub fn area_at(&self, x: f32, y: f32) -> Option<String> {
        let cell = Vec2::new(x, y) * self.size / CELL_SIZE;
        let is_there = |region: &Region| cell.min_element() >= 0.0 && region.contains(cell.x as u32, cell.y as u32);
        let place = self.named.regions.iter().position(is_there)?;
        self.named.last_marks(self.named.regions.len()).nth(place).map(Into::into)
    }
}

#[wasm_bindgen]
impl FinishedMap {
    /// Returns the names that stand on the picture whose masks were made last.
    #[wasm_bindgen(unchecked_return_type = "LabelFacts[]")]
    pub fn labels(&self) -> Array {
        let labels = self.labels.borrow();
        labels.iter().filter(|label| names_something(label.kind)).map(|label| self.label(label)).collect()
    }

    fn label(&self, label: &Label) -> Object {
        let identity = label.river.and_then(|river| Some(self.map.network().rivers.get(river as usize)?.identity));
        let mark = match (label.kind, identity) {
            (Kind::Title, _) => Some(Mark::Title),
            (Kind::Reach, identity) => identity.map(Mark::Reach),
            (_, identity) => identity.map(Mark::River),
        };
        let size = self.map.domain().size;
        let middles = label.letters.iter().map(|letter| letter.around(label.em).middle);
        object(&[
            ("mark", mark.map_or_else(String::new, |mark| mark.to_string()).into()),
            ("text", label.text.as_str().into()),
            ("em", (label.em / size.x).into()),
            ("line", shares(middles, size).into()),
        ])
    }
}

/// Returns `true` if labels of a kind are names, and no marks, plates or legends.
fn names_something(kind: Kind) -> bool {
    matches!(kind, Kind::Title) || !(kind.is_block() || kind.is_mark())
}

/// Points as shares of the map's width and height, x and y in turn.
fn shares(points: impl Iterator<Item = Vec2>, size: Vec2) -> Float32Array {
    let shares: Vec<f32> = points.flat_map(|at| (at / size).to_array()).collect();
    Float32Array::from(&shares[..])
}

/// The line along which a place lies, or its only point.
fn line_of(place: &PlaceName) -> &[Vec2] {
    if place.line.is_empty() { slice::from_ref(&place.at) } else { &place.line }
}
