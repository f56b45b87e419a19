//! A river: its recipe, its growth and its picture.

use js_sys::{Array, Object};
use wasm_bindgen::prelude::*;

use super::link::{list, read};
use crate::objects::{coded, object};
use riverseed::grow::Ending;
use riverseed::paint::{PaintError, Painted, Rect, View};
use riverseed::picture::Picture;
use riverseed::picture::carried::{Carried, Lettering};
use riverseed::recipe::link::{self, Notice};
use riverseed::recipe::reading::Reading;
use riverseed::recipe::{IntegerKey, Key, Stage, Value};
use riverseed::session::{Session, SessionError, Shortfall};

/// Whether this package knows names and places letters.
const PLACES_LETTERS: bool = cfg!(feature = "label");

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a river's next step does: a tick of growth; a part of the sea's rise, if it drowns valleys; rivers made of the tree, in a few; a round of meandering; a part of the relief; nothing. */
export type Phase = "growing" | "drowning" | "shaping" | "meandering" | "relief" | "finished";
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

/// A river: a recipe, its tree as far as it has grown, and its picture, once it has a size.
#[wasm_bindgen]
pub struct River {
    pub(crate) session: Session,
    pub(crate) notices: Vec<Notice>,
    pub(crate) picture: Option<Picture>,
    pub(crate) dirty: Option<Rect>,
    /// The recipe shown by drafts.
    pub(crate) drafted: Option<Reading>,
    lettering: Lettering,
}

impl River {
    /// Makes a river without a picture.
    pub(crate) fn of(session: Session, notices: Vec<Notice>) -> Self {
        Self { session, notices, picture: None, dirty: None, drafted: None, lettering: Lettering::Placed }
    }

    /// Changes to a recipe and returns the earliest stage that has to run again. After an error nothing has changed.
    pub(crate) fn change_to(&mut self, Reading { recipe, notices, .. }: Reading) -> Result<String, JsValue> {
        let stage = self.session.change(recipe).map_err(|error| session_error(&error))?;
        self.notices = notices;
        self.drafted = None;
        Ok(stage.map_or("none", Stage::name).into())
    }
}

#[wasm_bindgen]
impl River {
    /// Plants the recipe of a link, which is read like `readLink`. The river has no picture until it is given a size.
    /// Throws an Error with a `code`.
    #[wasm_bindgen(constructor)]
    pub fn new(
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) -> Result<Self, JsValue> {
        let Reading { recipe, notices, .. } = read(text, options);
        let session = Session::new(recipe).map_err(|error| session_error(&error))?;
        Ok(Self::of(session, notices))
    }

    /// Changes to the recipe of another link and returns the earliest stage that has to run again. If it throws,
    /// nothing has changed.
    #[wasm_bindgen(unchecked_return_type = "Stage | \"none\"")]
    pub fn change(
        &mut self,
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) -> Result<String, JsValue> {
        self.change_to(read(text, options))
    }

    /// Returns the canonical link of the recipe, with defaults left out.
    #[wasm_bindgen(getter)]
    pub fn link(&self) -> String {
        link::write(self.session.recipe())
    }

    /// Returns the link in the files of the map, which names the style even if that is the default.
    #[wasm_bindgen(getter, js_name = fileLink)]
    pub fn file_link(&self) -> String {
        link::write_for_file(self.session.recipe())
    }

    /// Returns the seed of the recipe.
    #[wasm_bindgen(getter)]
    pub fn seed(&self) -> String {
        self.session.recipe().seed().into()
    }

    /// Notices about values in the link that were wrong, or beyond a widget's limits.
    #[wasm_bindgen(getter, unchecked_return_type = "readonly Notice[]")]
    pub fn notices(&self) -> Array {
        list(&self.notices)
    }

    /// Returns the width and height of a picture of the whole map, given the longer of the two.
    #[wasm_bindgen(js_name = sidesFor)]
    pub fn sides_for(&self, longer_px: u32) -> Vec<u32> {
        let (width, height) = View::sides_for(&self.session.domain(), longer_px);
        vec![width, height]
    }

    /// Makes a picture of this size, which then has to be painted. `ratio` is its pixels to a CSS pixel, 1 if it is not
    /// given: letters have at least 11 CSS pixels. If it throws, nothing has changed.
    pub fn resize(&mut self, width_px: u32, height_px: u32, ratio: Option<f32>) -> Result<(), JsValue> {
        let picture = Picture::new(width_px, height_px).map_err(|error| paint_error(&error))?;
        let mut picture = picture.with_ratio(ratio.unwrap_or(1.0));
        picture.letter(self.lettering.clone());
        self.picture = Some(match self.picture.take() {
            Some(before) => picture.in_place_of(before),
            None => picture,
        });
        Ok(())
    }

    /// Goes back to tick 0.
    pub fn restart(&mut self) -> Result<(), JsValue> {
        self.session.restart().map_err(|error| session_error(&error))
    }

    /// Makes up to `steps` steps: ticks of growth, then a few steps that make rivers from the tree, then rounds of
    /// meandering, then the relief part by part if the style shows one. Returns `true` if there is more to do. Throws
    /// an Error with the code `no-memory` if there is not enough memory for one of these; what exists then does not
    /// show the whole recipe.
    pub fn advance(&mut self, steps: u32) -> Result<bool, JsValue> {
        self.session.advance(steps).map_err(|error| coded("no-memory", &error.to_string()))
    }

    /// Makes a step of the relief of finished rivers, even if the style shows none, so that files find it ready.
    /// Returns `true` if a step was left to make. Throws an Error if there is not enough memory.
    #[wasm_bindgen(js_name = raiseRelief)]
    pub fn raise_relief(&mut self) -> Result<bool, JsValue> {
        self.session.raise_relief().map_err(|error| session_error(&error))
    }

