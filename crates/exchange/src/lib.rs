//! Maps as files, for the command line, Python and any other program: [`Form`] is what a file can be, and [`Files`] makes
//! and writes those of a map.
//!
//! The core makes pictures, rasters and features; here they become files, also for game engines and geographic
//! information systems.
//!
//! ```
//! use riverseed::Session;
//! use riverseed_exchange::{Files, Form, Options};
//!
//! let map = Session::new("seed=kauri&attractors=300".parse()?)?.finish()?;
//! let (forms, options) = ([Form::Png, Form::Svg], Options { size: Some(300), ..Options::default() });
//! let picture = options.picture(&forms, &map.domain())?;
//! let mut files = Files::make(map, &forms, options, picture)?;
//! while files.paint_part() {}
//! for form in forms {
//!     let mut bytes = Vec::new();
//!     files.write(form, &mut bytes)?;
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! All files are in the map's own scale (`riverseed::scale`): as many kilometres wide as the recipe's span.
//!
//! As wasm it is empty: no page writes these files.
#![cfg(not(target_arch = "wasm32"))]

pub mod engine;
mod files;
mod form;
mod found;
pub mod gis;
pub mod memory;
mod options;
mod plot;
mod rasters;
mod write;
mod xml;

pub use files::{Files, FilesError};
pub use form::{Engine, Form, Readers};
pub use found::Found;
pub use options::{Options, SIZE, Setting, is_ratio};
pub use plot::Sheet;
pub use rasters::check_size;
pub use write::{Source, write};
