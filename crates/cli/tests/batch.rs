//! Many maps in one call: the files equal those of single calls to the bit, whatever the threads, shards and
//! interruptions.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use riverseed_exchange::Form;

use crate::maps::{ENGINES, FORMS, LINK, RIVERSEED, files, folder, names, outcome, render, said};

/// The options of the calls.
const OPTIONS: [&str; 4] = ["--size", "80", "--raster-size", "700"];

#[test]
fn forms_tested_are_those_that_the_library_has() {
    let tested: BTreeSet<_> = FORMS.into_iter().chain(ENGINES).collect();
    assert_eq!(tested, Form::all().map(Form::name).collect());
}

#[test]
fn files_are_those_of_single_calls_in_every_form_and_grown_once_for_all_of_them() {
    let (many, single) = (folder("forms"), folder("forms-single"));
    let patterns: Vec<String> = FORMS.iter().map(|form| format!("{{seed}}.{form}")).collect();
    let outputs: Vec<&str> = patterns.iter().flat_map(|pattern| ["-o", pattern]).collect();
    let arguments = [&[LINK, "--seeds", "1..3"], &OPTIONS[..], &outputs[..]].concat();
    assert!(said(&many, &arguments).ends_with("\nriverseed: maps: 3 made\n"));
    for seed in ["1", "2", "3"] {
        for form in FORMS {
            let options = match Form::named(form).map(|form| (form.has_pixels(), form.has_rasters())) {
                Some((true, true)) => &OPTIONS[..],
                Some((true, false)) => &OPTIONS[..2],
                Some((false, true)) => &OPTIONS[2..],
                _ => &[],
            };
            let out = format!("{seed}.{form}");
            said(&single, &[&[LINK, "--seed", seed, "-o", &out], options].concat());
        }
    }
    for ((name, bytes), (_, expected)) in files(&many).iter().zip(files(&single)) {
        assert!(*bytes == expected, "{name}");
    }
    assert_eq!(names(&many), names(&single));
    let known = patterns.iter().filter(|pattern| !pattern.ends_with(".r16"));
    let all_but_raw: Vec<&str> = known.flat_map(|pattern| ["-o", pattern]).collect();
    let arguments = [&[LINK, "--seeds", "1..3"], &OPTIONS[..], &all_but_raw[..]].concat();
    assert_eq!(said(&many, &arguments), "riverseed: maps: 3 there before\n", "each form is known again");
}

#[test]
fn bare_heights_cannot_tell_whose_they_are_and_are_made_again() {
    let folder = folder("raw");
    let arguments = [LINK, "--seeds", "1..2", "-o", "{seed}.r16"];
    let (first, second) = (said(&folder, &arguments), said(&folder, &arguments));
    for seed in ["1", "2"] {
        assert!(first.contains(&format!("riverseed: seed '{seed}': .r16 has 633 x 396 pixels; ")), "{first}");
    }
    assert!(first.ends_with("\nriverseed: maps: 2 made\n") && second.ends_with("\nriverseed: maps: 2 replaced\n"));
}

#[test]
fn packs_of_engines_are_known_again_and_have_sizes_of_their_own() {
    let folder = folder("engines");
    let call = |engine: &str, more: &[&str]| {
        said(
            &folder,
            &[&[LINK, "--aspect", "1", "--seeds", "1..1", "-o", &format!("{{seed}}.{engine}")], more].concat(),
        )
    };
    for (engine, side, other) in
        [("unreal.zip", "505", "1009"), ("unity.zip", "513", "1025"), ("godot.zip", "513", "1025")]
    {
        let sized = |side: &str, size: &str| call(engine, &["--raster-size", side, "--size", size]);
        assert_eq!(sized(side, "60"), "riverseed: maps: 1 made\n");
        assert_eq!(sized(side, "60"), "riverseed: maps: 1 there before\n");
        assert_eq!(sized(side, "61"), "riverseed: maps: 1 replaced\n");
        assert_eq!(sized(other, "61"), "riverseed: maps: 1 replaced\n");
    }
    let refused = outcome(&folder, &[LINK, "--aspect", "1", "--raster-size", "2017", "-o", "x.unity.zip"]);
    let word = "a landscape of this map in Unity is 513, 1025, 2049 or 4097 pixels wide, not 2017";
    assert_eq!(refused, (2, format!("riverseed: --raster-size: {word}\n")));
}

