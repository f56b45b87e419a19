//! Seeking back and forth through the making of a map.

use wasm_bindgen::prelude::*;

use crate::make::river::{River, session_error};
use riverseed::session::{Moment, Timeline as Moments};

/// Copies of the moments of a finished river.
#[wasm_bindgen]
pub struct Timeline(Moments);

#[wasm_bindgen]
impl Timeline {
    /// The number of ticks that it grows, and the last round of meandering after which it is not finished.
    pub fn lengths(&self) -> Vec<u32> {
        vec![self.0.ticks(), self.0.rounds()]
    }
}

#[wasm_bindgen]
impl River {
    /// Returns the timeline of a finished river; nothing for an unfinished one, or if there is not enough memory.
    pub fn timeline(&self) -> Option<Timeline> {
        Moments::new(&self.session).map(Timeline)
    }

    /// The moment that the river has reached: the part of its making (0 growth, 1 bends, 2 the end) and the number of
    /// its tick or round.
    pub fn moment(&self) -> Vec<u32> {
        match self.session.moment() {
            Moment::Growth(tick) => vec![0, tick],
            Moment::Bends(round) => vec![1, round],
            Moment::Finished => vec![2, 0],
        }
    }

    /// Seeks towards a moment, given like the result of `moment`: jumps back, or advances one step. Returns `true`
    /// until it arrives. The timeline has to be one of the same recipe. Throws an Error if there is not enough memory.
    pub fn seek(&mut self, timeline: &mut Timeline, part: u32, number: u32) -> Result<bool, JsValue> {
        let to = match part {
            0 => Moment::Growth(number),
            1 => Moment::Bends(number),
            _ => Moment::Finished,
        };
        timeline.0.seek(&mut self.session, to).map_err(|error| session_error(&error))
    }
}
