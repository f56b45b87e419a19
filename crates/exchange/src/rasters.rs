//! The rasters that a file is made from: square ones for an engine, else those of the map.

use riverseed::Map;
use riverseed::domain::Domain;
use riverseed::export::rasters::Rasters;

use crate::engine::{self, EngineError};
use crate::form::Form;
use crate::options::Options;

/// Checks the longer side of rasters for files of these forms, before anything grows. Engines have the fewest sizes, so
/// they are asked first: what they refuse with lists sizes that are possible.
///
/// # Errors
/// Fails if an engine has no such landscapes, or the map no such rasters.
pub fn check_size(forms: &[Form], domain: &Domain, size: u32) -> Result<(), EngineError> {
    forms.iter().try_for_each(|form| match form {
        Form::Engine(engine) => engine::check(*engine, domain, size),
        _ => Ok(()),
    })?;
    Ok(Rasters::grid(domain, size).map(drop)?)
}

/// Makes the rasters for a file. `None` for forms that hold no rasters.
///
/// # Errors
/// Fails if the size is not possible, or if there is not enough memory.
pub(crate) fn rasters(form: Form, map: &Map, options: &Options) -> Result<Option<Rasters>, EngineError> {
    let (size, threads) = (options.raster_size, options.threads());
    match form {
        Form::Engine(engine) => engine::rasters(map, engine, size, threads).map(Some),
        form if form.has_rasters() => {
            let sized = |size| Rasters::with_size_on(map, size, threads);
            Ok(Some(size.map_or_else(|| Rasters::new(map), sized)?))
        }
        _ => Ok(None),
    }
}
