//! The forms of files, as paths and messages have them.

use std::path::Path;

pub use riverseed::export::Form;

use super::Failure;

/// The form that a path's ending names.
///
/// # Errors
/// If it names none, or the path is that of a folder.
pub fn form_of(path: &Path) -> Result<Form, Failure> {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    // A file's name leaves out what stands behind the last separator, if that is nothing, or a dot.
    if !path.as_os_str().as_encoded_bytes().ends_with(name.as_bytes()) {
        return Err(Failure::Folder { path: path.into() });
    }
    Form::of_file(name).ok_or_else(|| Failure::Ending { path: path.into() })
}

/// The endings of some forms, for messages.
pub fn listed(forms: &[Form]) -> String {
    forms.iter().map(|form| format!(".{}", form.name())).collect::<Vec<_>>().join(", ")
}
