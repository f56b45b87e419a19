//! Errors as exceptions of Python: a wrong recipe or option is a `ValueError`, too little memory a `MemoryError`. The
//! messages are the library's, which name the key, the value and what is allowed.

use std::io;

use pyo3::PyErr;
use pyo3::exceptions::{PyMemoryError, PyRuntimeError, PyValueError};
use riverseed::export::ExportError;
use riverseed::grow::GrowError;
use riverseed::network::ShapeError;
use riverseed::paint::PaintError;
use riverseed::recipe::RecipeError;
use riverseed::relief::ReliefError;
use riverseed::session::SessionError;
use riverseed_exchange::FilesError;
use riverseed_exchange::engine::EngineError;

/// The reason why there is no map.
pub enum Failure {
    /// The recipe or an option is refused.
    Refused(String),
    /// There is not enough memory.
    OutOfMemory(String),
    /// Anything else.
    Other(String),
}

/// The result of a function of the library.
pub type Done<T> = Result<T, Failure>;

impl Failure {
    /// Names an option in the error.
    pub fn of_option(self, option: &str) -> Self {
        match self {
            Self::Refused(message) => Self::Refused(format!("{option}: {message}")),
            other => other,
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Refused(message) => PyValueError::new_err(message),
            Failure::OutOfMemory(message) => PyMemoryError::new_err(message),
            Failure::Other(message) => PyRuntimeError::new_err(message),
        }
    }
}

impl From<RecipeError> for Failure {
    fn from(error: RecipeError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<SessionError> for Failure {
    fn from(error: SessionError) -> Self {
        let message = error.to_string();
        match error {
            SessionError::Grow(GrowError::OutOfMemory { .. } | GrowError::NoRoomForRaster { .. })
            | SessionError::Shape(ShapeError::OutOfMemory { .. })
            | SessionError::Relief(ReliefError::OutOfMemory { .. })
            | SessionError::Copy { .. } => Self::OutOfMemory(message),
            _ => Self::Other(message),
        }
    }
}

impl From<PaintError> for Failure {
    fn from(error: PaintError) -> Self {
        let message = error.to_string();
        match error {
            PaintError::Size { .. } => Self::Refused(message),
            PaintError::OutOfMemory { .. } => Self::OutOfMemory(message),
            _ => Self::Other(message),
        }
    }
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        let message = error.to_string();
        match error {
            ExportError::RasterSize { .. } => Self::Refused(message),
            ExportError::OutOfMemory { .. } => Self::OutOfMemory(message),
            _ => Self::Other(message),
        }
    }
}

/// Sizes that an engine or a map does not have are those of the option.
impl From<EngineError> for Failure {
    fn from(error: EngineError) -> Self {
        let failure = match error {
            EngineError::Export(error) => error.into(),
            error => Self::Refused(error.to_string()),
        };
        failure.of_option("raster_size")
    }
}

impl From<FilesError> for Failure {
    fn from(error: FilesError) -> Self {
        match error {
            FilesError::Rasters(error) => error.into(),
            FilesError::Paint(error) => error.into(),
            FilesError::Relief(error) => SessionError::from(error).into(),
            FilesError::Memory(error) => error.into(),
            error => Self::Other(error.to_string()),
        }
    }
}

/// Writing to memory fails only for the library's own reasons.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.get_ref().and_then(|inner| inner.downcast_ref::<ExportError>()) {
            Some(export) => (*export).into(),
            None if error.kind() == io::ErrorKind::OutOfMemory => Self::OutOfMemory(error.to_string()),
            None => Self::Other(error.to_string()),
        }
    }
}
