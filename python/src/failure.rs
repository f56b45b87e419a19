//! What can go wrong, as the exceptions of Python: a recipe or an option that is no good is a `ValueError`, too little memory a
//! `MemoryError`. The words are the library's own, which name the key, the value and what is allowed.

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

/// Why there is no map.
pub enum Failure {
    /// The recipe or an option is refused.
    Refused(String),
    /// There is not enough memory.
    OutOfMemory(String),
    /// Anything else.
    Other(String),
}

/// What a function of the library returned.
pub type Done<T> = Result<T, Failure>;

impl Failure {
    /// The same, of this option.
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

/// Writing to memory fails for the library's own reasons only.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.get_ref().and_then(|inner| inner.downcast_ref::<ExportError>()) {
            Some(export) => (*export).into(),
            None if error.kind() == io::ErrorKind::OutOfMemory => Self::OutOfMemory(error.to_string()),
            None => Self::Other(error.to_string()),
        }
    }
}
