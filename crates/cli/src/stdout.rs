//! Detection of a closed standard output.
//!
//! If standard output is closed (`>&-`), Rust opens the null device in its place before `main`, for reading and
//! writing, and writing to it never fails. A shell's `>/dev/null` opens it for writing only, so it can be told apart.
//! Some programs pass the null device to their children opened like Rust's; those calls fail too, since nobody could
//! read their output either.

use super::Failure;

/// Checks that standard output is open. Commands that only print call it before the work begins. It always succeeds on
/// systems other than Linux, where this cannot be known.
///
/// # Errors
/// Fails if standard output is closed.
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