#[test]
fn threads_and_shards_change_no_byte() {
    let calls: [(&str, &[&[&str]]); 4] = [
        ("one-thread", &[&["--threads", "1"]]),
        ("many-threads", &[&["--threads", "7"]]),
        ("shards", &[&["--shard", "3/3"], &["--shard", "1/3", "--threads", "2"], &["--shard", "2/3"]]),
        ("more-shards-than-maps", &[&["--shard", "1/2"], &["--shard", "9/9"], &["--shard", "2/2"]]),
    ];
    let made = calls.map(|(name, options)| {
        let folder = folder(name);
        for more in options {
            said(&folder, &[&[LINK, "--seeds", "1..7", "-o", "map-{seed}.json"], *more].concat());
        }
        files(&folder)
    });
    assert_eq!(made[0].len(), 7);
    assert!(made.iter().all(|files| *files == made[0]));
}

#[test]
fn shards_make_their_own_maps_only() {
    let folder = folder("own-shard");
    said(&folder, &[LINK, "--seeds", "11..20", "--shard", "3/4", "-o", "{seed}.json"]);
    assert_eq!(names(&folder), ["13.json", "17.json"]);
}

#[test]
fn lines_come_in_the_order_of_the_seeds_and_are_the_files() {
    let folder = folder("lines");
    fs::write(folder.join("seeds"), "tui\nkea\nkaka\nweka\nruru\nkiwi\nmoa\n").unwrap();
    let output = render(&folder, &[LINK, "--seeds", "seeds", "--threads", "4", "-o", "-", "-o", "{seed}.json"]);
    assert!(output.status.success());
    let seeds = ["tui", "kea", "kaka", "weka", "ruru", "kiwi", "moa"];
    let expected = seeds.map(|seed| fs::read_to_string(folder.join(format!("{seed}.json"))).unwrap());
    assert_eq!(String::from_utf8(output.stdout).unwrap(), expected.concat());
    let output = render(&folder, &[LINK, "--seed", "kea", "-o", "-"]);
    assert_eq!(String::from_utf8(output.stdout).unwrap(), expected[1], "of one map, too");
}

#[test]
fn seeds_are_read_from_standard_input() {
    let folder = folder("input");
    let mut call = Command::new(RIVERSEED);
    call.current_dir(&folder).args(["render", LINK, "--seeds", "-", "-o", "{seed}.json"]);
    let mut running = call.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    running.stdin.take().unwrap().write_all(b"kea\nkaka").unwrap();
    assert!(running.wait_with_output().unwrap().status.success());
    assert_eq!(names(&folder), ["kaka.json", "kea.json"]);
}

#[test]
fn what_is_missing_cut_short_or_of_another_recipe_is_made_and_the_rest_left_alone() {
    let folder = folder("resumed");
    let patterns = ["-o", "{seed}.json", "-o", "{seed}.png", "-o", "{seed}.svg", "--size", "60"];
    let run = |more: &[&str]| said(&folder, &[&[LINK, "--seeds", "1..6"], &patterns[..], more].concat());
    assert_eq!(run(&[]), "riverseed: maps: 6 made\n");
    let whole = files(&folder);
    let path = |name: &str| folder.join(name);
    fs::remove_file(path("1.json")).unwrap();
    let text = fs::read(path("2.json")).unwrap();
    fs::write(path("2.json"), &text[..text.len() - 1]).unwrap();
    fs::write(path("3.png"), "").unwrap();
    fs::copy(path("5.svg"), path("4.svg")).unwrap();
    let before = fs::metadata(path("6.json")).unwrap().modified().unwrap();
    assert_eq!(run(&[]), "riverseed: maps: 1 made, 3 replaced, 2 there before\n");
    assert!(files(&folder) == whole);
    assert_eq!(fs::metadata(path("6.json")).unwrap().modified().unwrap(), before);
    assert_eq!(run(&["--again"]), "riverseed: maps: 6 made\n");
    assert!(files(&folder) == whole);
}

#[test]
fn file_whose_beginning_is_cut_off_or_written_over_is_made_again_in_every_form() {
    let folder = folder("beginnings");
    // Bare heights are made again in any case.
    let forms = || FORMS.into_iter().filter(|form| *form != "r16");
    let patterns: Vec<String> = forms().map(|form| format!("{{seed}}.{form}")).collect();
    let outputs: Vec<&str> = patterns.iter().flat_map(|pattern| ["-o", pattern]).collect();
    let call = || said(&folder, &[&[LINK, "--seeds", "1..1"], &OPTIONS[..], &outputs[..]].concat());
    assert!(call().ends_with("riverseed: maps: 1 made\n"));
    let whole = files(&folder);
    for is_cut in [true, false] {
        for (name, bytes) in &whole {
            let spoilt = if is_cut { bytes[100..].to_vec() } else { [&[0; 8], &bytes[8..]].concat() };
            fs::write(folder.join(name), spoilt).unwrap();
        }
        assert!(call().ends_with("riverseed: maps: 1 replaced\n"));
        for ((name, bytes), (_, before)) in files(&folder).iter().zip(&whole) {
            assert!(bytes == before, "{name}, cut off: {is_cut}");
        }
    }
}

