//! Links, as the page reads them.

use js_sys::{Array, Object, Reflect};
use wasm_bindgen::prelude::*;

use crate::objects::object;
use riverseed::land::Land;
use riverseed::recipe::is_decided;
use riverseed::recipe::link::{self, Notice};
use riverseed::recipe::reading::{self, ReadOptions, Reading};
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Decimal, Key, Parameter, Recipe};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The stages of a river, in the order in which they run. */
export type Stage = "land" | "grow" | "prune" | "shape" | "relief" | "name" | "paint";
/** Something in a link that had to be corrected. */
export interface Notice {
  /** The parameter; `link` if damage to the link was mended. */
  readonly key: string;
  readonly message: string;
}
/** Where the rivers of a link are to be seen. */
export interface ReadOptions {
  /** In a widget: the recipe is kept within its limits. */
  readonly widget?: boolean;
  /** On a dark page: if the link names no style, it is the one for dark pages. */
  readonly dark?: boolean;
  /** Link text with values that take precedence. If the seed in it is an address, that is read instead of the text. */
  readonly values?: string;
}
/** A link as it was understood. */
export interface Reading {
  /** The canonical link of what is drawn: defaults, and what the country decides, left out. */
  readonly link: string;
  /** The canonical link to share: it names a style only where the text that was read did. */
  readonly sharedLink: string;
  /** Whether the text names a style. */
  readonly namesStyle: boolean;
  /** Every parameter's value that is drawn, as link text. The `country` is `own` for land that is in no country. */
  readonly values: readonly (readonly [key: string, value: string])[];
  /** The keys whose values the text leaves to the word: `country`, and what that decides. */
  readonly auto: readonly string[];
  /** The keys that do nothing in this recipe, and why. */
  readonly idle: readonly (readonly [key: string, reason: string])[];
  readonly notices: readonly Notice[];
  /** Words for readers who do not see the picture; of the largest engine only. */
  readonly alternative?: string;
}
"#;

/// Reads a link leniently, in the larger engines also an address or a word. It never throws, whatever the text.
#[wasm_bindgen(js_name = readLink, unchecked_return_type = "Reading")]
pub fn read_link(
    text: &str,
    #[wasm_bindgen(unchecked_optional_param_type = "ReadOptions")] options: &JsValue,
) -> Object {
    let reading = read(text, options);
    let Reading { recipe, .. } = &reading;
    let value = |parameter: &Parameter| pair(parameter.name, &drawn(recipe, parameter));
    let is_auto = |row: &&Parameter| (is_decided(row.key) || row.key == Key::Country) && !recipe.is_named(row.key);
    let land = Land::kind_of(recipe);
    let idle = |row: &Parameter| recipe.inactive_reason(row.key, land).map(|reason| pair(row.name, reason));
    object(&[
        ("link", link::write(recipe).into()),
        ("sharedLink", reading.shared_link().into()),
        ("namesStyle", reading.names_style.into()),
        ("values", TABLE.iter().map(value).collect::<Array>().into()),
        ("auto", TABLE.iter().filter(is_auto).map(|row| JsValue::from_str(row.name)).collect::<Array>().into()),
        ("idle", TABLE.iter().filter_map(idle).collect::<Array>().into()),
        ("notices", list(&reading.notices).into()),
        #[cfg(feature = "engine")]
        ("alternative", recipe.alternative().into()),
    ])
}

/// Reads a text with a page's options; options that are left out are off. The smallest engine reads link text alone: an
/// element hands whatever else it was given to the others, so that most readers load nothing that understands it.
pub(crate) fn read(text: &str, options: &JsValue) -> Reading {
    let option = |name: &str| Reflect::get(options, &JsValue::from_str(name)).unwrap_or_default();
    let is = |name: &str| option(name).is_truthy();
    let options = ReadOptions { widget: is("widget"), dark: is("dark") };
    if cfg!(feature = "label") {
        reading::read_given(text, &option("values").as_string().unwrap_or_default(), options)
    } else {
        reading::read(text, options)
    }
}

pub(crate) fn list(notices: &[Notice]) -> Array {
    let notice = |Notice { key, message, .. }: &Notice| {
        object(&[("key", key.as_str().into()), ("message", message.as_str().into())])
    };
    notices.iter().map(notice).collect()
}

/// Writes the value of a parameter that is drawn, also where the recipe has one that stands for another.
fn drawn(recipe: &Recipe, parameter: &Parameter) -> String {
    let text = parameter.text_of(recipe.value(parameter.key));
    match parameter.key {
        Key::Country => recipe.country().into(),
        Key::Sea if text == "0" => Decimal::new(recipe.sea().into()).to_string(),
        _ => text,
    }
}

fn pair(name: &str, text: &str) -> Array {
    [name, text].into_iter().map(JsValue::from_str).collect()
}
