//! The page's demands on a picture: a part of the map, a heading, no ground, how far it is; and a copy of the river for
//! another picture.

use std::num::NonZero;

use glam::Vec2;
use js_sys::Object;
use wasm_bindgen::prelude::*;

use crate::make::river::{River, session_error};
use crate::objects::object;
use riverseed::paint::Framing;
use riverseed::picture::builder::AnnotationBuilder;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The sides of a box. */
export interface Sides {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}
"#;

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

    /// Lays labels, woods and hills over the picture of a finished map, with the map's title as a heading: as large as it
    /// fits into a box of the picture, in pixels. The next `paint` shows it, until picture or map change.
    pub fn head(&mut self, ratio: f32, left: f32, top: f32, right: f32, bottom: f32) -> Result<(), JsValue> {
        let map = self.map()?;
        if let Some(picture) = &mut self.picture {
            let within = [Vec2::new(left, top), Vec2::new(right, bottom)];
            let masks = AnnotationBuilder::headed(&map, picture.view(), ratio, within);
            picture.take_annotation(&self.session, masks);
        }
        Ok(())
    }

    /// Returns the sides of the box around all land, in widths of the map from its north-western corner.
    #[wasm_bindgen(js_name = landBounds, unchecked_return_type = "Sides")]
    pub fn land_bounds(&self) -> Object {
        let size = self.session.domain().size;
        let bounds = self.session.land().and_then(|land| land.bounds()).unwrap_or([Vec2::ZERO, size]);
        let [least, most] = [bounds[0], bounds[1].min(size)].map(|corner| corner / size.x);
        let sides = [("left", least.x), ("top", least.y), ("right", most.x), ("bottom", most.y)];
        object(&sides.map(|(side, length)| (side, length.into())))
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