#[test]
fn file_of_other_options_is_not_taken_for_the_one_that_is_asked_for() {
    let folder = folder("options");
    let made = |more: &[&str]| said(&folder, &[&[LINK, "--seeds", "7..7"], more].concat());
    let new = "riverseed: maps: 1 made\n";
    let (other, same) = ("riverseed: maps: 1 replaced\n", "riverseed: maps: 1 there before\n");
    let calls: [(&[&str], &[&str]); 19] = [
        (&["-o", "{seed}.json"], &["-o", "{seed}.json", "--trim", "9"]),
        (&["-o", "{seed}.geojson"], &["-o", "{seed}.geojson", "--trim", "9"]),
        (&["-o", "a{seed}.json"], &["-o", "a{seed}.json", "--attractors"]),
        (&["-o", "{seed}.png", "--size", "60"], &["-o", "{seed}.png", "--size", "61"]),
        (&["-o", "{seed}.flow.png"], &["-o", "{seed}.flow.png", "--raster-size", "700"]),
        (&["-o", "{seed}.zip", "--size", "60"], &["-o", "{seed}.zip", "--size", "61"]),
        (&["-o", "a{seed}.zip"], &["-o", "a{seed}.zip", "--raster-size", "700"]),
        (&["-o", "{seed}.gpkg"], &["-o", "{seed}.gpkg", "--trim", "9"]),
        (&["-o", "{seed}.tif", "--size", "60"], &["-o", "{seed}.tif", "--size", "61"]),
        (&["-o", "{seed}.flow.tif"], &["-o", "{seed}.flow.tif", "--raster-size", "700"]),
        (&["-o", "{seed}.glb", "--size", "60"], &["-o", "{seed}.glb", "--size", "60", "--raster-size", "700"]),
        (&["-o", "{seed}.splines.json"], &["-o", "{seed}.splines.json", "--raster-size", "700"]),
        (&["-o", "a{seed}.geojson"], &["-o", "a{seed}.geojson", "--geojson-segments"]),
        (
            &["-o", "b{seed}.geojson", "--geojson-segments"],
            &["-o", "b{seed}.geojson", "--geojson-segments", "--geojson-flat"],
        ),
        (&["-o", "a{seed}.gpkg"], &["-o", "a{seed}.gpkg", "--crs", "none"]),
        (&["-o", "a{seed}.land.tif"], &["-o", "a{seed}.land.tif", "--crs", "EPSG:32633"]),
        (&["-o", "{seed}.plot.svg"], &["-o", "{seed}.plot.svg", "--sheet", "a3"]),
        (&["-o", "{seed}.godot.zip"], &["-o", "{seed}.godot.zip", "--no-beds"]),
        (&["-o", "{seed}.heights.qml"], &["-o", "{seed}.heights.qml", "--trim", "9"]),
    ];
    for (first, second) in calls {
        assert_eq!([made(first), made(first)], [new, same], "{first:?}");
        assert_eq!([made(second), made(second), made(first)], [other, same, other], "{second:?}");
    }
}

#[test]
fn rasters_and_pictures_of_one_size_are_not_taken_for_each_other() {
    are_not_taken_for_each_other("layers", "png");
    are_not_taken_for_each_other("places", "tif");
}

fn are_not_taken_for_each_other(name: &str, ending: &str) {
    let folder = folder(name);
    let forms: Vec<&str> = FORMS.into_iter().filter(|form| form.ends_with(ending)).collect();
    let patterns: Vec<String> = forms.iter().map(|form| format!("{{seed}}.{form}")).collect();
    let outputs: Vec<&str> = patterns.iter().flat_map(|pattern| ["-o", pattern]).collect();
    let arguments = [&[LINK, "--seeds", "1..1", "--size", "500"], &outputs[..]].concat();
    said(&folder, &arguments);
    let whole = files(&folder);
    for turn in 1..whole.len() {
        for (i, (name, _)) in whole.iter().enumerate() {
            fs::write(folder.join(name), &whole[(i + turn) % whole.len()].1).unwrap();
        }
        assert_eq!(said(&folder, &arguments), "riverseed: maps: 1 replaced\n");
        for ((name, bytes), (_, expected)) in files(&folder).iter().zip(&whole) {
            assert!(bytes == expected, "{name}");
        }
    }
}