    /// Returns the kind of the next step.
    #[wasm_bindgen(getter, unchecked_return_type = "Phase")]
    pub fn phase(&self) -> String {
        self.session.phase().name().into()
    }

    /// Paints what is new, or a part of it that takes a few milliseconds. Returns `true` if there is more to do; until
    /// then no pixel changes. With `isBare`, labels, woods and hills that are not made yet are left for later.
    pub fn paint(&mut self, #[wasm_bindgen(js_name = isBare)] is_bare: Option<bool>) -> bool {
        let paint = if is_bare == Some(true) { Picture::paint_part_bare } else { Picture::paint_part };
        let painted = self.picture.as_mut().map(|picture| paint(picture, &self.session));
        self.dirty = painted.and_then(Painted::changed);
        painted == Some(Painted::Part)
    }

    /// Takes the letters that are carried along with the link of this recipe, for a picture of this size, or of none yet. Where they are an
    /// empty text, or are for another map or picture, this package places letters as whoever has carried them would have, if it places
    /// any. Returns `true` if the map can have its names, and its woods and hills, in one way or the other.
    #[wasm_bindgen(js_name = takeLetters)]
    pub fn take_letters(&mut self, text: &str, width_px: u32, height_px: u32, ratio: f32) -> bool {
        let recipe = self.session.recipe();
        let view = View::new(&self.session.domain(), width_px, height_px);
        let has_room = view.is_ok_and(|view| Carried::have_room(&view, ratio)) || width_px == 0;
        // Who places letters reads none: they would be the same.
        let carried = if PLACES_LETTERS { None } else { Carried::read(text) };
        let carried = carried.filter(|carried| has_room && carried.are_for(recipe));
        let is_able = PLACES_LETTERS || carried.is_some() || !recipe.is_annotated();
        self.lettering = carried.map_or(Lettering::InSteps, |carried| Lettering::Carried(carried.into()));
        if let Some(picture) = &mut self.picture {
            picture.letter(self.lettering.clone());
        }
        is_able
    }

    /// `true` if the map is finished, and the picture lacks letters that only another package can paint: those that were taken are for
    /// other rivers, or for no picture of this size or shape.
    #[wasm_bindgen(getter, js_name = lacksLetters)]
    pub fn lacks_letters(&self) -> bool {
        let lacks = |picture: &Picture| picture.lacks_annotation(&self.session);
        !PLACES_LETTERS && self.picture.as_ref().is_some_and(lacks)
    }

    /// `true` if the recipe asks for labels, a cartouche, woods or hills. The package `make` paints none of them.
    #[wasm_bindgen(getter, js_name = isAnnotated)]
    pub fn is_annotated(&self) -> bool {
        self.session.recipe().is_annotated()
    }

    /// Returns the rectangle changed by the last `paint`: x, y, width, height.
    pub fn dirty(&self) -> Vec<u32> {
        self.dirty.map_or_else(|| vec![0; 4], |r| vec![r.left, r.top, r.right - r.left, r.bottom - r.top])
    }

    /// Returns the address of the picture's bytes in the module's memory: RGBA, opaque; 0 without a picture.
    #[wasm_bindgen(js_name = pixelsPointer)]
    pub fn pixels_pointer(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().data().as_ptr() as u32)
    }

    /// Returns the number of bytes in the picture; 0 without one.
    #[wasm_bindgen(js_name = pixelsLength)]
    pub fn pixels_length(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().data().len() as u32)
    }

    /// Returns the width of the picture in pixels; 0 without one.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().width())
    }

    /// Returns the height of the picture in pixels; 0 without one.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.picture.as_ref().map_or(0, |picture| picture.pixmap().height())
    }

    /// Returns the width of the domain over its height.
    #[wasm_bindgen(getter)]
    pub fn aspect(&self) -> f64 {
        match self.session.recipe().value(Key::Aspect) {
            Value::Number(aspect) => aspect.to_f64(),
            _ => 1.0,
        }
    }

    /// Returns the progress of the phase, from 0 to 1: growth by the share drained, meandering by rounds, relief by parts.
    #[wasm_bindgen(getter)]
    pub fn progress(&self) -> f32 {
        self.session.progress()
    }

    /// Returns the number of rounds that the rivers will have meandered at the end.
    #[wasm_bindgen(getter)]
    pub fn rounds(&self) -> u32 {
        self.session.recipe().integer(IntegerKey::MeanderRounds)
    }

    /// Returns the picture in numbers.
    #[wasm_bindgen(unchecked_return_type = "Summary")]
    pub fn summary(&self) -> Object {
        let summary = self.session.summary();
        let growth = Key::Growth.parameter().text_of(self.session.recipe().value(Key::Growth));
        let stopped = match (summary.ending, summary.shortfall()) {
            (Some(Ending::NodeLimit), _) => Some("The tree grew to its limit of nodes and was stopped."),
            (_, Some(Shortfall::NoRiver)) => Some("No river grew: no land lies open to the sea."),
            (_, Some(Shortfall::Unreached)) => Some(UNREACHED),
            (_, Some(Shortfall::CutOff)) => Some(CUT_OFF),
            (_, Some(_)) => Some("Rivers leave much of the land dry."),
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

pub(crate) fn session_error(error: &SessionError) -> JsValue {
    let code = match error {
        SessionError::OtherMap { .. } => "bad-params",
        // All other errors concern memory.
        _ => "too-large",
    };
    coded(code, &error.to_string())
}

pub(crate) fn paint_error(error: &PaintError) -> JsValue {
    let code = match error {
        PaintError::Size { width: 0, .. } | PaintError::Size { height: 0, .. } => "bad-params",
        _ => "too-large",
    };
    coded(code, &error.to_string())
}
