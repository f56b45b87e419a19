//! The files that the command line leaves on a disk: a complete file in its place or nothing, even when it is stopped
//! or short of memory.

use std::fs::{self, Permissions};
use std::io::Read;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};

const RIVERSEED: &str = env!("CARGO_BIN_EXE_riverseed");
const PNG: &[u8] = b"\x89PNG";

/// Makes an empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("output").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

fn render(link: &str, out: &Path) -> Output {
    Command::new(RIVERSEED).args(["render", link, "--size", "60", "-o"]).arg(out).output().unwrap()
}

fn draw(out: &Path) {
    let output = render("attractors=100", out);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).unwrap().permissions().mode() & 0o777
}

#[test]
fn permissions_of_a_file_stay_and_those_of_a_new_one_are_as_usual() {
    let folder = folder("modes");
    let (old, new, usual) = (folder.join("old.png"), folder.join("new.png"), folder.join("usual"));
    fs::write(&old, "older").unwrap();
    fs::set_permissions(&old, Permissions::from_mode(0o640)).unwrap();
    fs::write(&usual, "").unwrap();
    draw(&old);
    draw(&new);
    assert!(fs::read(&old).unwrap().starts_with(PNG));
    assert_eq!((mode(&old), mode(&new)), (0o640, mode(&usual)));
    assert_eq!(names(&folder).len(), 3);
}

#[test]
fn link_stays_a_link_and_what_it_leads_to_is_written() {
    let folder = folder("links");
    for (name, is_there) in [("there.png", true), ("not-yet.png", false)] {
        let (target, link) = (folder.join(name), folder.join(format!("to-{name}")));
        if is_there {
            fs::write(&target, "older").unwrap();
        }
        symlink(name, &link).unwrap();
        draw(&link);
        assert!(link.is_symlink() && !target.is_symlink());
        assert!(fs::read(&target).unwrap().starts_with(PNG), "{name}");
    }
    assert_eq!(names(&folder).len(), 4);
}

#[test]
fn pipe_is_written_through() {
    let folder = folder("pipes");
    let pipe = folder.join("pipe.png");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reading = {
        let pipe = pipe.clone();
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            fs::File::open(pipe).unwrap().read_to_end(&mut bytes).unwrap();
            bytes
        })
    };
    draw(&pipe);
    // Checked before reading, which would wait for ever if the pipe is gone.
    assert!(!fs::metadata(&pipe).unwrap().is_file(), "the pipe was replaced");
    assert!(reading.join().unwrap().starts_with(PNG));
}

#[test]
fn full_device_is_an_error_and_stays_a_device() {
    let folder = folder("devices");
    let full = folder.join("full.png");
    symlink("/dev/full", &full).unwrap();
    let output = render("attractors=100", &full);
    assert_eq!(output.status.code(), Some(1));
    assert!(!output.stderr.is_empty() && full.is_symlink());
}

#[test]
fn longest_names_that_a_disk_takes_are_written() {
    let folder = folder("names");
    for length in [250, 251, 255] {
        draw(&folder.join(format!("{}.png", "n".repeat(length - 4))));
    }
    assert_eq!(names(&folder).len(), 3);
}

/// Waits until a process has a file open in a folder, or has ended. Returns `true` if it has one open.
fn is_writing(process: &mut Child, folder: &Path) -> bool {
    let open = PathBuf::from(format!("/proc/{}/fd", process.id()));
    while process.try_wait().unwrap().is_none() {
        let Ok(files) = fs::read_dir(&open) else { continue };
        if files.flatten().any(|file| fs::read_link(file.path()).is_ok_and(|path| path.starts_with(folder))) {
            return true;
        }
    }
    false
}

