//! Functions for the page's controls, which a widget does without: the parameter table, presets, random seeds, drawn
//! lines.

use glam::Vec2;
use js_sys::{Array, Float32Array, Object};
use wasm_bindgen::prelude::*;

use super::rivers::{River, pair, read_options};
use crate::objects::{coded, object, set};
use riverseed::base::dice;
use riverseed::paint::{Framing, Painted};
use riverseed::recipe::preset::{COUNTRIES, PRESETS, Preset};
use riverseed::recipe::reading;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Decimal, GridPoint, Key, Kind, LONGEST_OUTLINE, Outline, Parameter};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A row of the parameter table. */
export interface Parameter {
  readonly key: string;
  readonly label: string;
  readonly help: string;
  /** The heading it stands under. */
  readonly group: string;
  /** The earliest stage that runs again when it changes. */
  readonly stage: Stage;
  readonly kind: "text" | "integer" | "number" | "choice" | "sides" | "outline";
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly unit?: string;
  readonly scale?: "linear" | "log";
  readonly maxLength?: number;
  readonly choices?: readonly { readonly value: string; readonly label: string }[];
  /** As link text. */
  readonly default: string;
}
/** A named set of values; what it leaves out keeps its default. */
export interface Preset {
  readonly name: string;
  readonly label: string;
  readonly help: string;
  readonly values: readonly (readonly [key: string, value: string])[];
}
/** Lines of a drawn land, each as x and y in turn, in fractions of the map's width and height. */
export interface Lines {
  /** Closed: the last point is joined to the first. */
  readonly coasts: readonly Float32Array[];
  readonly ridges: readonly Float32Array[];
  /** Each from its mouth; of one point if nothing more of it is drawn. */
  readonly rivers: readonly Float32Array[];
}
/** What came of painting a draft: a part, of which nothing is seen yet; all of it; or nothing, since there can be none. */
export type Drafted = "part" | "whole" | "impossible";
"#;

#[wasm_bindgen]
impl River {
    /// Shows another part of the map or its surroundings. The first three numbers are in widths of the map: the
    /// distance of the picture's western edge east of the map's, that of its northern edge south of the map's, and the
    /// picture's width. Four more numbers may follow: the depths that other things cover along its western, northern,
    /// eastern and southern edges. For any other count of numbers, and for values that are too large, too small or too
    /// far away, the whole map is shown, cut to cover the picture.
    pub fn frame(&mut self, framing: &[f32]) {
        if let Some(picture) = &mut self.picture {
            picture.frame(&self.session, Framing::of(framing));
        }
    }

    /// Reads the link of another recipe like `readLink`, for `paintDraft` to show. It stays until the next `draft`, or
    /// until the river changes to a recipe.
    pub fn draft(
        &mut self,
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) {
        self.drafted = Some(reading::read(text, read_options(options)));
    }

    /// Paints a part of a preview of the recipe given to `draft`, without changing to it. A preview is possible if the
    /// recipe differs only in width, only in mountains and plains, or only in coasts, once these rivers are finished.
    /// It has no labels, and lasts until the next `paint`.
    #[wasm_bindgen(js_name = paintDraft, unchecked_return_type = "Drafted")]
    pub fn paint_draft(&mut self) -> String {
        let wanted = self.picture.as_mut().zip(self.drafted.as_ref());
        let painted = wanted.and_then(|(picture, reading)| picture.paint_draft(&self.session, &reading.recipe));
        self.drafted_as(painted)
    }

    /// Paints the rivers as they are now, finished or not, on the ground in the picture, even if its relief belongs to
    /// other rivers. The result has no labels, and lasts until the next `paint`.
    #[wasm_bindgen(js_name = paintUnfinished, unchecked_return_type = "Drafted")]
    pub fn paint_unfinished(&mut self) -> String {
        let painted =
            self.picture.as_mut().and_then(|picture| picture.paint_draft(&self.session, self.session.recipe()));
        self.drafted_as(painted)
    }

    /// Changes to the recipe given to `draft`, like `change`, and returns the earliest stage that has to run again.
    #[wasm_bindgen(js_name = adoptDraft, unchecked_return_type = "Stage | \"none\"")]
    pub fn adopt_draft(&mut self) -> Result<String, JsValue> {
        self.drafted.take().map_or_else(|| Ok("none".into()), |reading| self.change_to(reading))
    }
}

impl River {
    /// Notes the pixels that a draft changed, and returns its outcome.
    fn drafted_as(&mut self, painted: Option<Painted>) -> String {
        if let Some(Painted::Whole(changed)) = painted {
            self.dirty = changed.or(self.dirty);
        }
        painted.map_or("impossible", |painted| if painted == Painted::Part { "part" } else { "whole" }).into()
    }
}

/// The parameter table.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn parameters() -> Array {
    TABLE.iter().map(row).collect()
}

/// The presets of links.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn presets() -> Array {
    list(PRESETS)
}

