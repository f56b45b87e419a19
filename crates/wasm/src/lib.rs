//! The edge to JavaScript. No other code knows JavaScript. Features choose what a wasm package exports.
#![cfg(target_arch = "wasm32")]

#[cfg(feature = "engine")]
mod engine;
mod make;
mod objects;

use wasm_bindgen::prelude::*;

/// Half the size of Rust's default allocator.
#[global_allocator]
static ALLOCATOR: talc::wasm::WasmDynamicTalc = talc::wasm::new_wasm_dynamic_allocator();

#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
