//! The forms of files, by the endings of paths.

use std::path::Path;

use riverseed_exchange::{Form, Readers};

use super::Failure;

/// Finds the form for the ending of a path.
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

/// Lists the last endings of all forms, without those before them, as in `heights.png`.
pub fn last_endings() -> String {
    listed(&Form::all().filter(|form| !form.name().contains('.')).collect::<Vec<_>>())
}

/// Explains all endings for the help.
pub fn help() -> String {
    let [any, engines, gis] = [Readers::Any, Readers::Engines, Readers::Gis]
        .map(|readers| listed(&Form::all().filter(|form| form.readers() == readers).collect::<Vec<_>>()));
    format!(
        "A file to write, in the form of its ending: {any} (.zip is a game pack, and .heights.png one of its rasters); \
         for GIS {gis}; for game engines {engines}; or - for JSON on standard output, one line per map. Repeat the \
         option for several files: each map is grown only once"
    )
}

/// Lists the endings of some forms, for messages.
pub fn listed(forms: &[Form]) -> String {
    forms.iter().map(|form| format!(".{}", form.name())).collect::<Vec<_>>().join(", ")
}
