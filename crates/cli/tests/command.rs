//! Calls of the command line, and their output.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

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

/// Returns the exit code and the standard error of a call. A call that hangs is ended, and its test fails.
#[cfg(unix)]
pub fn ended(call: &mut Command) -> (i32, String) {
    const LONG_ENOUGH: u32 = 12_000;
    let mut running = call.stderr(Stdio::piped()).spawn().unwrap();
    let ends = (0..LONG_ENOUGH).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(10));
        running.try_wait().unwrap().is_some()
    });
    if !ends {
        running.kill().unwrap();
        panic!("{call:?} hangs");
    }
    let output = running.wait_with_output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}
