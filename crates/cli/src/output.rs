//! The file that a call writes: whole or not at all, whatever ends the process.
//!
//! On Linux it has no name while it is written, so that no signal leaves a part of it. Elsewhere, and on file systems
//! that know no such files, it is begun only when the rivers have grown, under a passing name.

use std::fs::{self, File, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::Failure;

/// A place to write to.
pub struct Output {
    /// As it was given, for messages.
    given: PathBuf,
    way: Way,
}

enum Way {
    /// The output replaces a file, if there is one, and keeps its permissions.
    Replace { path: PathBuf, permissions: Option<Permissions>, unnamed: Option<File> },
    /// The path is not a file that could be replaced, but a pipe, a device, or a link to nothing.
    Through,
}

impl Output {
    /// Looks at what there is, before the work begins, and leaves nothing behind.
    ///
    /// # Errors
    /// If nothing can be written there.
    pub fn open(given: &Path) -> Result<Self, Failure> {
        let way = Way::of(given).map_err(Failure::file(given))?;
        Ok(Self { given: given.into(), way })
    }

    /// Whether it will be a file, and nothing that somebody reads while it is written.
    pub fn is_file(&self) -> bool {
        matches!(self.way, Way::Replace { .. })
    }

    /// Writes it.
    pub fn write(self, write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> Result<(), Failure> {
        let Self { given, way } = self;
        match way {
            Way::Replace { path, permissions, unnamed: Some(file) } => {
                let file = filled(file, &given, write)?;
                publish(&file, &path, permissions).map_err(Failure::file(&given))
            }
            Way::Replace { path, permissions, unnamed: None } => {
                let file = filled(named(&path).map_err(Failure::file(&given))?, &given, write)?;
                replace(file, &path, permissions).map_err(Failure::file(&given))
            }
            Way::Through => {
                let file = File::options().write(true).create(true).truncate(true).open(&given);
                filled(file.map_err(Failure::file(&given))?, &given, write).map(drop)
            }
        }
    }
}

impl Way {
    fn of(given: &Path) -> io::Result<Self> {
        let is_link = given.is_symlink();
        let there = match fs::metadata(given) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            there => Some(there?),
        };
        match there {
            Some(there) if there.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            Some(there) if !there.is_file() => Ok(Self::Through),
            None if is_link => Ok(Self::Through),
            there => {
                let path = if is_link { fs::canonicalize(given)? } else { given.to_owned() };
                fs::metadata(folder(&path))?; // so that a missing folder is reported before the work
                let unnamed = unnamed(folder(&path))?;
                Ok(Self::Replace { path, permissions: there.map(|there| there.permissions()), unnamed })
            }
        }
    }
}

/// Whether a path is that of a pipe, which waits for somebody to read it.
#[cfg(unix)]
pub fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;

    fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo())
}

#[cfg(not(unix))]
pub fn is_pipe(_: &Path) -> bool {
    false
}

/// The folder that a file lies in.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes into a file, and gives it back.
fn filled<Target: Write>(
    file: Target,
    given: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
) -> Result<Target, Failure> {
    let mut out = Watched { out: BufWriter::new(file), error: None };
    write(&mut out).map_err(|failure| match (failure, out.error) {
        (Failure::Output(_), Some(code)) => Failure::file(given)(io::Error::from_raw_os_error(code)),
        (Failure::Output(error), None) => Failure::file(given)(error),
        (failure, _) => failure,
    })?;
    out.out.into_inner().map_err(|error| Failure::file(given)(error.into_error()))
}

/// A writer that keeps the system's error, of which encoders hand on the text alone: a full disk is to be known as one.
struct Watched<Target: Write> {
    out: BufWriter<Target>,
    error: Option<i32>,
}

impl<Target: Write> Write for Watched<Target> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes).inspect_err(|error| self.error = error.raw_os_error())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush().inspect_err(|error| self.error = error.raw_os_error())
    }
}

/// A file without a name; `None` where the system has no such files.
///
/// # Errors
/// If no file can be written in the folder.
#[cfg(target_os = "linux")]
fn unnamed(folder: &Path) -> io::Result<Option<File>> {
    use std::os::unix::fs::OpenOptionsExt;

    use rustix::fs::OFlags;
    use rustix::io::Errno;

    if !Path::new(NAMES_OF_FILES).is_dir() {
        return Ok(None);
    }
    let flags = OFlags::TMPFILE.bits() as i32;
    match File::options().read(true).write(true).mode(0o666).custom_flags(flags).open(folder) {
        Ok(file) => Ok(Some(file)),
        // How file systems and kernels answer that know no such files.
        Err(error) if matches!(Errno::from_io_error(&error), Some(Errno::OPNOTSUPP | Errno::ISDIR | Errno::INVAL)) => {
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

#[cfg(not(target_os = "linux"))]
#[expect(clippy::unnecessary_wraps, reason = "as on Linux")]
fn unnamed(_: &Path) -> io::Result<Option<File>> {
    Ok(None)
}

/// Where Linux names the open files of a process.
#[cfg(target_os = "linux")]
const NAMES_OF_FILES: &str = "/proc/self/fd";

/// Puts a file without a name in its place. A name cannot be given to another file at once, so this one has a passing name
/// for a moment.
#[cfg(target_os = "linux")]
fn publish(file: &File, path: &Path, permissions: Option<Permissions>) -> io::Result<()> {
    use std::os::fd::AsRawFd;

    use rustix::fs::{AtFlags, CWD, linkat};

    if let Some(permissions) = permissions {
        file.set_permissions(permissions)?;
    }
    let own = format!("{NAMES_OF_FILES}/{}", file.as_raw_fd());
    let named = builder().make_in(folder(path), |name| Ok(linkat(CWD, &*own, CWD, name, AtFlags::SYMLINK_FOLLOW)?))?;
    Ok(named.into_temp_path().persist(path)?)
}

#[cfg(not(target_os = "linux"))]
fn publish(_: &File, _: &Path, _: Option<Permissions>) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A file under a passing name.
fn named(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = builder();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path))
}

fn builder() -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(".riverseed-");
    builder
}

/// Puts a file under a passing name in its place.
fn replace(file: NamedTempFile, path: &Path, permissions: Option<Permissions>) -> io::Result<()> {
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    Ok(file.persist(path).map(drop)?)
}