#[test]
fn hostile_seeds_stay_in_the_folder() {
    let outside = folder("hostile");
    let folder = outside.join("inside");
    fs::create_dir(&folder).unwrap();
    let seeds =
        ["..", "/etc/passwd", "../escaped", "a/b", "Kea", "kea", "nul", "-rf", "%4Bea", "x{seed}", "ki\u{301}wi"];
    let long = "\u{1f30a}".repeat(64);
    fs::write(folder.join("seeds"), format!("{}\n{long}\n", seeds.join("\n"))).unwrap();
    said(&folder, &[LINK, "--seeds", "seeds", "-o", "{seed}.json"]);
    assert_eq!(names(&folder).len(), 1 + seeds.len() + 1, "with the list");
    let found = names(&folder);
    for name in ["%2E%2E.json", "%2Fetc%2Fpasswd.json", "%4Bea.json", "kea.json", "%254%42ea.json", "x%7Bseed%7D.json"]
    {
        assert!(found.iter().any(|found| found == name), "{name}: {found:?}");
    }
    let folded: std::collections::BTreeSet<_> = found.iter().map(|name| name.to_lowercase()).collect();
    assert_eq!(folded.len(), found.len(), "nor do disks without great letters mix them up");
    assert_eq!(fs::read_dir(&outside).unwrap().count(), 1);
}

#[test]
fn lines_that_are_no_seeds_are_named_and_the_others_made() {
    let folder = folder("faults");
    let text = [b"kea\r\n\xff\n\n".as_slice(), "x".repeat(65).as_bytes(), b"\nkea\nkaka\n"].concat();
    fs::write(folder.join("seeds"), text).unwrap();
    let (code, said) = outcome(&folder, &[LINK, "--seeds", "seeds", "-o", "{seed}.json"]);
    assert_eq!(code, 1);
    assert_eq!(
        said.lines().collect::<Vec<_>>(),
        [
            "riverseed: seeds: line 2: the text is not UTF-8",
            "riverseed: seeds: line 4: seed: the text has 65 characters, at most 64 are allowed",
            "riverseed: seeds: 1 empty lines are left out",
            "riverseed: seeds: 1 lines repeat a seed: each map is made once",
            "riverseed: maps: 2 made",
            "riverseed: 2 of 4 maps were not made",
        ]
    );
    assert_eq!(names(&folder), ["kaka.json", "kea.json", "seeds"]);
}

#[test]
fn warnings_name_the_map_and_do_not_flood() {
    let folder = folder("warnings");
    let said = said(&folder, &[LINK, "--names", "l77.Nowhere", "--seeds", "1..25", "-o", "{seed}.json"]);
    let is_of_map =
        |line: &&str| line.starts_with("riverseed: seed '") && line.contains("'names' has no effect on 'l77'");
    assert_eq!(said.lines().filter(is_of_map).count(), 20, "{said}");
    assert!(said.ends_with("riverseed: 5 further warnings are not shown\nriverseed: maps: 25 made\n"), "{said}");
}

#[test]
fn what_does_nothing_is_said_beforehand_only_of_maps_of_one_country() {
    let folder = folder("idle");
    let idle = "'sensitivity' has no effect";
    let said = |link: &str| said(&folder, &[link, "--sensitivity", "40", "--seeds", "1..3", "-o", "{seed}.json"]);
    // A word may draw a country with a Brownian tree.
    assert!(!said("attractors=200").contains(idle));
    assert!(said("country=usual&attractors=200").contains(idle));
}

#[test]
fn common_recipe_file_may_name_a_seed_and_nothing_else_may() {
    let folder = folder("recipe");
    said(&folder, &[LINK, "--seed", "kea", "-o", "kea.json"]);
    said(&folder, &["--recipe", "kea.json", "--seeds", "5..5", "-o", "{seed}.json"]);
    said(&folder, &[LINK, "--seed", "5", "-o", "five.json"]);
    assert!(fs::read(folder.join("5.json")).unwrap() == fs::read(folder.join("five.json")).unwrap());
    let besides = "riverseed: a seed is given besides --seeds\n";
    let given = |more: &[&str]| outcome(&folder, &[more, &["--seeds", "1..2", "-o", "{seed}.json"]].concat());
    assert_eq!(given(&["seed=kea"]), (2, besides.into()));
    let (code, said) = given(&["--seed", "kea"]);
    assert!(code == 2 && said.contains("cannot be used with '--seed"), "{said}");
}

