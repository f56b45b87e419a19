//! The edge to JavaScript. No other code knows JavaScript. Features choose what a wasm package exports.
#![cfg(target_arch = "wasm32")]

#[cfg(feature = "charts")]
mod charts;
#[cfg(all(feature = "rivers", feature = "controls"))]
mod controls;
#[cfg(all(feature = "rivers", feature = "files"))]
mod files;
#[cfg(all(feature = "rivers", feature = "files", feature = "controls"))]
mod inspector;
#[cfg(all(feature = "rivers", feature = "controls"))]
mod measures;
#[cfg(any(feature = "rivers", feature = "tracing", feature = "charts"))]
mod objects;
#[cfg(feature = "rivers")]
mod rivers;
#[cfg(all(feature = "rivers", feature = "controls"))]
mod timeline;
#[cfg(feature = "tracing")]
mod tracing;

use wasm_bindgen::prelude::*;

/// Half the size of Rust's default allocator.
#[cfg(any(feature = "rivers", feature = "tracing", feature = "charts"))]
#[global_allocator]
static ALLOCATOR: talc::wasm::WasmDynamicTalc = talc::wasm::new_wasm_dynamic_allocator();

#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
