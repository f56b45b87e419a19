//! Seeking back and forth through the making of a map.

use js_sys::Object;
use wasm_bindgen::prelude::*;

use crate::make::river::{River, session_error};
use crate::objects::object;
use riverseed::session::{Moment, Timeline as Moments};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A part of the making of a map. */
export type Part = "growth" | "bends" | "map";
/** A moment in the making of a map: a tick of growth, a round of meandering, or its end, whose step is 0. */
export interface Moment {
  readonly part: Part;
  readonly step: number;
}
/** How long the making of a map is: the number of ticks, and the last round of meandering before it is finished. */
export interface Making {
  readonly ticks: number;
  readonly rounds: number;
}
"#;

/// Copies of the moments of a finished river.
#[wasm_bindgen]
pub struct Timeline(Moments);

#[wasm_bindgen]
impl Timeline {
    /// Returns how long the making of the map is.
    #[wasm_bindgen(unchecked_return_type = "Making")]
    pub fn making(&self) -> Object {
        object(&[("ticks", self.0.ticks().into()), ("rounds", self.0.rounds().into())])
    }
}

#[wasm_bindgen]
impl River {
    /// Returns the timeline of a finished river; nothing for an unfinished one, or if there is not enough memory.
    pub fn timeline(&self) -> Option<Timeline> {
        Moments::new(&self.session).map(Timeline)
    }

    /// Returns the moment that the river has reached.
    #[wasm_bindgen(unchecked_return_type = "Moment")]
    pub fn moment(&self) -> Object {
        let (part, step) = match self.session.moment() {
            Moment::Growth(tick) => ("growth", tick),
            Moment::Bends(round) => ("bends", round),
            Moment::Finished => ("map", 0),
        };
        object(&[("part", part.into()), ("step", step.into())])
    }

    /// Seeks towards a moment: jumps back, or advances one step. Returns `true` until it arrives. The timeline has to be
    /// one of the same recipe. Throws an Error if there is not enough memory.
    pub fn seek(
        &mut self,
        timeline: &mut Timeline,
        #[wasm_bindgen(unchecked_param_type = "Part")] part: &str,
        step: u32,
    ) -> Result<bool, JsValue> {
        let to = match part {
            "growth" => Moment::Growth(step),
            "bends" => Moment::Bends(step),
            _ => Moment::Finished,
        };
        timeline.0.seek(&mut self.session, to).map_err(|error| session_error(&error))
    }
}
