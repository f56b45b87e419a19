//! The sizes of the landscapes of engines.

use std::io;
use std::num::NonZero;

use riverseed::Map;
use riverseed::domain::Domain;
use riverseed::export::ExportError;
use riverseed::export::rasters::Rasters;
use riverseed::relief::Grid;
use thiserror::Error;

use crate::form::Engine;

/// The sides of landscapes that Unreal's guide recommends: whole components of 2 x 2 sections of 63 quads, plus a row.
const UNREAL: [u32; 4] = [505, 1009, 2017, 4033];
/// Powers of two plus one, for Unity's terrains and those of Godot's add-ons.
const POWERS: [u32; 4] = [513, 1025, 2049, 4097];
/// The place in these lists of the side that is taken unless another one is asked for.
const USUAL: usize = 2;

/// Reasons why there are no rasters for an engine.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum EngineError {
    /// The engine has no such landscapes, or this map has no such rasters.
    #[error("a landscape of this map in {engine} is {sizes} pixels wide, not {size}")]
    Size {
        /// The name of the engine.
        engine: &'static str,
        /// The requested number of pixels.
        size: u32,
        /// The possible ones.
        sizes: String,
    },
    /// There was not enough memory.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl From<EngineError> for io::Error {
    fn from(error: EngineError) -> Self {
        match error {
            EngineError::Export(error) => Self::other(error),
            error => Self::other(error),
        }
    }
}

/// Returns the name of an engine, as it writes it.
pub fn name(engine: Engine) -> &'static str {
    match engine {
        Engine::Unreal => "Unreal Engine",
        Engine::Unity => "Unity",
        Engine::Godot => "Godot",
    }
}

/// Lists the possible sides of a map's landscape in an engine, in pixels.
pub fn sizes(engine: Engine, domain: &Domain) -> Vec<u32> {
    let possible = Grid::sizes(domain);
    of(engine).into_iter().filter(|size| possible.contains(size)).collect()
}

fn of(engine: Engine) -> [u32; 4] {
    if engine == Engine::Unreal { UNREAL } else { POWERS }
}

/// Returns the side of an engine's landscape unless another one is asked for, in pixels.
pub fn usual(engine: Engine) -> u32 {
    of(engine)[USUAL]
}

/// Checks the side of a landscape, before anything grows.
///
/// # Errors
/// Fails if the engine has no such landscapes, or the map no such rasters.
pub fn check(engine: Engine, domain: &Domain, size: u32) -> Result<(), EngineError> {
    let sizes = sizes(engine, domain);
    if sizes.contains(&size) {
        return Ok(());
    }
    let (last, others) = sizes.split_last().map_or((String::new(), String::new()), |(last, others)| {
        (last.to_string(), others.iter().map(|size| format!("{size}, ")).collect())
    });
    let sizes = format!("{} or {last}", others.trim_end_matches(", "));
    Err(EngineError::Size { engine: name(engine), size, sizes })
}

/// Makes the square rasters of a map's landscape in an engine, on a number of threads; they do not depend on it.
///
/// # Errors
/// Fails if the size is not possible, or if there is not enough memory.
pub fn rasters(map: &Map, engine: Engine, size: Option<u32>, threads: NonZero<usize>) -> Result<Rasters, EngineError> {
    let size = size.unwrap_or(usual(engine));
    check(engine, &map.domain(), size)?;
    Ok(Rasters::with_size_on(map, size, threads)?.into_squares()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_those_that_the_engine_and_the_map_have() {
        let square = Domain::with_aspect(1.0);
        assert_eq!(sizes(Engine::Unreal, &square), UNREAL);
        assert_eq!(sizes(Engine::Godot, &Domain::with_aspect(4.0)), [1025, 2049, 4097]);
        for engine in [Engine::Unreal, Engine::Unity, Engine::Godot] {
            assert!(check(engine, &Domain::with_aspect(0.25), of(engine)[USUAL]).is_ok());
        }
        let refused = check(Engine::Unity, &Domain::with_aspect(1.5), 2017).unwrap_err().to_string();
        assert_eq!(refused, "a landscape of this map in Unity is 1025, 2049 or 4097 pixels wide, not 2017");
    }
}
