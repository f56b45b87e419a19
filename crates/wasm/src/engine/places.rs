//! The names on a finished map and where they lie, for a page on which they are changed there.

use std::slice;

use glam::Vec2;
use js_sys::{Array, Float32Array, Object};
use wasm_bindgen::prelude::*;

use super::inspector::Inspector;
use crate::make::river::River;
use crate::objects::object;
use riverseed::annotate::names::{Names, PlaceName};
use riverseed::annotate::place::{Kind, Label};
use riverseed::land::{CELL_SIZE, Region};
use riverseed::recipe::Mark;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Something on a map with its name. */
export type Marked = readonly [mark: string, name: string];

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

#[wasm_bindgen]
impl Inspector {
    /// Returns all names on the map, with the marks of what they name.
    #[wasm_bindgen(unchecked_return_type = "Marked[]")]
    pub fn names(&self) -> Array {
        let marked = |(mark, name): &(String, String)| [mark, name].into_iter().map(JsValue::from).collect::<Array>();
        self.named.names.iter().map(marked).collect()
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
impl River {
    /// Returns the names that stand on the picture of the finished map, as far as it has been painted.
    #[wasm_bindgen(unchecked_return_type = "LabelFacts[]")]
    pub fn labels(&self) -> Array {
        let Some((picture, map)) = self.picture.as_ref().zip(self.session.map()) else { return Array::new() };
        let shown = picture.labels().iter().filter(|label| names_something(label.kind));
        let marks = Names::identities(&map);
        shown.map(|label| label_facts(label, &marks, map.domain().size)).collect()
    }
}

fn label_facts(label: &Label, identities: &[u32], size: Vec2) -> Object {
    let identity = label.river.and_then(|river| identities.get(river as usize).copied());
    let mark = match (label.kind, identity) {
        (Kind::Title, _) => Some(Mark::Title),
        (Kind::Reach, identity) => identity.map(Mark::Reach),
        (_, identity) => identity.map(Mark::River),
    };
    let middles = label.letters.iter().map(|letter| letter.around(label.em).middle);
    object(&[
        ("mark", mark.map_or_else(String::new, |mark| mark.to_string()).into()),
        ("text", label.text.as_str().into()),
        ("em", (label.em / size.x).into()),
        ("line", shares(middles, size).into()),
    ])
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

/// Returns the line along which a place lies, or its only point.
fn line_of(place: &PlaceName) -> &[Vec2] {
    if place.line.is_empty() { slice::from_ref(&place.at) } else { &place.line }
}