/// Countries to start with. Links cannot name them.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn countries() -> Array {
    list(COUNTRIES)
}

fn list(presets: &[Preset]) -> Array {
    let values = |preset: &Preset| -> Array {
        let canonical = |(key, text): &(Key, &str)| pair(key.parameter().name, &canonical(key.parameter(), text));
        preset.values.iter().map(canonical).collect()
    };
    let view = |preset: &Preset| {
        object(&[
            ("name", preset.name.into()),
            ("label", preset.label.into()),
            ("help", preset.help.into()),
            ("values", values(preset).into()),
        ])
    };
    presets.iter().map(view).collect()
}

/// Makes a new seed: a random word that can be pronounced.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<String, JsValue> {
    getrandom::u64().map(dice::word).map_err(|error| coded("no-randomness", &error.to_string()))
}

/// Makes an outline from lines with any number of points, simplified until it fits a link. Throws an Error if they
/// enclose no land.
#[wasm_bindgen(js_name = outlineOf)]
pub fn outline_of(
    coasts: Vec<Float32Array>,
    ridges: Vec<Float32Array>,
    rivers: Vec<Float32Array>,
) -> Result<String, JsValue> {
    let [coasts, ridges, rivers] = [coasts, ridges, rivers].map(|lines| lines.iter().map(points).collect());
    let outline = Outline::from_polylines(coasts, ridges, rivers);
    outline.map(|outline| outline.to_string()).map_err(|error| coded("no-land", &error.to_string()))
}

/// Returns the lines of an outline. Throws an Error if the text is not an outline.
#[wasm_bindgen(js_name = outlineLines, unchecked_return_type = "Lines")]
pub fn outline_lines(text: &str) -> Result<Object, JsValue> {
    let outline = Outline::parse(text).map_err(|error| coded("bad-params", &error.to_string()))?;
    let flat = |line: &Vec<GridPoint>| -> Vec<f32> { line.iter().flat_map(|at| at.fraction().to_array()).collect() };
    let lines =
        |lines: &[Vec<GridPoint>]| lines.iter().map(|line| Float32Array::from(&flat(line)[..])).collect::<Array>();
    let lines = [("coasts", outline.coasts()), ("ridges", outline.ridges()), ("rivers", outline.rivers())]
        .map(|(kind, of_kind)| (kind, lines(of_kind).into()));
    Ok(object(&lines))
}

/// The points of a line given as x and y in turn; an odd number at the end is ignored.
fn points(line: &Float32Array) -> Vec<Vec2> {
    line.to_vec().chunks_exact(2).map(Vec2::from_slice).collect()
}

/// A value in the spelling that links use.
fn canonical(parameter: &Parameter, text: &str) -> String {
    parameter.parse(text).map_or_else(|_| text.into(), |value| parameter.text_of(&value))
}

/// A row of the parameter table.
fn row(parameter: &Parameter) -> Object {
    let row = object(&[
        ("key", parameter.name.into()),
        ("label", parameter.label.into()),
        ("help", parameter.help.into()),
        ("kind", kind_name(parameter.kind).into()),
        ("group", parameter.group.into()),
        ("stage", parameter.stage.name().into()),
        ("unit", parameter.unit.into()),
        ("scale", if parameter.logarithmic { "log" } else { "linear" }.into()),
        ("default", parameter.text_of(&parameter.default_value()).into()),
    ]);
    describe(parameter.kind, &row);
    row
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Text { .. } => "text",
        Kind::Integer { .. } => "integer",
        Kind::Number { .. } => "number",
        Kind::Outline => "outline",
        Kind::Choice { .. } => "choice",
        Kind::Sides { .. } => "sides",
    }
}

/// Adds the range or choices of a parameter to its row.
fn describe(kind: Kind, row: &Object) {
    let range =
        |[min, max, step]: [f64; 3]| set(row, &[("min", min.into()), ("max", max.into()), ("step", step.into())]);
    match kind {
        Kind::Text { longest, .. } => set(row, &[("maxLength", longest.into())]),
        Kind::Integer { min, max, .. } => range([min.into(), max.into(), 1.0]),
        Kind::Number { min, max, step, .. } => range([min, max, step].map(Decimal::to_f64)),
        Kind::Outline => set(row, &[("maxLength", LONGEST_OUTLINE.into())]),
        Kind::Choice { choices } => {
            set(row, &[("choices", choices_of(choices.iter().map(|word| (word.name, word.label))).into())])
        }
        Kind::Sides { .. } => {
            let sides = [("n", "North"), ("e", "East"), ("s", "South"), ("w", "West")];
            set(row, &[("choices", choices_of(sides.into_iter()).into())]);
        }
    }
}

fn choices_of(choices: impl Iterator<Item = (&'static str, &'static str)>) -> Array {
    choices.map(|(value, label)| object(&[("value", value.into()), ("label", label.into())])).collect()
}