#[test]
fn what_is_wrong_with_a_call_is_named_and_nothing_is_made() {
    let folder = folder("wrong");
    fs::write(folder.join("empty"), "\n\n").unwrap();
    let calls: [(&[&str], i32, &str); 19] = [
        (&["--seeds", "1..3", "-o", "map.json"], 2, "has to hold '{seed}'"),
        (&["--seeds", "1..3", "-o", "{seed}/map.json"], 2, "not in that of a folder"),
        (&["--seeds", "1..3", "-o", "{seed}{seed}.json"], 2, "only once"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "-o", "{seed}.json"], 2, "two outputs may write the same file"),
        (&["--seeds", "1..3", "-o", "-", "-o", "-"], 2, "given twice"),
        (&["--seeds", "1..3", "-o", "{seed}.gif"], 2, "the ending of the output is none of"),
        (&["--seeds", "1..3", "-o", "no/folder/{seed}.json"], 1, "no/folder/{seed}.json: No such file"),
        (&["--seeds", "3..1", "-o", "{seed}.json"], 2, "--seeds 3..1: a range goes from the lesser"),
        (&["--seeds", "1..9999999999", "-o", "{seed}.json"], 2, "at most 1000000000"),
        (&["--seeds", "no-list", "-o", "{seed}.json"], 1, "no-list: No such file"),
        (&["--seeds", "empty", "-o", "{seed}.json"], 2, "--seeds empty: there are no seeds in it"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "--shard", "4/3"], 2, "with I from 1 to N"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "--shard", "0/3"], 2, "with I from 1 to N"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "--threads", "0"], 2, "from 1 to 1024"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "--size", "9"], 2, "--size does not go with .json"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "-o", "{seed}.svg", "--ratio", "2"], 2, "with .json, .svg"),
        (&["--seeds", "1..3", "-o", "{seed}.json", "--curl", "9"], 2, "curl: 9 is not between 0 and 2"),
        (&["--shard", "1/3", "-o", "a.json"], 2, "--seeds"),
        (&["--threads", "1", "-o", "a.json"], 2, "--seeds"),
    ];
    for (arguments, code, reason) in calls {
        let (found, said) = outcome(&folder, arguments);
        assert!(found == code && said.contains(reason), "{arguments:?}: {found}, {said}");
    }
    assert_eq!(names(&folder), ["empty"]);
}

#[test]
fn one_map_may_have_several_files_without_many_maps() {
    let (several, single) = (folder("several"), folder("several-single"));
    assert_eq!(said(&several, &[LINK, "-o", "a.json", "-o", "a.heights.png", "-o", "a.png", "--size", "50"]), "");
    said(&single, &[LINK, "-o", "a.json"]);
    said(&single, &[LINK, "-o", "a.heights.png"]);
    said(&single, &[LINK, "-o", "a.png", "--size", "50"]);
    assert!(files(&several) == files(&single));
}

/// Waits for a file in a folder, or the end of a process.
#[cfg(unix)]
fn wait_for_a_file(folder: &Path, process: &mut std::process::Child) {
    while process.try_wait().unwrap().is_none() && fs::read_dir(folder).unwrap().next().is_none() {
        std::thread::yield_now();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn interrupted_run_leaves_whole_files_and_the_same_call_goes_on() {
    let (stopped, whole) = (folder("stopped"), folder("not-stopped"));
    let arguments = [LINK, "--seeds", "1..40", "--threads", "2", "-o", "{seed}.json", "-o", "{seed}.heights.png"];
    said(&whole, &arguments);
    let expected = files(&whole);
    for signal in ["INT", "TERM", "KILL"] {
        let mut call = Command::new(RIVERSEED);
        let mut running = call.current_dir(&stopped).arg("render").args(arguments).spawn().unwrap();
        wait_for_a_file(&stopped, &mut running);
        let kill = format!("kill -{signal} {}", running.id());
        Command::new("sh").args(["-c", &kill]).status().unwrap();
        running.wait().unwrap();
        for (name, bytes) in files(&stopped) {
            let is_whole = expected.iter().any(|(other, whole)| *other == name && *whole == bytes);
            assert!(is_whole, "{signal}: {name}");
        }
    }
    said(&stopped, &arguments);
    assert!(files(&stopped) == expected);
}
