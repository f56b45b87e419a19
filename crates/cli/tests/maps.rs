//! Calls of `riverseed render`, each in its own folder, and the files that they write.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub const RIVERSEED: &str = env!("CARGO_BIN_EXE_riverseed");
/// Small maps that are made quickly.
pub const LINK: &str = "country=usual&land=island&attractors=100&style=ink";

/// All forms of a file but the packs of engines, whose rasters have sizes of their own.
pub const FORMS: [&str; 28] = [
    "json",
    "geojson",
    "svg",
    "plot.svg",
    "png",
    "zip",
    "heights.png",
    "land.png",
    "rivers.png",
    "flow.png",
    "basins.png",
    "water.png",
    "depth.png",
    "r16",
    "normals.png",
    "splat.png",
    "splines.json",
    "glb",
    "gpkg",
    "tif",
    "heights.tif",
    "land.tif",
    "rivers.tif",
    "flow.tif",
    "basins.tif",
    "water.tif",
    "depth.tif",
    "heights.qml",
];

/// The packs of engines.
pub const ENGINES: [&str; 3] = ["unreal.zip", "unity.zip", "godot.zip"];

/// Makes an empty folder for a test.
pub fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("batch").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Calls `riverseed render` in a folder.
pub fn render(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(RIVERSEED).current_dir(folder).arg("render").args(arguments).output().unwrap()
}

/// Returns the standard error of a call that succeeds.
pub fn said(folder: &Path, arguments: &[&str]) -> String {
    let output = render(folder, arguments);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    said
}

/// Returns the exit code and the standard error of a call.
pub fn outcome(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = render(folder, arguments);
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// Reads the files of a folder, by name, except those that a killed call had not yet renamed.
pub fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<_> =
        entries.map(|entry| (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())).collect();
    files.retain(|(name, _)| !name.starts_with(".riverseed-"));
    files.sort();
    files
}

/// Lists the names of a folder's files.
pub fn names(folder: &Path) -> Vec<String> {
    files(folder).into_iter().map(|(name, _)| name).collect()
}
