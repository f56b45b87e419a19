//! The page's demands on a picture: a part of the map, a heading, no ground, how far it is; and a copy of the river for
//! another picture.

use std::num::NonZero;

use wasm_bindgen::prelude::*;

use crate::make::river::{River, session_error};
use riverseed::paint::Framing;

/// Wasm has no threads here.
const ONE: NonZero<usize> = NonZero::<usize>::MIN;

#[wasm_bindgen]
impl River {
    /// Copies the river without its picture; the copies are independent. Throws an Error if there is not enough memory.
    pub fn copy(&self) -> Result<Self, JsValue> {
        let session = self.session.try_clone().map_err(|error| session_error(&error))?;
        Ok(Self::of(session, self.notices.clone()))
    }

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

    /// Solves the relief of the finished map again if the picture's pixels are much smaller than the relief's cells, so
    /// that the ground of large pictures is sharp; the next `paint` shows it. Throws an Error if there is not enough
    /// memory.
    pub fn refine(&mut self) -> Result<(), JsValue> {
        let refined = self.picture.as_mut().zip(self.session.map()).map(|(picture, map)| picture.refine(&map, ONE));
        refined.unwrap_or(Ok(())).map_err(|error| session_error(&error.into()))
    }

    /// Shows all of the land of the finished map, with its title above or beside it, and letters that can be read where
    /// chats show the picture. The next `paint` shows it, until picture or map change.
    pub fn head(&mut self) -> Result<(), JsValue> {
        let map = self.map()?;
        if let Some(picture) = &mut self.picture {
            picture.head(&self.session, &map);
        }
        Ok(())
    }

    /// Returns the share of the picture's ground that is painted, from 0 to 1, once the rivers are finished.
    #[wasm_bindgen(getter)]
    pub fn painted(&self) -> f32 {
        self.picture.as_ref().map_or(0.0, |picture| picture.progress(&self.session))
    }

    /// Makes the background of the painted picture transparent: the sea, or in line styles the paper. Pixels are then
    /// RGBA, not premultiplied, until the picture is painted again.
    #[wasm_bindgen(js_name = cutOut)]
    pub fn cut_out(&mut self) {
        if let Some(picture) = &mut self.picture {
            picture.cut_out(&self.session);
        }
    }
}
