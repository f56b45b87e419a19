//! Pictures that the command line uses as land, or traces.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::command::{network, refusal, riverseed, scratch};

/// Writes a picture of greys, 120 x 80 pixels.
fn greys(name: &str, grey: impl Fn(usize, usize) -> u8) -> PathBuf {
    let path = scratch(name);
    let greys: Vec<u8> = (0..120 * 80).map(|i| grey(i % 120, i / 120)).collect();
    let mut encoder = png::Encoder::new(fs::File::create(&path).unwrap(), 120, 80);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.write_header().unwrap().write_image_data(&greys).unwrap();
    path
}

/// Writes a picture of one grey with a square of another in it.
fn picture(name: &str, ground: u8, square: u8) -> PathBuf {
    greys(name, |x, y| if (30..90).contains(&x) && (20..60).contains(&y) { square } else { ground })
}

#[test]
fn picture_of_a_land_becomes_an_outline_that_renders() {
    let path = picture("square.png", 0, 255);
    let traced = |arguments: &[&str]| {
        let output = riverseed(&[&["outline", path.to_str().unwrap()], arguments].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    let (outline, link) = (traced(&[]), traced(&["--link"]));
    assert_eq!(link, format!("seed=kauri&edition=1&aspect=1.5&land=drawn&outline={outline}"));
    let network = network("traced.json", &[&link, "--roughness", "0", "--attractors", "300"]);
    let xs = network["nodes"]["x"].as_array().unwrap();
    let width = network["domain"]["width"].as_f64().unwrap();
    assert!(xs.iter().all(|x| (0.23..0.77).contains(&(x.as_f64().unwrap() / width))), "rivers leave the land");
}

#[test]
fn a_picture_given_as_land_is_the_land_and_links_hold_its_outline() {
    let path = picture("mask.png", 0, 255);
    let path = path.to_str().unwrap();
    let said = |arguments: &[&str]| {
        let output = riverseed(&[arguments, &["--land", path, "--attractors", "2400"]].concat());
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    let out = scratch("masked.json");
    let out = out.to_str().unwrap();
    for growth in ["colonize", "drainage", "brownian"] {
        // A Brownian tree has no attractors.
        let first = said(&["render", "--growth", growth, "--trim", "0", "-o", out]);
        let first = first.lines().next().unwrap();
        assert!(first.contains("mask.png in full detail; links in files hold only its outline, of "), "{first}");
        let network: serde_json::Value = serde_json::from_slice(&fs::read(out).unwrap()).unwrap();
        let outline = riverseed(&["outline", path]).stdout;
        let recipe = &network["recipe"];
        assert_eq!((&recipe["land"], &recipe["aspect"]), (&"drawn".into(), &1.5.into()));
        assert_eq!(recipe["outline"].as_str().unwrap(), String::from_utf8(outline).unwrap().trim());
        // Rough coasts are those of the outline, not of the mask.
        for (axis, length) in [("x", "width"), ("y", "height")] {
            let length = network["domain"][length].as_f64().unwrap();
            let all = network["nodes"][axis].as_array().unwrap();
            let off = |at: &serde_json::Value| (at.as_f64().unwrap() / length - 0.5).abs();
            assert!(all.len() > 20, "{growth}: {}", all.len());
            assert!(all.iter().all(|at| off(at) < 0.252), "{growth}: rivers leave the land");
        }
    }
    for name in ["masked.svg", "masked.geojson", "masked.png"] {
        said(&["render", "-o", scratch(name).to_str().unwrap()]);
    }
    assert!(said(&["measure"]).contains("in full detail"));
    // The link that it wrote may be given again, with the same picture.
    let again = scratch("masked-again.json");
    said(&["render", "--growth", "drainage", "-o", out]);
    said(&["render", "--recipe", out, "-o", again.to_str().unwrap()]);
    assert_eq!(fs::read(out).unwrap(), fs::read(again).unwrap());
    assert!(said(&["render", "--roughness", "0.5", "-o", out]).contains("'roughness' has no effect: the picture"));
    said(&["render", "land=auto", "-o", out]);
}

#[test]
fn what_does_not_go_with_a_picture_as_land_is_refused() {
    let path = picture("mask-alone.png", 0, 255);
    let path = path.to_str().unwrap();
    let out = scratch("never-masked.png");
    let _ = fs::remove_file(&out);
    let refused = |arguments: &[&str]| refusal(&[&["render", "-o", out.to_str().unwrap()], arguments].concat());
    let square = ".MzMzzMMzzMzMMzzM";
    for (given, name) in
        [(&["--outline", square] as &[&str], "outline"), (&["land=island"], "land"), (&["aspect=2"], "aspect")]
    {
        let (code, message) = refused(&[given, &["--land", path]].concat());
        let reason = format!("mask-alone.png: the picture determines '{name}', and another value is given\n");
        assert!(code == 2 && message.ends_with(&reason), "{code}, {message}");
    }
    for (ground, square, reason) in [(0, 0, "all water"), (255, 255, "all land")] {
        let path = picture(&format!("masked {reason}.png"), ground, square);
        let (code, message) = refused(&["--land", path.to_str().unwrap()]);
        assert!(code == 1 && message.contains(reason), "{code}, {message}");
    }
    let junk = scratch("junk-mask.png");
    fs::write(&junk, "junk").unwrap();
    let (code, message) = refused(&["--land", junk.to_str().unwrap()]);
    assert!(code == 1 && message.contains("junk-mask.png: this is not a readable PNG"), "{message}");
    let (code, message) = refused(&["--land", scratch("absent.png").to_str().unwrap()]);
    assert!(code == 1 && message.contains("absent.png"), "{message}");
    let large = scratch("large.png");
    let mut encoder = png::Encoder::new(fs::File::create(&large).unwrap(), 5000, 20);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.write_header().unwrap().write_image_data(&[0; 100_000]).unwrap();
    let (code, message) = refused(&["--land", large.to_str().unwrap()]);
    assert!(code == 1 && message.contains("too large: 5000 x 20 pixels, at most 4096 x 4096"), "{message}");
    assert_eq!(refused(&["--land", "pangaea"]).0, 2);
    assert!(!fs::exists(out).unwrap());
}

#[test]
fn an_area_of_the_third_colour_stays_without_rivers() {
    let from_middle = |x: usize, y: usize| (x.abs_diff(60), y.abs_diff(40));
    let path = greys("area.png", |x, y| match from_middle(x, y) {
        (0..15, 0..10) => 128,
        (0..45, 0..35) => 255,
        _ => 0,
    });
    let output = riverseed(&["outline", path.to_str().unwrap(), "--link"]);
    let link = String::from_utf8(output.stdout).unwrap();
    for growth in ["colonize", "brownian"] {
        let network = network("area.json", &[link.trim(), "--growth", growth, "--attractors", "1000"]);
        let share = |axis: &str, length: &str| -> Vec<f64> {
            let length = network["domain"][length].as_f64().unwrap();
            network["nodes"][axis]
                .as_array()
                .unwrap()
                .iter()
                .map(|at| (at.as_f64().unwrap() / length - 0.5).abs())
                .collect()
        };
        let places: Vec<(f64, f64)> = share("x", "width").into_iter().zip(share("y", "height")).collect();
        assert!(places.len() > 200, "{growth}: {}", places.len());
        assert!(places.iter().all(|&(x, y)| x > 0.11 || y > 0.11), "{growth}: rivers run over the area");
        assert!(places.iter().any(|&(x, y)| x < 0.2 && y < 0.2), "{growth}: no river comes near the area");
        if growth == "colonize" {
            let unreached = network["growth"]["unreached"].as_u64().unwrap();
            assert!(unreached < 20, "{unreached} attractors lie within");
        }
    }
}

#[test]
fn tracing_says_what_it_kept_and_a_link_takes_a_seed() {
    let path = picture("kept.png", 0, 255);
    let output = riverseed(&["outline", path.to_str().unwrap(), "--link", "--seed", "rimu"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("kept 1 of 1 coast and 0 of 0 ridges, "));
    assert!(String::from_utf8_lossy(&output.stdout).starts_with("seed=rimu&"));
    assert_eq!(refusal(&["outline", path.to_str().unwrap(), "--seed", "rimu"]).0, 2);
}

#[test]
fn a_heightmap_that_is_given_as_land_is_told() {
    let heights = greys("heights.png", |x, y| (4 * x.min(119 - x).min(y).min(79 - y)).min(255) as u8);
    let land = greys("land.png", |x, y| if (30..90).contains(&x) && (20..60).contains(&y) { 255 } else { 0 });
    let out = scratch("heights.json");
    for command in [&["outline"][..], &["render", "--attractors", "300", "-o", out.to_str().unwrap(), "--land"]] {
        let said = |path: &PathBuf| {
            let output = riverseed(&[command, &[path.to_str().unwrap()]].concat());
            assert!(output.status.success(), "{output:?}");
            String::from_utf8(output.stderr).unwrap().contains("riverseed: this looks like a heightmap, ")
        };
        assert!(said(&heights) && !said(&land), "{command:?}");
    }
}

#[test]
fn pictures_that_show_no_land_are_refused_by_name() {
    for (ground, square, reason) in [(0, 0, "all water"), (255, 255, "all land")] {
        let path = picture(reason, ground, square);
        let (code, message) = refusal(&["outline", path.to_str().unwrap()]);
        assert_eq!(code, 1);
        assert!(message.contains(reason), "{message}");
    }
    let junk = scratch("junk.png");
    fs::write(&junk, "junk").unwrap();
    let (code, message) = refusal(&["outline", junk.to_str().unwrap()]);
    assert!(code == 1 && message.contains("junk.png: this is not a readable PNG"), "{message}");
    let (code, message) = refusal(&["outline", scratch("absent.png").to_str().unwrap()]);
    assert!(code == 1 && message.contains("absent.png"), "{message}");
    let (code, message) = refusal(&["render", "--outline", ".AAA", "-o", scratch("x.png").to_str().unwrap()]);
    assert!(code == 2 && message.contains("outline: the coast that begins at character 1"), "{message}");
}

/// A script's log may be on a full disk.
#[test]
#[cfg(target_os = "linux")]
fn what_cannot_be_said_does_not_keep_a_picture_from_becoming_a_land() {
    let path = picture("unheard.png", 0, 255);
    let deaf = |arguments: &[&str]| {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        Command::new(env!("CARGO_BIN_EXE_riverseed")).args(arguments).stderr(full).output().unwrap()
    };
    let (path, out) = (path.to_str().unwrap(), scratch("unheard.json"));
    let outline = deaf(&["outline", path]);
    assert!(outline.status.success());
    assert_eq!(outline.stdout, riverseed(&["outline", path]).stdout);
    let render = ["render", "attractors=100", "--land", path, "-o", out.to_str().unwrap()];
    assert!(deaf(&render).status.success());
    assert!(out.exists());
}
