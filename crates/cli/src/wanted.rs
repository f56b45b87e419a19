//! The files that a call asks for.

use std::path::Path;

use riverseed_exchange::Form;

use super::Failure;
use super::form::form_of;

/// A requested file.
pub struct Wanted<'a> {
    pub form: Form,
    /// `None` for standard output.
    pub path: Option<&'a Path>,
}

impl<'a> Wanted<'a> {
    /// Reads the path of an output.
    ///
    /// # Errors
    /// Fails if the ending is not known, or if the path is that of a folder.
    pub fn of(path: &'a Path) -> Result<Self, Failure> {
        match path.to_str() {
            Some("-") => Ok(Self { form: Form::Json, path: None }),
            _ => Ok(Self { form: form_of(path)?, path: Some(path) }),
        }
    }
}
