//! `riverseed page` in a folder with other files: it replaces and removes what it wrote itself, and nothing else.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

#[cfg(unix)]
use crate::command::ended;
use crate::command::{riverseed, scratch};

const RIVERSEED: &str = env!("CARGO_BIN_EXE_riverseed");
const LINK: &str = "attractors=300&seed=a";
/// A line of every page that this command writes. Other pages may have it, too.
const GENERATOR: &str = "<meta name=\"generator\" content=\"riverseed page\" />";

/// Makes a folder for a test, with one for the element in it.
fn workshop(name: &str) -> PathBuf {
    let folder = scratch("page-owns").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("files")).unwrap();
    for file in ["river-seed.js", "core.wasm"] {
        fs::write(folder.join("files").join(file), file).unwrap();
    }
    folder
}

/// Calls the command for the folder `out`, with the element's files or `--no-element`.
fn write(workshop: &Path, has_element: bool, options: &[&str]) -> (i32, String) {
    let (out, files) = (workshop.join("out"), workshop.join("files"));
    let element = if has_element { vec!["--element", files.to_str().unwrap()] } else { vec!["--no-element"] };
    let call = ["page", LINK, "-o", out.to_str().unwrap(), "--size", "256"];
    let output = riverseed(&[&call[..], &element, options].concat());
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn written(workshop: &Path, has_element: bool, options: &[&str]) -> String {
    let (code, said) = write(workshop, has_element, options);
    assert_eq!(code, 0, "{said}");
    said
}

fn refused(workshop: &Path, has_element: bool, name: &str) {
    let before = contents(workshop);
    let (code, said) = write(workshop, has_element, &[]);
    let path = workshop.join("out").join(name);
    assert!(code == 1 && said.contains(path.to_str().unwrap()) && said.contains("--replace"), "{name}: {code}, {said}");
    assert!(contents(workshop) == before, "{name}: nothing is written");
}

/// Reads all files below a folder, and where links lead, which are not followed.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let (path, kind) = (entry.path(), entry.file_type().unwrap());
        if kind.is_dir() {
            found.extend(contents(&path));
        } else if kind.is_symlink() {
            found.insert(path.clone(), fs::read_link(&path).unwrap().into_os_string().into_encoded_bytes());
        } else {
            found.insert(path.clone(), fs::read(&path).unwrap());
        }
    }
    found
}

#[test]
fn files_of_others_are_kept_unless_they_are_to_be_replaced() {
    let names = ["index.html", "map.png", "page.css", "element", "element/river-seed.js", "riverseed-page.json"];
    for (i, name) in names.into_iter().enumerate() {
        let workshop = workshop(&format!("other-{i}"));
        let path = workshop.join("out").join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, GENERATOR).unwrap();
        refused(&workshop, true, name);
        written(&workshop, true, &["--replace"]);
        assert!(
            path.is_dir() == (name == "element") && (path.is_dir() || fs::read(&path).unwrap() != GENERATOR.as_bytes())
        );
        written(&workshop, true, &[]);
    }
}

#[test]
fn files_that_no_page_needs_are_no_hindrance_and_stay() {
    let workshop = workshop("beside");
    let mine = ["mine.txt", ".htaccess", "element/mine.js", "oembed.json"].map(|name| workshop.join("out").join(name));
    fs::create_dir_all(workshop.join("out/element")).unwrap();
    mine.iter().for_each(|path| fs::write(path, "mine").unwrap());
    for has_element in [true, false] {
        written(&workshop, has_element, &[]);
        mine.iter().for_each(|path| assert_eq!(fs::read_to_string(path).unwrap(), "mine", "{}", path.display()));
        assert_eq!(workshop.join("out/element/core.wasm").exists(), has_element);
    }
}

#[test]
fn nothing_of_an_earlier_page_stays_that_the_new_one_does_not_have() {
    let workshop = workshop("again");
    written(&workshop, true, &["--address", "https://example.org/"]);
    let names =
        |folder: &Path| contents(folder).into_keys().filter(|path| path.starts_with(workshop.join("out"))).count();
    assert_eq!(names(&workshop), 8 + 1 + 2);
    written(&workshop, false, &[]);
    assert_eq!(names(&workshop), 8);
    assert!(!workshop.join("out/element").exists());
}

#[test]
fn file_that_somebody_has_changed_is_theirs() {
    let workshop = workshop("changed");
    written(&workshop, true, &[]);
    let (page, script) = (workshop.join("out/index.html"), workshop.join("out/element/river-seed.js"));
    let whole = fs::read(&page).unwrap();
    fs::write(&page, [&whole[..], b"<!-- mine -->"].concat()).unwrap();
    refused(&workshop, true, "index.html");
    fs::write(&page, whole).unwrap();
    fs::write(&script, "mine").unwrap();
    refused(&workshop, true, "element/river-seed.js");
    let said = written(&workshop, false, &[]);
    assert!(said.contains("river-seed.js: was changed since"), "{said}");
    assert_eq!(fs::read_to_string(&script).unwrap(), "mine");
    assert!(!workshop.join("out/element/core.wasm").exists());
}

#[test]
fn folder_in_the_place_of_a_file_is_named_and_never_replaced() {
    let workshop = workshop("folder");
    fs::create_dir_all(workshop.join("out/map.png")).unwrap();
    for options in [&[][..], &["--replace"]] {
        let (code, said) = write(&workshop, false, options);
        assert!(code == 2 && said.contains("map.png: this is the path of a folder"), "{code}, {said}");
    }
}

