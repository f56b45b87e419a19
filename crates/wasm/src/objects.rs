//! Plain objects and errors.

use js_sys::{Error, Object, Reflect};
use wasm_bindgen::prelude::*;

/// Makes a JavaScript Error with a `code` for programs and a message for people.
pub(super) fn coded(code: &str, message: &str) -> JsValue {
    Object::assign(&Error::new(message), &object(&[("code", code.into())])).into()
}

/// Makes a plain object.
pub(super) fn object(members: &[(&str, JsValue)]) -> Object {
    let object = Object::new();
    set(&object, members);
    object
}

/// Sets properties of a fresh object.
pub(super) fn set(object: &Object, members: &[(&str, JsValue)]) {
    for (name, value) in members {
        // Setting a property of a fresh, extensible object cannot fail.
        let _ = Reflect::set(object, &JsValue::from_str(name), value);
    }
}
