//! `riverseed page`: a map's page as a folder.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use riverseed::picture::carried::Carried;
use serde_json::Value;

use crate::command::{refusal, riverseed, scratch};

/// Makes a folder like that of the element's files.
fn element(name: &str) -> String {
    let folder = scratch(name).join("files");
    fs::create_dir_all(&folder).unwrap();
    for file in ["river-seed.js", "river-seed.classic.js", "riverseed_bg.wasm", "weights.txt"] {
        fs::write(folder.join(file), file).unwrap();
    }
    folder.to_str().unwrap().into()
}

/// Makes an empty folder to write to.
fn out(name: &str) -> PathBuf {
    let folder = scratch(name).join("out");
    let _ = fs::remove_dir_all(&folder);
    folder
}

const FEW: &str = "attractors=300&seed=";

/// Makes a page and returns its folder.
fn page(name: &str, link: &str, options: &[&str]) -> PathBuf {
    let (element, folder) = (element(name), out(name));
    let call = ["page", link, "-o", folder.to_str().unwrap(), "--element", &element, "--size", "256"];
    let output = riverseed(&[&call[..], options].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Lists the names of the files in a folder.
fn names(folder: &Path) -> BTreeSet<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

/// Returns the names of all that is in a page's folder, with others.
fn whole(others: &[&str]) -> BTreeSet<String> {
    const ALL: [&str; 8] =
        ["card.jpg", "embed.html", "index.html", "map.jpg", "map.png", "page.css", "riverseed-page.json", "shape.css"];
    ALL.iter().chain(others).map(|name| (*name).into()).collect()
}

/// Reads the page as a tree of nodes. The template is well-formed XML, but for its first line.
fn with_nodes<T>(html: &str, read: impl FnOnce(&roxmltree::Document<'_>) -> T) -> T {
    let html = html.replace("<!doctype html>", "");
    // Boolean attributes are not XML, and the page has none.
    read(&roxmltree::Document::parse(&html).unwrap_or_else(|error| panic!("{error}:\n{html}")))
}

#[test]
fn folder_has_all_that_its_page_shows_and_all_addresses_in_it_are_relative() {
    let folder = page("page-whole", &format!("{FEW}kauri"), &[]);
    assert_eq!(names(&folder), whole(&["element"]));
    assert_eq!(
        names(&folder.join("element")),
        ["river-seed.js", "riverseed_bg.wasm"].map(String::from).into(),
        "what pages load"
    );
    for file in ["index.html", "embed.html"] {
        with_nodes(&text(&folder, file), |html| {
            let addresses = html.descendants().flat_map(|node| node.attributes());
            for address in addresses.filter(|one| ["href", "src"].contains(&one.name())) {
                let address = address.value();
                assert!(address.starts_with("data:") || folder.join(address).is_file(), "{file}: {address}");
            }
        });
    }
    assert!(text(&folder, "shape.css").contains("--aspect: 1.6;"));
}

#[test]
fn the_element_carries_the_letters_of_its_map_and_a_map_without_names_has_none() {
    let letters = |folder: &Path, file: &str| {
        with_nodes(&text(folder, file), |html| {
            let element = html.descendants().find(|node| node.has_tag_name("river-seed")).unwrap();
            element.attribute("letters").and_then(Carried::read)
        })
    };
    let folder = page("page-letters", &format!("{FEW}kauri"), &[]);
    let recipe = riverseed::recipe::link::read(&format!("{FEW}kauri")).unwrap();
    for file in ["index.html", "embed.html"] {
        assert!(letters(&folder, file).unwrap().are_for(&recipe), "{file}");
    }
    let bare = page("page-no-letters", &format!("{FEW}kauri&labels=none"), &[]);
    assert!(letters(&bare, "embed.html").is_none());
}

#[test]
fn with_an_address_card_and_oembed_are_absolute_under_any_path() {
    let folder = page("page-address", &format!("{FEW}kauri&aspect=2"), &["--address", "https://example.org/a/b"]);
    let html = text(&folder, "index.html");
    for (property, content) in [
        ("og:image", "https://example.org/a/b/card.jpg"),
        ("og:url", "https://example.org/a/b/"),
        ("og:title", "Kauri"),
        ("og:image:width", "1200"),
        ("og:image:height", "630"),
    ] {
        assert!(
            html.contains(&format!("<meta property=\"{property}\" content=\"{content}\" />")),
            "{property}: {html}"
        );
    }
    assert!(html.contains("type=\"application/json+oembed\" href=\"https://example.org/a/b/oembed.json\""), "{html}");
    let response: Value = serde_json::from_str(&text(&folder, "oembed.json")).unwrap();
    // What the specification requires of a rich response, section 2.3.4.
    assert_eq!((&response["version"], &response["type"]), (&"1.0".into(), &"rich".into()));
    assert_eq!((&response["width"], &response["height"]), (&720.into(), &360.into()));
    let frame = response["html"].as_str().unwrap();
    assert!(frame.starts_with("<iframe src=\"https://example.org/a/b/embed.html\" title=\"Kauri\""), "{frame}");
    assert_eq!(response["thumbnail_url"], "https://example.org/a/b/card.jpg");
}

#[test]
fn pictures_are_those_of_render_and_the_card_has_its_size() {
    let link = format!("{FEW}kauri&style=ink");
    let folder = page("page-pictures", &link, &[]);
    let drawn = scratch("page-drawn.png");
    assert!(riverseed(&["render", &link, "--size", "256", "-o", drawn.to_str().unwrap()]).status.success());
    assert!(fs::read(&drawn).unwrap() == fs::read(folder.join("map.png")).unwrap(), "map.png");
    let size = |name: &str| frame_of_jpeg(&fs::read(folder.join(name)).unwrap());
    assert_eq!((size("card.jpg"), size("map.jpg")), ((1200, 630), (256, 160)));
}

/// Width and height in the frame header of a JPEG: the segment SOF2 of a progressive one.
fn frame_of_jpeg(bytes: &[u8]) -> (u16, u16) {
    let at = bytes.windows(4).position(|four| four == [0xFF, 0xC2, 0x00, 0x11]).unwrap();
    let number = |from: usize| u16::from_be_bytes([bytes[at + from], bytes[at + from + 1]]);
    (number(7), number(5))
}

/// Writes the sign that turns text as pages show it.
fn in_order(text: &str) -> String {
    text.replace('\u{202e}', r"\u{202e}")
}

#[test]
fn no_sign_that_turns_text_stands_in_a_page_and_the_element_has_the_seed_whole() {
    const SEED: &str = "\u{202e}a\u{2066}b\u{200d}c";
    let words = ["--seed", SEED, "--title", SEED, "--description", SEED, "--address", "https://example.org/"];
    let folder = page("page-turned", "attractors=300", &words);
    for file in ["index.html", "embed.html", "oembed.json"] {
        let text = text(&folder, file);
        assert!(!text.contains(['\u{202e}', '\u{2066}']) && text.contains(r"\u{202e}a"), "{file}: {text}");
        assert!(text.contains("\u{200d}"), "{file}: letters are joined");
    }
    with_nodes(&text(&folder, "index.html"), |html| {
        let element = html.descendants().find(|node| node.has_tag_name("river-seed")).unwrap();
        assert_eq!(element.attribute("seed"), Some(SEED));
        let pasted = html.descendants().filter(|node| node.has_tag_name("code")).nth(1).unwrap().text().unwrap();
        assert!(pasted.contains("seed=\"&#x202e;a&#x2066;b"), "{pasted}");
    });
}

#[test]
fn hostile_seeds_are_text_on_the_page_and_no_path() {
    for (i, seed) in [
        "\"><script>alert(1)</script>",
        "'onload='x",
        "../../../etc/passwd",
        "{{#each this}}",
        "a/b\\c",
        "\u{202e}gpj.exe",
    ]
    .into_iter()
    .enumerate()
    {
        let name = format!("page-hostile-{i}");
        let folder = out(&name);
        let place = folder.join("{seed}");
        let recipe = ["--seed", seed, "--attractors", "300", "--size", "256", "--title", seed, "--no-element"];
        let call = ["page", "-o", place.to_str().unwrap(), "--address", "https://example.org/"];
        let output = riverseed(&[&call[..], &recipe].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let made: Vec<PathBuf> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        let [made] = &made[..] else { panic!("{seed}: {made:?}") };
        with_nodes(&text(made, "index.html"), |html| {
            let heading = html.descendants().find(|node| node.has_tag_name("h1")).unwrap();
            assert_eq!(heading.text(), Some(&*in_order(seed)));
            assert!(html.descendants().all(|node| !node.has_tag_name("script")), "{seed}");
            let is_handler = |node: roxmltree::Node<'_, '_>| node.attributes().any(|one| one.name().starts_with("on"));
            assert!(!html.descendants().any(is_handler), "{seed}");
        });
        let response: Value = serde_json::from_str(&text(made, "oembed.json")).unwrap();
        with_nodes(response["html"].as_str().unwrap(), |frame| {
            assert_eq!(frame.root_element().attribute("title"), Some(&*in_order(seed)));
            assert_eq!(frame.root_element().children().count(), 0);
        });
    }
}

#[test]
fn maps_that_the_element_would_not_grow_whole_are_pictures() {
    let output = riverseed(&[
        "page",
        "attractors=20001&growth=colonize&trim=60&meander-rounds=0",
        "-o",
        out("page-large").to_str().unwrap(),
        "--size",
        "256",
    ]);
    assert!(output.status.success(), "without --element");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("a picture instead of the element: attractors: 20001 exceeds the widget's limit"), "{said}");
    assert!(!text(&out_of("page-large"), "index.html").contains("<river-seed"));
}

fn out_of(name: &str) -> PathBuf {
    scratch(name).join("out")
}

#[test]
fn seed_of_a_folder_is_that_of_its_address_and_an_empty_one_is_refused() {
    let place = out("page-seed").join("{seed}");
    let call = ["page", "attractors=300&seed=Kea", "-o", place.to_str().unwrap(), "--no-element", "--size", "256"];
    assert!(riverseed(&[&call[..], &["--address", "https://example.org/maps/{seed}"]].concat()).status.success());
    let html = text(&out_of("page-seed").join("%4Bea"), "index.html");
    assert!(html.contains("href=\"https://example.org/maps/%254Bea/\""), "{html}");
    let (code, said) = refusal(&[&call[..], &["--seed", ""]].concat());
    assert!(code == 2 && said.contains("the seed is empty"), "{code}: {said}");
}

#[test]
fn title_is_on_the_card_and_must_be_seen() {
    let link = format!("{FEW}kauri");
    let cards = [&[][..], &["--title", "Home"]]
        .map(|title| fs::read(page("page-title", &link, title).join("card.jpg")).unwrap());
    assert!(cards[0] != cards[1]);
    for (option, words, reason) in [
        ("--title", " ", "no words"),
        ("--title", "a\u{7}b", "cannot be shown"),
        ("--description", &"x".repeat(301), "more than 300"),
    ] {
        let folder = out("page-title-wrong");
        let (code, said) = refusal(&["page", &link, "-o", folder.to_str().unwrap(), "--no-element", option, words]);
        assert!(code == 2 && said.contains(option) && said.contains(reason), "{code}: {said}");
    }
}

#[test]
fn a_page_without_the_element_allows_no_script() {
    let folder = page("page-policy", &format!("{FEW}kauri"), &[]);
    assert!(text(&folder, "index.html").contains("script-src &#x27;self&#x27; &#x27;wasm-unsafe-eval&#x27;"));
    let call = ["page", "attractors=300", "-o", folder.to_str().unwrap(), "--no-element", "--size", "256"];
    assert!(riverseed(&call).status.success());
    for file in ["index.html", "embed.html"] {
        let html = text(&folder, file);
        assert!(!html.contains("<script") && !html.contains("script-src"), "{file}: {html}");
    }
}

#[test]
fn wrong_calls_are_told_what_is_expected() {
    let folder = out("page-wrong");
    let folder = folder.to_str().unwrap();
    let call = |options: &[&str]| refusal(&[&["page", "seed=kauri", "-o", folder], options].concat());
    for (options, code, expected) in [
        (&[][..], 2, "--no-element"),
        (&["--element", ""], 2, "--no-element"),
        (&["--element", "/nowhere"], 2, "--element: /nowhere: there is no river-seed.js"),
        (&["--no-element", "--address", "https://a.b;script-src/"], 2, "https://example.org/maps/kauri/"),
        (&["--no-element", "--address", "kauri"], 2, "https://example.org/maps/kauri/"),
        (&["--no-element", "--maker", "javascript:alert(1)"], 2, "--maker javascript:alert(1)"),
        (&["--element", "ftp://example.org/"], 2, "--element ftp://example.org/"),
        (&["--no-element", "--size", "9000"], 2, "--size"),
        (&["--no-element", "--curl", "9"], 2, "curl"),
    ] {
        let (actual, said) = call(options);
        assert!(actual == code && said.contains(expected), "{options:?}: {actual}, {said}");
    }
    assert!(!Path::new(folder).exists(), "nothing is written");
    let file = scratch("page-file");
    fs::write(&file, "").unwrap();
    let (code, said) = refusal(&["page", "-o", file.to_str().unwrap(), "--no-element"]);
    assert!(code == 2 && said.contains("a file, not a folder"), "{code}: {said}");
}
