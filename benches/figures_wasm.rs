//! The measurements of `figures.rs` as a wasm module, for Node.
