//! The output file of a call. It is written completely or not at all, whatever ends the process.
//!
//! On Linux the file has no name while it is written, so no signal leaves a part of it. Elsewhere, and on file systems
//! without such files, writing begins only after the rivers have grown, under a temporary name.

use std::fs::{self, File, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::Failure;

/// A destination for output.
pub struct Output {
    /// The path as it was given, for messages.
    given: PathBuf,
    way: Way,
}

enum Way {
    /// The output replaces the file, if there is one, and keeps its permissions.
    Replace { path: PathBuf, permissions: Option<Permissions>, unnamed: Option<File> },
    /// The path is not a file that can be replaced, but a pipe, a device, or a broken link.
    Through,
}

impl Output {
    /// Checks the destination before the work begins, and leaves nothing behind.
    ///
    /// # Errors
    /// Fails if nothing can be written there.
    pub fn open(given: &Path) -> Result<Self, Failure> {
        let way = Way::of(given).map_err(Failure::file(given))?;
        Ok(Self { given: given.into(), way })
    }

    /// Returns `true` if the output will be a file, and not a stream that is read while it is written.
    pub fn is_file(&self) -> bool {
        matches!(self.way, Way::Replace { .. })
    }

    /// Writes the output.
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

/// Returns `true` if a path is that of a pipe, which would wait for a reader.
#[cfg(unix)]
pub fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;

    fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo())
}

#[cfg(not(unix))]
pub fn is_pipe(_: &Path) -> bool {
    false
}

/// Returns the folder that contains a file.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes into a target and returns it.
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

/// A writer that keeps the system's error. Encoders pass on only its text, but a full disk must be recognized as one.
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

/// Opens a file without a name; `None` where the system has no such files.
///
/// # Errors
/// Fails if no file can be written in the folder.
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
        // The answers of file systems and kernels without such files.
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

/// The folder in which Linux lists the open files of a process.
#[cfg(target_os = "linux")]
const NAMES_OF_FILES: &str = "/proc/self/fd";

/// Gives a file without a name its place. Such a file cannot replace another one directly, so it has a temporary name
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

/// Opens a file under a temporary name.
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

/// Moves a file from its temporary name to its place.
fn replace(file: NamedTempFile, path: &Path, permissions: Option<Permissions>) -> io::Result<()> {
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    Ok(file.persist(path).map(drop)?)
}
