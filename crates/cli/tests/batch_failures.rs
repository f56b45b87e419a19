//! Batches with obstacles: maps that can be made are made, and the others are named. Nothing hangs, and nothing is lost
//! silently.

use std::fs;
use std::process::{Command, Stdio};

#[cfg(unix)]
use crate::command::ended;
use crate::maps::{self, LINK, RIVERSEED, files, folder, names, outcome, render, said};

#[test]
fn map_that_cannot_be_written_is_named_and_the_others_are_made() {
    let folder = folder("one-fails");
    fs::create_dir(folder.join("3.json")).unwrap();
    let output = render(&folder, &[LINK, "--seeds", "1..5", "-o", "{seed}.json", "-o", "-"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(said.contains("riverseed: seed '3': 3.json: is a directory"), "{said}");
    assert!(said.ends_with("riverseed: maps: 4 made\nriverseed: 1 of 5 maps were not made\n"), "{said}");
    assert_eq!(output.stdout.iter().filter(|byte| **byte == b'\n').count(), 4);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 5);
}

#[cfg(target_os = "linux")]
#[test]
fn full_disk_ends_the_run_with_one_word() {
    let folder = folder("full");
    for form in ["json", "heights.png", "zip"] {
        let link = |seed: u32| std::os::unix::fs::symlink("/dev/full", folder.join(format!("{seed}.{form}"))).unwrap();
        (1..=9).for_each(link);
        let out = format!("{{seed}}.{form}");
        let (code, said) = outcome(&folder, &[LINK, "--seeds", "1..100", "--threads", "1", "-o", &out]);
        assert_eq!(code, 1);
        assert_eq!(
            said,
            format!(
                "riverseed: 1.{form}: No space left on device (os error 28): stopped before all 100 maps were there; the same call \
                 goes on from here\n"
            )
        );
    }
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let mut call = Command::new(RIVERSEED);
    let call = call.args(["render", LINK, "--seeds", "1..100", "-o", "-"]).stdout(full).output().unwrap();
    assert_eq!(call.status.code(), Some(1));
    let said = String::from_utf8(call.stderr).unwrap();
    let word = "riverseed: No space left on device (os error 28): stopped before all 100 maps were there\n";
    assert_eq!(said, word, "lines are made from the start each time");
}

#[test]
fn it_is_no_failure_if_nobody_reads_all_lines() {
    let mut call = Command::new(RIVERSEED);
    call.args(["render", LINK, "--seeds", "1..1000000000", "-o", "-"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = call.spawn().unwrap();
    drop(running.stdout.take());
    let output = running.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && !said.contains("Broken pipe"), "{said}");
}

#[cfg(unix)]
#[test]
fn pipe_in_the_place_of_a_file_is_named_and_holds_nothing_up() {
    let folder = folder("pipe");
    assert!(Command::new("mkfifo").arg(folder.join("2.json")).status().unwrap().success());
    for (more, others) in [(None, "made"), (None, "there before"), (Some("--again"), "made")] {
        let mut call = Command::new(RIVERSEED);
        call.current_dir(&folder).args(["render", LINK, "--seeds", "1..3", "-o", "{seed}.json"]).args(more);
        let said = "riverseed: seed '2': 2.json: is a pipe, and a map of many has to be a file";
        let counted = format!("riverseed: maps: 2 {others}\nriverseed: 1 of 3 maps were not made\n");
        assert_eq!(ended(&mut call), (1, format!("{said}\n{counted}")));
    }
}

/// Opens a standard output that nobody reads.
fn unread() -> std::io::PipeWriter {
    std::io::pipe().unwrap().1
}

#[test]
fn files_are_written_though_nobody_reads_standard_output() {
    let (whole, left) = (folder("read"), folder("unread"));
    let calls: [&[&str]; 3] = [
        &["--seeds", "1..9", "--threads", "1", "-o", "-", "-o", "{seed}.json"],
        &["--seeds", "11..30", "--threads", "4", "-o", "-", "-o", "{seed}.json"],
        &["-o", "-", "-o", "one.json", "-o", "one.svg"],
    ];
    for arguments in calls {
        let mut call = Command::new(RIVERSEED);
        let call = call.current_dir(&left).args(["render", LINK]).args(arguments).stdout(unread());
        let output = call.stderr(Stdio::piped()).output().unwrap();
        let expected = said(&whole, &[&[LINK], arguments].concat());
        assert!(output.status.success() && String::from_utf8(output.stderr).unwrap() == expected, "{arguments:?}");
        assert_eq!(names(&left), names(&whole));
    }
    assert!(files(&left) == files(&whole) && names(&left).len() == 9 + 20 + 2);
}

#[cfg(target_os = "linux")]
#[test]
fn where_no_threads_can_be_had_the_maps_are_made_on_one() {
    let folder = folder("no-threads");
    let made = |seeds: &str| {
        let mut call = Command::new(RIVERSEED);
        // A stack larger than any process can have.
        call.current_dir(&folder).env("RUST_MIN_STACK", (1u64 << 50).to_string());
        call.args(["render", LINK, "--seeds", seeds, "--threads", "1024", "-o", "{seed}.json"]);
        let output = call.output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let said = "riverseed: could start only 1 thread: ";
    let (code, text) = made("1..5");
    assert!(code == Some(0) && text.starts_with(said) && text.ends_with("\nriverseed: maps: 5 made\n"), "{text}");
    assert_eq!(made("6..6"), (Some(0), "riverseed: maps: 1 made\n".into()), "no more threads than maps");
}

#[cfg(unix)]
#[test]
fn each_thread_opens_one_file_at_a_time() {
    let folder = folder("few-files");
    let outputs = maps::FORMS.map(|form| format!("-o {{seed}}.{form}")).join(" ");
    let call = format!("ulimit -n 12; exec {RIVERSEED} render '{LINK}' --seeds 1..4 --threads 2 --size 80 {outputs}");
    let output = Command::new("sh").current_dir(&folder).args(["-c", &call]).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.ends_with("\nriverseed: maps: 4 made\n") && said.matches("seed '").count() == 4, "{said}");
    assert_eq!(names(&folder).len(), 4 * maps::FORMS.len());
}

#[test]
fn what_is_read_is_not_overwritten() {
    let folder = folder("read-and-written");
    let path = |name: &str| folder.join(name);
    let reason = "is read by this call, and not replaced";
    let refused = |arguments: &[&str], name: &str, seed: &str| {
        let before = fs::read(path(name)).unwrap();
        let (code, said) = outcome(&folder, &[&["attractors=100&style=ink"], arguments].concat());
        assert!(code == 1 && said.contains(&format!("riverseed: seed '{seed}': {name}: {reason}\n")), "{said}");
        assert!(said.ends_with("riverseed: maps: 1 made\nriverseed: 1 of 2 maps were not made\n"), "{said}");
        assert!(fs::read(path(name)).unwrap() == before, "{name}");
    };
    fs::write(path("list.json"), "kea\nlist\n").unwrap();
    refused(&["--seeds", "./list.json", "-o", "{seed}.json"], "list.json", "list");
    said(&folder, &[LINK, "--seed", "rimu", "-o", "1.json"]);
    refused(&["--recipe", "1.json", "--seeds", "1..2", "-o", "{seed}.json"], "1.json", "1");
    said(&folder, &[LINK, "-o", "3.land.png"]);
    refused(&["--land", "3.land.png", "--seeds", "3..4", "-o", "{seed}.land.png"], "3.land.png", "3");
}
