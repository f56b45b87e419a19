//! The names on a finished map, and names that people give.

use js_sys::{Array, Object};
use wasm_bindgen::prelude::*;

use crate::make::river::River;
use crate::objects::{coded, object};
use riverseed::annotate::names::Names;
use riverseed::picture::carried::Carried;
use riverseed::recipe::reading::{ReadOptions, read};
use riverseed::recipe::{Mark, OwnNames};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The name of something on a map. */
export interface NameFacts {
  /** The mark by which `names` in a link knows it. */
  readonly mark: string;
  readonly name: string;
  /** Whether the link gives it this name. */
  readonly isOwn: boolean;
}
"#;

#[wasm_bindgen]
impl River {
    /// Returns the letters to carry along with the link of an element that shows this finished map, in the light and in the dark. None
    /// if it shows another map, within an element's limits, or if there are none to carry.
    #[wasm_bindgen(js_name = lettersFor)]
    pub fn letters_for(&self, link: &str) -> Result<Option<String>, JsValue> {
        let map = self.map()?;
        let [light, dark] = [false, true].map(|dark| read(link, ReadOptions { widget: true, dark }).recipe);
        Ok(Carried::write(&map, &[&light, &dark]))
    }

    /// Returns names on the finished map: the map's, those of the `rivers` greatest rivers, the user's own, and those of
    /// everything that is not a river. Own names for nothing on this map come last.
    #[wasm_bindgen(unchecked_return_type = "NameFacts[]")]
    pub fn greatest(&self, rivers: usize) -> Result<Array, JsValue> {
        let map = self.map()?;
        let (names, own) = (Names::of(&map), map.recipe().own_names());
        let marked = names.marked(map.network());
        let mut left = rivers;
        let mut is_shown = |(mark, _): &&(Mark, &str)| {
            let is_great = !matches!(mark, Mark::River(_)) || left > 0;
            left -= usize::from(is_great && matches!(mark, Mark::River(_)));
            is_great || own.get(*mark).is_some()
        };
        let shown: Vec<_> = marked.iter().filter(|named| is_shown(named)).copied().collect();
        let unused = own.marks().filter(|mark| marked.iter().all(|(known, _)| known != mark));
        let unused = unused.map(|mark| (mark, own.get(mark).unwrap_or_default()));
        let facts = |(mark, name): (Mark, &str)| named(mark, name, own.get(mark).is_some());
        Ok(shown.into_iter().chain(unused).map(facts).collect())
    }
}

fn named(mark: Mark, name: &str, is_own: bool) -> Object {
    object(&[("mark", mark.to_string().into()), ("name", name.into()), ("isOwn", is_own.into())])
}

/// Returns the text of `names` in a link with another name for a mark, or with its usual name again. Throws an Error if
/// there would be too many names, or if the name is too long.
#[wasm_bindgen]
pub fn renamed(names: &str, mark: &str, name: Option<String>) -> Result<String, JsValue> {
    let own = OwnNames::readable(names).with(mark, name.as_deref());
    own.map(|own| own.to_string()).map_err(|error| coded("bad-params", &error.to_string()))
}
