//! The command line, called like its user calls it.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use crate::command::{network, refusal, riverseed, scratch};
use riverseed::analyse::statistics::TABLE;
use riverseed::digest::COMMITTED;

#[test]
fn later_values_win_whatever_form_they_come_in() {
    let file = scratch("recipe.json");
    fs::write(&file, r#"{"curl": 0.5, "attractors": 300}"#).unwrap();
    let file = file.to_str().unwrap();
    let curl = |name, arguments: &[&str]| network(name, arguments)["recipe"]["curl"].as_f64();
    assert_eq!(curl("a.json", &["curl=0.25", "--recipe", file]), Some(0.5));
    assert_eq!(curl("b.json", &["--recipe", file, "curl=0.25"]), Some(0.25));
    assert_eq!(curl("c.json", &["--recipe", file, "curl=0.25", "--curl", "0.75"]), Some(0.75));
    assert_eq!(curl("d.json", &["--curl", "0.75", "--recipe", file]), Some(0.5));
    assert_eq!(curl("e.json", &["--curl", "0.75", "--attractors", "200", "--preset", "original"]), Some(0.75));
}

#[test]
fn recipe_may_begin_with_a_byte_order_mark() {
    let file = scratch("marked.json");
    fs::write(&file, "\u{feff}{\"attractors\": 123}").unwrap();
    assert_eq!(network("marked-network.json", &["--recipe", file.to_str().unwrap()])["recipe"]["attractors"], 123);
}

#[test]
fn network_has_columns_of_one_length_and_parents_first() {
    let network = network("network.json", &["seed=kauri&growth=colonize&valleys=0&attractors=400", "--attractors"]);
    let column = |name: &str| network["nodes"][name].as_array().unwrap().clone();
    let parents = column("parent");
    for name in ["x", "y", "tick", "depth", "order", "magnitude", "discharge"] {
        assert_eq!(column(name).len(), parents.len(), "{name}");
    }
    assert!(parents.iter().enumerate().all(|(i, parent)| parent.as_i64().unwrap() < i as i64));
    assert_eq!(network["attractors"]["x"].as_array().unwrap().len(), 400);
    assert_eq!(network["recipe"]["seed"], "kauri");
    let reach = network["resolved"]["reach"].as_f64().unwrap() / network["resolved"]["spacing"].as_f64().unwrap();
    assert!((reach - network["recipe"]["reach"].as_f64().unwrap()).abs() < 1e-5);
}

#[test]
fn attractors_are_counted_and_asked_for_at_once() {
    let network = network("both.json", &["growth=colonize&valleys=0", "--attractors", "250", "--attractors"]);
    assert_eq!(network["attractors"]["x"].as_array().unwrap().len(), 250);
}

#[test]
fn an_older_file_survives_a_failure_and_nothing_is_left_beside_it() {
    let folder = scratch("older");
    fs::create_dir_all(&folder).unwrap();
    let out = folder.join("kept.png");
    fs::write(&out, "older").unwrap();
    assert_eq!(refusal(&["render", "curl=9", "-o", out.to_str().unwrap()]).0, 2);
    assert_eq!(fs::read_to_string(&out).unwrap(), "older");
    assert!(riverseed(&["render", "attractors=100", "-o", out.to_str().unwrap()]).status.success());
    let names: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names, ["kept.png"]);
}

#[test]
fn ending_says_what_is_written() {
    let written = |name: &str| {
        let out = scratch(name);
        let output = riverseed(&["render", "seed=rata&attractors=200", "-o", out.to_str().unwrap()]);
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        fs::read_to_string(out).unwrap()
    };
    let svg = written("map.svg");
    let document = roxmltree::Document::parse(&svg).unwrap();
    assert!(document.descendants().any(|node| node.attribute("id") == Some("river-0")));
    let rivers = written("map.GeoJSON").parse::<geojson::FeatureCollection>().unwrap();
    assert_eq!(rivers.foreign_members.unwrap()["riverseed"], "seed=rata&edition=1&attractors=200&style=atlas");
    assert_eq!(written("map.svg"), svg);
}

