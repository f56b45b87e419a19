//! The forms of files, as paths and messages have them.

use std::path::Path;

pub use riverseed::export::Form;

use super::Failure;

/// The form that a path's ending names.
///
/// # Errors
/// If it names none.
pub fn form_of(path: &Path) -> Result<Form, Failure> {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    Form::of_file(name).ok_or_else(|| Failure::Ending { path: path.into() })
}

/// The endings of some forms, for messages.
pub fn listed(forms: &[Form]) -> String {
    forms.iter().map(|form| format!(".{}", form.name())).collect::<Vec<_>>().join(", ")
}
