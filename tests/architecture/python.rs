//! The modules of a Python package and what each imports, at whatever time and for types alone.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::{Uses, files};

/// Finds the modules of a package in its folder, and those that each imports. The package itself is the root.
pub fn uses(folder: &Path) -> Uses {
    let name_of = |file: &Path| file.file_stem().unwrap().to_str().unwrap().to_owned();
    let files = files(folder, "py").into_iter().map(|file| (name_of(&file), fs::read_to_string(file).unwrap()));
    let files: Vec<_> = files.collect();
    let names: BTreeSet<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let path = |name: &str| if name == "__init__" { Vec::new() } else { vec![name.to_owned()] };
    files.iter().map(|(name, code)| (path(name), imports(code, &names).map(path).collect())).collect()
}

/// The modules named in statements that import.
fn imports<'a>(code: &str, names: &BTreeSet<&'a str>) -> impl Iterator<Item = &'a str> {
    let mut found = BTreeSet::new();
    let mut is_open = false;
    for line in code.lines().map(str::trim_start) {
        if is_open || line.starts_with("from ") || line.starts_with("import ") {
            let words = line.split(|sign: char| !sign.is_alphanumeric() && sign != '_');
            found.extend(words.filter_map(|word| names.get(word).copied()));
            // Lists in brackets go on.
            is_open = (is_open || line.contains('(')) && !line.contains(')');
        }
    }
    found.into_iter()
}

#[test]
fn imports_are_seen_however_they_are_written() {
    let names = BTreeSet::from(["_map", "_words", "_arrays", "widget"]);
    let code = "\
from riverseed import _map
if TYPE_CHECKING:
    from riverseed._words import (
        describe,
    )
def f():
    import riverseed.widget as shown
    return _arrays
";
    assert_eq!(imports(code, &names).collect::<Vec<_>>(), ["_map", "_words", "widget"]);
}
