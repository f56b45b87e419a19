//! The beginnings and the ends of files that are there.

use std::fs::File;
use std::io::{Read, Result, Seek, SeekFrom};

/// The greatest distance of a link from the beginning of a file, in bytes: it may follow a seed as a title, or a few
/// small chunks.
pub const NEAR: usize = 2048;

/// Returns `true` if a file begins and ends with these texts.
pub fn is_between(file: &mut File, head: &str, tail: &str) -> Result<bool> {
    Ok(ends_with(file, tail.as_bytes())? && start(file, head.len())? == head.as_bytes())
}

/// Returns `true` if a file of markup begins and ends with these texts, and has a part near its beginning.
pub fn is_marked(file: &mut File, head: &str, part: &str, tail: &str) -> Result<bool> {
    let start = start(file, part.len() + NEAR)?;
    Ok(ends_with(file, tail.as_bytes())? && start.starts_with(head.as_bytes()) && contains(&start, part.as_bytes()))
}

/// Returns `true` if a file ends with these bytes.
pub fn ends_with(file: &mut File, end: &[u8]) -> Result<bool> {
    if file.metadata()?.len() < end.len() as u64 {
        return Ok(false);
    }
    file.seek(SeekFrom::End(-(end.len() as i64)))?;
    Ok(start_here(file, end.len())? == end)
}

/// Reads the beginning of a file, up to a length.
pub fn start(file: &mut File, length: usize) -> Result<Vec<u8>> {
    file.rewind()?;
    start_here(file, length)
}

fn start_here(file: &mut File, length: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::with_capacity(length);
    file.take(length as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Returns `true` if bytes contain others.
pub fn contains(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}
