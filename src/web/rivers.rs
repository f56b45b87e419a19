//! Recipes, the parameter table and a river.

use glam::Vec2;
use js_sys::{Array, Float32Array, Object, Reflect};
use wasm_bindgen::prelude::*;

use super::objects::{coded, object, set};
use crate::dice;
use crate::grow::Ending;
use crate::land::Land;
use crate::paint::{PaintError, Rect};
use crate::picture::Picture;
use crate::recipe::link::{self, Notice};
use crate::recipe::preset::{PRESETS, Preset};
use crate::recipe::reading::{self, ReadOptions, Reading};
use crate::recipe::table::TABLE;
use crate::recipe::{Decimal, GridPoint, Key, Kind, LONGEST_OUTLINE, Outline, Parameter, Stage, Value};
use crate::session::{Phase, Session, SessionError, Shortfall};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The stages of a river, in the order in which they run. */
export type Stage = "land" | "grow" | "prune" | "shape" | "relief" | "paint";
/** What a river's next step does: a tick of growth; rivers made of the tree, in a few; a round of meandering; a part of the relief; nothing. */
export type Phase = "growing" | "shaping" | "meandering" | "relief" | "finished";
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
/** Something in a link that had to be corrected. */
export interface Notice {
  readonly key: string;
  readonly message: string;
}
/** Where the rivers of a link are to be seen. */
export interface ReadOptions {
  /** In a widget: the recipe is kept within its limits. */
  readonly widget?: boolean;
  /** On a dark page: if the link names no style, it is the one for dark pages. */
  readonly dark?: boolean;
}
/** A link as it was understood. */
export interface Reading {
  /** The canonical link of what is drawn: defaults left out. */
  readonly link: string;
  /** The canonical link to share: it names a style only where the text that was read did. */
  readonly sharedLink: string;
  /** Whether the text names a style. */
  readonly namesStyle: boolean;
  /** Every parameter's value as link text. */
  readonly values: readonly (readonly [key: string, value: string])[];
  /** The keys that do nothing in this recipe, and why. */
  readonly idle: readonly (readonly [key: string, reason: string])[];
  readonly notices: readonly Notice[];
}
/** Lines of a drawn land, each as x and y in turn, in fractions of the map's width and height. */
export interface Lines {
  /** Closed: the last point is joined to the first. */
  readonly coasts: readonly Float32Array[];
  readonly ridges: readonly Float32Array[];
  /** Each from its mouth; of one point if nothing more of it is drawn. */
  readonly rivers: readonly Float32Array[];
}
/** What a picture shows, in numbers. */
export interface Summary {
  /** How its rivers grow: a word of the parameter `growth`. */
  readonly growth: string;
  readonly ticks: number;
  readonly nodes: number;
  readonly mouths: number;
  readonly sources: number;
  readonly order: number;
  /** Attractors scattered, or parcels of drainage; 0 for a Brownian tree. */
  readonly attractors: number;
  /** How many of them no river reaches. */
  readonly unreached: number;
  /** Rounds that rivers have meandered. */
  readonly rounds: number;
  /** Oxbow lakes that they have left. */
  readonly oxbows: number;
  /** Whether everything is done, meandering included. */
  readonly finished: boolean;
  /** Why growth ended early; null if it did not. */
  readonly stopped: string | null;
}
"#;

/// The parameter table.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn parameters() -> Array {
    TABLE.iter().map(row).collect()
}

/// All presets.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn presets() -> Array {
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
    PRESETS.iter().map(view).collect()
}

/// Reads a link leniently. Total: never throws, whatever the text.
#[wasm_bindgen(js_name = readLink, unchecked_return_type = "Reading")]
pub fn read_link(
    text: &str,
    #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
) -> Object {
    let reading = reading::read(text, read_options(options));
    let Reading { recipe, .. } = &reading;
    let value = |parameter: &Parameter| pair(parameter.name, &parameter.text_of(recipe.value(parameter.key)));
    let land = Land::kind_of(recipe);
    let idle = |row: &Parameter| recipe.inactive_reason(row.key, land).map(|reason| pair(row.name, reason));
    object(&[
        ("link", link::write(recipe).into()),
        ("sharedLink", reading.shared_link().into()),
        ("namesStyle", reading.names_style.into()),
        ("values", TABLE.iter().map(value).collect::<Array>().into()),
        ("idle", TABLE.iter().filter_map(idle).collect::<Array>().into()),
        ("notices", list(&reading.notices).into()),
    ])
}

