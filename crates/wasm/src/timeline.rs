//! Back and forth through the making of a map.

use wasm_bindgen::prelude::*;

use super::rivers::{River, session_error};
use riverseed::session::{Moment, Timeline as Moments};

/// What has been kept of the moments of a river that was finished once.
#[wasm_bindgen]
pub struct Timeline(Moments);

#[wasm_bindgen]
impl Timeline {
    /// How many ticks it grows, and the last round of meandering after which it is not finished.
    pub fn lengths(&self) -> Vec<u32> {
        vec![self.0.ticks(), self.0.rounds()]
    }
}

#[wasm_bindgen]
impl River {
    /// The timeline of a finished river; nothing of any other, and where there is not enough memory.
    pub fn timeline(&self) -> Option<Timeline> {
        Moments::new(&self.session).map(Timeline)
    }

    /// How far it has come: which part of its making, 0 for growth, 1 for bends and 2 at its end, and the number of its tick or round.
    pub fn moment(&self) -> Vec<u32> {
        match self.session.moment() {
            Moment::Growth(tick) => vec![0, tick],
            Moment::Bends(round) => vec![1, round],
            Moment::Finished => vec![2, 0],
        }
    }

    /// Goes nearer to a moment, told likewise: back at once, forth by a step. Returns whether it has not come there yet. The timeline has to be
    /// of the same recipe. Throws an Error if there is not enough memory.
    pub fn seek(&mut self, timeline: &mut Timeline, part: u32, number: u32) -> Result<bool, JsValue> {
        let to = match part {
            0 => Moment::Growth(number),
            1 => Moment::Bends(number),
            _ => Moment::Finished,
        };
        timeline.0.seek(&mut self.session, to).map_err(|error| session_error(&error))
    }
}