#[test]
fn name_says_which_raster_is_written_and_zip_holds_them_all() {
    let written = |name: &str, more: &[&str]| {
        let out = scratch(name);
        let output = riverseed(&[&["render", "seed=rata&attractors=200", "-o", out.to_str().unwrap()], more].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        fs::read(out).unwrap()
    };
    let pack = written("map.zip", &["--size", "100"]);
    let archive = rawzip::ZipArchive::from_slice(&pack).unwrap();
    let mut files = std::collections::BTreeMap::new();
    let mut entries = archive.entries();
    while let Some(entry) = entries.next_entry().unwrap() {
        let name = entry.file_path().try_normalize().unwrap().as_ref().to_owned();
        let content = archive.get_entry(entry.wayfinder()).unwrap();
        let mut bytes = Vec::new();
        flate2::read::DeflateDecoder::new(content.data()).read_to_end(&mut bytes).unwrap();
        files.insert(name, bytes);
    }
    for name in ["heights.png", "land.png", "rivers.png", "flow.png", "basins.png", "water.png", "depth.png"] {
        assert!(files[name] == written(&format!("map.{name}"), &[]), "{name}");
    }
    assert!(
        files["map.png"] == written("map.at.night.png", &["--size", "100"]),
        "a picture, whatever dots are in its name"
    );
    assert!(String::from_utf8(files["README.txt"].clone()).unwrap().contains("seed=rata&edition=1&attractors=200"));
    assert_eq!(
        refusal(&["render", "--size", "100", "-o", "x.Heights.png"]),
        (2, "riverseed: --size does not go with .heights.png\n".into())
    );
}

#[test]
fn rasters_have_the_size_asked_for_alone_and_in_a_pack() {
    const LINK: &str = "seed=rata&attractors=200&aspect=2";
    let written = |name: &str, more: &[&str]| {
        let out = scratch(name);
        let output = riverseed(&[&["render", LINK, "-o", out.to_str().unwrap()], more].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        fs::read(out).unwrap()
    };
    let alone = written("finer.land.png", &["--raster-size", "1024"]);
    let info = png::Decoder::new(std::io::Cursor::new(&alone)).read_info().unwrap();
    assert_eq!((info.info().width, info.info().height), (1024, 512));
    let pack = written("finer.zip", &["--size", "64", "--raster-size", "1024"]);
    let archive = rawzip::ZipArchive::from_slice(&pack).unwrap();
    let (mut entries, mut land) = (archive.entries(), Vec::new());
    while let Some(entry) = entries.next_entry().unwrap() {
        if entry.file_path().try_normalize().unwrap().as_ref() == "land.png" {
            let content = archive.get_entry(entry.wayfinder()).unwrap();
            flate2::read::DeflateDecoder::new(content.data()).read_to_end(&mut land).unwrap();
        }
    }
    assert!(land == alone);
    let refused = |size: &str, out: &str| refusal(&["render", LINK, "--raster-size", size, "-o", out]);
    for size in ["707", "4098"] {
        let text =
            format!("riverseed: --raster-size: rasters of this map are from 708 to 4097 pixels long, not {size}\n");
        assert_eq!(refused(size, "x.heights.png"), (2, text.clone()));
        assert_eq!(refused(size, "x.zip"), (2, text));
    }
    for size in ["513", "700"] {
        let text = format!("a landscape of this map in Unity is 1025, 2049 or 4097 pixels wide, not {size}");
        assert_eq!(refused(size, "x.unity.zip"), (2, format!("riverseed: --raster-size: {text}\n")));
    }
    assert_eq!(refused("-3", "x.zip").0, 2);
    assert_eq!(refused("1024", "x.png"), (2, "riverseed: --raster-size does not go with .png\n".into()));
    assert_eq!(refused("1024", "x.json"), (2, "riverseed: --raster-size does not go with .json\n".into()));
}

#[test]
fn rivers_are_in_the_network_with_what_they_were_made_by() {
    let network =
        network("rivers.json", &["growth=colonize&valleys=0&attractors=400&meander=flow&meander-rounds=3&simplify=50"]);
    let resolved = &network["resolved"];
    assert_eq!((&resolved["meander"], &resolved["meander-rounds"]), (&"flow".into(), &3.into()));
    assert_eq!((&resolved["simplify"], &resolved["total-discharge"]), (&0.5.into(), &400.into()));
    let rivers = network["rivers"].as_array().unwrap();
    assert!(!rivers.is_empty() && rivers.iter().any(|river| river["parent"].is_null()));
    let points = rivers[0]["points"].as_array().unwrap();
    assert!(points.iter().all(|point| point.as_array().unwrap().len() == 3));
}

#[test]
fn it_is_no_failure_if_nobody_reads_to_the_end() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_riverseed"));
    command.args(["names", "attractors=300"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = command.spawn().unwrap();
    drop(running.stdout.take());
    let output = running.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[cfg(unix)]
#[test]
fn files_are_written_before_what_nobody_reads_to_its_end() {
    let folder = scratch("pipe-and-file");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let [pipe, file] = ["pipe.png", "file.json"].map(|name| folder.join(name));
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = pipe.clone();
    let reader = std::thread::spawn(move || fs::File::open(reader).unwrap().read_exact(&mut [0]).unwrap());
    let [pipe, file] = [&pipe, &file].map(|path| path.to_str().unwrap());
    let output = riverseed(&["render", "attractors=100", "--size", "2000", "-o", pipe, "-o", file]);
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    assert!(fs::exists(file).unwrap());
    reader.join().unwrap();
}

#[test]
fn names_are_printed_greatest_first_with_their_marks() {
    let printed = |arguments: &[&str]| {
        let output = riverseed(&[&["names", "seed=kauri&land=island&attractors=3000"], arguments].concat());
        assert!(output.status.success(), "{output:?}");
        let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        (out.lines().map(str::to_owned).collect::<Vec<_>>(), err)
    };
    let (plain, complaints) = printed(&[]);
    assert_eq!(complaints, "");
    assert_eq!(plain[0].split_whitespace().collect::<Vec<_>>(), ["mark", "name", "order", "km"]);
    assert!(plain[1].trim_start().starts_with("t  Kauri"), "{:?}", plain[1]);
    let network = network("names.json", &["seed=kauri&land=island&attractors=3000"]);
    let rivers = network["rivers"].as_array().unwrap();
    let greatest = rivers.iter().max_by_key(|river| river["discharge"].as_u64()).unwrap();
    let (mark, name) = (greatest["identity"].to_string(), greatest["name"].as_str().unwrap());
    assert!(plain[2].trim_start().starts_with(&format!("{mark}  {name}")), "{}", plain[2]);
    assert_eq!(plain.len(), 1 + rivers.len() + network["names"].as_array().unwrap().len());
    let (named, complaints) = printed(&["--names", &format!("{mark}.Silver Water_l77.Nowhere")]);
    assert!(named[2].contains(&format!("{mark}  Silver Water")), "{}", named[2]);
    assert_eq!(complaints, "riverseed: 'names' has no effect on 'l77': there is no such thing on this map\n");
    let complaints = |link: &str| {
        let path = scratch("letters.png");
        let output = riverseed(&["render", "-o", path.to_str().unwrap(), "--size", "40", link]);
        String::from_utf8(output.stderr).unwrap()
    };
    let small = "attractors=300&labels=few&cartouche=plain";
    assert_eq!(complaints(&format!("{small}&seed=kea&names=t.Home")), "");
    assert_eq!(
        complaints(&format!("{small}&seed=\u{6771}&names=t.\u{5d0}x\u{5d0}")),
        "riverseed: 'names' is drawn without '\u{5d0}': the type has no such letters\n\
         riverseed: the cartouche is drawn without the seed: the type has no '\u{6771}'\n"
    );
    let written = |name: &str, options: &[&str]| {
        let path = scratch(name);
        let link = format!("{small}&land=island&seed=kea");
        let output = riverseed(&[&["render", &link, "-o", path.to_str().unwrap()], options].concat());
        assert!(output.status.success(), "{output:?}");
        fs::read(path).unwrap()
    };
    let with_ratio = |ratio: &str| written("ratio.png", &["--size", "400", "--ratio", ratio]);
    assert!(written("ratio.png", &["--size", "400"]) == with_ratio("1"));
    assert!(with_ratio("1") != with_ratio("4"), "letters are as large");
    let has_text = |options: &[&str]| String::from_utf8(written("text.svg", options)).unwrap().contains("<textPath");
    assert!(has_text(&["--svg-text"]) && !has_text(&[]));
    let refused = |options: &[&str]| refusal(&[&["render", small], options].concat());
    let message = |option: &str, ending: &str| (2, format!("riverseed: {option} does not go with {ending}\n"));
    assert_eq!(refused(&["-o", "x.svg", "--ratio", "2"]), message("--ratio", ".svg"));
    assert_eq!(refused(&["-o", "x.png", "--svg-text"]), message("--svg-text", ".png"));
    for (option, value) in
        [("--geojson-segments", ""), ("--geojson-flat", ""), ("--crs", "none"), ("--crs", "EPSG:32601")]
    {
        let words: Vec<&str> = ["-o", "x.png", option, value].into_iter().filter(|word| !word.is_empty()).collect();
        assert_eq!(refused(&words), message(option, ".png"));
    }
    for crs in ["EPSG:4326", "32633", "utm"] {
        let (code, complaint) = refused(&["-o", "x.gpkg", "--crs", crs]);
        assert!(code == 2 && complaint.contains(crs) && complaint.contains("32601 to 32660"), "{complaint}");
    }
    for ratio in ["0.25", "1.3", "5", "NaN", "x"] {
        let (code, complaint) = refused(&["-o", "x.png", "--ratio", ratio]);
        assert!(code == 2 && complaint.contains("from 0.5 to 4, in quarters"), "{complaint}");
    }
    let (code, complaint) = refusal(&["names", "--names", "x3.y"]);
    assert!(code == 2 && complaint.contains("names: 'x3' is not a mark"), "{complaint}");
}

#[test]
fn lines_for_plotters_are_on_the_sheet_that_is_asked_for() {
    let small = "attractors=100&land=island";
    let head = |options: &[&str]| {
        let path = scratch("sheet.plot.svg");
        let output = riverseed(&[&["render", small, "-o", path.to_str().unwrap()], options].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        fs::read_to_string(path).unwrap().lines().next().unwrap().to_owned()
    };
    assert!(head(&[]).ends_with(" width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\">"), "{}", head(&[]));
    assert_eq!(head(&[]), head(&["--sheet", "a4"]));
    assert!(
        head(&["--sheet", "letter", "--aspect", "0.5"])
            .ends_with(" width=\"215.9mm\" height=\"279.4mm\" viewBox=\"0 0 215.9 279.4\">")
    );
    let refused = |options: &[&str]| refusal(&[&["render", small], options].concat());
    let message = "riverseed: --sheet does not go with .svg\n";
    assert_eq!(refused(&["-o", "x.svg", "--sheet", "a4"]), (2, message.into()));
    let (code, complaint) = refused(&["-o", "x.plot.svg", "--sheet", "a9"]);
    assert!(code == 2 && complaint.contains("must be one of a5, a4, letter, a3, a2, a1"), "{complaint}");
}

#[test]
fn heights_have_beds_where_engines_dig_none_or_where_they_are_asked_for() {
    let bytes = |options: &[&str]| {
        let path = scratch("beds.r16");
        let link = "attractors=300&land=island";
        assert!(riverseed(&[&["render", link, "-o", path.to_str().unwrap()], options].concat()).status.success());
        fs::read(path).unwrap()
    };
    let (with, without) = (bytes(&["--beds"]), bytes(&["--no-beds"]));
    assert!(with != without && bytes(&[]) == without && bytes(&["--beds", "--no-beds"]) == without);
    let message = "riverseed: --beds or --no-beds does not go with .png, .glb\n";
    assert_eq!(refusal(&["render", "-o", "x.png", "-o", "x.glb", "--beds"]), (2, message.into()));
}

#[test]
fn measures_are_printed_beside_nature_s() {
    let printed = |arguments: &[&str]| {
        let output = riverseed(&[&["measure"], arguments].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let link = "seed=kauri&land=rectangle&growth=colonize&valleys=0&attractors=3000&trim=2";
    let lines = printed(&[link]);
    let line = |label: &str| lines.lines().find(|line| line.starts_with(label)).unwrap();
    assert!(lines.lines().all(|line| line.chars().count() <= 100), "{lines}");
    assert!(line("Bifurcation ratio").ends_with("4.1 (3.5 to 5.2) [1]"), "{lines}");
    assert_eq!(line("[1]"), "[1] 11 river basins");
    let said = lines.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(TABLE.iter().all(|measure| said.contains(measure.help)), "{lines}");
    let json: serde_json::Value = serde_json::from_str(&printed(&[link, "--json"])).unwrap();
    let network = network("measured.json", &[link]);
    assert_eq!((&json["measures"], &json["pattern"]), (&network["measures"], &network["pattern"]));
    let pattern = json["pattern"].as_object().unwrap().keys().next().unwrap();
    assert_eq!(line("Pattern"), format!("Pattern: {pattern}"));
    assert!(lines.contains(&format!("\n    distances: {pattern} ")), "{lines}");
    assert_eq!(json["nature"]["hack-exponent"]["median"], 0.67);
    let ratio = json["measures"]["bifurcation-ratio"].as_f64().unwrap();
    assert!(line("Bifurcation ratio").contains(&format!(" {ratio:.2} ")), "{lines}");
    let small = printed(&["--land", "rectangle", "--attractors", "100"]);
    assert!(small.lines().nth(1).unwrap().contains("too small"), "{small}");
    assert_eq!(refusal(&["measure", "--curl", "9"]).0, 2);
}

#[test]
fn a_map_is_checked_against_its_promises() {
    let printed = |arguments: &[&str]| {
        let output = riverseed(&[&["check"], arguments].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let (digest, link) = COMMITTED.lines().next().unwrap().split_once(' ').unwrap();
    let lines = printed(&[link]);
    let line = |label: &str| lines.lines().find(|line| line.starts_with(label)).unwrap();
    for promise in ["Nothing runs uphill", "Nothing crosses", "Every river arrives", "Discharge adds up"] {
        assert!(line(promise).ends_with(" kept"), "{lines}");
    }
    assert!(line("The same bits").contains(&format!("{digest}, as committed")), "{lines}");
    assert!(line("Bifurcation ratio").contains("4.1 (3.5 to 5.2) [1]"), "{lines}");
    assert!(lines.contains("No promise is broken by that"), "{lines}");
    let json: serde_json::Value = serde_json::from_str(&printed(&[link, "--json"])).unwrap();
    assert_eq!((&json["verdict"], &json["digest"]), (&"kept".into(), &digest.into()));
    let names = |list: &str| -> Vec<String> {
        let rows = json[list].as_array().unwrap();
        rows.iter().map(|row| row["name"].as_str().unwrap().into()).collect()
    };
    assert_eq!(names("promises"), ["falls", "apart", "joins", "adds-up", "same-bits"]);
    let compared = TABLE.iter().filter(|measure| measure.nature.is_some()).map(|measure| measure.name);
    assert_eq!(names("nature"), compared.collect::<Vec<_>>());
    assert!(json["promises"][1]["count"].as_u64().unwrap() > 1000, "{json}");
    // A file of a network is the recipe that it holds.
    network("checked.json", &["seed=rata&attractors=300"]);
    let file = scratch("checked.json");
    let of_file = printed(&["--recipe", file.to_str().unwrap()]);
    assert_eq!(of_file, printed(&["seed=rata&attractors=300"]));
    assert_eq!(refusal(&["check", "--curl", "9"]).0, 2);
}

#[test]
fn network_is_a_recipe_of_itself() {
    let first = network("first.json", &["seed=rimu&attractors=300&curl=0.6"]);
    let again = network("again.json", &["--recipe", scratch("first.json").to_str().unwrap()]);
    assert_eq!(first, again);
}

#[test]
fn numbers_are_written_in_full() {
    let network = network("full.json", &["attractors=150"]);
    let tree = {
        use riverseed::{recipe::link, session::Session};
        let mut session = Session::new(link::read("attractors=150").unwrap()).unwrap();
        while session.advance(9).unwrap() {}
        session.pruned().tree
    };
    for (x, at) in network["nodes"]["x"].as_array().unwrap().iter().zip(tree.at) {
        assert_eq!(x.as_f64().unwrap() as f32, at.x);
    }
}

#[test]
fn picture_has_the_size_asked_for_on_its_longer_side() {
    for (link, expected) in [("aspect=2&attractors=100", (300, 150)), ("aspect=0.5&attractors=100", (150, 300))] {
        let out = scratch(&format!("{}.png", expected.0));
        let output = riverseed(&["render", link, "--size", "300", "-o", out.to_str().unwrap()]);
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        let info = png::Decoder::new(std::io::BufReader::new(fs::File::open(out).unwrap())).read_info().unwrap();
        assert_eq!((info.info().width, info.info().height), expected);
    }
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_written() {
    let out = scratch("never.png");
    let out = out.to_str().unwrap();
    let wrong = |link: &str| refusal(&["render", link, "-o", out]);
    assert_eq!(wrong("curl=9"), (2, "riverseed: curl: 9 is not between 0 and 2\n".into()));
    assert_eq!(wrong("flow=9"), (2, "riverseed: there is no parameter 'flow'\n".into()));
    assert_eq!(
        refusal(&["render", "--trim", "-1", "-o", out]),
        (2, "riverseed: trim: -1 is not between 0 and 400\n".into())
    );
    assert_eq!(refusal(&["render", "--attractors", "-o", out]).0, 2);
    assert_eq!(refusal(&["render", "--size", "300", "-o", "x.json"]).0, 2);
    assert_eq!(
        refusal(&["render", "--size", "300", "-o", "x.svg"]),
        (2, "riverseed: --size does not go with .svg\n".into())
    );
    assert_eq!(
        refusal(&["render", "--attractors", "-o", "x.geojson"]),
        (2, "riverseed: --attractors without a number does not go with .geojson\n".into())
    );
    assert_eq!(
        refusal(&["render", "-o", "x.gif"]),
        (2, "riverseed: x.gif: the ending of the output is none of .png, .svg, .geojson, .json, .zip, .r16, .glb, .gpkg, .tif\n".into())
    );
    assert_eq!(refusal(&["render", "--size", "9000", "-o", out]).0, 2);
    assert_eq!(refusal(&["render", "--recipe", "no-such-file.json", "-o", out]).0, 1);
    assert_eq!(refusal(&["render", "curl=1", "--curl", "1", "--curl", "1", "-o", out]).0, 2);
    assert_eq!(refusal(&["render", "--attractors", "100", "-o", "no/such/folder/x.png"]).0, 1);
    assert!(!fs::exists(out).unwrap());
}

#[test]
fn addresses_words_and_damaged_links_are_the_maps_they_are_of() {
    let drawn = |arguments: &[&str]| {
        let output = riverseed(&[&["names", "--attractors", "100"], arguments].concat());
        assert!(output.status.success(), "{arguments:?}: {output:?}");
        (output.stdout, String::from_utf8(output.stderr).unwrap())
    };
    let (wanted, _) = drawn(&["seed=kauri&land=valley"]);
    let mended = "riverseed: the link was damaged on its way, and has been mended\n";
    for (text, said) in [
        ("https://rivers.example/?seed=kauri&land=valley", ""),
        ("seed=kauri&amp;land=valley", mended),
        ("seed%3Dkauri%26land%3Dvalley", mended),
        ("[our map](https://rivers.example/?land=valley&seed=kauri).", mended),
        (
            "https://rivers.example/?seed=kauri&land=valley&utm_source=mail",
            "riverseed: there is no parameter 'utm_source': it is left out\n",
        ),
    ] {
        assert_eq!(drawn(&[text]), (wanted.clone(), said.into()), "{text}");
        let is_address = text.contains("://");
        if is_address {
            assert_eq!(drawn(&["land=island", "--seed", text]).0, wanted, "{text}");
        }
    }
    assert_eq!(drawn(&["kauri", "--land", "valley"]), (wanted, String::new()));
    assert_eq!(drawn(&["Why?"]).0, drawn(&["seed=Why%3F"]).0);
}

#[test]
fn what_is_given_and_does_nothing_is_said() {
    let file = scratch("idle-recipe.json");
    fs::write(&file, r#"{"land": "rectangle", "sea": 0.4, "aspect": 2}"#).unwrap();
    let out = scratch("idle.json");
    let arguments = ["growth=brownian&mouths=9&sensitivity=64", "--recipe", file.to_str().unwrap(), "--kill", "1"];
    let output = riverseed(&[&["render", "-o", out.to_str().unwrap()], &arguments[..]].concat());
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr);
    for name in ["mouths", "sea", "kill"] {
        assert!(said.contains(&format!("'{name}' has no effect: ")), "{said}");
    }
    assert_eq!(said.lines().count(), 3, "{said}");
}

#[test]
fn heights_of_a_style_without_relief_matter_to_files_of_data() {
    let said = |out: &str, mountains: &str| {
        let out = scratch(out);
        let link = "attractors=200&style=ink&land=island&lakes=0";
        let output = riverseed(&["render", link, "--mountains", mountains, "-o", out.to_str().unwrap()]);
        assert!(output.status.success());
        (String::from_utf8_lossy(&output.stderr).into_owned(), fs::read(&out).unwrap())
    };
    let ((of_picture, _), (of_heights, low)) = (said("flat.png", "2"), said("low.heights.png", "2"));
    assert!(of_picture.contains("'mountains' has no effect: this style shows no relief"), "{of_picture}");
    assert_eq!(of_heights, "");
    assert_ne!(low, said("high.heights.png", "3").1);
}

/// A network's file states every parameter, so a default value in it was not asked for.
#[test]
fn network_read_as_a_recipe_warns_only_of_what_it_changes() {
    network("stated.json", &["attractors=100&land=rectangle&sea=0.7&growth=brownian&sensitivity=64"]);
    let out = scratch("stated-again.json");
    let file = scratch("stated.json");
    let output = riverseed(&["render", "-o", out.to_str().unwrap(), "--recipe", file.to_str().unwrap(), "--kill", "1"]);
    let warnings = String::from_utf8(output.stderr).unwrap();
    let named: Vec<&str> = warnings.lines().filter_map(|line| line.split('\'').nth(1)).collect();
    assert_eq!(named, ["sea", "attractors", "kill"], "{warnings}");
}

#[test]
fn drawn_land_without_an_outline_is_the_rectangle_and_says_so() {
    let out = scratch("undrawn.json");
    let output = riverseed(&["render", "land=drawn&attractors=100", "-o", out.to_str().unwrap()]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("no outline"));
}

#[test]
fn land_that_rivers_do_not_reach_is_told_with_what_helps() {
    let out = scratch("unreached.svg");
    let advice = |link: &str| refusal(&["render", link, "-o", out.to_str().unwrap()]).1;
    assert!(advice("attractors=300&kill=0.5&step=1.2").contains("'step'"));
    assert_eq!(advice("attractors=300"), "");
}

#[test]
fn this_machine_is_told_to_draw_as_all_others() {
    let output = riverseed(&["verify"]);
    let (said, wrong) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && wrong.is_empty(), "{said}{wrong}");
    let count = COMMITTED.lines().count();
    assert!(
        said.starts_with(&format!("the same bits: {count} of {count} recipes")) && said.lines().count() == 1,
        "{said}"
    );
}

#[test]
fn recipe_that_is_drawn_otherwise_is_named() {
    let file = scratch("digests.txt");
    let right = COMMITTED.lines().next().unwrap();
    let wrong = "seed=kauri&attractors=100";
    fs::write(&file, format!("{right}\n0123456789abcdef {wrong}\n")).unwrap();
    let output = riverseed(&["verify", "--digests", file.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.starts_with(&format!("{wrong}: ")) && said.ends_with(", not 0123456789abcdef\n"), "{said}");
    assert_eq!(said.lines().count(), 1);
    let verdict = String::from_utf8(output.stderr).unwrap();
    assert_eq!(verdict, "riverseed: 1 of 2 recipes give other rivers, pixels or files here\n");
}

#[test]
fn digests_that_are_none_are_refused() {
    let file = scratch("no-digests.txt");
    for (text, reason) in [("", "no digests"), ("0123456789abcdef seed=a\nseed=b\n", "line 2 is no digest")] {
        fs::write(&file, text).unwrap();
        let (code, message) = refusal(&["verify", "--digests", file.to_str().unwrap()]);
        assert!(code == 1 && message.contains("no-digests.txt") && message.contains(reason), "{message}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn closed_standard_output_is_an_error_of_commands_that_print() {
    let calls = [
        "table",
        "names seed=kea\\&attractors=100",
        "measure seed=kea\\&attractors=100",
        "check seed=kea\\&attractors=100",
        "render seed=kea\\&attractors=100 -o -",
        "render attractors=100 --seeds 1..2 -o -",
    ];
    for call in calls {
        let by_shell = |redirected: &str| {
            let call = format!("exec {} {call} {redirected}", env!("CARGO_BIN_EXE_riverseed"));
            let output = Command::new("sh").args(["-c", &call]).output().unwrap();
            (output.status.code(), String::from_utf8(output.stderr).unwrap())
        };
        let said = "riverseed: standard output is closed: nobody would read what is printed\n";
        assert_eq!(by_shell(">&-"), (Some(1), said.into()), "{call}");
        assert_eq!(by_shell(">/dev/null").0, Some(0), "{call}");
    }
}

#[test]
fn path_of_a_folder_is_no_output() {
    for path in ["s.json/", "s.json/.", "no-such-folder/{seed}.json/"] {
        let (code, message) = refusal(&["render", "attractors=100", "--seeds", "1..1", "-o", path]);
        assert_eq!((code, message), (2, format!("riverseed: {path}: this is the path of a folder, not of a file\n")));
    }
}

#[test]
fn embed_prints_the_element_or_what_a_generator_of_pages_needs() {
    let printed = |words: &[&str]| {
        let output = riverseed(&[&["embed"], words].concat());
        assert!(output.status.success(), "{output:?}");
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap())
    };
    let facts = |map: &str| serde_json::from_str::<serde_json::Value>(&printed(&[map, "--json"])[0]).unwrap();
    let link = "seed=rimu&edition=1&land=valley";
    assert_eq!(
        facts("https://rivers.example/?seed=rimu&amp;land=valley"),
        serde_json::json!({
            "link": link,
            "seed": "rimu",
            "edition": 1,
            "alternative": "Rivers grown from “rimu”",
            "aspect": 1.6,
            "beyond_element": [],
        })
    );
    assert_eq!(facts("seed=rimu&style=atlas")["link"], "seed=rimu&edition=1&style=atlas", "with its style");
    assert_eq!(facts("attractors=30000")["beyond_element"].as_array().unwrap().len(), 1);
    assert_eq!(facts("a \"b\" & c")["link"], "seed=a+%22b%22+%26+c&edition=1");
    let [element, said] = printed(&["seed=rimu&amp;land=valley"]);
    let escaped = link.replace('&', "&amp;");
    assert_eq!(element, format!("<river-seed recipe=\"{escaped}\" style=\"display:block\"></river-seed>\n"));
    assert_eq!(said, "riverseed: the link was damaged on its way, and has been mended\n");
    assert_eq!(refusal(&["embed", "sea=7"]), (2, "riverseed: sea: 7 is not between 0 and 0.8\n".into()));
}
