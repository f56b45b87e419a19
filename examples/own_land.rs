//! Rivers on your own land, a PNG that is white on land and black in water: `cargo run --features png --example
//! own_land -- land.png`. Without a file it draws a round island.

use std::error::Error;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use riverseed::domain::Domain;
use riverseed::land::trace::trace;
use riverseed::{Key, Land, Recipe, Session, export, import};

/// Writes the land's rivers as SVG into a folder. The recipe holds an outline of the land, as far as there is room for
/// it, which the file's link shows; the rivers run on the land itself, in full detail.
pub fn write(folder: &Path, (width, height, rgba): (u32, u32, &[u8])) -> Result<(), Box<dyn Error>> {
    let traced = trace(width, height, rgba)?;
    let mut recipe: Recipe = "seed=matai&growth=drainage&land=drawn".parse()?;
    recipe.set(Key::Aspect, &format!("{:.2}", traced.aspect))?;
    recipe.set(Key::Outline, &traced.outline.to_string())?;
    let land = Land::from_picture(&Domain::of(&recipe), width, height, rgba)?;
    let mut session = Session::on_land(recipe, land)?;
    session.finish()?;
    Ok(std::fs::write(folder.join("matai.svg"), export::svg::svg(&session)?)?)
}

/// A white disc on black: sides in pixels, and RGBA.
pub fn disc() -> (u32, u32, Vec<u8>) {
    let side = 200;
    let is_land = |i: i32| (i % side - 100).pow(2) + (i / side - 100).pow(2) < 80 * 80;
    let pixel = |i| if is_land(i) { [255, 255, 255, 255] } else { [0, 0, 0, 255] };
    (200, 200, (0..side * side).flat_map(pixel).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let (width, height, rgba) = match std::env::args().nth(1) {
        Some(path) => {
            let image = import::png::read(BufReader::new(File::open(path)?))?;
            (image.width, image.height, image.rgba)
        }
        None => disc(),
    };
    write(Path::new("."), (width, height, &rgba))
}
