//! The command line, called like its users call it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod batch;
mod batch_failures;
mod command;
mod command_line;
mod documents;
mod land_pictures;
#[cfg(target_os = "linux")]
mod little_memory;
mod maps;
#[cfg(target_os = "linux")]
mod output;
mod page;
mod page_owns;
