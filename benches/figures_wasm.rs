//! The wasm side of `make bench`: the tasks of `workload.rs` as a module for Node. `run.mjs` times them.
#![cfg(target_arch = "wasm32")]

mod workload;

use wasm_bindgen::prelude::*;

/// All tasks that have been made ready.
#[wasm_bindgen]
#[derive(Default)]
pub struct Figures(workload::Workload);

#[wasm_bindgen]
impl Figures {
    /// No task yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes a task ready. Returns whether there is such a task.
    pub fn prepare(&mut self, task: &str) -> bool {
        self.0.prepare(task).is_some()
    }

    /// Runs a task that is ready once, and returns its result.
    pub fn run(&mut self, task: &str) -> u32 {
        self.0.prepare(task).map_or(u32::MAX, |run| run())
    }

    /// How much memory the module has taken. It never gives any back.
    pub fn memory(&self) -> u32 {
        const PAGE: usize = 65_536;
        (core::arch::wasm32::memory_size::<0>() * PAGE) as u32
    }
}
