//! The wasm side of `make bench`: the tasks of `workload.rs` as a module for Node. `run.mjs` measures the time.
#![cfg(target_arch = "wasm32")]

mod workload;

use wasm_bindgen::prelude::*;

/// That of the wasm packages, `crates/wasm`.
#[global_allocator]
static ALLOCATOR: talc::wasm::WasmDynamicTalc = talc::wasm::new_wasm_dynamic_allocator();

/// All tasks that have been prepared.
#[wasm_bindgen]
#[derive(Default)]
pub struct Figures(workload::Workload);

#[wasm_bindgen]
impl Figures {
    /// Begins without tasks.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Prepares a task. Returns `true` if the task exists.
    pub fn prepare(&mut self, task: &str) -> bool {
        self.0.prepare(task).is_some()
    }

    /// Runs a prepared task once, and returns its result.
    pub fn run(&mut self, task: &str) -> u32 {
        self.0.prepare(task).map_or(u32::MAX, |run| run())
    }

    /// The memory of the module. It never shrinks.
    pub fn memory(&self) -> u32 {
        const PAGE: usize = 65_536;
        (core::arch::wasm32::memory_size::<0>() * PAGE) as u32
    }
}