/// What a page says of where rivers are to be seen; what it leaves out is not so.
fn read_options(given: &JsValue) -> ReadOptions {
    let is = |name: &str| Reflect::get(given, &JsValue::from_str(name)).is_ok_and(|value| value.is_truthy());
    ReadOptions { widget: is("widget"), dark: is("dark") }
}

fn list(notices: &[Notice]) -> Array {
    let notice = |Notice { key, message }: &Notice| {
        object(&[("key", key.as_str().into()), ("message", message.as_str().into())])
    };
    notices.iter().map(notice).collect()
}

/// A new seed, a word that can be said aloud.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<String, JsValue> {
    getrandom::u64().map(dice::word).map_err(|error| coded("no-randomness", &error.to_string()))
}

/// The outline of lines with any number of points, simplified until it fits a link. Throws an Error if that is no land.
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

/// The lines of an outline. Throws an Error if the text is none.
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

/// The points of a line given as x and y in turn; half a point at the end is left out.
fn points(line: &Float32Array) -> Vec<Vec2> {
    line.to_vec().chunks_exact(2).map(Vec2::from_slice).collect()
}

/// A river: a recipe, its tree as far as it has grown, and its picture, if it has been given a size.
#[wasm_bindgen]
pub struct River {
    pub(super) session: Session,
    pub(super) notices: Vec<Notice>,
    pub(super) picture: Option<Picture>,
    pub(super) dirty: Option<Rect>,
}

#[wasm_bindgen]
impl River {
    /// Plants the recipe of a link, which is read as `readLink` does. It has no picture until it is given a size. Throws
    /// an Error with a `code`.
    #[wasm_bindgen(constructor)]
    pub fn new(
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) -> Result<Self, JsValue> {
        let Reading { recipe, notices, .. } = reading::read(text, read_options(options));
        let session = Session::new(recipe).map_err(|error| session_error(&error))?;
        Ok(Self { session, notices, picture: None, dirty: None })
    }

    /// Goes over to the recipe of another link and says what has to run again. If it throws, everything is as before.
    #[wasm_bindgen(unchecked_return_type = "Stage | \"none\"")]
    pub fn change(
        &mut self,
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) -> Result<String, JsValue> {
        let Reading { recipe, notices, .. } = reading::read(text, read_options(options));
        let stage = self.session.change(recipe).map_err(|error| session_error(&error))?;
        self.notices = notices;
        Ok(stage.map_or("none", Stage::name).into())
    }

    /// The canonical link of its recipe: defaults left out.
    #[wasm_bindgen(getter)]
    pub fn link(&self) -> String {
        link::write(self.session.recipe())
    }

    /// The seed of its recipe.
    #[wasm_bindgen(getter)]
    pub fn seed(&self) -> String {
        self.session.recipe().seed().into()
    }

    /// What of its link was wrong, or beyond a widget's limits.
    #[wasm_bindgen(getter, unchecked_return_type = "readonly Notice[]")]
    pub fn notices(&self) -> Array {
        list(&self.notices)
    }

    /// Gives it a picture of this size, which is then painted again. If it throws, everything is as before.
    pub fn resize(&mut self, width_px: u32, height_px: u32) -> Result<(), JsValue> {
        self.picture = Some(Picture::new(width_px, height_px).map_err(|error| paint_error(&error))?);
        Ok(())
    }

    /// Goes back to tick 0.
    pub fn restart(&mut self) -> Result<(), JsValue> {
        self.session.restart().map_err(|error| session_error(&error))
    }

    /// Advances by this number of steps at most: ticks of growth, then a few that make rivers of the tree, then rounds of
    /// meandering, then the relief part by part, if the style shows one. Returns whether there is more to do. Throws an Error with
    /// the code `no-memory` if there is not enough for one of these: what is there then is no picture of the recipe.
    pub fn advance(&mut self, steps: u32) -> Result<bool, JsValue> {
        self.session.advance(steps).map_err(|error| coded("no-memory", &error.to_string()))
    }

    /// What the next step does.
    #[wasm_bindgen(getter, unchecked_return_type = "Phase")]
    pub fn phase(&self) -> String {
        match self.session.phase() {
            Phase::Growing => "growing",
            Phase::Shaping => "shaping",
            Phase::Meandering => "meandering",
            Phase::Relief => "relief",
            Phase::Finished => "finished",
        }
        .into()
    }

