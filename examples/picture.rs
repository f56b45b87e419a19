//! Draws a recipe as PNG: `cargo run --features png --example picture`, and look at `kauri.png`.

use std::error::Error;
use std::fs::File;
use std::path::Path;

use riverseed::{Picture, Recipe, Session, export};

/// Writes the picture into a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let recipe: Recipe = "seed=kauri&growth=drainage&land=island&style=atlas".parse()?;
    let mut session = Session::new(recipe)?;
    session.finish()?;
    let mut picture = Picture::new(1200, 750)?;
    picture.paint(&session);
    // The recipe travels in the file.
    let link = session.recipe().to_string();
    Ok(export::png::write(File::create(folder.join("kauri.png"))?, picture.pixmap(), &link)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    write(Path::new("."))
}
