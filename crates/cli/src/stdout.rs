//! Standard output that nobody gave.
//!
//! Before `main`, Rust opens the null device, for reading and writing, in place of a standard output that is closed (`>&-`), and writing
//! there never fails. A shell's `>/dev/null` opens it for writing only, and so can be told apart. Some programs hand the null device to
//! theirs as Rust opens it; they are told the same, since nobody could read what is printed there either.

use super::Failure;

/// Whether what is printed goes anywhere: asked before the work begins by commands that do nothing but print. On systems other than
/// Linux it is not known.
///
/// # Errors
/// If standard output is closed.
pub fn check() -> Result<(), Failure> {
    if is_closed() { Err(Failure::Closed) } else { Ok(()) }
}

#[cfg(target_os = "linux")]
fn is_closed() -> bool {
    use rustix::fs::{FileType, OFlags, fcntl_getfl, fstat, stat};

    let out = std::io::stdout();
    let (Ok(flags), Ok(own), Ok(null)) = (fcntl_getfl(&out), fstat(&out), stat("/dev/null")) else { return false };
    let is_null = FileType::from_raw_mode(own.st_mode) == FileType::CharacterDevice && own.st_rdev == null.st_rdev;
    is_null && flags.contains(OFlags::RDWR)
}

#[cfg(not(target_os = "linux"))]
fn is_closed() -> bool {
    false
}
