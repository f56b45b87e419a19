//! Requests for memory before it is used, so that a shortage is an error instead of an abort.

use std::io::{Error, ErrorKind, Result};

/// Checks that bytes that are needed soon can be allocated.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn ask(bytes: usize) -> Result<()> {
    let megabytes = bytes / 1_000_000 + 1;
    let refused = || format!("the file needs about {megabytes} MB, and the allocation failed");
    Vec::<u8>::new().try_reserve_exact(bytes).map_err(|_| Error::new(ErrorKind::OutOfMemory, refused()))
}
