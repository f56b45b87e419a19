//! The command line as its users call it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod batch;
mod batch_failures;
mod command;
mod command_line;
mod documents;
mod land_pictures;
mod maps;
#[cfg(target_os = "linux")]
mod output;
