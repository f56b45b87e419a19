//! The forms of files, by the endings of paths.

use std::path::Path;

pub use riverseed::export::Form;

use super::Failure;

/// The form for the ending of a path.
///
/// # Errors
/// Fails if the ending is not known, or if the path is that of a folder.
pub fn form_of(path: &Path) -> Result<Form, Failure> {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    // `Path::file_name` ignores a last separator with nothing or a dot behind it.
    if !path.as_os_str().as_encoded_bytes().ends_with(name.as_bytes()) {
        return Err(Failure::Folder { path: path.into() });
    }
    Form::of_file(name).ok_or_else(|| Failure::Ending { path: path.into() })
}

/// The endings of some forms, for messages.
pub fn listed(forms: &[Form]) -> String {
    forms.iter().map(|form| format!(".{}", form.name())).collect::<Vec<_>>().join(", ")
}