    /// Draws what is new. Returns whether any pixel changed: none does without a picture.
    pub fn paint(&mut self) -> bool {
        self.dirty = self.picture.as_mut().and_then(|picture| picture.paint(&self.session));
        self.dirty.is_some()
    }

    /// What the last `paint` changed: x, y, width, height.
    pub fn dirty(&self) -> Vec<u32> {
        self.dirty.map_or_else(|| vec![0; 4], |r| vec![r.left, r.top, r.right - r.left, r.bottom - r.top])
    }

    /// Where the picture's bytes begin in the module's memory: RGBA, opaque; 0 without a picture.
    #[wasm_bindgen(js_name = pixelsPointer)]
    pub fn pixels_pointer(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().data().as_ptr() as u32)
    }

    /// How many bytes the picture has; 0 without one.
    #[wasm_bindgen(js_name = pixelsLength)]
    pub fn pixels_length(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().data().len() as u32)
    }

    /// Width of the picture in pixels; 0 without one.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().width())
    }

    /// Height of the picture in pixels; 0 without one.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().height())
    }

    /// Width of the domain over its height.
    #[wasm_bindgen(getter)]
    pub fn aspect(&self) -> f64 {
        match self.session.recipe().value(Key::Aspect) {
            Value::Number(aspect) => aspect.to_f64(),
            _ => 1.0,
        }
    }

    /// How far the phase has come, from 0 to 1: growth by what is drained, meandering by its rounds.
    #[wasm_bindgen(getter)]
    pub fn progress(&self) -> f32 {
        self.session.progress()
    }

    /// How many rounds the rivers will have meandered.
    #[wasm_bindgen(getter)]
    pub fn rounds(&self) -> u32 {
        self.session.recipe().integer(Key::MeanderRounds)
    }

    /// The picture in numbers.
    #[wasm_bindgen(unchecked_return_type = "Summary")]
    pub fn summary(&self) -> Object {
        let summary = self.session.summary();
        let growth = Key::Growth.parameter().text_of(self.session.recipe().value(Key::Growth));
        let stopped = match (summary.ending, summary.shortfall()) {
            (Some(Ending::NodeLimit), _) => Some("The tree grew to its limit of nodes and was stopped."),
            (_, Some(Shortfall::NoRiver)) => Some("No river grew: no land lies open to the sea."),
            (_, Some(Shortfall::Unreached)) => Some(UNREACHED),
            (_, Some(Shortfall::CutOff)) => Some(CUT_OFF),
            (_, None) => None,
        };
        object(&[
            ("growth", growth.into()),
            ("ticks", summary.ticks.into()),
            ("nodes", summary.nodes.into()),
            ("mouths", summary.mouths.into()),
            ("sources", summary.sources.into()),
            ("order", summary.order.into()),
            ("attractors", summary.attractors.into()),
            ("unreached", summary.unreached.into()),
            ("rounds", summary.rounds.into()),
            ("oxbows", summary.oxbows.into()),
            ("finished", self.session.is_finished().into()),
            ("stopped", stopped.map_or(JsValue::NULL, JsValue::from)),
        ])
    }
}

const UNREACHED: &str =
    "Rivers do not reach all land: a shorter step, a longer kill distance or reach, or mouths less far apart helps.";
const CUT_OFF: &str = "Rivers do not reach all land: a gap in the ridges, or more mouths, helps.";

pub(super) fn session_error(error: &SessionError) -> JsValue {
    let code = match error {
        SessionError::Grow(_) | SessionError::Shape(_) | SessionError::Relief(_) | SessionError::Copy { .. } => {
            "too-large"
        }
        SessionError::OtherMap { .. } => "bad-params",
    };
    coded(code, &error.to_string())
}

pub(super) fn paint_error(error: &PaintError) -> JsValue {
    let code = match error {
        PaintError::Size { width: 0, .. } | PaintError::Size { height: 0, .. } => "bad-params",
        PaintError::Size { .. } | PaintError::OutOfMemory { .. } => "too-large",
    };
    coded(code, &error.to_string())
}

fn pair(name: &str, text: &str) -> Array {
    [name, text].into_iter().map(JsValue::from_str).collect()
}

/// A value in the one spelling that links are written in.
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

/// Says in a row what values its parameter takes.
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
