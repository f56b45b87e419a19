//! Calls of the command line, and their output.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

pub fn riverseed(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_riverseed")).args(arguments).output().unwrap()
}

/// Makes a path for this test.
pub fn scratch(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("command-line");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

pub fn network(name: &str, arguments: &[&str]) -> serde_json::Value {
    let out = scratch(name);
    let output = riverseed(&[&["render", "-o", out.to_str().unwrap()], arguments].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&fs::read(out).unwrap()).unwrap()
}

pub fn refusal(arguments: &[&str]) -> (i32, String) {
    let output = riverseed(arguments);
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}
