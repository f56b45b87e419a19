//! Measures of rivers and the promises of their map, for a page that compares them with nature.

use js_sys::{Array, Object};
use wasm_bindgen::prelude::*;

use crate::make::river::River;
use crate::objects::{object, set};
use riverseed::analyse::proof::{self, Finding};
use riverseed::analyse::statistics::{Measure, Measures, Nature, TABLE};
use riverseed::scale::MapScale;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A measure of a network of rivers. */
export interface Measure {
  readonly name: string;
  readonly help: string;
  readonly unit: string;
  /** How many decimal places say something. */
  readonly places: number;
  /** None of a network that is too small for it. */
  readonly value?: number;
  /** Of the pattern, which is named after the nearest: how far each is. */
  readonly distances?: Readonly<Record<string, number>>;
  /** None where rivers of the world cannot be compared with those of a map. */
  readonly nature?: { readonly median?: number; readonly least: number; readonly most: number; readonly source: string };
}

/** What was found of a promise that every map keeps. */
export interface MapPromise {
  /** Such as "Nothing crosses". */
  readonly says: string;
  /** What was looked at, in the plural, and how many of them. */
  readonly counted: string;
  readonly count: number;
  /** In how many places it is broken: 0 if it is kept. */
  readonly broken: number;
}
"#;

#[wasm_bindgen]
impl River {
    /// Returns the measures of the finished rivers, and as the last one the pattern that they are named after.
    #[wasm_bindgen(unchecked_return_type = "Measure[]")]
    pub fn measures(&self) -> Result<Array, JsValue> {
        let map = self.map()?;
        let (measures, scale) = (Measures::of(&map), map.scale());
        Ok(TABLE.iter().map(|measure| row(measure, &measures, &scale)).chain([pattern(&measures)]).collect())
    }

    /// Checks the promises of the finished rivers.
    #[wasm_bindgen(unchecked_return_type = "MapPromise[]")]
    pub fn promises(&self) -> Result<Array, JsValue> {
        let findings = proof::findings(&self.map()?).map_err(|error| JsError::new(&error.to_string()))?;
        Ok(findings.iter().map(promise).collect())
    }
}

/// Makes the row of a promise.
fn promise(finding: &Finding) -> Object {
    object(&[
        ("says", finding.promise.says.into()),
        ("counted", finding.promise.counted.into()),
        ("count", finding.looked_at.into()),
        ("broken", finding.breaches.len().into()),
    ])
}

/// Makes the row of the pattern of drainage: the nearest one, and how far the map is from each.
fn pattern(measures: &Measures) -> Object {
    let row = object(&[("name", "pattern".into()), ("help", "".into()), ("unit", "".into()), ("places", 1.into())]);
    if let Some(pattern) = measures.pattern() {
        let nearest_first = pattern.nearest_first();
        let distances = object(&nearest_first.map(|(name, distance)| (name, distance.into())));
        set(&row, &[("value", nearest_first[0].1.into()), ("distances", distances.into())]);
    }
    row
}

/// Makes the row of a measure.
fn row(measure: &Measure, measures: &Measures, scale: &MapScale) -> Object {
    let (value, unit) = measure.told(measures, scale);
    let row = object(&[
        ("name", measure.name.into()),
        ("help", measure.help.into()),
        ("unit", unit.into()),
        ("places", measure.places.into()),
        ("value", value.into()),
    ]);
    if let Some(Nature { median, least, most, source, .. }) = measure.nature {
        let range =
            [("median", median.into()), ("least", least.into()), ("most", most.into()), ("source", source.into())];
        set(&row, &[("nature", object(&range).into())]);
    }
    row
}
