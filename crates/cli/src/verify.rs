//! `riverseed verify`: checks that this machine gives the same bits as all others.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};
use riverseed::digest::{COMMITTED, digest};
use riverseed::recipe::link;

use super::Failure;

/// Grows and paints all recipes and compares their digests with the committed ones, or with those of a file.
pub fn verify(path: Option<&Path>) -> Result<(), Failure> {
    let text = match path {
        Some(path) => fs::read_to_string(path).map_err(Failure::file(path))?,
        None => COMMITTED.into(),
    };
    let lines = lines(&text).map_err(Failure::file(path.unwrap_or(Path::new("tests/digest.txt"))))?;
    let progress = progress(lines.len());
    let mut differing = 0;
    for (expected, text) in &lines {
        let found = digest(&link::read(text)?)?;
        if found != *expected {
            progress.suspend(|| writeln!(io::stdout(), "{text}: {found}, not {expected}"))?;
            differing += 1;
        }
        progress.inc(1);
    }
    progress.finish_and_clear();
    let all = lines.len();
    if differing > 0 {
        return Err(Failure::Differs { differing, all });
    }
    writeln!(
        io::stdout(),
        "the same bits: {all} of {all} recipes give the rivers, pixels and files that they give everywhere"
    )?;
    Ok(())
}

/// Reads the digests of a text with their links.
fn lines(text: &str) -> io::Result<Vec<(&str, &str)>> {
    let wrong = |why: String| io::Error::new(io::ErrorKind::InvalidData, why);
    let lines = text.lines().zip(1..).map(|(line, number)| {
        let parts = line.split_once(' ').filter(|(digest, _)| digest.len() == 16);
        parts.ok_or_else(|| wrong(format!("line {number} is no digest of 16 digits, a space and a link")))
    });
    let lines = lines.collect::<Result<Vec<_>, _>>()?;
    if lines.is_empty() { Err(wrong("there are no digests in it".into())) } else { Ok(lines) }
}

/// Makes a progress bar on standard error; invisible if that is not a terminal.
fn progress(recipes: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("recipe {pos} of {len} {wide_bar} {percent}%");
    ProgressBar::new(recipes as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