#[test]
fn signal_leaves_nothing_behind_and_an_older_file_as_it_was() {
    for (signal, number) in [("INT", 2), ("HUP", 1), ("TERM", 15), ("KILL", 9)] {
        let folder = folder(signal);
        let out = folder.join("kept.png");
        fs::write(&out, "older").unwrap();
        let mut process = Command::new(RIVERSEED);
        let mut process = process.args(["render", "attractors=1000000", "-o"]).arg(&out).spawn().unwrap();
        assert!(is_writing(&mut process, &folder), "it ended before it was stopped");
        // The shell always has `kill`.
        let kill = format!("kill -{signal} {}", process.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        // The parent of this test may have made it ignore some signals; it then writes the whole file.
        match process.wait().unwrap().signal() {
            Some(by) => assert!(by == number && fs::read_to_string(&out).unwrap() == "older", "{signal}"),
            None => assert!(fs::read(&out).unwrap().starts_with(PNG), "{signal}"),
        }
        assert_eq!(names(&folder), ["kept.png"], "{signal}");
    }
}

/// Renders with a limit on its address space, in kilobytes; `None` where the shell cannot limit them.
fn render_within(kilobytes: u32, link: &str, out: &Path) -> Option<Output> {
    render_by(&[], kilobytes, link, out)
}

/// Renders like `render_within`, through another program, for example `sudo`.
fn render_by(runner: &[&str], kilobytes: u32, link: &str, out: &Path) -> Option<Output> {
    let limited = format!("ulimit -v {kilobytes} && [ \"$(ulimit -v)\" = {kilobytes} ] || exit 77; exec \"$@\"");
    let shell = ["-c", &limited, "sh"];
    let arguments = [&shell[..], runner, &[RIVERSEED, "render", link, "--size", "600", "-o"]].concat();
    let output = Command::new("sh").args(arguments).arg(out).output().unwrap();
    (output.status.code() != Some(77)).then_some(output)
}

#[test]
fn too_little_memory_is_an_error_and_never_another_picture() {
    check_too_little_memory("memory", "seed=a&growth=colonize&valleys=0&attractors=300000");
    // Half of the cells of the plane lie in the sea.
    check_too_little_memory("valleys", "seed=a&growth=colonize&valleys=0.2&attractors=600000");
}

fn check_too_little_memory(name: &str, link: &str) {
    let folder = folder(name);
    let whole = folder.join("whole.png");
    let Some(output) = render_within(4_000_000, link, &whole) else {
        eprintln!("skipped: this shell cannot limit memory");
        return;
    };
    assert!(output.status.success());
    let whole = fs::read(whole).unwrap();
    let mut refused = 0;
    for kilobytes in [60_000, 70_000, 80_000, 90_000, 110_000] {
        let out = folder.join(format!("{kilobytes}.png"));
        let Some(output) = render_within(kilobytes, link, &out) else { continue };
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        if output.status.success() {
            assert!(fs::read(&out).unwrap() == whole, "{kilobytes}: another picture");
            continue;
        }
        assert_eq!(output.status.code(), Some(1), "{kilobytes}: {said}");
        assert!(said.starts_with("riverseed: ") && said.contains("and the allocation failed"), "{kilobytes}: {said}");
        assert!(!out.exists());
        refused += 1;
    }
    assert!(refused > 2, "no limit was too low");
}

/// Returns a runner that takes away root's power to write into any folder; no runner for other users.
fn as_others() -> &'static [&'static str] {
    let is_root = fs::metadata("/proc/self").unwrap().uid() == 0;
    if is_root { &["setpriv", "--bounding-set=-dac_override"] } else { &[] }
}

#[test]
fn folder_that_refuses_files_is_told_of_before_the_rivers_grow() {
    let folder = folder("refusing");
    fs::set_permissions(&folder, Permissions::from_mode(0o555)).unwrap();
    // With so little memory, growing would fail first if the call came to that.
    let output = render_by(as_others(), 60_000, "attractors=1000000", &folder.join("out.png"));
    fs::set_permissions(&folder, Permissions::from_mode(0o755)).unwrap();
    let Some(output) = output else {
        eprintln!("skipped: this shell cannot limit memory");
        return;
    };
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("out.png: Permission denied"), "{said}");
}