#[cfg(unix)]
#[test]
fn nothing_is_removed_or_written_through_a_link() {
    use std::os::unix::fs::symlink;

    let workshop = workshop("links");
    let (mine, out) = (workshop.join("mine"), workshop.join("out"));
    fs::create_dir_all(&mine).unwrap();
    // The element's own files, and a page of this command: nothing about them is strange but that they lie elsewhere.
    written(&workshop, true, &[]);
    for file in ["index.html", "riverseed-page.json", "element/river-seed.js", "element/core.wasm"] {
        fs::copy(out.join(file), mine.join(Path::new(file).file_name().unwrap())).unwrap();
    }
    fs::write(mine.join("app.js"), "mine").unwrap();
    let before = contents(&mine);
    fs::remove_dir_all(out.join("element")).unwrap();
    symlink("../mine", out.join("element")).unwrap();
    refused(&workshop, true, "element");
    let said = written(&workshop, false, &[]);
    assert!(said.contains("stays"), "{said}");
    assert!(contents(&mine) == before && out.join("element").is_symlink(), "without the element");
    for file in ["index.html", "riverseed-page.json"] {
        fs::remove_file(out.join(file)).unwrap();
        symlink(Path::new("../mine").join(file), out.join(file)).unwrap();
        refused(&workshop, false, file);
        written(&workshop, false, &["--replace"]);
        assert!(contents(&mine) == before && !out.join(file).is_symlink(), "{file}: the link itself is replaced");
    }
    written(&workshop, true, &["--replace"]);
    assert!(contents(&mine) == before && !out.join("element").is_symlink(), "and that of the element");
}

#[cfg(unix)]
#[test]
fn pipe_in_the_place_of_a_file_is_named_and_holds_nothing_up() {
    for (i, name) in ["index.html", "map.png", "element", "riverseed-page.json"].into_iter().enumerate() {
        let workshop = workshop(&format!("pipe-{i}"));
        let out = workshop.join("out");
        // A page of this command, whose list names all files.
        written(&workshop, true, &[]);
        if name == "element" { fs::remove_dir_all(out.join(name)) } else { fs::remove_file(out.join(name)) }.unwrap();
        assert!(Command::new("mkfifo").arg(out.join(name)).status().unwrap().success());
        let mut call = Command::new(RIVERSEED);
        call.args(["page", LINK, "--size", "256", "--element"]).arg(workshop.join("files")).arg("-o").arg(&out);
        let (code, said) = ended(&mut call);
        assert!(code == 1 && said.contains(out.join(name).to_str().unwrap()), "{name}: {code}, {said}");
        let (code, said) = ended(call.arg("--replace"));
        assert!(code == 0 && !is_pipe(&out.join(name)), "{name}: {said}");
    }
}

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;

    fs::symlink_metadata(path).unwrap().file_type().is_fifo()
}

/// Calls the command where no file may be larger than a few kilobytes. The system ends a program that writes a larger one, unless it
/// does not listen.
#[cfg(unix)]
fn write_little(workshop: &Path, listens: bool) -> Output {
    let trap = if listens { "" } else { "trap '' XFSZ; " };
    let limited = format!("{trap}ulimit -c 0; ulimit -f 8; exec \"$@\"");
    let mut call = Command::new("sh");
    call.args(["-c", &limited, "sh", RIVERSEED, "page", LINK, "--size", "700", "--no-element", "-o"]);
    call.arg(workshop.join("out")).output().unwrap()
}

#[cfg(unix)]
#[test]
fn call_that_fails_or_is_ended_while_it_writes_leaves_the_old_page_whole_and_the_next_goes_on() {
    let workshop = workshop("ended");
    let out = workshop.join("out");
    let beside = |found: &BTreeMap<PathBuf, Vec<u8>>| found.keys().filter(|path| is_hidden(path)).count();
    for has_page in [false, true] {
        let before = if out.exists() { contents(&out) } else { BTreeMap::new() };
        let output = write_little(&workshop, false);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(1) && said.contains("File too large"), "{said}");
        assert!(contents(&out) == before, "{has_page}: a failure");
        assert_eq!(write_little(&workshop, true).status.code(), None, "ended by a signal");
        let mut after = contents(&out);
        assert!(beside(&after) > 0, "the new page is made beside");
        after.retain(|path, _| !is_hidden(path));
        assert!(after == before, "{has_page}: a signal");
        written(&workshop, false, &[]);
        let after = contents(&out);
        assert_eq!((beside(&after), after.len()), (0, 8));
    }
}

/// Returns `true` for a file in a folder whose name begins with a dot.
#[cfg(unix)]
fn is_hidden(path: &Path) -> bool {
    path.parent().and_then(Path::file_name).is_some_and(|name| name.to_string_lossy().starts_with('.'))
}

#[test]
fn own_folder_in_which_files_are_missing_is_completed() {
    let workshop = workshop("missing");
    written(&workshop, true, &[]);
    let whole = contents(&workshop);
    for missing in [&["index.html"][..], &["map.png", "element/core.wasm"], &["index.html", "embed.html", "map.jpg"]] {
        missing.iter().for_each(|name| fs::remove_file(workshop.join("out").join(name)).unwrap());
        written(&workshop, true, &[]);
        assert!(contents(&workshop) == whole, "{missing:?}");
    }
}

#[cfg(unix)]
#[test]
fn page_keeps_the_permissions_of_its_files() {
    use std::os::unix::fs::PermissionsExt;

    let workshop = workshop("permissions");
    let page = workshop.join("out/index.html");
    written(&workshop, false, &[]);
    fs::set_permissions(&page, fs::Permissions::from_mode(0o640)).unwrap();
    written(&workshop, false, &["--title", "Home"]);
    assert_eq!(fs::metadata(&page).unwrap().permissions().mode() & 0o777, 0o640);
}
