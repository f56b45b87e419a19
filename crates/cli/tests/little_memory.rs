//! Calls with little memory. However much there is, a call writes the right bytes and ends with 0, or it writes
//! nothing, gives the reason and ends with 1.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use png::{ColorType, Encoder};

const RIVERSEED: &str = env!("CARGO_BIN_EXE_riverseed");

/// Megabytes that the limits add to the memory that the program needs to start.
const RUNGS: [u32; 14] = [0, 1, 2, 3, 5, 8, 12, 18, 26, 36, 50, 70, 100, 2000];

/// Calls the program with a limit on its address space, in megabytes.
fn call_within(megabytes: u32, arguments: &[&str]) -> Output {
    let kilobytes = megabytes * 1000;
    let limited = format!("ulimit -v {kilobytes} && exec \"$@\"");
    Command::new("sh").args([&["-c", &limited, "sh", RIVERSEED], arguments].concat()).output().unwrap()
}

/// Finds the lowest limit under which the system starts the program, with a room that depends on nothing but its size.
fn least_to_start() -> u32 {
    (4..400).find(|&megabytes| matches!(call_within(megabytes, &["--version"]).status.code(), Some(0 | 1))).unwrap()
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("little-memory").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn check(form: &str, arguments: &[&str]) {
    let (folder, least) = (folder(form), least_to_start());
    let render = |extra: u32| {
        let out = folder.join(format!("{extra}.{form}"));
        let output = call_within(least + extra, &[&["render", "-o", out.to_str().unwrap()], arguments].concat());
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned(), fs::read(&out).ok())
    };
    let (code, said, whole) = render(3000);
    assert_eq!(code, Some(0), "{said}");
    let mut refused = 0;
    for extra in RUNGS {
        let (code, said, file) = render(extra);
        match code {
            Some(0) => assert!(file == whole, "{form}, {extra}: other bytes"),
            _ => {
                assert_eq!(code, Some(1), "{form}, {extra}: {said}");
                assert!(
                    said.lines().last().is_some_and(|line| line.starts_with("riverseed: ")),
                    "{form}, {extra}: {said}"
                );
                assert!(file.is_none(), "{form}, {extra}: a file is left");
                refused += 1;
            }
        }
    }
    assert!((1..RUNGS.len()).contains(&refused), "{form}: {refused} limits were too low");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn too_little_memory_is_exit_code_1_in_every_form() {
    const ANNOTATED: &str = "seed=kea&attractors=1500&style=parchment&labels=many&cartouche=framed&woods=0.5";
    for form in ["png", "svg", "json", "geojson", "zip", "heights.png", "gpkg", "heights.tif", "glb"] {
        let size: &[&str] = if matches!(form, "png" | "zip" | "glb") { &["--size", "500"] } else { &[] };
        check(form, &[&[ANNOTATED], size].concat());
    }
}

/// Draws a picture of a lake in a land.
fn land(path: &Path, (width, height): (u32, u32)) {
    let mut encoder = Encoder::new(File::create(path).unwrap(), width, height);
    encoder.set_color(ColorType::Grayscale);
    let is_land = |x: u32, y: u32| {
        let (dx, dy) = (x as f32 / width as f32 - 0.5, y as f32 / height as f32 - 0.5);
        (0.02..0.16).contains(&(dx * dx + dy * dy))
    };
    let pixels: Vec<u8> = (0..height).flat_map(|y| (0..width).map(move |x| u8::from(is_land(x, y)) * 255)).collect();
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
}

#[test]
fn too_little_memory_is_exit_code_1_with_a_picture_as_the_land() {
    let picture = folder("picture").join("land.png");
    land(&picture, (1500, 1000));
    let picture = picture.to_str().unwrap();
    check("land.png", &["seed=kea&attractors=600", "--land", picture]);
}
