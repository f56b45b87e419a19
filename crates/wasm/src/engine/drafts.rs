//! Previews of another recipe, while somebody moves a slider.

use wasm_bindgen::prelude::*;

use crate::make::link::read;
use crate::make::river::River;
use riverseed::paint::Painted;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What came of painting a draft: a part, of which nothing is seen yet; all of it; or nothing, since there can be none. */
export type Drafted = "part" | "whole" | "impossible";
"#;

#[wasm_bindgen]
impl River {
    /// Reads the link of another recipe like `readLink`, for `paintDraft` to show. It stays until the next `draft`, or
    /// until the river changes to a recipe.
    pub fn draft(
        &mut self,
        text: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
    ) {
        self.drafted = Some(read(text, options));
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
